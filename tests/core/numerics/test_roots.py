"""Bracketed roots: exact to the last places, however flat, steep or many."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from tmmcalc.core.numerics.roots import bracketed

PROBLEMS = [  # name, function, bracket, root
    ("line", lambda x: 3 * x - 1, (0.0, 1.0), 1 / 3),
    ("cosine", lambda x: np.cos(x) - x, (0.0, 1.0), 0.7390851332151607),
    ("odd power", lambda x: (x - 0.3) ** 3, (-1.0, 1.5), 0.3),
    ("ninth power", lambda x: (x + 0.1) ** 9, (-1.0, 0.7), -0.1),
    ("exponential", lambda x: np.exp(x) - 1e-8, (-50.0, 5.0), math.log(1e-8)),
    ("steep", lambda x: np.arctan(1e8 * (x - 0.123)), (-1.0, 1.0), 0.123),
    ("square root", lambda x: np.sign(x - 0.2) * np.sqrt(np.abs(x - 0.2)), (-1.0, 1.0), 0.2),
    ("large", lambda x: x - 123456789.0, (0.0, 1e9), 123456789.0),
    ("tiny", lambda x: x - 1e-300, (-1.0, 1.0), 1e-300),
]


@pytest.mark.parametrize(("name", "f", "bracket", "root"), PROBLEMS, ids=[p[0] for p in PROBLEMS])
def test_one_root(name: str, f: Callable[[np.ndarray], np.ndarray], bracket: tuple[float, float], root: float) -> None:
    for low, high in (bracket, bracket[::-1]):
        found = bracketed(lambda x, _: f(x), np.array([low]), np.array([high]))
        assert found[0] == pytest.approx(root, rel=1e-14, abs=1e-15 if root == 0 else 1e-18 + abs(root) * 1e-14) or (
            name == "ninth power" and abs(found[0] - root) < 1e-15 * 8
        )


def test_many_roots_at_once_are_those_found_alone() -> None:
    levels = np.linspace(-0.99, 0.99, 501)
    seen: list[int] = []

    def f(x: np.ndarray, which: np.ndarray) -> np.ndarray:
        seen.append(len(which))
        return np.sin(x) - levels[which]

    found = bracketed(f, np.full(501, -math.pi / 2), np.full(501, math.pi / 2))
    np.testing.assert_allclose(found, np.arcsin(levels), rtol=1e-14, atol=1e-15)
    assert len(seen) < 20
    assert seen[-1] < 501


def test_an_end_that_is_a_root_is_returned() -> None:
    found = bracketed(lambda x, _: x * (x - 1), np.array([0.0, 0.5]), np.array([0.5, 1.0]))
    assert found.tolist() == [0.0, 1.0]


def test_an_end_that_is_a_root_but_for_rounding_is_returned() -> None:
    """Both values are positive, one of them by a rounding error: the sampled sign was another."""
    found = bracketed(lambda x, _: x + 1e-17, np.array([0.0, -1.0]), np.array([1.0, 1.0]))
    assert found[0] == 0.0
    assert abs(found[1]) < 1e-15


def test_none_to_find() -> None:
    assert bracketed(lambda x, _: x, np.empty(0), np.empty(0)).shape == (0,)


def test_an_absolute_tolerance_saves_calls() -> None:
    calls = [0, 0]
    for k, tolerance in enumerate((0.0, 1e-3)):

        def f(x: np.ndarray, _: np.ndarray, k: int = k) -> np.ndarray:
            calls[k] += 1
            return np.tanh(5 * (x - 0.4))

        found = bracketed(f, np.array([-3.0]), np.array([3.0]), absolute=tolerance)
        assert abs(found[0] - 0.4) <= max(tolerance, 1e-14)
    assert calls[1] < calls[0]


def test_rough_functions_end() -> None:
    """A jump has no root; the place of the change of sign is found all the same."""
    found = bracketed(lambda x, _: np.where(x < 0.7, -1.0, 2.0), np.array([0.0]), np.array([1.0]))
    assert abs(found[0] - 0.7) < 1e-14


def test_known_ends_and_guesses_spare_calls() -> None:
    calls: list[int] = []

    def f(x: np.ndarray, which: np.ndarray) -> np.ndarray:
        calls.append(len(x))
        return np.exp(x) - 2 - which

    low, high, roots, every = np.zeros(3), np.full(3, 2.0), np.log([2.0, 3.0, 4.0]), np.arange(3)
    known = f(low, every), f(high, every), roots + 1e-3
    calls.clear()
    assert bracketed(f, low, high) == pytest.approx(roots, rel=1e-15)
    plain = len(calls)
    assert bracketed(f, low, high, known=known) == pytest.approx(roots, rel=1e-15)
    assert len(calls) - plain < plain - 2


def test_a_value_within_the_level_is_a_root() -> None:
    found = bracketed(lambda x, _: x**3 - 2, np.zeros(1), np.full(1, 2.0), level=1e-3)
    assert 0 < abs(found[0] ** 3 - 2) <= 1e-3
