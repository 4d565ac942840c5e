"""Fourier series of periodic functions: coefficients, means and extremes against closed forms and scipy."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from tmmcalc import AccuracyError
from tmmcalc.core.numerics.fourier import Series, crests, magnitude, resolved

TURN = 2 * math.pi
ONE = np.ones(1)


def geometric(a: float) -> Series:
    """1 / (1 - a exp(it)) = sum of a^k exp(ikt)."""
    (series,), tail = resolved(lambda t: 1 / (1 - a * np.exp(1j * t))[None], np.array([1 / (1 - a)]))
    assert tail <= 1e-12
    return series


def random_series(seed: int, highest: int) -> Series:
    rng = np.random.default_rng(seed)
    return Series(rng.normal(size=2 * highest + 1) + 1j * rng.normal(size=2 * highest + 1))


@pytest.mark.parametrize("a", [0.1, 0.6, 0.9, 0.99, 0.999])
def test_coefficients_of_a_geometric_series(a: float) -> None:
    series = geometric(a)
    powers = np.where(series.orders >= 0, a ** np.maximum(series.orders, 0), 0.0)
    assert np.max(np.abs(series.coefficients - powers)) * (1 - a) < 2e-13
    assert series.rms == pytest.approx(1 / math.sqrt(1 - a * a), rel=1e-12)
    peak = magnitude(series)
    assert peak.largest == pytest.approx(1 / (1 - a), rel=1e-12)
    assert peak.at == pytest.approx(0.0, abs=1e-9)


def test_two_functions_have_one_length_and_each_its_own_scale() -> None:
    (large, small), _ = resolved(
        lambda t: np.array([1e9 * np.cos(3 * t), 1e-9 * np.sin(5 * t)], complex), np.array([1e9, 1e-9])
    )
    assert len(large.coefficients) == len(small.coefficients) >= 11
    assert large.coefficient(-3) == pytest.approx(5e8, rel=1e-14)
    assert small.coefficient(5) == pytest.approx(-0.5e-9j, rel=1e-12)
    assert abs(small.coefficient(6)) < 1e-24
    assert small.coefficient(-99) == 0


def test_nothing_is_the_series_of_order_0() -> None:
    (series,), tail = resolved(lambda t: np.zeros((1, len(t)), complex), np.zeros(1))
    assert series.highest == 0
    assert tail == 0
    assert (magnitude(series).rms, magnitude(series).largest, magnitude(series).at) == (0.0, 0.0, 0.0)


def test_rounding_of_the_function_is_not_chased_but_told() -> None:
    rng = np.random.default_rng(3)
    (series,), tail = resolved(lambda t: (np.cos(t) + 1e-10 * rng.normal(size=t.shape))[None].astype(complex), ONE)
    assert 1e-11 < tail < 1e-9
    assert series.coefficient(1) == pytest.approx(0.5, abs=1e-10)
    assert series.highest < 2**13


def test_a_kink_is_refused() -> None:
    with pytest.raises(AccuracyError, match="do not die out") as refused:
        resolved(lambda t: np.abs(np.sin(t))[None].astype(complex), ONE, where="here")
    assert refused.value.limit == 1e-8
    assert str(refused.value).startswith("here: ")


@pytest.mark.parametrize("highest", [0, 1, 4, 30])
def test_values_slope_and_changed_series(highest: int) -> None:
    series = random_series(highest, highest)
    t = np.linspace(-3, 9, 41)
    direct = sum(c * np.exp(1j * k * t) for k, c in zip(series.orders, series.coefficients, strict=True))
    scale = np.abs(series.coefficients).sum()
    assert np.max(np.abs(series.at(t) - direct)) < 1e-13 * scale
    n = 2 * highest + 3
    assert np.max(np.abs(series.even(n) - series.at(np.arange(n) * TURN / n))) < 1e-13 * scale
    h = 1e-5
    difference = (series.at(t + h) - series.at(t - h)) / (2 * h)
    assert np.max(np.abs(series.slope().at(t) - difference)) < 1e-8 * (1 + highest**3) * scale
    for order in (-3, 0, 2):
        assert np.max(np.abs(series.turned(order).at(t) - series.at(t) * np.exp(1j * order * t))) < 1e-13 * scale
    more = series.plus({-2: 1j, highest + 5: 2.0, 0: -1.0})
    added = 1j * np.exp(-2j * t) + 2 * np.exp(1j * (highest + 5) * t) - 1
    assert np.max(np.abs(more.at(t) - series.at(t) - added)) < 1e-13 * (scale + 4)
    assert series.rms == pytest.approx(math.sqrt(np.mean(np.abs(series.even(4 * highest + 3)) ** 2)), rel=1e-13)


@pytest.mark.parametrize("seed", range(12))
def test_the_largest_value_against_a_scan_and_a_search(seed: int) -> None:
    series = random_series(seed, 1 + seed)
    found = magnitude(series)
    t = np.linspace(0, TURN, 20001)
    values = np.abs(series.at(t))
    best = t[np.argmax(values)]
    searched = minimize_scalar(
        lambda s: -abs(series.at(np.array([s]))[0]), bounds=(best - 1e-3, best + 1e-3), options={"xatol": 1e-12}
    )
    assert found.largest >= values.max()
    assert found.largest == pytest.approx(-searched.fun, rel=1e-14)
    assert math.remainder(found.at - searched.x, TURN) == pytest.approx(0, abs=1e-6)
    at, height = crests(series)
    inner = values[1:-1]
    assert len(at) == np.sum((inner > values[:-2]) & (inner >= values[2:])) + (values[0] > max(values[1], values[-2]))
    assert np.all(np.abs((np.conj(series.at(at)) * series.slope().at(at)).real) < 1e-11 * height**2)


def test_of_equal_crests_the_first_and_of_a_constant_none() -> None:
    assert magnitude(Series(np.array([0.5, 0, 0.5]))).at == 0.0
    turned = Series(np.array([0.5 * np.exp(0.3j), 0, 0.5 * np.exp(-0.3j)]))
    assert magnitude(turned).at == pytest.approx(0.3, abs=1e-14)
    assert magnitude(Series(np.array([0, 0, 3j]))).at == 0.0
    assert magnitude(Series(np.array([0, 0, 3j]))).largest == pytest.approx(3.0, rel=1e-15)
