"""Derivatives by differences: functions whose derivatives are known, kinks, jumps, ends, noise."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from tmmcalc.design.differences import Slope, slope, steps


def found(function: Callable[[float], float], scale: float = 1.0) -> Slope:
    return slope(scale, function(0.0), np.array([function(float(step)) for step in steps(scale)]))


@pytest.mark.parametrize(
    ("function", "truth"),
    [
        (math.exp, 1.0),
        (lambda x: math.sin(20 * x), 20.0),
        (lambda x: 3 + 2 * x, 2.0),
        (lambda x: 3.0, 0.0),
        (lambda x: 1 + x * x, 0.0),
        (lambda x: 1e6 + 1e-6 * x, 1e-6),
        (lambda x: math.sqrt(x + 0.1), 0.5 / math.sqrt(0.1)),
        (lambda x: x + abs(x - 1e-3), 0.0),  # a kink nearby
    ],
)
def test_the_error_holds_the_truth(function: Callable[[float], float], truth: float) -> None:
    told = found(function)
    assert told.side == "both"
    assert abs(told.value - truth) <= told.error + 1e-15 * abs(truth)


def test_it_is_close_to_the_last_digits() -> None:
    told = found(math.exp)
    assert abs(told.value - 1) < 1e-13
    assert told.curvature == pytest.approx(1, rel=1e-9)


@pytest.mark.parametrize("seed", range(40))
def test_errors_are_honest_where_results_have_noise(seed: int) -> None:
    """What iterations leave of a result is not smooth: the error has to know of it."""
    rng = np.random.default_rng(seed)
    told = found(lambda x: math.exp(x) + 1e-10 * rng.standard_normal())
    assert abs(told.value - 1) < 10 * told.error
    assert told.error < 1e-5


def test_a_kink_has_both_sides() -> None:
    told = found(lambda x: 3 * abs(x) + x + math.sin(x))
    assert told.side == "kink"
    assert math.isnan(told.value)
    assert (told.left, told.right) == pytest.approx((-1, 5), rel=1e-12)


def test_a_jump_has_no_derivative() -> None:
    assert found(lambda x: x + (x > 0)).side == "jump"
    assert found(lambda x: x + (x < 0)).side == "jump"


def test_one_side_is_told() -> None:
    told = found(lambda x: math.sin(x) if x >= 0 else math.nan)
    assert told.side == "right"
    assert abs(told.value - 1) < told.error < 1e-11
    assert found(lambda x: math.sin(x) if x <= 0 else math.nan).side == "left"


def test_no_line_stands_for_a_root_at_its_end() -> None:
    """As an angle near a dead point has it."""
    assert found(lambda x: math.sqrt(x) if x >= 0 else math.nan).side == "none"
    assert found(np.cbrt).side == "none"
