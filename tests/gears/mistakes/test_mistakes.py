"""Mistakes in gears, worked out again from teeth, module and shifts by the formulas of the involute."""

from __future__ import annotations

import math

import pytest
from mistakes import items, key, right, wrong

ALPHA = math.radians(20)


def inv(angle: float) -> float:
    return math.tan(angle) - angle


def tip(z: int, m: float, x: float, other: float, total: int) -> float:
    """Tip diameter of wheel 1 [mm]: r_a = a_w - r_f2 - c m, with a_w from inv(alpha_w)."""
    target = inv(ALPHA) + 2 * (x + other) * math.tan(ALPHA) / total
    low, high = 0.0, 1.2
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if inv(middle) < target else (low, middle)
    distance = m * total / 2 * math.cos(ALPHA) / math.cos(low)
    root = m * ((total - z) / 2 - 1.25 + other)
    return 2 * (distance - root - 0.25 * m)


PAIR = "pair-spur"
X = tuple(right(PAIR, "pair.x_1 ", "pair.x_2 "))


def test_shifts() -> None:
    asked = "pair.1.wheels.0.d_a mm", "pair.1.wheels.1.d_a mm"
    assert right(PAIR, *asked) == pytest.approx([tip(14, 5, *X, 41), tip(27, 5, *X[::-1], 41)], rel=1e-9)
    assert wrong(PAIR, "gears.shifts_swapped", *asked) == pytest.approx(
        [tip(14, 5, *X[::-1], 41), tip(27, 5, *X, 41)], rel=1e-9
    )
    assert wrong(PAIR, "gears.shifts_left_out", *asked, "pair.a_w mm") == pytest.approx([80, 145, 102.5])


def test_module_doubled() -> None:
    asked = "pair.1.wheels.0.r mm", "pair.1.wheels.0.r_b mm", "pair.1.p_t mm"
    assert wrong(PAIR, "gears.module_doubled", *asked) == pytest.approx([70, 70 * math.cos(ALPHA), 10 * math.pi])


def test_circles() -> None:
    names = ("r", "r_b", "r_w")
    asked = [f"pair.1.wheels.0.{name} mm" for name in names]
    r, base, operating = right(PAIR, *asked)
    assert (r, base) == pytest.approx((35, 35 * math.cos(ALPHA)))
    nan = math.nan
    for mistake, found in (
        ("reference_for_base", (nan, r, nan)),
        ("base_for_reference", (base, nan, nan)),
        ("reference_for_operating", (nan, nan, r)),
        ("operating_for_reference", (operating, nan, nan)),
    ):
        got = key(PAIR, items(*asked), f"gears.{mistake}").mistaken[0]
        assert got == pytest.approx(found, nan_ok=True)


def test_the_other_wheel_and_the_pitch() -> None:
    asked = "pair.1.wheels.0.r mm", "pair.x_1 ", "pair.1.p_t mm"
    assert wrong(PAIR, "gears.wheels_swapped", *asked)[:2] == pytest.approx([67.5, X[1]])
    assert wrong(PAIR, "gears.pi_of_pitch", *asked)[2] == pytest.approx(5)


def test_involute_function_in_degrees() -> None:
    asked = "pair.1.inv_alpha_t ", "pair.1.wheels.0.s_ta mm"
    assert wrong(PAIR, "gears.involute_in_degrees", asked[0]) == pytest.approx([math.tan(ALPHA) - 20])
    tooth = 5 * (math.pi / 2 + 2 * X[0] * math.tan(ALPHA))
    diameter = tip(14, 5, *X, 41)
    at_tip = math.acos(70 * math.cos(ALPHA) / diameter)
    by_degrees = (math.tan(ALPHA) - 20) - (math.tan(at_tip) - math.degrees(at_tip))
    assert right(PAIR, asked[1]) == pytest.approx([diameter * (tooth / 70 + inv(ALPHA) - inv(at_tip))], rel=1e-9)
    assert wrong(PAIR, "gears.involute_in_degrees", asked[1]) == pytest.approx([diameter * (tooth / 70 + by_degrees)])


def test_helix_left_out() -> None:
    helical = ('pair.helix_angle="15 deg"',)
    assert right(PAIR, "pair.1.m_t mm", sets=helical) == pytest.approx([5 / math.cos(math.radians(15))])
    assert wrong(PAIR, "gears.helix_left_out", "pair.1.m_t mm", sets=helical) == pytest.approx([5])


def test_planetary_ratio_without_the_one() -> None:
    """Of AIbar i_1H = 1 + z_3/z_1: without the 1 the chosen train has z_3/z_1, and teeth are sought for the ratio."""
    train = "gears-single-planets"
    suns = "criteria.chosen(z_1) ", "criteria.chosen(z_3) "
    sun, ring = right(train, *suns)
    assert right(train, "criteria.ratio ") == pytest.approx([1 + ring / sun])
    assert wrong(train, "gears.chosen_ratio_without_one", "criteria.ratio ") == pytest.approx([ring / sun])
    sun, ring = wrong(train, "gears.ratio_without_one", *suns)
    assert ring / sun == pytest.approx(7.29, abs=0.1)
    assert wrong(train, "gears.chosen_ratio_inverted", "criteria.ratio ") == pytest.approx([1 / 7.2])


@pytest.mark.parametrize(("layout", "ratio", "sign"), [("AI", 31.29, -1), ("AA", -20, 1), ("II", -3, 1)])
def test_the_ratio_with_the_carrier_at_rest(layout: str, ratio: float, sign: int) -> None:
    """By Willis i_13^H = sign z_2 z_3/(z_1 z_2'), a minus for each external mesh; without the 1 there is no sign."""
    train, sets = "gears-double-planets", (f'train.layout="{layout}"', f"train.ratio={ratio}")
    first, second, third, fourth = right(train, *(f"criteria.chosen(z_{k}) " for k in ("1", "2", "2'", "3")), sets=sets)
    teeth = second * fourth / (first * third)
    assert right(train, "criteria.ratio ", sets=sets) == pytest.approx([1 - sign * teeth])
    assert wrong(train, "gears.carrier_at_rest", "criteria.ratio ", sets=sets) == pytest.approx([sign * teeth])
    assert wrong(train, "gears.chosen_ratio_without_one", "criteria.ratio ", sets=sets) == pytest.approx([teeth])


def test_a_train_without_a_carrier_has_none_at_rest() -> None:
    asked, sets = items("criteria.ratio "), ('train.layout="coaxial"', "train.ratio=10")
    assert math.isnan(key("gears-double-planets", asked, "gears.carrier_at_rest", sets=sets).mistaken[0][0])


SINGLE = """
[gearing]
speeds = { s = "1000 rpm", r = "0 rpm" }
output = "H"
[[gearing.members]]
name = "p"
carrier = "H"
[[gearing.meshes]]
first = "s"
first_teeth = 18
second = "p"
second_teeth = 48
[[gearing.meshes]]
first = "p"
first_teeth = 48
second = "r"
second_teeth = 114
internal = true
"""


def test_the_carrier_of_a_network_at_rest() -> None:
    """Sun 18, ring 114 held: i_sH = 1 + 114/18, and -114/18 with the carrier at rest; its inverse has none."""
    asked = items("gearing.i_s_H ", "gearing.i_H_s ")
    assert key(SINGLE, asked).values == pytest.approx([1 + 114 / 18, 18 / (18 + 114)])
    found = key(SINGLE, asked, "gears.carrier_at_rest").mistaken[0]
    assert found == pytest.approx([-114 / 18, math.nan], nan_ok=True)


def test_speed_against_the_carrier() -> None:
    train = "gears-circulating"
    planet, carrier, against = right(
        train, "gearing.omega@sun rad/s", "gearing.omega@H rad/s", "gearing.omega_rel@planet rad/s"
    )
    own = right(train, "gearing.omega@planet rad/s")[0]
    assert against == pytest.approx(own - carrier)
    assert wrong(train, "gears.relative_speed", "gearing.omega@planet rad/s") == pytest.approx([own - carrier])
    assert planet != own


@pytest.mark.slow
def test_shifts_of_the_meshes_of_a_train() -> None:
    """The first mesh of the course project runs at its reference distance where shifts are left out."""
    asked = "pair.1-2.a mm", "pair.1-2.a_w mm", "pair.1-2.wheels.0.x ", "pair.1-2.wheels.1.x "
    a, operating, first, second = right("course-project", *asked)
    assert first != second
    assert wrong("course-project", "gears.shifts_swapped", *asked[2:]) == pytest.approx([second, first])
    assert wrong("course-project", "gears.shifts_left_out", *asked) == pytest.approx([a, a, 0, 0])
    assert operating >= a
