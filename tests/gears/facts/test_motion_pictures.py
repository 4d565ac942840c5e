"""Plans of velocities and of speeds, and schemes of written trains, read back from paper."""

from __future__ import annotations

import cmath
import math
from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from paper import curves, inside, of_words, on_sheet, written

from tmmcalc.api import run
from tmmcalc.gears.chosen.choice import written_set
from tmmcalc.gears.chosen.motion import Moving, moving, plans_of
from tmmcalc.gears.chosen.motion import written as in_motion
from tmmcalc.gears.gearingtask import GearingTask, layout_task
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.network.model import FRAME, Body, Mesh, Network
from tmmcalc.gears.network.speeds import solve_speeds
from tmmcalc.gears.pictures.memberscheme import draw_members, view_of
from tmmcalc.gears.pictures.motionplans import Drawn, draw_motion, member_pens, member_points
from tmmcalc.gears.pictures.sideview import SHAFT, WHEELS
from tmmcalc.project import load_spec
from tmmcalc.project.templates import path
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.pens import HATCH, MIDDLE
from tmmcalc.report.drawing.scales import SERIES, standard_scale
from tmmcalc.report.drawing.shapes import Area, Drawing, Stroke
from tmmcalc.report.drawing.wording import corners

# teeth, and w_1/w_out by hand (4.2), (4.19)
TRAINS: dict[str, tuple[tuple[int, ...], Fraction]] = {
    "unfolded2": ((17, 59, 18, 40), Fraction(59 * 40, 17 * 18)),
    "unfolded3": ((17, 59, 18, 44, 19, 35), -Fraction(59 * 44 * 35, 17 * 18 * 19)),
    "coaxial": ((26, 100, 27, 57), Fraction(100 * 57, 26 * 27)),
    "AIbar": ((18, 48, 114), 1 + Fraction(114, 18)),
    "AI": ((22, 118, 17, 97), 1 + Fraction(118 * 97, 22 * 17)),
    "AA": ((100, 101, 100, 99), 1 - Fraction(101 * 99, 100 * 100)),
    "II": ((90, 30, 24, 84), 1 - Fraction(30 * 84, 90 * 24)),
    "AII": ((20, 25, 28, 70, 73), (1 + Fraction(70, 20)) / (1 - Fraction(70 * 28, 25 * 73))),
    "2A-AA": ((18, 24, 66, 72), 1 + Fraction(72, 18)),
}
OUTPUTS = {"unfolded2": "3", "unfolded3": "4", "coaxial": "3", "AII": "4"}
WRITTEN = ("gears-circulating", "gears-differential", "gears-ravigneaux")
SHEET = Box(10.0, 10.0, 330.0, 210.0)


@cache
def train(name: str) -> Moving:
    if name in WRITTEN:
        return in_motion(run(load_spec(path(name)), target="gearing").results["gearing"])
    chosen = written_set(layout_task(name, TRAINS[name][0], 1 if name == "AA" else 3))
    assert chosen is not None
    return moving(chosen, 100.0)


@cache
def drawn(name: str) -> tuple[Drawing, Drawn]:
    drawing = Drawing(340.0, 220.0)
    return drawing, draw_motion(drawing, SHEET, train(name))


def test_every_layout_is_tried() -> None:
    assert {key for key in LAYOUTS if not key.startswith("open")} == {*TRAINS}


def segments(name: str) -> dict[str, complex]:
    """Rays of the members on paper from the pole to the line of speeds [mm], drawn to there or not."""
    return {member: ray * drawn(name)[1].pole / ray.imag for member, ray in drawn_rays(name).items()}


def drawn_rays(name: str) -> dict[str, complex]:
    """Rays of the members on paper as they are drawn [mm]."""
    _, parts = drawn(name)
    found = {}
    for member, pen in member_pens(plans_of(train(name))).items():
        (ray,) = [z for z in curves(parts.speeds, pen) if abs(z[0]) < 1e-9]
        places = parts.speeds.paper(ray)
        found[member] = complex(places[-1] - places[0])
    return found


@pytest.mark.parametrize("name", TRAINS)
def test_segments_of_the_plan_of_speeds_give_the_ratio(name: str) -> None:
    found = segments(name)
    ratio = found["1"].real / found[OUTPUTS.get(name, "H")].real
    assert ratio == pytest.approx(float(TRAINS[name][1]), rel=1e-9)
    (said,) = [text for text in written(drawn(name)[0]) if text.startswith("From the plan")]
    assert float(said.rpartition("= ")[2].replace("−", "-")) == pytest.approx(ratio, rel=1e-4)


@pytest.mark.parametrize("name", [*TRAINS, *WRITTEN])
def test_the_ray_of_a_member_far_faster_than_all_others_runs_out_of_the_plan(name: str) -> None:
    told = sorted((abs(line.speed), line.member) for line in plans_of(train(name)).lines)
    pole = drawn(name)[1].pole
    short = {member for member, ray in drawn_rays(name).items() if ray.imag < 0.99 * pole}
    if told[-1][0] > 4.0 * told[-2][0] > 0.0:
        assert short == {told[-1][1]}
        assert any(text.startswith(f"{told[-1][1]}: ") for text in written(drawn(name)[0]))
        others = [ray.real for member, ray in drawn_rays(name).items() if member not in short]
        assert max(others) - min(others) > 12.0
    else:
        assert not short


@pytest.mark.parametrize("name", TRAINS)
@pytest.mark.parametrize("wide", [290.0, 320.0, 350.0, 420.0])
def test_the_scale_factor_of_speeds_is_standard(name: str, wide: float) -> None:
    """It is mu_v/(mu_l h), which a suitable h makes round, but not under a scale like 1:15."""
    drawing = Drawing(wide + 20.0, 220.0)
    parts = draw_motion(drawing, Box(10.0, 10.0, 10.0 + wide, 200.0), train(name))
    (told,) = [text for text in written(drawing) if text.startswith("$μ_ω$")]
    factor = float(told.partition(" = ")[2].partition(" ")[0])
    line = parts.speeds.place(1.0) - parts.speeds.place(0.0)
    assert factor * line.real == pytest.approx(1.0, rel=1e-3)
    if not any(f"(1:{size})" in text for size in (15, 75) for text in written(drawing)):
        assert factor == pytest.approx(standard_scale(factor))


@pytest.mark.parametrize("name", [*TRAINS, *WRITTEN])
def test_rays_are_parallel_to_the_lines_of_velocities(name: str) -> None:
    _, parts = drawn(name)
    told, network, rays = plans_of(train(name)), train(name).task.network, segments(name)
    for member, pen in member_pens(told).items():
        if network.tilted(member):
            continue  # its points lie at one height, and its ray is that of its own axis
        (line,) = curves(parts.velocities, pen)
        places = parts.velocities.paper(line)
        way = complex(places[-1] - places[0])
        if abs(way) > 1e-6:
            assert cmath.phase(way / rays[member]) == pytest.approx(0.0, abs=1e-9), member


@pytest.mark.parametrize("name", [*TRAINS, *WRITTEN])
def test_lines_of_wheels_in_mesh_meet_at_the_velocity_of_their_pitch_point(name: str) -> None:
    """Every pitch point is an end or a point of the lines of both wheels, at the speed of both about their axes."""
    told, network = plans_of(train(name)), train(name).task.network
    for point in told.points:
        if point.kind != "pitch point":
            continue
        for member in point.members:
            if member != FRAME:
                own = member_points(network, told, member)
                assert min(abs(own - complex(point.velocity, point.x))) == 0.0


@pytest.mark.parametrize("name", [each for each in TRAINS if each not in ("II", "2A-AA", "AII")])
def test_wheels_of_the_scheme_touch_at_the_height_of_the_pitch_point(name: str) -> None:
    """The bars of the first two wheels end at P_12, to the scale that the scheme and the plan of velocities share."""
    drawing, parts = drawn(name)
    point = next(each for each in plans_of(train(name)).points if each.name == "P_1-2")
    height = parts.velocities.place(complex(0.0, point.x)).imag
    bars = [each for each in drawing.shapes if isinstance(each, Area) and each.pen in WHEELS]
    ends = [edge for bar in bars for edge in (float(bar.points.imag.min()), float(bar.points.imag.max()))]
    assert sum(abs(end - height) < 1e-9 for end in ends) >= 2
    assert parts.scheme.mu in SERIES
    z1, z2 = TRAINS[name][0][:2]
    sizes = [float(np.ptp(bar.points.imag)) for bar in bars]
    assert any(abs(size * parts.scheme.mu - 2 * z1 / (z1 + z2) * point_distance(name)) < 1e-12 for size in sizes)


def point_distance(name: str) -> float:
    """Centre distance of wheels 1 and 2 by the places of their axes."""
    lines = {line.member: complex(line.x, line.y) for line in plans_of(train(name)).lines}
    return abs(lines["1"] - lines["2"])


@pytest.mark.parametrize("name", WRITTEN)
def test_wheels_of_a_written_train_are_to_scale(name: str) -> None:
    """Every wheel of a pitch point has a bar of its own operating radius; of a ring both rims, of bevel ones a disc."""
    drawing, parts = drawn(name)
    bars = [each for each in drawing.shapes if isinstance(each, Area) and each.pen in WHEELS]
    spans = [(np.ptp(bar.points.imag), np.ptp(bar.points.real)) for bar in bars]
    ends = [edge for bar in bars for edge in (float(bar.points.imag.min()), float(bar.points.imag.max()))]
    told, network = plans_of(train(name)), train(name).task.network
    axis = {line.member: line.x for line in told.lines}
    for point in told.points:
        if point.radii is None:
            continue
        for member, radius in zip(point.members, point.radii, strict=True):
            size = 2 * radius / parts.scheme.mu
            if network.tilted(member):
                assert any(abs(wide - size) < 1e-9 for _, wide in spans)
                continue
            reach = [parts.scheme.place(1j * (axis[member] + side * radius)).imag for side in (-1, 1)]
            assert all(min(abs(np.array(ends) - end)) < 1e-9 for end in reach)


@pytest.mark.parametrize("name", [*TRAINS, *WRITTEN])
def test_all_is_within_the_rectangle(name: str) -> None:
    drawing, parts = drawn(name)
    assert not on_sheet(drawing)
    assert all(inside(corners(words), SHEET) for words in of_words(drawing))
    assert inside(parts.scheme.paper(view_of(train(name)).content), parts.scheme.box)
    boards = drawing.fields
    faults = [fault for board in boards for fault in board.labels.faults]
    assert len(faults) <= (1 if name == "gears-differential" else 0)


def test_names_of_a_held_ring_and_of_its_planet_stand_clear() -> None:
    """On the scheme of a task no shaft, web or hatching goes through the name of the ring 3 or the teeth of 2'."""
    network = Network((Mesh("1", 22, "2", 47), Mesh("2", 24, "3", 77, 1)), (Body("2", "H"),))
    speeds = {"1": 300.0, "3": 0.0}
    found = Moving(GearingTask(network, speeds), solve_speeds(network, speeds), None)
    drawing = Drawing(150.0, 100.0)
    draw_members(drawing, Box(5.0, 5.0, 115.0, 80.0), found)
    strokes = [each for each in drawing.shapes if isinstance(each, Stroke) and each.pen in (SHAFT, MIDDLE, HATCH)]
    assert {each.pen for each in strokes} == {SHAFT, MIDDLE, HATCH}
    lines = np.concatenate([np.interp(np.linspace(0, len(z) - 1, 500), np.arange(len(z)), z)
                            for z in (each.points for each in strokes)])  # fmt: skip
    for text, clear in (("3", 0.5), ("$z_{2'}$ = 24", 1.0)):  # [mm]
        (box,) = [corners(words) for words in of_words(drawing) if words.text == text]
        away = np.maximum(np.abs(lines.real - box.real.mean()) - np.ptp(box.real) / 2,
                          np.abs(lines.imag - box.imag.mean()) - np.ptp(box.imag) / 2)  # fmt: skip
        assert away.min() > clear, text


def test_the_table_tells_the_speeds() -> None:
    """n = 30 w/pi; a planet by the formula of Willis: w_2 = w_H (1 - Z3/Z2)."""
    said = written(drawn("AIbar")[0])
    z1, z2, z3 = TRAINS["AIbar"][0]
    carrier = 100.0 / (1 + z3 / z1)
    planet = carrier * (1 - z3 / z2)
    for omega in (100.0, carrier, planet):
        for value in (omega, omega * 30 / math.pi):
            assert f"{value:.6g}".replace("-", "−") in said


RANDOM: tuple[tuple[tuple[Mesh, ...], tuple[Body, ...], dict[str, float]], ...] = (
    ((Mesh("a", 20, "b", 40),), (), {"a": 5.0}),
    ((Mesh("a", 20, "b", 60, 1),), (), {"a": 5.0}),
    ((Mesh("a", 20, "b", 40), Mesh("b", 18, "c", 54), Mesh("c", 18, "d", 30), Mesh("d", 18, "e", 30)), (), {"a": -9.0}),
    ((Mesh("a", 12, "b", 12, 1),), (), {"a": 5.0}),  # a coupling has no pitch point
    (tuple(Mesh(f"s{k}", 17 + k, f"s{k + 1}", 40 + k) for k in range(7)), (), {"s0": 3.0}),
    ((Mesh("sun", 20, "p", 20), Mesh("p", 20, "frame", 60, 1)), (Body("p", "H", count=3),), {"sun": 10.0}),
    ((Mesh("sun", 20, "p", 20), Mesh("p", 20, "ring", 60, 1)), (Body("p", "H", count=3),), {"sun": 0.0, "H": 0.0}),
)


@pytest.mark.parametrize("case", range(len(RANDOM)))
def test_trains_of_any_meshes_are_drawn(case: int) -> None:
    meshes, bodies, speeds = RANDOM[case]
    network = Network(meshes, bodies)
    found = Moving(GearingTask(network, speeds), solve_speeds(network, speeds), None)
    drawing = Drawing(340.0, 220.0)
    parts = draw_motion(drawing, SHEET, found)
    assert not on_sheet(drawing)
    finite = [np.isfinite(each.points).all() for each in drawing.shapes if isinstance(each, Area)]
    assert all(finite)
    for line in plans_of(found).lines:
        rays = curves(parts.speeds, member_pens(plans_of(found))[line.member])
        (ray,) = [z for z in rays if abs(z[0]) < 1e-9]
        assert ray[-1].real == pytest.approx(found.motion.speed(line.member), abs=1e-9)
