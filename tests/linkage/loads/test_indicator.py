"""Indicator diagrams: two and four strokes, either way round, fixed and oscillating cylinders; work is that of p dV."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from linkage.forces.test_cases import cylinder
from linkage.loads.acting import scene_of, value, work
from linkage.scenes import crank_slider, full_turn, part, with_input
from tmmcalc import NoSolutionError
from tmmcalc.linkage.loading import Load
from tmmcalc.linkage.loadlaws.indicator import Indicator
from tmmcalc.linkage.loads.scene import Scene
from tmmcalc.linkage.model import Mechanism

TURN = 2 * np.pi
AREA, BACK = 0.01, 1e5
# pressures of strokes from the outer dead centre on: out (suction or power), in, out, in; abscissae either way
SUCTION = ((0.0, 0.1, 1.0), (1e5, 0.9e5, 0.9e5))
COMPRESSION = ((1.0, 0.4, 0.1, 0.0), (0.9e5, 3e5, 12e5, 20e5))
POWER = ((0.0, 0.05, 0.3, 0.8, 1.0), (20e5, 50e5, 15e5, 5e5, 3e5))
EXHAUST = ((1.0, 0.9, 0.0), (3e5, 1.1e5, 1.1e5))
TWO = (POWER, COMPRESSION)
FOUR = (SUCTION, COMPRESSION, POWER, EXHAUST)
Table = tuple[tuple[float, ...], tuple[float, ...]]


def engine(start: float = 0.0, speed: float = 100.0, e: float = 0.0) -> Mechanism:
    return with_input(full_turn(crank_slider(0.05, 0.16, e), start), speed=speed)


def gas(strokes: tuple[Table, ...], delay: float = 0.0) -> Load:
    """The closed end is on the far side of the piston: a positive pressure pushes it towards the crank."""
    return Load("gas", 3, "force", Indicator(strokes, AREA, BACK, delay), direction=-1 + 0j)


def mean(table: Table) -> float:
    """Integral of the broken line over its abscissae, in their own sense."""
    points = list(zip(*table, strict=True))
    return sum((b[0] - a[0]) * (a[1] + b[1] - 2 * BACK) / 2 for a, b in pairwise(points))


def expected_work(strokes: tuple[Table, ...], stroke: float) -> float:
    return AREA * stroke * sum(mean(table) for table in strokes)


def stroke_of(e: float) -> float:
    return float(np.sqrt(0.21**2 - e**2) - np.sqrt(0.11**2 - e**2))


@pytest.mark.parametrize("strokes", [TWO, FOUR], ids=["two", "four"])
@pytest.mark.parametrize("speed", [100.0, -100.0])
@pytest.mark.parametrize("start", [0.0, 1.0, 4.0])
@pytest.mark.parametrize("e", [0.0, 0.02])
def test_work_is_the_integral_of_pressure_over_volume(
    strokes: tuple[Table, ...], speed: float, start: float, e: float
) -> None:
    scene = scene_of(engine(start, speed, e), gas(strokes))
    exact = expected_work(strokes, stroke_of(e))
    assert work(scene) == pytest.approx(exact, rel=1e-12)
    assert exact > 0
    assert scene.travel.period == pytest.approx(TURN * len(strokes) / 2)


def piston(scene: Scene, theta: np.ndarray) -> np.ndarray:
    """Distance from the outer dead centre as a part of the stroke."""
    x = scene.place(theta).configuration.motions[3].r.real
    return np.clip((0.21 - x) / 0.1, 0, 1)


def test_strokes_follow_each_other() -> None:
    """From position 0 at the outer dead centre: four strokes of half a turn."""
    scene = scene_of(engine(), gas(FOUR))
    for k, (x, p) in enumerate(FOUR):
        theta = np.pi * (k + np.linspace(0.01, 0.99, 50))
        order = np.argsort(x)
        pressure = np.interp(piston(scene, theta), np.array(x)[order], np.array(p)[order])
        np.testing.assert_allclose(value(scene, theta), AREA * (pressure - BACK), rtol=1e-11)


def test_at_dead_centres_the_value_before_counts() -> None:
    """Position 0 takes the beginning of the first stroke, the last position the end of the last."""
    scene = scene_of(engine(), gas(FOUR))
    found = value(scene, np.arange(5) * np.pi)
    before = [FOUR[0][1][0], *(p[-1] for _, p in FOUR)]
    np.testing.assert_allclose(found, AREA * (np.array(before) - BACK), rtol=1e-9)


@pytest.mark.parametrize(
    ("start", "delay", "first"), [(0.0, 0.0, 0.0), (0.0, 1.0, TURN), (1.0, 0.0, TURN - 1.0), (1.0, 6.0, 2 * TURN - 1.0)]
)
def test_the_first_stroke_begins_after_the_delay(start: float, delay: float, first: float) -> None:
    scene = scene_of(engine(start), gas(FOUR, delay))
    theta = np.mod(first + np.linspace(0.02, 3.1, 40), 2 * TURN)
    pressure = np.interp(piston(scene, theta), *map(np.array, SUCTION))
    np.testing.assert_allclose(value(scene, theta), AREA * (pressure - BACK), rtol=1e-10, atol=1e-6)


def test_edges_are_dead_centres_and_corners() -> None:
    scene = scene_of(engine(0.3), gas(FOUR))
    phi = 0.3 + np.array(scene.edges())
    parts = (0.21 - 0.05 * np.cos(phi) - np.sqrt(0.16**2 - (0.05 * np.sin(phi)) ** 2)) / 0.1
    known = sorted({a for table in FOUR for a in table[0]})
    for part_of_stroke in parts:
        assert np.min(np.abs(np.array(known) - part_of_stroke)) < 1e-9
    inner = [a for a in known if 0 < a < 1]
    assert len(scene.edges()) == 4 * len(inner) + 4  # each corner twice a turn, two turns; four dead centres


def test_two_cylinders_fire_after_each_other() -> None:
    """The second cylinder is delayed by a turn: the same work, the force moved by a turn."""
    mechanism = engine(0.4)
    one, two = (scene_of(mechanism, gas(FOUR, delay)) for delay in (0.0, TURN))
    theta = np.linspace(0.01, TURN - 0.01, 300)
    np.testing.assert_allclose(value(two, theta + TURN), value(one, theta), rtol=1e-9, atol=1e-6)
    both = scene_of(mechanism, gas(FOUR), replace(gas(FOUR, TURN), name="other"))
    assert work(both) == pytest.approx(2 * expected_work(FOUR, 0.1), rel=1e-12)


@pytest.mark.parametrize("speed", [6.0, -6.0])
def test_an_oscillating_cylinder(speed: float) -> None:
    """The direction turns with the cylinder, which takes the opposite force: work is p dV all the same."""
    mechanism = with_input(cylinder(), speed=speed)
    # axes of rod and cylinder lie along A -> E; the closed end is at E
    load = Load("gas", 2, "force", Indicator(TWO, AREA, BACK), 0j, -1 + 0j, follows=3, against=3)
    scene = scene_of(mechanism, load)
    length = abs(0.5 + 0.1j)
    assert length > 0.08
    assert work(scene) == pytest.approx(expected_work(TWO, 2 * 0.08), rel=1e-12)
    assert scene.edges()


class TestRefusals:
    def test_an_open_range(self) -> None:
        with pytest.raises(NoSolutionError, match="needs a crank that turns fully") as raised:
            scene_of(part(crank_slider(0.05, 0.16), 0.0, 3.0), gas(TWO))
        assert raised.value.where == "load gas"

    def test_a_direction_across_the_cylinder(self) -> None:
        with pytest.raises(NoSolutionError, match="reverses 0 times a turn") as raised:
            scene_of(engine(), replace(gas(TWO), direction=1j))
        assert "along the cylinder" in raised.value.remedy
