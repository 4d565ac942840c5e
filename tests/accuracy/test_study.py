"""Orders of convergence, choices of the cheapest, medians."""

from __future__ import annotations

import math
import time
from collections.abc import Callable

import numpy as np
import pytest

from tmmcalc import NoSolutionError
from tmmcalc.core.studies.measure import Clock, Way, relative, series
from tmmcalc.core.studies.order import observed
from tmmcalc.core.studies.study import FLOOR, Point, Reference, Series, Study

SIZES = [1 / 4, 1 / 8, 1 / 16, 1 / 32, 1 / 64, 1 / 128, 1 / 256, 1 / 512]


def _trapezoid(step: float) -> float:
    x = np.linspace(0.0, 1.0, round(1 / step) + 1)
    return float(np.trapezoid(np.exp(x), x))


def _simpson(step: float) -> float:
    x = np.linspace(0.0, 1.0, round(1 / step) + 1)
    y = np.exp(x)
    return step / 3 * float(y[0] + y[-1] + 4 * y[1:-1:2].sum() + 2 * y[2:-1:2].sum())


@pytest.mark.parametrize(("rule", "order"), [(_trapezoid, 2), (_simpson, 4)])
def test_orders_of_quadrature(rule: Callable[[float], float], order: int) -> None:
    errors = [abs(rule(step) - (math.e - 1)) for step in SIZES]
    assert observed(SIZES, errors) == pytest.approx(order, abs=0.05)


def test_rounding_at_the_fine_end_and_coarse_settings_do_not_spoil_the_order() -> None:
    errors = [0.9, 0.7, *(step**3 for step in SIZES[2:6]), 3e-4, 6e-4]
    assert observed(SIZES, errors) == pytest.approx(3.0)
    assert observed(SIZES, [1e-16] * len(SIZES)) is None, "rounding has no order"
    assert observed(SIZES[:2], [1e-2, 1e-4]) is None, "two settings are no line"


def test_three_settings_that_are_straight_by_chance_have_no_order() -> None:
    errors = [3e-3, 2.9e-3, 2.8e-3, 1.9e-3, 1.2e-3, 1.1e-3]
    assert observed(SIZES[:6], errors) is None, "the error does not fall by a decade"


def test_settings_that_are_no_steps_have_no_order() -> None:
    ways = [Way("a", 1e-3, lambda: 1e-3), Way("b", 1e-5, lambda: 1e-5), Way("c", 1e-7, lambda: 1e-7)]
    assert series("m", ways, lambda x: float(x), Clock(1)).order == pytest.approx(1.0)
    assert series("m", ways, lambda x: float(x), Clock(1), stepwise=False).order is None


def test_the_order_does_not_depend_on_the_order_of_settings() -> None:
    errors = [step**2 for step in SIZES]
    assert observed(SIZES[::-1], errors[::-1]) == observed(SIZES, errors) == pytest.approx(2.0)


def test_a_method_that_fails_keeps_its_reason() -> None:
    def fails() -> float:
        raise NoSolutionError("does not converge\nmore of it")

    found = series("m", [Way("a", 1.0, fails), Way("b", 0.5, lambda: 2.0)], lambda x: relative(x, 2.5), Clock(1))
    assert found.points[0] == Point("a", 1.0, None, None, failed="does not converge")
    assert found.points[1].error == pytest.approx(0.2)


def test_errors_are_relative_to_the_largest_and_never_zero() -> None:
    exact = np.array([1e-9, 100.0])
    assert relative(exact + np.array([1.0, 0.0]), exact) == pytest.approx(0.01)
    assert relative(exact, exact) == FLOOR
    assert relative(np.zeros(3), np.zeros(3)) == FLOOR
    assert relative(3.0, 2.0, 10.0) == pytest.approx(0.1)


def test_the_median_leaves_the_first_run_out() -> None:
    waits = iter([0.05, 0.001, 0.002, 0.02])
    _, seconds, runs = Clock(repeats=3, budget=10.0).median(lambda: time.sleep(next(waits)))
    assert 0.002 <= seconds < 0.02
    assert runs == 3


def test_a_long_run_is_made_once_but_for_the_first_of_a_method() -> None:
    calls: list[int] = []

    def long() -> None:
        calls.append(1)
        time.sleep(0.02)

    ways = [Way("a", 1.0, long), Way("b", 0.5, long)]
    found = series("m", ways, lambda _: 0.1, Clock(repeats=5, budget=0.01))
    assert [point.runs for point in found.points] == [1, 1]
    assert len(calls) == 3, "the first setting, which imports, is run once more"


def test_cheapest_and_front() -> None:
    slow, fast, coarse = Point("s", 1, 1e-9, 2.0), Point("f", 1, 1e-8, 1.0), Point("c", 1, 1e-2, 0.1)
    bad, broken = Point("b", 1, 1e-2, 3.0), Point("x", 1, None, None, failed="no")
    study = Study("s", "q", Reference("r", 0.0), (Series("a", (bad, slow)), Series("b", (coarse, fast, broken))))
    assert [_point(study, t) for t in (1e-1, 1e-5, 1e-9, 1e-12)] == [coarse, fast, slow, None]
    assert [point for _, point, _ in study.front] == [coarse, fast, slow]


def _timed(*errors: float) -> Series:
    """A method whose settings take ever longer."""
    return Series("m", tuple(Point(str(k), None, error, 1.0 + k) for k, error in enumerate(errors)))


def test_a_setting_near_the_truth_by_chance_counts_as_the_finer_ones_do() -> None:
    lucky = _timed(1e-2, 1e-16, 1e-3, 1e-4, 1e-5)
    assert [kept for _, kept in lucky.sure] == [1e-2, 1e-3, 1e-3, 1e-4, 1e-5]
    assert lucky.cheapest(1e-12) is None
    assert lucky.cheapest(1e-4) == lucky.points[3]
    assert lucky.cheapest(1e-3) == lucky.points[1], "it does keep what the finer ones keep"
    assert lucky.best == lucky.points[1]
    front = Study("s", "q", Reference("r", 0.0), (lucky,)).front
    assert [(point.setting, kept) for _, point, kept in front] == [("0", 1e-2), ("1", 1e-3), ("3", 1e-4), ("4", 1e-5)]


def test_rounding_at_the_fine_end_says_nothing_against_coarser_settings() -> None:
    differences = _timed(1e-2, 1e-4, 1e-6, 1e-5, 1e-3)
    assert [kept for _, kept in differences.sure] == [1e-2, 1e-4, 1e-6, 1e-5, 1e-3]
    assert differences.cheapest(1e-5) == differences.points[2]
    assert differences.cheapest(1e-4) == differences.points[1]
    assert differences.cheapest(1e-7) is None
    assert _timed(1e-3, FLOOR, FLOOR, 2 * FLOOR, FLOOR).cheapest(1e-12).setting == "1"


def test_a_setting_without_a_size_has_no_order() -> None:
    ways = [Way(str(n), None, lambda n=n: 10.0**-n) for n in range(1, 6)]
    found = series("m", ways, lambda x: float(x), Clock(1))
    assert found.order is None
    assert found.points[0].size is None


def test_a_method_and_its_best_setting() -> None:
    coarse, fine, broken = Point("c", 1, 1e-2, 0.1), Point("f", 1, 1e-8, 1.0), Point("x", 1, None, None, failed="no")
    assert Series("m", (coarse, fine, broken)).best == fine
    assert Series("m", (coarse, fine)).cheapest(1e-1) == coarse
    assert Series("m", (coarse, fine)).cheapest(1e-9) is None
    assert Series("m", (broken,)).best is None


def _point(study: Study, tolerance: float) -> Point | None:
    found = study.cheapest(tolerance)
    return found and found[1]
