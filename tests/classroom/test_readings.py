"""What is read off wrongly in any subject: factors of units, neighbours, ratios."""

from __future__ import annotations

import math

import pytest
from mistakes import items, key, right, wrong

from tmmcalc.classroom.unitslips import lengths_swapped


@pytest.mark.parametrize(
    ("unit", "factor"),
    [
        ("m", 1e3),
        ("mm", 1e-3),
        ("m/s^2", 1e3),
        ("N*m", 1e3),
        ("kg*m^2", 1e6),
        ("1/mm", 1e3),
        ("N/m", 1e-3),
        ("kg/m^3", 1e-9),
        ("rad", math.nan),
        ("rpm", math.nan),
        ("m/m", math.nan),
        ("MPa", math.nan),
        ("", math.nan),
    ],
)
def test_millimetres_for_metres(unit: str, factor: float) -> None:
    assert lengths_swapped(unit) == pytest.approx(factor, nan_ok=True)


@pytest.mark.parametrize(
    ("mistake", "asked", "factor"),
    [
        ("sense_reversed", "kinematics.vS_D@5 m/s", -1),
        ("other_length_unit", "kinematics.vS_D@5 mm/s", 1e-3),
        ("other_length_unit", "kinematics.stroke_D m", 1e3),
        ("degrees_for_radians", "kinematics.angle_3@5 deg", math.pi / 180),
        ("degrees_for_radians", "kinematics.angle_3@5 rad", 180 / math.pi),
        ("degrees_for_radians", "kinematics.omega_3@5 rad/s", 180 / math.pi),
        ("rpm_for_radians", "kinematics.omega_3@5 rad/s", 30 / math.pi),
        ("rpm_for_radians", "kinematics.omega_3@5 rpm", math.pi / 30),
        ("per_degree", "kinematics.dS_D@5 m/rad", math.pi / 180),
        ("per_degree", "kinematics.ddangle_3@5 rad/rad^2", (math.pi / 180) ** 2),
        ("kilograms_for_newtons", "forces.R_A@5 N", 1 / 9.81),
        ("other_prefix", "forces.R_A@5 kN", 1e3),
        ("other_prefix", "power.P_mean W", 1e-3),
        ("pi_left_out", "forces.R_A@5 N", 1 / math.pi),
        ("turn_for_radian", "forces.R_A@5 N", 0.5 / math.pi),
        ("percent", "power.eta ", 100),
    ],
)
def test_a_factor(mistake: str, asked: str, factor: float) -> None:
    assert wrong("shaper", f"classroom.{mistake}", asked) == pytest.approx(
        [factor * right("shaper", asked)[0]], rel=1e-12
    )


def test_neighbours() -> None:
    asked = items("kinematics.vS_D@5 m/s", "kinematics.vS_D@0 m/s", "kinematics.stroke_D m")
    before, after, own = (right("shaper", f"kinematics.vS_D@{n} m/s")[0] for n in (4, 6, 1))
    nan = math.nan
    found = key("shaper", asked, "classroom.position_before", "classroom.position_after").mistaken
    assert found[0] == pytest.approx((before, nan, nan), nan_ok=True)
    assert found[1] == pytest.approx((after, own, nan), nan_ok=True)


def test_ratios_and_radii() -> None:
    (ratio,) = right("shaper", "kinematics.K_D ")
    assert wrong("shaper", "classroom.inverted", "kinematics.K_D ") == pytest.approx([1 / ratio])
    found = key("cam", items("cam_synthesis.R0 mm", "cam_law.stroke mm"), "classroom.diameter_for_radius")
    assert found.mistaken[0] == pytest.approx((2 * found.values[0], math.nan), nan_ok=True)
    found = key("course-project", items("flywheel.rim_mean_diameter mm"), "classroom.radius_for_diameter")
    assert found.mistaken[0] == pytest.approx((160.0,))


def test_an_angle_and_its_complement() -> None:
    name = "transmission_min_RRP(4,5)"
    asked = items(f"kinematics.{name} deg", f"kinematics.{name}_at_angle_1 deg", "kinematics.pressure_max_RRP(4,5) rad")
    found = key("shaper", asked, "classroom.complement_of_angle")
    own, _, pressure = found.values
    assert found.mistaken[0] == pytest.approx((90 - own, math.nan, math.pi / 2 - pressure), nan_ok=True)
    assert math.degrees(pressure) == pytest.approx(90 - own)
