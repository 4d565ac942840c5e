"""Throws of ready arrangements, and firing intervals."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tmmcalc import NoSolutionError, UsageError
from tmmcalc.machine.balance.arrangements import FIRING, Gear, in_line, vee
from tmmcalc.machine.balance.cylinders import piston
from tmmcalc.machine.balance.firing import firing

GEAR = Gear(0.04, 0.14, 0.5, 0.6)


def throws(cylinders: tuple) -> list[int]:
    return [round(math.degrees(c.crank_angle - math.pi / 2)) % 360 for c in cylinders]


@pytest.mark.parametrize(
    ("count", "angles"),
    [
        (1, [0]),
        (2, [0, 0]),
        (3, [0, 240, 120]),
        (4, [0, 180, 180, 0]),
        (5, [0, 216, 144, 72, 288]),
        (6, [0, 240, 120, 120, 240, 0]),
        (8, [0, 180, 270, 90, 90, 270, 180, 0]),
    ],
)
def test_customary_in_line_cranks(count: int, angles: list[int]) -> None:
    cylinders = in_line(count, 0.1, GEAR)
    assert throws(cylinders) == angles
    found = firing(cylinders, FIRING[count])
    assert found.even
    np.testing.assert_allclose(found.intervals, 4 * math.pi / count, rtol=1e-12)
    assert [c.position_along_shaft for c in cylinders] == pytest.approx([0.1 * i for i in range(count)])


@pytest.mark.parametrize("count", [1, 2, 3, 4, 5, 6, 8])
@pytest.mark.parametrize("strokes", [2, 4])
def test_cylinders_reach_top_dead_centre_in_their_order(count: int, strokes: int) -> None:
    cylinders = in_line(count, 0.1, GEAR, strokes=strokes)
    for turn, number in enumerate(FIRING[count]):
        c = cylinders[number - 1]
        phi = np.array([turn * strokes * math.pi / count])
        s, _, _ = piston(phi + c.crank_angle - c.axis_angle, c.crank_radius, c.rod_length)
        assert s[0] == pytest.approx(0.18, rel=1e-14)


def test_other_orders_and_throws() -> None:
    assert throws(in_line(4, 0.1, GEAR, firing_order=[1, 2, 4, 3])) == [0, 180, 180, 0]
    assert throws(in_line(2, 0.1, GEAR, strokes=2)) == [0, 180]
    apart = in_line(2, 0.1, GEAR, throws=[0.0, math.pi])
    np.testing.assert_allclose(np.degrees(firing(apart, [1, 2]).intervals), [180, 540])
    assert not firing(apart, [1, 2]).even
    assert firing(apart, [1, 2], strokes=2).even


def test_banks_and_pins_of_a_v() -> None:
    left, right = vee(2, math.radians(45), 0.1, GEAR, stagger=0.02)
    assert math.degrees(left.axis_angle - right.axis_angle) == pytest.approx(45)
    assert math.degrees(left.axis_angle + right.axis_angle) == pytest.approx(180)
    assert right.position_along_shaft - left.position_along_shaft == pytest.approx(0.02)
    assert left.crank_angle == right.crank_angle
    np.testing.assert_allclose(np.degrees(firing([left, right], [1, 2]).intervals), [315, 405])
    np.testing.assert_allclose(np.degrees(firing([left, right], [1, 2], sense=-1).intervals), [45, 675])
    split = vee(6, math.radians(60), 0.1, GEAR, split=math.radians(60))
    offsets = [math.degrees(b.crank_angle - a.crank_angle) for a, b in zip(split[::2], split[1::2], strict=True)]
    np.testing.assert_allclose(offsets, 60)


@pytest.mark.parametrize("cylinders", [vee(8, math.pi / 2, 0.1, GEAR), vee(12, math.pi / 3, 0.1, GEAR)])
def test_v_engines_fire_evenly_in_some_order(cylinders: tuple) -> None:
    """Dead centres are spread evenly over two turns; the order is found by going through them."""
    dead = np.array([math.degrees(c.axis_angle - c.crank_angle) % 360 for c in cylinders])
    order: list[int] = []
    for t in np.arange(len(cylinders)) * 720 / len(cylinders) + dead[1]:
        near = np.flatnonzero(np.abs((dead - t + 180) % 360 - 180) < 1e-6) + 1
        order.append(next(int(i) for i in near if i not in order))
    assert firing(cylinders, order).even
    assert sorted(order) == list(range(1, len(cylinders) + 1))


def test_faulty_arrangements_are_refused() -> None:
    with pytest.raises(UsageError, match="unknown of 7"):
        in_line(7, 0.1, GEAR)
    with pytest.raises(UsageError, match="firing order 1-2-3-3"):
        in_line(4, 0.1, GEAR, firing_order=[1, 2, 3, 3])
    with pytest.raises(UsageError, match="throws for 3"):
        in_line(4, 0.1, GEAR, throws=[0, 1, 2])
    with pytest.raises(UsageError, match="no customary V of 14"):
        vee(14, 1.0, 0.1, GEAR)
    with pytest.raises(UsageError, match="throws for 4"):
        vee(6, 1.0, 0.1, GEAR, throws=[0, 1])
    four = in_line(4, 0.1, GEAR)
    with pytest.raises(NoSolutionError, match="more than one cycle of 720 deg") as refused:
        firing(four, [1, 2, 3, 4])
    assert refused.value.value == pytest.approx(720)
    with pytest.raises(UsageError, match="does not name all"):
        firing(four, [1, 2, 3])
    with pytest.raises(UsageError, match="3 strokes"):
        firing(four, [1, 3, 4, 2], strokes=3)
