"""Willis' equations, plans of velocities and speeds, against speeds that numpy solves from equations written anew."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, example, given

import tmmcalc
from gears.formulas import worked
from gears.network.trains import EXAMPLES, trains
from gears.strength.scenes import TRAINS
from tmmcalc.core.errors import TmmError
from tmmcalc.gears.chosen.choice import written_set
from tmmcalc.gears.chosen.motion import equations, moving, plans_of, written
from tmmcalc.gears.gearingtask import layout_task
from tmmcalc.gears.network.model import FRAME, INTERNAL, Body, Mesh, Network
from tmmcalc.gears.network.places import places
from tmmcalc.gears.network.plans import Plans, plans
from tmmcalc.gears.network.speeds import Motion, solve_speeds
from tmmcalc.gears.network.willis import willis
from tmmcalc.pipeline.runner import run

CONFIGS = Path(__file__).parents[3] / "configs"
MEETING = Network(  # s0 turns in the housing where the plan has the axis of the planet
    tuple(Mesh(one, 12, other, 12) for one, other in (("c0", "pa0"), ("c1", "pa0"), ("c2", "pa0"), ("c0", "s0"))),
    (Body("pa0", "H"),),
)
WRITTEN = ("circulating", "differential", "ravigneaux")


def by_numpy(network: Network, known: dict[str, float]) -> dict[str, float]:
    """Speeds of all members by least squares of the meshes (relative to what bears the axes) and the known ones."""
    names, rows, right = network.members, [], []

    def at(name: str) -> np.ndarray:
        return np.array([float(each == name) for each in names])

    for mesh, carrier in zip(network.meshes, network.carriers, strict=True):
        first, second = (at(name) - (0 if network.tilted(name) else at(carrier)) for name in (mesh.first, mesh.second))
        rows.append(first * mesh.first_teeth - mesh.sign * second * mesh.second_teeth)
        right.append(0.0)
    for name, speed in known.items():
        rows.append(1e3 * at(name))
        right.append(1e3 * speed)
    found = np.linalg.lstsq(np.array(rows), np.array(right), rcond=None)[0]
    return {FRAME: 0.0, **dict(zip(names, found.tolist(), strict=True))}


def check_plans(network: Network, found: Plans, omega: dict[str, float], scale: float) -> None:
    """Each pitch point has the velocity that either member gives it, where both radii and their distance meet."""
    lines = {line.member: line for line in found.lines}
    axis = {name: complex(line.x, line.y) for name, line in lines.items()}

    def of_axis(name: str) -> complex:
        bearer = network.bearer(name)
        return 0j if bearer == FRAME else of_axis(bearer) + 1j * omega[bearer] * (axis[name] - axis[bearer])

    for point in found.points:
        if point.kind == "axis":
            for name in point.members:
                assert complex(point.x, point.y) == pytest.approx(axis[name], abs=1e-12)
                moved = of_axis(name) if not network.tilted(name) else 1j * omega[network.bearer(name)] * axis[name]
                assert complex(point.along, point.velocity) == pytest.approx(moved, abs=1e-9 * scale)
            continue
        place, v = complex(point.x, point.y), complex(point.along, point.velocity)
        for name in point.members:
            if network.tilted(name):
                moved = 1j * (omega[network.bearer(name)] * place.real + omega[name] * place.imag)
            elif any(network.tilted(other) for other in point.members):
                moved = 1j * omega[name] * place.real
            elif name == FRAME:
                moved = 0j
            else:
                moved = of_axis(name) + 1j * omega[name] * (place - axis[name])
            assert v == pytest.approx(moved, abs=1e-9 * scale), (point, name)
    for line in found.lines:
        drawn = found.length_scale / found.velocity_scale
        assert line.speed == pytest.approx(omega[line.member], abs=1e-9 * scale)
        assert math.tan(line.slope) == pytest.approx(line.speed * drawn, rel=1e-12)
        assert line.ray == pytest.approx(found.pole * math.tan(line.slope), rel=1e-12)
        assert line.ray * 1e3 * found.speed_scale == pytest.approx(line.speed, rel=1e-12)
        if line.centre_x is not None and line.centre_y is not None and not network.tilted(line.member):
            rest = of_axis(line.member)
            rest += 1j * omega[line.member] * (complex(line.centre_x, line.centre_y) - axis[line.member])
            assert abs(rest) <= 1e-9 * scale


@example(MEETING)
@given(trains())
@EXAMPLES
def test_any_train(network: Network) -> None:
    """Random trains of nested sets and ordinary pairs: speeds, equations, plans."""
    known = {"H": 3.0, "c0": -7.0}
    try:
        motion = solve_speeds(network, known)
    except TmmError:
        assume(False)
        raise
    omega = by_numpy(network, known)
    scale = max(map(abs, omega.values()))
    assume(scale < 1e6)
    assert motion.speeds.tolist() == pytest.approx([omega[name] for name in network.members], abs=1e-8 * scale)
    for each in willis(network, motion):
        check_equation(each.first_relative, each.inverted * each.last_relative, scale)
        assert each.first_relative == pytest.approx(omega[each.first] - omega[each.carrier], abs=1e-8 * scale)
        assert float(Fraction(each.exact)) == each.inverted
    hung = {(carrier, name) for k, carrier in enumerate(network.carriers) for name in names(network, k)}
    assert len(willis(network, motion)) == len(hung) - len(parts(network))
    check_plans(network, plans(network, motion), omega, scale)


def test_a_planet_on_the_axis_of_its_carrier() -> None:
    """A ring of as many teeth couples it: a planet beside it is on the line of centres."""
    meshes = (Mesh("c0", 61, "pa0", 61, INTERNAL), Mesh("pa0", 75, "pa1", 89, INTERNAL))
    network = Network(meshes, (Body("pa0", "H"), Body("pa1", "H")))
    motion = solve_speeds(network, {"H": 3.0, "c0": -7.0})
    found = {each.member: each for each in plans(network, motion).lines}
    assert found["pa0"].x == found["c0"].x == 0.0
    assert found["pa1"].x == pytest.approx(7.0 * plans(network, motion).assumed, rel=1e-12)
    check_plans(network, plans(network, motion), by_numpy(network, {"H": 3.0, "c0": -7.0}), 10.0)


def test_axes_that_only_meet_in_the_plan_are_two_points() -> None:
    """The carrier takes that of its planet along, at 3 rad/s on 12 mm; that of the wheel stays."""
    motion = solve_speeds(MEETING, {"H": 3.0, "c0": -7.0})
    found = {point.members: point for point in plans(MEETING, motion).points if point.kind == "axis"}
    assert {members: point.velocity for members, point in found.items()} == pytest.approx(
        {("c0", "c1", "c2", "H"): 0.0, ("pa0",): 0.036, ("s0",): 0.0}, abs=1e-15
    )
    assert found["pa0",].x == found["s0",].x == pytest.approx(0.012, rel=1e-12)


def parts(network: Network) -> list[set[tuple[str, str]]]:
    """What hangs together by meshes on one carrier."""
    found: list[set[tuple[str, str]]] = []
    for k, carrier in enumerate(network.carriers):
        both = {(carrier, name) for name in names(network, k)}
        joined = [part for part in found if part & both]
        found = [part for part in found if not part & both] + [both.union(*joined)]
    return found


def names(network: Network, k: int) -> tuple[str, str]:
    return network.meshes[k].first, network.meshes[k].second


def check_equation(left: float, right: float, scale: float) -> None:
    assert left == pytest.approx(right, abs=1e-9 * scale)


@pytest.mark.parametrize("layout", TRAINS)
def test_every_layout(layout: str) -> None:
    teeth, _ = TRAINS[layout]
    chosen = written_set(layout_task(layout, teeth, 3))
    assert chosen is not None
    found = moving(chosen, 100.0)
    network, told = found.task.network, plans_of(found)
    omega = by_numpy(network, found.task.speeds)
    check_plans(network, told, omega, 100.0)
    assert told.assumed == 1e-3
    assert all(point.y == point.along == 0 for point in told.points)
    for each in equations(found).equations:
        left, right = each.numbers.split(" = ")
        assert worked(right) == pytest.approx(each.inverted, rel=1e-12)
        assert worked(left) == pytest.approx(each.inverted, rel=1e-6)
    for point in told.points:
        if point.radii is not None:
            ratio = point.radii[0] / point.radii[1]
            of_point = [each for each in network.meshes if (each.first, each.second) == point.members]
            mesh = next(each for each in of_point if math.isclose(each.first_teeth / each.second_teeth, ratio))
            one, other = (next(line.x for line in told.lines if line.member == name) for name in point.members)
            apart = point.radii[0] - point.radii[1] if mesh.sign == INTERNAL else sum(point.radii)
            assert abs(one - other) == pytest.approx(abs(apart), rel=1e-12)


def test_known_modules_make_the_radii() -> None:
    """The train that criteria chose: pitch radii are m z/2 of its real modules."""
    spec = tmmcalc.load_spec(CONFIGS / "gears-double-planets.toml")
    results = run(spec, target="criteria").results
    from tmmcalc.gears.chosen.choice import chosen_sets

    (chosen,) = chosen_sets(results["train"], results["criteria"])
    told = plans_of(moving(chosen, 150.0))
    assert told.assumed is None
    (m1, m2), z = chosen.modules, chosen.teeth
    first, last = (point for point in told.points if point.radii is not None)
    assert first.radii == pytest.approx((m1 * z["1"] / 2, m1 * z["2"] / 2), rel=1e-12)
    assert last.radii == pytest.approx((m2 * z["2'"] / 2, m2 * z["3"] / 2), rel=1e-12)
    assert first.velocity == pytest.approx(150 * m1 * z["1"] / 2, rel=1e-12)
    assert last.velocity == pytest.approx(0.0, abs=1e-12)
    planet = next(line for line in told.lines if line.member == "2")
    assert planet.centre_x == pytest.approx(last.x, rel=1e-12)  # the pitch point on the fixed ring


@pytest.mark.parametrize("name", WRITTEN)
def test_written_trains(name: str) -> None:
    result = run(tmmcalc.load_spec(CONFIGS / f"gears-{name}.toml"), target="gearing").results["gearing"]
    found = written(result)
    network = found.task.network
    omega = by_numpy(network, found.task.speeds)
    scale = max(map(abs, omega.values()))
    told = plans_of(found)
    check_plans(network, told, omega, scale)
    assert {line.member for line in told.lines} == {*network.members}
    assert sum(point.kind == "pitch point" for point in told.points) == len(network.meshes)
    for each in equations(found).equations:
        left, right = each.numbers.split(" = ")
        assert worked(left) == pytest.approx(worked(right), rel=1e-6)


def test_planets_of_a_ravigneaux_set_close_their_triangle() -> None:
    """Orbits (30 + 18)/2 and (36 + 19)/2, and (18 + 19)/2 between both planets, in modules."""
    network = (
        run(tmmcalc.load_spec(CONFIGS / "gears-ravigneaux.toml"), target="gearing").results["gearing"].task.network
    )
    at = places(network).axes
    assert abs(at["short"]) == pytest.approx(0.024, rel=1e-12)
    assert abs(at["long"]) == pytest.approx(0.0275, rel=1e-12)
    assert abs(at["long"] - at["short"]) == pytest.approx(0.0185, rel=1e-12)


def test_the_ratio_with_the_last_held_is_that_of_the_textbook() -> None:
    """(4.19): i_1H = 1 - i_13^H = 1 + Z2 Z3/(Z1 Z2') of AI."""
    chosen = written_set(layout_task("AI", (22, 118, 17, 97), 3))
    assert chosen is not None
    last = equations(moving(chosen)).equations[-1]
    assert (last.first, last.last, last.planet) == ("1", "3", False)
    assert last.held == pytest.approx(1 + 118 * 97 / (22 * 17), rel=1e-15)
    assert last.formula == "(omega_1 - omega_H)/(omega_3 - omega_H) = (-Z2/Z1)*(Z3/Z2')"


def test_a_train_that_turns_as_one_has_no_quotient() -> None:
    """All locked: nothing turns against the carrier, and the equation is a product."""
    from tmmcalc.gears.network.builder import network_of

    network = network_of("AIbar", (18, 48, 114)).network
    motion: Motion = solve_speeds(network, {"1": 5.0, "3": 5.0})
    last = willis(network, motion)[-1]
    assert last.formula.startswith("omega_1 - omega_H = ")
    assert last.first_relative == last.last_relative == 0
    told = plans(network, motion)
    assert all(line.slope == told.lines[0].slope for line in told.lines)
