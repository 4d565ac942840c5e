"""Formulas of slip, shaft, stem, pin and contact against the worked cases and independent forms."""

import json
from math import pi, radians
from pathlib import Path

import numpy as np
import pytest

from tmmcalc.cams.follower import Follower, contact_path, curvature
from tmmcalc.cams.forces.formulas import contact_force, driving_torque, guided_forces, inclination, resultant
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.strength.formulas import (
    BAD,
    concave_margin,
    contact_stress,
    convex_margin,
    cylinder,
    flat_radius,
    flat_stress,
    guide_pressure,
    pin_pressure,
    pin_radius,
    reduced_moment,
    resisting,
    rolling,
    shaft_by_stiffness,
    shaft_by_strength,
    shafted,
    slip,
    stem_moment,
    stem_stress,
    unused,
    whole,
)

CASES = {case["id"]: case for case in json.loads((Path(__file__).parents[1] / "cases/cams.json").read_text())}


def rise(law: str, k: np.ndarray, stroke: float, angle: float) -> np.ndarray:
    return stroke * LAWS[law].at(np.asarray(k, float)) / angle ** np.arange(4)[:, None]


@pytest.mark.parametrize("case", ["cams-s08", "cams-s09"])
def test_rocker_of_the_worked_cases(case):
    """M, R, theta and sigma_H of program 2.7."""
    given, expected = CASES[case]["inputs"], CASES[case]["expected"]
    table = expected["table"]
    follower = Follower(
        "oscillating", radians(30), roller=0.01, centres=0.1, rocker=0.1, assembly=given["assembly"]
    )  # fmt: skip
    motion = rise(given["law"], np.arange(11) / 10, radians(30), radians(60))
    load = resultant(motion, 1e-4 * 100**2, expected["c_psi_Nm_per_rad"], expected["M0_Nm"])
    sine, cosine = inclination(follower, motion)
    contact, _ = contact_force(load, cosine, 0.0, np.ones(11), 0.1)
    bend, _ = rolling(follower, motion)
    stress, works = contact_stress(contact, bend, 0.01, 0.007, 2e11)
    close = {"rel": 1e-5, "abs": 1e-6}
    assert load == pytest.approx(table["M_sum_Nm"], **close)
    assert np.degrees(np.arctan2(sine, cosine)) == pytest.approx(table["theta_deg"], **close)
    assert contact == pytest.approx(table["R_N"], **close)
    assert 1e3 / bend == pytest.approx(table["rho_mm"], **close)
    assert stress / 1e6 == pytest.approx(table["sigma_H_MPa"], **close)
    assert works.all()


def test_slip_stem_shaft_and_stress_of_the_worked_case():
    expected = CASES["cams-s14"]["expected"]
    motion = rise("cosine", np.linspace(0, 1, 4001), 0.02, radians(60))
    load = resultant(motion, 2000.0, 9500.0, 10.0)
    follower = Follower("translating", 0.06, roller=0.008)
    found = guided_forces(
        follower, motion, load, np.ones(4001), stroke=0.02, friction=0.1, start=0.06, roller=0.008, top=0.12
    )
    bend, run = rolling(follower, motion)
    pin = pin_radius(np.max(found.contact), 5e6, 1.4)
    c1 = resisting(0.05e-3, 0.1, pin, 0.1, 0.008)
    inertia = cylinder(0.007, 7820.0, 0.008, pin)
    grown, _ = slip(found.contact, run, c1, inertia, 100.0, 0.1, 0.008)
    stress, _ = contact_stress(found.contact, bend, 0.008, 0.007, 2e11)
    moment = reduced_moment(found.contact, driving_torque(load, motion), 0.1, 0.75)
    near = {"rel": 1e-4}
    assert run[[0, 400, 1000, 2000, 3000, 4000]] * 1e3 == pytest.approx(expected["A_mm"], abs=1e-6, **near)
    assert 1e3 * pin == pytest.approx(expected["r0_pin_mm"], **near)
    assert c1 == pytest.approx(expected["C1"], **near)
    assert inertia * 100**2 / (0.1 * 0.008**2) / 1e3 == pytest.approx(expected["C2_N_per_mm"], **near)
    assert np.max(np.abs(grown)) == pytest.approx(expected["D_max"], **near)
    assert np.max(stress) / 1e6 == pytest.approx(expected["sigma_H_max_MPa"], **near)
    bent = stem_moment(follower, motion, found.contact, found.sine, found.protrusion)
    assert np.max(bent) * 1e3 == pytest.approx(expected["M_T_max_Nmm"], **near)
    assert np.max(moment) * 1e3 == pytest.approx(expected["M_E_max_Nmm"], **near)
    assert 1e3 * shaft_by_strength(np.max(moment), 1e8) == pytest.approx(expected["r1_strength_mm"], **near)
    stiff = shaft_by_stiffness(np.max(found.contact), 0.1, 2e11, 1e-5)
    assert 1e3 * stiff == pytest.approx(expected["r1_stiffness_mm"], **near)
    assert whole(stiff) == pytest.approx(0.008)


@pytest.mark.parametrize("law", ["sine", "const", "poly5"])
@pytest.mark.parametrize("kind", ["translating", "oscillating+", "oscillating-"])
def test_curvature_and_speed_are_those_of_the_pitch_curve(law, kind):
    """Against the complex path, and A against the derivative of its speed by differences."""
    sign = -1 if kind.endswith("-") else 1
    follower = (
        Follower("translating", 0.04, -0.007)
        if kind == "translating"
        else Follower("oscillating", 0.6, centres=0.11, rocker=0.08, assembly=sign)
    )
    stroke, angle, k = (0.02 if kind == "translating" else 0.4), 1.1, np.array([0.1, 0.3, 0.45, 0.7, 0.93])
    motion = rise(law, k, stroke, angle)
    bend, run = rolling(follower, motion)
    assert bend == pytest.approx(curvature(contact_path(follower, k * angle, motion)), rel=1e-12)
    step = 1e-5
    speeds = [np.abs(contact_path(follower, k * angle, rise(law, k + d, stroke, angle))[1]) for d in (step, -step)]
    assert run == pytest.approx((speeds[0] - speeds[1]) / (2 * step * angle), abs=1e-9)


def test_rolling_takes_sizes_that_broadcast():
    motion = rise("shun", np.linspace(0, 1, 9), 0.02, 1.0)
    starts = np.array([0.03, 0.05])[:, None]
    grid = rolling(Follower("translating", 0.04, 0.005), motion, starts)
    for i, start in enumerate(starts[:, 0]):
        one = rolling(Follower("translating", float(start), 0.005), motion)
        assert np.array_equal(grid[0][i], one[0])
        assert np.array_equal(grid[1][i], one[1])


def test_contact_stress_is_that_of_two_cylinders():
    """0.418 against the exact Hertz constant for Poisson's ratio 0.3, on both walls, convex and concave."""
    exact = np.sqrt(1 / (2 * pi * (1 - 0.3**2)))
    r2, width, modulus = 0.008, 0.007, 2e11
    for force, kappa in ((100.0, 20.0), (100.0, -30.0), (-80.0, 20.0), (-80.0, -30.0)):
        wall = 1 / kappa - r2 if force > 0 else -(1 / kappa + r2)
        reduced = 1 / wall + 1 / r2
        value, works = contact_stress(np.array([force]), np.array([kappa]), r2, width, modulus)
        assert works.all()
        assert value[0] == pytest.approx(exact * np.sqrt(modulus * abs(force) * reduced / width), rel=6e-4)


def test_stress_goes_smoothly_through_the_inflection_and_stops_at_the_cusp():
    kappa = np.array([-1e-9, 0.0, 1e-9])
    values, _ = contact_stress(np.full(3, 50.0), kappa, 0.01, 0.01, 2e11)
    assert values == pytest.approx(np.full(3, values[1]), rel=1e-9)
    values, works = contact_stress(
        np.array([50.0, 50.0, -50.0, -50.0]), np.array([100, 120, 120, -100]), 0.01, 0.01, 2e11
    )
    assert works.tolist() == [False, False, True, False]
    assert np.isfinite(values).all()
    assert unused(values, 4e8, works)[[0, 1, 3]].tolist() == [BAD] * 3
    values, works = flat_stress(np.array([50.0, 50.0]), np.array([0.02, -0.01]), 0.01, 2e11)
    assert works.tolist() == [True, False]
    assert np.isfinite(values).all()


def test_margins_are_zero_at_their_limits_and_fall_beyond():
    assert convex_margin(1 / 0.012, 0.0095, 0.0025) == pytest.approx(0, abs=1e-15)
    assert convex_margin(1 / 0.012, 0.0096, 0.0025) < 0 < convex_margin(1 / 0.012, 0.0094, 0.0025)
    assert convex_margin(-5.0, 0.0095, 0.0025) > 1  # no convex part at all
    assert concave_margin(-1 / 0.067, 0.008, 0.075) == pytest.approx(0, abs=1e-14)
    assert concave_margin(-1 / 0.060, 0.008, 0.075) < 0 < concave_margin(-1 / 0.070, 0.008, 0.075)
    assert concave_margin(3.0, 0.008, 0.075) == 1
    assert shafted(0.02, 0.012, 0.008) == pytest.approx(0, abs=1e-15)
    assert unused(np.array([90.0]), 100.0)[0] == pytest.approx(0.1)


def test_slip_without_force_is_masked():
    grown, works = slip(np.array([0.0, -50.0]), np.array([0.02, 0.02]), 0.4, 1e-6, 100.0, 0.1, 0.008)
    assert works.tolist() == [False, True]
    assert np.isfinite(grown).all()
    opposite, _ = slip(np.array([50.0]), np.array([0.02]), 0.4, 1e-6, 100.0, 0.1, 0.008)
    assert grown[1] == opposite[0]  # the size of the force counts, on either wall


def test_plain_sections():
    """Stem, land and pin by their sections."""
    assert stem_stress(1.0, 0.004) == pytest.approx(1.0 * 0.004 / (pi * 0.004**4 / 4))
    assert guide_pressure(-140.0, 0.005, 0.0028) == pytest.approx(5e6)
    pin = pin_radius(200.0, 5e6, 1.4)
    assert pin_pressure(200.0, pin, 1.4) == pytest.approx(5e6)
    assert cylinder(0.007, 7820.0, 0.01, 0.004) == pytest.approx(
        0.5 * 7820 * 0.007 * pi * (0.01**2 - 0.004**2) * (0.01**2 + 0.004**2)
    )


def test_flat_radius_is_the_curvature_of_the_profile():
    follower = Follower("flat", 0.05)
    motion = rise("shun", np.linspace(0.1, 0.9, 5), 0.01, 1.2)
    bend = curvature(contact_path(follower, np.zeros(5), motion))
    assert flat_radius(motion, 0.05) == pytest.approx(1 / bend, rel=1e-12)
