"""Extrema without derivatives to nearly full precision, local searches around samples, hidden changes of sign."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from tmmcalc.core.numerics.extrema import around, refine, turning, with_turning_points

TURN = 2 * math.pi


@pytest.mark.parametrize(
    ("f", "guess", "radius", "at", "value"),
    [
        (np.cos, 0.2, 0.5, 0.0, 1.0),
        (np.cos, 3.0, 1.0, math.pi, -1.0),
        (lambda x: (x - 0.3) ** 2 + 1e-3, 0.31, 0.02, 0.3, 1e-3),
        (lambda x: np.exp(-((x - 1) ** 2)), 0.8, 0.5, 1.0, 1.0),
        (lambda x: 1 / (1 + 1e4 * (x - 0.017) ** 2), 0.0, 0.05, 0.017, 1.0),
        (lambda x: x**4 - x**2, 0.6, 0.2, math.sqrt(0.5), -0.25),
        (lambda x: 1e6 + np.sin(x), 1.5, 0.3, math.pi / 2, 1e6 + 1),
    ],
)
def test_one_extremum(
    f: Callable[[np.ndarray], np.ndarray], guess: float, radius: float, at: float, value: float
) -> None:
    found, best = refine(lambda x, _: f(x), np.array([guess]), np.array([radius]))
    noise = 1e-16 * abs(value) / radius**2
    assert found[0] == pytest.approx(at, abs=max(1e-11 * max(radius, 0.1), math.sqrt(noise) * 1e-2))
    assert best[0] == pytest.approx(value, rel=1e-14, abs=1e-15)


def test_many_at_once_are_those_found_alone() -> None:
    shifts = np.linspace(-0.4, 0.4, 33)
    found, best = refine(lambda x, k: np.cos(x - shifts[k]), np.zeros(33), np.ones(33))
    np.testing.assert_allclose(found, shifts, atol=1e-12)
    np.testing.assert_allclose(best, 1.0, rtol=1e-14)


@pytest.mark.parametrize("slope", [1.0, -1.0])
def test_the_function_is_never_called_outside_the_radius(slope: float) -> None:
    """No extremum within: an end is returned, and a function that ends there is not left."""
    seen: list[np.ndarray] = []

    def f(x: np.ndarray, _: np.ndarray) -> np.ndarray:
        seen.append(x)
        return slope * np.sqrt(np.maximum(x, 0.0) + 1e-9)

    found, best = refine(f, np.array([0.5]), np.array([0.5]))
    everything = np.concatenate(seen)
    assert everything.min() >= -1e-16
    assert everything.max() <= 1 + 1e-15
    assert min(abs(found[0]), abs(found[0] - 1)) < 1e-15
    assert np.isfinite(best[0])


def test_turning_samples() -> None:
    values = np.array([3.0, 1.0, 2.0, 2.0, 0.0, 5.0])
    assert turning(values, 1, False).tolist() == [0, 3, 5]
    assert turning(values, -1, False).tolist() == [1, 4]
    assert turning(values, 1, True).tolist() == [3, 5]
    assert turning(-values, -1, True).tolist() == [3, 5]


def test_around_reaches_the_farther_neighbour_and_no_end() -> None:
    x = np.array([0.0, 1.0, 1.5, 3.0, 4.0])
    centre, radius = around(x, np.array([0, 1, 2, 3, 4]), periodic=False)
    assert centre.tolist() == [0.5, 1.0, 1.5, 3.0, 3.5]
    assert radius.tolist() == [0.5, 1.0, 1.5, 1.0, 0.5]
    centre, radius = around(x, np.array([0, 3]), periodic=True)
    assert centre.tolist() == [0.0, 3.0]
    assert radius.tolist() == [1.0, 1.5]


@pytest.mark.parametrize("depth", [1e-2, 1e-4, 1e-8])
@pytest.mark.parametrize("place", [0.0, 0.02, 1.0, TURN - 1e-3, 3.0])
def test_a_dip_between_two_samples_is_found(depth: float, place: float) -> None:
    """1 - cos dips below zero by ``depth`` at one place of the turn, the seam included."""
    x = np.linspace(0, TURN, 41)

    def f(at: np.ndarray, _: object) -> np.ndarray:
        return 1 - np.cos(at - place) - depth

    more, values = with_turning_points(f, x, f(x, None), near=0.02, period=TURN)
    assert -depth * (1 + 1e-6) < values.min() < 0
    if f(x, None).min() < 0:
        return  # a sample stands in it already
    assert values.min() == pytest.approx(-depth, rel=1e-6)
    assert abs(math.remainder(more[np.argmin(values)] - place, TURN)) < 1e-7
    assert np.all(np.diff(more) >= 0)
    assert more[0] >= 0
    assert more[-1] <= TURN


def test_a_dip_in_the_last_cell_of_an_open_range_is_found() -> None:
    x = np.linspace(0, 1, 11)
    for place in (0.02, 0.05, 0.97):

        def f(at: np.ndarray, _: object, place: float = place) -> np.ndarray:
            return (at - place) ** 2 - 1e-9

        _, values = with_turning_points(f, x, f(x, None), near=0.0)
        assert values.min() == pytest.approx(-1e-9, rel=1e-6)


def test_what_only_touches_zero_is_left_out() -> None:
    x = np.linspace(0, 1, 12)
    more, _ = with_turning_points(lambda at, _: (at - 0.5) ** 2, x, (x - 0.5) ** 2, near=0.1, touch=1e-12)
    assert len(more) == 12
    more, _ = with_turning_points(lambda at, _: (at - 0.5) ** 2 + 1, x, (x - 0.5) ** 2 + 1, near=0.1)
    assert len(more) == 12
