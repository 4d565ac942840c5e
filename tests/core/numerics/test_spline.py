"""The periodic cubic spline against that of scipy, and its order."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from tmmcalc.core.numerics.spline import periodic_spline

TURN = 2 * math.pi


@pytest.mark.parametrize("count", [3, 4, 24, 2000])
@pytest.mark.parametrize("period", [TURN, 0.3, 4 * math.pi])
def test_values_and_slopes_are_those_of_scipy(count: int, period: float) -> None:
    rng = np.random.default_rng(count)
    x, y = (np.arange(count) + rng.uniform(0, 0.8, count)) * period / count, rng.normal(size=count)
    at = np.linspace(-period, 2 * period, 2001)
    wanted = CubicSpline(np.append(x, x[0] + period), np.append(y, y[0]), bc_type="periodic")
    inside = np.mod(at - x[0], period) + x[0]
    for order, found in enumerate(periodic_spline(x, y, period)(at)):
        exact = wanted(inside, order)
        assert found == pytest.approx(exact, abs=1e-12 * np.max(np.abs(exact)))


def test_values_are_of_fourth_order_and_slopes_of_third() -> None:
    at = np.linspace(0, TURN, 1001)

    def off(count: int) -> tuple[float, float]:
        x = np.arange(count) * TURN / count
        value, slope = periodic_spline(x, np.exp(np.sin(x)), TURN)(at)
        exact = np.exp(np.sin(at))
        return float(np.max(np.abs(value - exact))), float(np.max(np.abs(slope - np.cos(at) * exact)))

    (value, slope), (finer, steeper) = off(48), off(96)
    assert 14 < value / finer < 18
    assert 7 < slope / steeper < 9
