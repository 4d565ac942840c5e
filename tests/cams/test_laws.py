"""The laws of the catalogue: the worked cases, closed forms, differences, symmetry, and independent integration."""

import json
from math import pi, sqrt
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import quad

from cams.turns import turn
from tmmcalc.cams.laws.catalogue import LAWS, law_of, title_of
from tmmcalc.cams.laws.constants import constants
from tmmcalc.cams.laws.own import of_coefficients
from tmmcalc.core.errors import UsageError

CASES = {c["id"]: c for c in json.loads((Path(__file__).parents[1] / "cases/cams.json").read_text())}
K = np.linspace(0.0, 1.0, 101)

# s of the textbook's table 5.1 as it is printed there, for the halves k <= 1/2 and k > 1/2
PRINTED = {
    "sine": lambda k: k - np.sin(2 * pi * k) / (2 * pi),
    "cosine": lambda k: (1 - np.cos(pi * k)) / 2,
    "linear": lambda k: k**2 * (3 - 2 * k),
    "parab2": lambda k: np.where(k <= 0.5, 8 * k**3 * (1 - k), 1 - 8 * (1 - k) ** 3 * k),
    "const": lambda k: np.where(k <= 0.5, 2 * k**2, 1 - 2 * (1 - k) ** 2),
    "shun": lambda k: k**3 * (10 - 15 * k + 6 * k**2),
    "poly5": lambda k: k**3 * (18 - 55 * k + 78 * k**2 - 56 * k**3 + 16 * k**4),
    "poly4567": lambda k: 35 * k**4 - 84 * k**5 + 70 * k**6 - 20 * k**7,
}
JERKS = {
    "sine": lambda k: 4 * pi**2 * np.cos(2 * pi * k),
    "cosine": lambda k: -(pi**3) / 2 * np.sin(pi * k),
    "linear": lambda k: np.full_like(k, -12),
    "shun": lambda k: 60 * (1 - 6 * k + 6 * k**2),
    "poly5": lambda k: 4 * (27 - 330 * k + 1170 * k**2 - 1680 * k**3 + 840 * k**4),
}


def test_poly5_s01():
    case = CASES["cams-s01"]
    found = LAWS["poly5"].at(np.array(case["inputs"]["k"]))
    for row, name in enumerate(("s", "s1", "s2")):
        np.testing.assert_allclose(found[row], case["expected"][name], atol=1e-6)


def test_constant_acceleration_s02():
    case = CASES["cams-s02"]
    found = LAWS["const"].at(np.array(case["inputs"]["k"]))
    for row, name in enumerate(("s", "s1", "s2")):
        np.testing.assert_allclose(found[row], case["expected"][name], atol=1e-9)


@pytest.mark.parametrize("name", ["shun", "sine", "cosine"])
def test_spot_values_s03(name):
    case = CASES["cams-s03"]
    found = LAWS[name].at(np.array([case["inputs"]["k"]]))[:, 0]
    np.testing.assert_allclose(found[:3], [case["expected"][name][s] for s in ("s", "s1", "s2")], atol=1e-6)


@pytest.mark.parametrize("name", CASES["cams-s04"]["inputs"]["laws"])
def test_constants_s04(name):
    expected = CASES["cams-s04"]["expected"][name]
    found = constants(LAWS[name])
    told = (found.velocity, found.acceleration, found.braking_at, found.braking_lift, *found.jerk)
    wanted = [expected[key] for key in ("Cv", "Ca", "k_M", "s_M", "jerk_min", "jerk_max")]
    np.testing.assert_allclose(told, wanted, rtol=1e-6, atol=1e-9)
    assert LAWS[name].at(np.array([0.0]))[3, 0] == pytest.approx(expected["jerk_at_0"], rel=1e-6, abs=1e-12)


@pytest.mark.parametrize(("lead", "place"), [([0, 0, 0, 4, -3], 1.0), ([0, 0, 6, -8, 3], 0.0)])
def test_the_largest_acceleration_stands_where_it_is_told(lead, place):
    """s = 4k^3 - 3k^4 has s'' = 24k - 36k^2: 4 at 1/3, -12 at 1; s = 6k^2 - 8k^3 + 3k^4 is the same from its end."""
    found = constants(of_coefficients(lead))
    assert found.acceleration == pytest.approx(12, rel=1e-12)
    assert found.acceleration_at == pytest.approx(place, abs=1e-12)


@pytest.mark.parametrize("name", LAWS)
def test_of_equal_accelerations_the_rising_one_counts(name):
    found = constants(LAWS[name])
    assert LAWS[name].at(np.array([found.acceleration_at]))[2, 0] == pytest.approx(found.acceleration, rel=1e-9)


# max(s's'') and its k as in table 5.1
POWERS = {
    "sine": (3 * sqrt(3) * pi / 2, 1 / 3),
    "cosine": (pi**3 / 8, 0.25),
    "linear": (2 * sqrt(3), 0.5 - sqrt(3) / 6),
    "const": (8.0, 0.5),
}


@pytest.mark.parametrize("name", POWERS)
def test_the_largest_power_in_closed_form(name):
    found = constants(LAWS[name])
    assert (found.power, found.power_at) == pytest.approx(POWERS[name], rel=1e-12)


@pytest.mark.parametrize(
    ("name", "velocity", "acceleration"),
    [
        ("shun", 1.875, 10 / sqrt(3)),
        ("sine", 2.0, 2 * pi),
        ("cosine", pi / 2, pi**2 / 2),
        ("modified_trapezoid", 2.0, 8 * pi / (2 + pi)),
        ("modified_sine", 4 * pi / (4 + pi), 4 * pi**2 / (4 + pi)),
        ("poly4567", 2.1875, 84 * sqrt(5) / 25),
    ],
)
def test_largest_velocity_and_acceleration_in_closed_form(name, velocity, acceleration):
    found = constants(LAWS[name])
    assert found.acceleration == pytest.approx(acceleration, rel=1e-12)
    assert found.velocity == pytest.approx(velocity, rel=1e-9)


@pytest.mark.parametrize("name", PRINTED)
def test_the_displacement_is_that_of_the_table(name):
    np.testing.assert_allclose(LAWS[name].at(K)[0], PRINTED[name](K), atol=4e-15)


@pytest.mark.parametrize("name", JERKS)
def test_the_jerk_in_closed_form(name):
    np.testing.assert_allclose(LAWS[name].at(K)[3], JERKS[name](K), rtol=1e-12, atol=1e-11)


@pytest.mark.parametrize("name", LAWS)
def test_a_law_leads_from_rest_to_rest(name):
    law = LAWS[name]
    ends = law.at(np.array([0.0, 1.0]))
    np.testing.assert_allclose(ends[:2], [[0, 1], [0, 0]], atol=2e-15)


@pytest.mark.parametrize("name", LAWS)
def test_every_row_is_the_derivative_of_the_one_before(name):
    """Inside of every piece, by differences of the fourth order."""
    law = LAWS[name]
    h = 1e-3
    for piece in range(law.count):
        low, high = law.breaks[piece : piece + 2]
        k = np.linspace(low + 2 * h, high - 2 * h, 7)
        at = [law.at(k + n * h, np.full(7, piece)) for n in (-2, -1, 1, 2)]
        slope = (at[0] - 8 * at[1] + 8 * at[2] - at[3]) / (12 * h)
        np.testing.assert_allclose(law.at(k, np.full(7, piece))[1:], slope[:-1], rtol=1e-7, atol=2e-7)


@pytest.mark.parametrize("name", LAWS)
def test_displacement_is_the_double_integral_of_the_acceleration(name):
    law = LAWS[name]
    for k in (0.3, 0.77, 1.0):
        breaks = [b for b in law.breaks[1:-1] if b < k]
        value, _ = quad(lambda x, k=k: (k - x) * law.at(np.array([x]))[2, 0], 0, k, points=breaks or None, limit=200)
        assert law.at(np.array([k]))[0, 0] == pytest.approx(value, abs=2e-8)


@pytest.mark.parametrize("name", LAWS)
def test_symmetric_about_the_middle(name):
    """s(k) + s(1 - k) = 1, so that s' and s''' are even and s'' is odd about k = 1/2."""
    law = LAWS[name]
    k = np.array([0.013, 0.11, 0.2, 0.31, 0.44])
    ahead, back = law.at(k), law.at(1 - k)
    np.testing.assert_allclose(ahead[0] + back[0], 1, atol=1e-14)
    np.testing.assert_allclose(ahead[1:], [back[1], -back[2], back[3]], rtol=1e-11, atol=1e-12)


def test_which_laws_have_soft_shocks():
    programs = {name: turn(name) for name in LAWS}
    soft = {name for name, program in programs.items() if np.any(program.jumps[2])}
    assert soft == {"cosine", "linear", "const"}
    assert not any(np.any(program.jumps[1]) for program in programs.values())
    jumps = programs["const"].jumps[2] * np.radians(60) ** 2 / 0.02
    np.testing.assert_allclose(jumps[:3], [4.0, -8.0, 4.0])


def test_continuity_inside_the_laws_in_pieces():
    for name in ("parab2", "modified_trapezoid", "modified_sine"):
        law, every = LAWS[name], np.arange(LAWS[name].count)
        before, after = law.at(law.breaks[1:], every), law.at(law.breaks[:-1], every)
        np.testing.assert_allclose(before[:3, :-1], after[:3, 1:], atol=1e-12)
        np.testing.assert_allclose([before[1:3, -1], after[1:3, 0]], 0, atol=1e-12)


def test_the_accelerating_branch_in_the_middle_of_const_and_both_limits():
    law = LAWS["const"]
    assert law.at(np.array([0.5]))[2, 0] == 4
    assert law.at(np.array([0.5]), np.array([1]))[2, 0] == -4


def test_names():
    assert all(law.name == name and title_of(name) for name, law in LAWS.items())
    assert law_of("shun") is LAWS["shun"]
    with pytest.raises(UsageError, match="'sinus'"):
        law_of("sinus")


def test_extremes_against_dense_samples():
    k = np.linspace(0, 1, 200_001)
    for law in LAWS.values():
        found, values = constants(law), law.at(k)
        assert found.velocity == pytest.approx(values[1].max(), rel=1e-9)
        assert found.braking == pytest.approx(values[2].min(), rel=1e-9)
        assert found.power == pytest.approx((values[1] * values[2]).max(), rel=1e-8)
        assert law.at(np.array([found.velocity_at]))[1, 0] == pytest.approx(found.velocity, rel=1e-13)
        assert law.at(np.array([found.braking_at]))[0, 0] == pytest.approx(found.braking_lift, rel=1e-13)
