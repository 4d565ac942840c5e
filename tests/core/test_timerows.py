"""Rows in time with one-sided limits, and extremes between jumps."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tmmcalc.core.timelaw import by_travel, motion
from tmmcalc.core.timerows import extremes, time_rows


def test_labels_and_sides() -> None:
    rows = time_rows(10.0, 5, (0.0, 2.5, 3.0, 4.0, 10.0))
    assert rows.labels == ("0", "1", "1'-", "1'", "1''-", "1''", "2-", "2", "3", "4", "5")
    assert rows.t.tolist() == [0, 2, 2.5, 2.5, 3, 3, 4, 4, 6, 8, 10]
    assert rows.side.tolist() == [1, 1, -1, 1, -1, 1, -1, 1, 1, 1, -1]


def test_a_jump_within_rounding_of_a_step_is_that_step() -> None:
    rows = time_rows(0.3, 3, (0.1 * (1 + 4e-16),))
    assert rows.labels == ("0", "1-", "1", "2", "3")


def test_the_last_step_is_the_duration() -> None:
    """0.1 * 3 / 3 is not 0.1."""
    assert time_rows(0.1, 3, ()).t[-1] == 0.1


def test_a_knot_has_one_row() -> None:
    rows = time_rows(4.0, 2, (0.0, 3.0, 4.0), (1.0, 2.0, 3.5))
    assert rows.labels == ("0", "0'", "1", "1'-", "1'", "1''", "2")
    assert rows.side.tolist() == [1, 1, 1, -1, 1, 1, -1]


def test_no_duration_is_one_row() -> None:
    assert time_rows(0.0, 8, ()).labels == ("0",)


def test_extremes_of_a_law_with_jumps() -> None:
    law = by_travel(1.3, 0.4, 0.8)
    names = [("s", "m"), ("v", "m/s"), ("a", "m/s^2")]
    s, v, a = extremes(lambda t: motion(law, t), law.duration, law.instants, names)
    assert (s.least, s.largest) == pytest.approx((0, 1.3), abs=1e-14)
    assert (v.largest, v.largest_at) == pytest.approx((0.4, 0.5), rel=1e-13)
    assert (a.largest, a.largest_at, a.least, a.least_at) == pytest.approx((0.8, 0.0, -0.8, 3.25), abs=1e-13)
    assert a.size == (a.largest, a.largest_at)


def test_extremes_inside_the_panels() -> None:
    """Of cos(3 t) exp(-t/5) the derivative vanishes at tan(3 t) = -1/15."""
    (found,) = extremes(lambda t: (np.cos(3 * t) * np.exp(-t / 5))[None], 7.0, (), [("y", "")])
    at = (np.pi - np.arctan(1 / 15)) / 3
    assert found.least_at == pytest.approx(at, abs=1e-9)
    assert found.least == pytest.approx(np.cos(3 * at) * np.exp(-at / 5), rel=1e-13)
    assert (found.largest, found.largest_at) == pytest.approx((1.0, 0.0), abs=1e-12)


def test_the_first_of_equal_extremes_counts_and_noise_is_zero() -> None:
    def rows(t: Any) -> Any:
        return np.stack((np.sin(2 * np.pi * t), 1e-17 * np.cos(50 * t) + 0 * t, 3 + 0 * t))

    wave, _, level = extremes(rows, 4.0, (), [("a", ""), ("b", ""), ("c", "")])
    assert wave.largest_at == pytest.approx(0.25, abs=1e-7)
    assert wave.least_at == pytest.approx(0.75, abs=1e-7)
    assert (level.least, level.largest) == pytest.approx((3, 3), rel=1e-14)
    assert (level.least_at, level.largest_at) == (0.0, 0.0)
