"""Bounds of e and limits of the number of planets: cases GT-S04, S05, S07, S08, and what the bounds exclude."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gears.criteria.worked import CASES, task
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.bounds import half_pitch, most_planets, single_planet_limits, step_bounds
from tmmcalc.gears.model import Limits


def test_double_planets() -> None:
    expected = CASES["GT-S07"]["expected"]
    found = step_bounds(task("AI", "22", "0.5", planets=3), (2, 3))
    assert found.neighbours_book is not None
    assert found.neighbours is not None
    assert (found.teeth.p, found.teeth.q) == pytest.approx((expected["p"], expected["q"]), abs=1e-6)
    assert found.teeth.root == pytest.approx(expected["e_min_teeth_root"], abs=1e-6)
    book = found.neighbours_book
    assert (book.p, book.q) == pytest.approx((expected["p_nb"], expected["q_nb"]), abs=1e-6)
    assert book.root == pytest.approx(expected["e_min_neighbour_root_book"], abs=1e-6)
    assert found.neighbours.root == pytest.approx(expected["e_min_neighbour_root_exact"], abs=1e-6)
    assert (found.first, found.largest) == (expected["e_min_teeth"], expected["e_max"])
    assert found.compatible


def test_second_double_planets_and_coaxial() -> None:
    expected = CASES["GT-S08"]["expected"]
    found = step_bounds(task("AI", "30.29", "0.5", planets=3), (4, 7))
    assert found.neighbours_book is not None
    assert found.neighbours is not None
    roots = [found.teeth.root, found.neighbours_book.root, found.neighbours.root]
    keys = ("e_min_teeth_root", "e_min_neighbour_root_book", "e_min_neighbour_root_exact")
    assert roots == pytest.approx([expected[key] for key in keys], abs=1e-6)
    plain = step_bounds(task("coaxial", "8.15", "0.08", limits=Limits(largest=100)), (2, 3))
    assert plain.teeth.root == pytest.approx(CASES["GT-S04"]["expected"]["e_min_root"], abs=1e-6)
    assert (plain.first, plain.neighbours, plain.neighbours_book) == (27, None, None)


@pytest.mark.parametrize(
    ("layout", "ratio", "proportion"), [("AI", 22, (2, 3)), ("AI", 30, (4, 7)), ("AA", 8, (2, 3)), ("AA", 14, (1, 2))]
)
def test_no_train_lies_below_the_bound(layout: str, ratio: int, proportion: tuple[int, int]) -> None:
    """All real trains with Z1, Z2' >= 17 and neighbours apart have an e at or above the exact bound at their ratio."""
    work = task(layout, str(ratio), "0", planets=3)
    mu1, mu2 = proportion
    side, s = (1 if layout == "AI" else -1), half_pitch(3)
    least = math.inf
    for tenth in range(100, 1500):
        e = tenth / 10
        for p in [17 + k / 4 for k in range(200)]:
            z3 = e * mu1 + side * p
            if z3 <= 0:
                break
            z2 = e * mu2 / (1 + z3 / (ratio * p))
            if e * mu2 - z2 >= 17 and e * mu2 * s > z2 + 3:
                least = min(least, e)
                break
    found = step_bounds(work, proportion)
    assert found.first - 1 <= least <= found.first + 1e-9 or least == pytest.approx(found.first, abs=1.1)
    assert found.neighbours is not None
    bound = (
        max(found.teeth.root, found.neighbours.root) if found.first > math.ceil(found.teeth.root) else found.teeth.root
    )
    assert bound <= least + 1e-9
    assert least - bound < 0.6


def test_incompatible() -> None:
    assert not step_bounds(task("AI", "300", "1", planets=3), (1, 3)).compatible
    with pytest.raises(UsageError, match="no parameter e"):
        step_bounds(task("AIbar", "6", "0.1", (1,)), (1, 1))


def test_bounds_at_the_least_ratio() -> None:
    work = task("AI", "22", "0.5", planets=3)
    lower, nominal = step_bounds(work, (2, 3), Fraction("21.5")), step_bounds(work, (2, 3))
    assert lower.teeth.root < nominal.teeth.root


def test_limits_of_single_planets() -> None:
    for row in CASES["GT-S05"]["expected"]["rows"]:
        found = single_planet_limits(row["K"])
        assert found.rational == pytest.approx(row["U_rational"], abs=6e-5)
        assert found.permissible == pytest.approx(row["U_permissible"], abs=6e-5)
    assert single_planet_limits(6).permissible == 3.0
    assert single_planet_limits(2).permissible is None


@given(st.floats(1.001, 50.0))
def test_most_planets(ratio: float) -> None:
    found = most_planets(ratio)
    limit = single_planet_limits(found).permissible
    assert limit is None or ratio < limit
    over = single_planet_limits(found + 1).permissible
    assert over is not None
    assert ratio >= over


def test_most_planets_at_the_border() -> None:
    assert most_planets(3.0) == 5  # at K = 6 the planets touch exactly
    assert most_planets(2.999999) == 6
    with pytest.raises(UsageError):
        most_planets(1.0)
    with pytest.raises(UsageError):
        half_pitch(1)
