"""Laws of the user's own against the catalogue, closed forms and independent splines."""

import numpy as np
import pytest
from scipy.interpolate import make_interp_spline

from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.laws.law import Acceleration, of_acceleration
from tmmcalc.cams.laws.own import of_accelerations, of_coefficients, of_points
from tmmcalc.core.errors import UsageError

K = np.linspace(0, 1, 41)


def test_coefficients_of_the_345_polynomial_to_any_scale():
    law = of_coefficients([0, 0, 0, 20, -30, 12])
    np.testing.assert_allclose(law.at(K), LAWS["shun"].at(K), rtol=1e-13, atol=1e-13)


@pytest.mark.parametrize(
    ("coefficients", "what"),
    [
        ([0, 1], "s' = 1"),
        ([0.1, 0, 3, -2], "s = 0.0"),
        ([0, 0, 1], "s' = 2"),
        ([0, 0, -3, 2], "s\\(1\\) = -1"),
        ([0.0], "s\\(1\\) = 0"),
    ],
)
def test_coefficients_that_strike_the_follower_are_refused(coefficients, what):
    with pytest.raises(UsageError, match=what):
        of_coefficients(coefficients)


def test_a_falling_straight_line_of_acceleration_is_the_law_linear():
    law = of_accelerations(np.array([0.0, 1.0]), np.array([1.0, -1.0]))
    np.testing.assert_allclose(law.at(K), LAWS["linear"].at(K), rtol=1e-13, atol=1e-13)


def test_a_step_of_acceleration_is_the_law_const_to_any_scale():
    law = of_accelerations(np.array([0.0, 0.5, 0.5, 1.0]), np.array([7.0, 7.0, -7.0, -7.0]))
    np.testing.assert_allclose(law.at(K), LAWS["const"].at(K), rtol=1e-13, atol=1e-13)
    sides = law.at(np.array([0.0, 0.5, 0.5, 1.0]), np.array([0, 0, 1, 1]))[2]
    np.testing.assert_allclose(sides, [4, 4, -4, -4], rtol=1e-13)


def test_an_unsymmetric_trapezoid_by_independent_quadrature():
    """s'' = 3 on [0, 1/4], then -1 on [1/4, 1]: s(1) = 3/32 + 9/16 - 9/32."""
    law = of_accelerations(np.array([0, 0.25, 0.25, 1.0]), np.array([3.0, 3.0, -1.0, -1.0]))
    scale = 3 / 32 + 0.75 * 0.75 - 0.75**2 / 2
    early = np.array([0.1, 0.2])
    np.testing.assert_allclose(law.at(early)[0], 1.5 * early**2 / scale, rtol=1e-13)
    late = np.array([0.5, 0.9])
    wanted = 3 / 32 + 0.75 * (late - 0.25) - (late - 0.25) ** 2 / 2
    np.testing.assert_allclose(law.at(late)[0], wanted / scale, rtol=1e-13)
    np.testing.assert_allclose(law.at(np.array([1.0]))[:2, 0], [1, 0], atol=1e-14)


def test_a_table_of_the_sine_law_comes_near_it():
    k = np.linspace(0, 1, 2001)
    law = of_accelerations(k, np.sin(2 * np.pi * k))
    np.testing.assert_allclose(law.at(K)[0], LAWS["sine"].at(K)[0], atol=1e-6)


@pytest.mark.parametrize(
    ("k", "acceleration", "what"),
    [
        ([0, 1], [1, 0], "areas above and below differ by 0.5"),
        ([0, 1], [-1, 1], "no lift"),
        ([0, 0.5, 0.4, 1], [1, 1, -1, -1], "ascend from 0 to 1"),
        ([0.1, 1], [1, -1], "ascend from 0 to 1"),
        ([0, 0.9], [1, -1], "ascend from 0 to 1"),
    ],
)
def test_accelerations_that_cannot_be(k, acceleration, what):
    with pytest.raises(UsageError, match=what):
        of_accelerations(np.array(k, float), np.array(acceleration, float))


def test_points_of_the_345_polynomial_give_it_back():
    """A polynomial of the fifth degree at rest at both ends is its own spline."""
    k = np.array([0, 0.2, 0.45, 0.7, 1.0])
    law = of_points(k, LAWS["shun"].at(k)[0])
    np.testing.assert_allclose(law.at(K), LAWS["shun"].at(K), rtol=1e-9, atol=1e-9)


def test_points_are_met_and_the_spline_is_that_of_scipy():
    k, s = np.array([0, 0.15, 0.4, 0.66, 0.8, 1.0]), np.array([0, 2.0, 9.0, 16.0, 19.0, 20.0])
    law = of_points(k, s)
    np.testing.assert_allclose(law.at(k)[0], s / 20, atol=1e-13)
    rest = ([(1, 0.0), (2, 0.0)], [(1, 0.0), (2, 0.0)])
    spline = make_interp_spline(k, s / 20, 5, bc_type=rest)
    for order in range(4):
        np.testing.assert_allclose(law.at(K)[order], spline(K, order), rtol=1e-9, atol=1e-8)
    inner, every = law.breaks[1:-1], np.arange(law.count)
    before, after = law.at(inner, every[:-1]), law.at(inner, every[1:])
    np.testing.assert_allclose(before[:3], after[:3], atol=1e-9)
    np.testing.assert_allclose(law.at(np.array([0.0, 1.0]), every[[0, -1]])[1:3], 0, atol=1e-9)


@pytest.mark.parametrize(
    ("k", "s"),
    [([0, 0.5, 0.5, 1], [0, 0.4, 0.5, 1]), ([0, 0.5, 1], [0.1, 0.5, 1]), ([0, 0.5, 1], [0, 0.5, 0]), ([0], [0])],
)
def test_points_that_cannot_be(k, s):
    with pytest.raises(UsageError):
        of_points(np.array(k, float), np.array(s, float))


def test_pieces_of_acceleration_with_a_harmonic():
    law = of_acceleration("half sines", Acceleration(0.0, amplitude=3.0, frequency=2 * np.pi))
    np.testing.assert_allclose(law.at(K), LAWS["sine"].at(K), rtol=1e-12, atol=1e-12)
