"""What a page shows moving of gears: flanks that touch where it says, true ratios, planets in mesh."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from tmmcalc.gears.chosen.choice import written_set
from tmmcalc.gears.chosen.motion import Moving, moving, written
from tmmcalc.gears.gearing import solve_gearing
from tmmcalc.gears.gearingtask import GearingTask, layout_task
from tmmcalc.gears.meshing.halftooth import half_tooth
from tmmcalc.gears.meshing.members import both
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.network.builder import bevel_differential
from tmmcalc.gears.network.model import INTERNAL, Mesh, Network
from tmmcalc.gears.network.model import Body as Borne
from tmmcalc.gears.views.front import Front
from tmmcalc.gears.views.pair import Rolling
from tmmcalc.gears.views.wheels import members_of
from tmmcalc.report.moving import Body, Track, View

PAIRS = {
    "external": PairTask((14, 27), 0.005, strategy="given", shifts=(0.5, 0.4)),
    "unshifted": PairTask((20, 40), 0.002, strategy="given", shifts=(0.0, 0.0)),
    "helical": PairTask((17, 31), 0.003, helix=math.radians(15), strategy="given", shifts=(0.3, 0.2)),
    "internal": PairTask((18, 57), 0.004, kind="internal", strategy="given", shifts=(0.2, 0.3)),
    "rack": PairTask((16, 0), 0.006, kind="rack", strategy="given", shifts=(0.3, 0.0)),
}


def value(track: Track, view: View, at: float) -> float:
    """A track that two places tell, there."""
    start, end = view.values
    assert len(view.values) == 2
    rate = (track.values[1] - track.values[0]) / (end - start)
    assert track.rates == pytest.approx(rate)
    return float(track.values[0] + rate * (at - start))


def pose(view: View, name: str, at: float) -> tuple[complex, complex]:
    """The origin of a body, and the direction of its axes; those that others bear go with them."""
    body = body_of(view, name)
    origin, turn = complex(value(body.x, view, at), value(body.y, view, at)), value(body.angle, view, at)
    axes = complex(math.cos(turn), math.sin(turn))
    if not body.on:
        return origin, axes
    there, around = pose(view, body.on, at)
    return there + around * origin, around * axes


def body_of(view: View, name: str) -> Body:
    return next(body for body in view.bodies if body.name == name)


@pytest.fixture(params=PAIRS)
def rolling(request: pytest.FixtureRequest) -> Rolling:
    return Rolling(solve_pair(PAIRS[request.param]))


def test_contact_points_lie_on_both_flanks(rolling: Rolling) -> None:
    """To a millionth of the module: on the polynomial through the points of a flank, whose course is smooth."""
    view, module = rolling.view("pair"), rolling.found.task.module
    seen = 0
    for j, (start, end) in rolling.contacts():
        for angle in np.linspace(start, end, 7):
            at = math.degrees(angle)
            contact, _ = pose(view, f"K{j}", at)
            assert contact == pytest.approx(rolling.contact(j, angle), abs=1e-9 * module)
            for name in "12":
                origin, axes = pose(view, name, at)
                flanks = [np.array(mark.points) for mark in body_of(view, name).marks if mark.kind == "flank"]
                own = (contact - origin) / axes
                assert min(distance(own, flank) for flank in flanks) < 1e-6 * module
                seen += 1
    assert seen >= 28


def distance(at: complex, flank: np.ndarray) -> float:
    """From a smooth curve through points, by Newton on the polynomial of all of them."""
    centre, size = flank.mean(), float(np.abs(flank - flank.mean()).max())
    if abs(at - centre) > 3 * size:
        return math.inf
    t = np.linspace(-1, 1, len(flank))
    curve = np.polynomial.Chebyshev.fit(t, (flank - centre) / size, len(flank) - 1)
    first, want = curve.deriv(), (at - centre) / size
    best = float(t[np.argmin(np.abs(flank - at))])
    for _ in range(20):
        best -= float(((curve(best) - want) * np.conj(first(best))).real / abs(first(best)) ** 2)
        best = min(max(best, -1.0), 1.0)
    return float(abs(curve(best) - want)) * size


def test_the_line_of_action_bears_the_contacts(rolling: Rolling) -> None:
    line = next(mark for mark in body_of(rolling.view("pair"), "action").marks if mark.kind == "bar").points
    along = (line[1] - line[0]) / abs(line[1] - line[0])
    for j, (start, end) in rolling.contacts():
        for angle in (start, end):
            away = (rolling.contact(j, angle) - line[0]) / along
            assert abs(away.imag) < 1e-9 * rolling.found.task.module
            assert -1e-9 < away.real / abs(line[1] - line[0]) < 1 + 1e-9


def test_the_end_is_like_the_beginning(rolling: Rolling) -> None:
    """A pitch further every tooth stands where its neighbour stood; contacts are there for the contact ratio."""
    view = rolling.view("pair")
    end = float(view.values[-1])
    assert end == pytest.approx(360 / rolling.found.task.teeth[0])
    for name in "12":
        (first, axes), (last, turned) = pose(view, name, 0.0), pose(view, name, end)
        flanks = [np.array(mark.points) for mark in body_of(view, name).marks if mark.kind == "flank"]
        middles = np.array([flank[len(flank) // 2] for flank in flanks])
        before, after = first + middles * axes, last + middles * turned
        near = [float(np.abs(after - place).min()) for place in before[1:-1]]
        assert max(near) < 1e-9 * rolling.found.task.module
    parts = sum(to - start for _, (start, to) in rolling.contacts())
    assert parts / rolling.turn == pytest.approx(rolling.found.shortened)


def test_the_ratio_is_true(rolling: Rolling) -> None:
    view, (first, second) = rolling.view("pair"), rolling.found.task.teeth
    end = float(view.values[-1])
    mate = body_of(view, "2")
    if rolling.found.task.kind == "rack":
        pitch = rolling.found.task.transverse_pitch
        assert value(mate.x, view, 0.0) - value(mate.x, view, end) == pytest.approx(pitch)
        return
    sense = 1 if rolling.found.task.kind == "internal" else -1
    assert value(mate.angle, view, end) == pytest.approx(sense * first / second * math.radians(end))


def test_sliding_is_that_of_the_specific_one(rolling: Rolling) -> None:
    """theta_1 = v_s/v_t1, with v_t1 = omega_1 rho_1 along the flank of wheel 1."""
    table = rolling.found.sliding
    for rho, theta in zip(table.rho1[table.active], table.theta1[table.active], strict=True):
        at = complex(rolling.pair.on_line(rho))
        along = rho / rolling.pair.pitch_point.imag
        assert abs(rolling.sliding(at)) / along == pytest.approx(abs(theta), abs=1e-9)


def test_working_flanks_are_those_of_the_theory(rolling: Rolling) -> None:
    """The ends of the drawn flanks are where the contact begins and ends."""
    found = rolling.found
    base = found.sizes[0].base
    flank = np.array(next(m for m in body_of(rolling.view("pair"), "1").marks if m.kind == "flank").points)
    rho = np.sqrt(np.abs(flank) ** 2 - base**2)
    assert sorted((rho[0], rho[-1])) == pytest.approx([found.line.begins, found.line.ends], rel=1e-9)
    assert half_tooth(both(found)[0]).base * found.task.module == pytest.approx(base)


RAVIGNEAUX = Network(
    (
        Mesh("small", 30, "short", 18),
        Mesh("short", 18, "long", 19),
        Mesh("large", 36, "long", 19),
        Mesh("long", 19, "ring", 74, INTERNAL),
    ),
    (Borne("short", "H", 3), Borne("long", "H", 3)),
)
LAYOUTS = {  # tooth numbers that fit in with so many planets
    "single": ("AIbar", (18, 48, 114), 3),
    "double": ("AI", (22, 118, 17, 97), 3),
    "carrier turns": ("AIbar", (25, 65, 155), 3),
    "three centrals": ("AII", (20, 25, 28, 70, 73), 3),
    "coaxial": ("coaxial", (18, 42, 20, 40), 1),
    "external": ("AA", (30, 32, 31, 31), 1),
    "internal": ("II", (60, 25, 20, 55), 1),
    "paired": ("2A-AA", (18, 24, 60, 66), 3),
    "unfolded": ("unfolded3", (18, 54, 20, 70, 19, 40), 1),
}


def trains() -> dict[str, Moving]:
    """Trains of every kind in motion."""
    found = {}
    for name, (key, teeth, planets) in LAYOUTS.items():
        chosen = written_set(layout_task(key, teeth, planets))
        assert chosen is not None
        found[name] = moving(chosen, 10.0)
    task = GearingTask(RAVIGNEAUX, {"small": 100.0, "H": 0.0}, outputs=("ring",))
    found["written out"] = written(solve_gearing(task))
    bevel = GearingTask(bevel_differential(16, 10, 16), {"left": 30.0, "right": 10.0})
    found["bevel"] = written(solve_gearing(bevel))
    return found


@pytest.fixture(params=trains())
def front(request: pytest.FixtureRequest) -> Front:
    return Front(trains()[request.param])


def test_members_turn_at_their_true_speeds(front: Front) -> None:
    view, motion = front.view("train"), front.found.motion
    start, end = view.values
    driver = motion.speed(front.driver)
    for member in front.members:
        if member.tilted or member.name == "frame":
            continue
        (_, before), (_, after) = pose(view, member.name, start), pose(view, member.name, start + 1.0)
        turned = float(np.angle(after / before))
        assert turned == pytest.approx(math.radians(motion.speed(member.name) / driver), abs=1e-12)
        if view.whole:
            assert pose(view, member.name, end) == pytest.approx(pose(view, member.name, start), abs=1e-9)


def test_wheels_mesh_wherever_it_stands(front: Front) -> None:
    """At every pitch point a tooth of one wheel stands in a space of the other, to a millionth of the pitch."""
    view = front.view("train")
    members = {member.name: member for member in front.members}
    seen = 0
    for at in (0.0, 17.0, 123.4):
        for first, second in front.meshes:
            one, other = members[first[0]], members[second[0]]
            for k in range(max(len(one.axes), len(other.axes))):
                a, b = (copy_of(view, each.name, k, len(each.axes)) for each in (one, other))
                ends = [pose(view, each, at)[0] for each in (a, b)]
                rings = [members[name].circles[place].ring for name, place in (first, second)]
                way = (ends[1] - ends[0]) * (-1 if rings[1] else 1)
                parts = []
                for name, (member, place), sense in ((a, first, 1), (b, second, -1)):
                    towards = way if any(rings) or sense == 1 else -way
                    parts.append(phase(view, name, place, members[member].circles, at, towards))
                apart = parts[0] - parts[1] if any(rings) else parts[0] + parts[1]
                assert (apart + 0.5) % 1.0 == pytest.approx(1.0, abs=1e-6) or (apart + 0.5) % 1.0 < 1e-6
                seen += 1
    assert seen or front.found.chosen is None


def test_planets_stand_where_they_fit() -> None:
    """Three pairs of the Ravigneaux set at multiples of 1/22 of a turn, where 44 and 66 teeth go on by whole ones."""
    found = members_of(trains()["written out"])[0]
    for name in ("short", "long"):
        axes = np.array(next(member.axes for member in found if member.name == name))
        turns = np.angle(axes / axes[0]) / (2 * math.pi) % 1.0
        np.testing.assert_allclose(np.sort(turns), [0.0, 7 / 22, 15 / 22], atol=1e-12)


def test_planets_without_room_are_one() -> None:
    crowded = Network((Mesh("1", 20, "2", 60), Mesh("2", 60, "3", 140, INTERNAL)), (Borne("2", "H", 4),))
    found = members_of(written(solve_gearing(GearingTask(crowded, {"1": 100.0, "3": 0.0}, outputs=("H",)))))[0]
    assert len(next(member.axes for member in found if member.name == "2")) == 1


@pytest.mark.parametrize(("sun", "planet", "count"), [(8, 3, 6), (8, 3, 5), (20, 18, 4), (19, 38, 3), (30, 9, 7)])
def test_no_two_planets_overlap(sun: int, planet: int, count: int) -> None:
    """Wherever they are put; the nearest two need not be the first ones: six on 22 places are 0, 4, 7, 11, 15, 18."""
    meshes = (Mesh("1", sun, "2", planet), Mesh("2", planet, "3", sun + 2 * planet, INTERNAL))
    task = GearingTask(Network(meshes, (Borne("2", "H", count),)), {"1": 100.0, "3": 0.0}, outputs=("H",))
    member = next(each for each in members_of(written(solve_gearing(task)))[0] if each.name == "2")
    module = 2 * member.circles[0].radius / planet
    gaps = [abs(one - other) for one, other in itertools.combinations(member.axes, 2)]
    assert len(member.axes) in (1, count)
    assert all(gap >= module * (planet + 2) for gap in gaps)


def copy_of(view: View, name: str, k: int, count: int) -> str:
    return f"{name}#{k}" if k and count > 1 else name


def phase(view: View, name: str, place: int, circles: Sequence[Any], at: float, towards: complex) -> float:
    """Where a tooth is beside a direction, in pitches, counter-clockwise."""
    marks = [mark for mark in body_of(view, name).marks if mark.kind in ("cog", "rim")]
    order = sorted(range(len(circles)), key=lambda k: -circles[k].radius)
    mark = marks[order.index(place)]
    _, axes = pose(view, name, at)
    return float(np.angle(mark.points[1] * axes / towards)) * mark.size / (2 * math.pi)


def test_pitch_circles_touch(front: Front) -> None:
    """Also while planets go round."""
    view = front.view("train")
    members = {member.name: member for member in front.members}
    for at in (0.0, 200.0):
        for first, second in front.meshes:
            apart = abs(pose(view, first[0], at)[0] - pose(view, second[0], at)[0])
            one, other = members[first[0]].circles[first[1]], members[second[0]].circles[second[1]]
            reach = abs(one.radius - other.radius) if one.ring or other.ring else one.radius + other.radius
            assert apart == pytest.approx(reach, rel=1e-9)


def test_all_speeds_are_told(front: Front) -> None:
    told = {reading.sign: float(reading.value.values[0]) for reading in front.view("train").readings}
    assert list(told.values()) == pytest.approx(front.found.motion.speeds.tolist())
