"""The Pareto front against comparison of all pairs, on tied, correlated and wholly undominated values."""

from __future__ import annotations

import time

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from sparing import sparing

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.criteria import pareto
from tmmcalc.gears.criteria.pareto import pareto_front
from tmmcalc.gears.model import Values


def by_all_pairs(values: Values) -> list[int]:
    kept = []
    for k, own in enumerate(values):
        dominating = np.all(values <= own, axis=1) & np.any(values < own, axis=1)
        if not dominating.any():
            kept.append(k)
    return kept


@pytest.fixture
def small_groups(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let halving begin at a few rows, so that small samples go through all of it."""
    monkeypatch.setattr(pareto, "SMALL", 3)
    monkeypatch.setattr(pareto, "PAIRS", 4)
    monkeypatch.setattr(pareto, "SIEVE", 1)


@given(
    st.integers(1, 6).flatmap(
        lambda k: arrays(float, st.tuples(st.integers(0, 40), st.just(k)), elements=st.integers(0, 6))
    )
)
def test_tied_values(values: Values) -> None:
    assert pareto_front(values).tolist() == by_all_pairs(values)


@pytest.mark.usefixtures("small_groups")
@sparing("criteria", [2, 3, 4, 5, 6], every=5)
@pytest.mark.parametrize("kind", ["tied", "random", "undominated", "one tied column"])
def test_halving(criteria: int, kind: str) -> None:
    rng = np.random.default_rng(criteria)
    for n in (5, 60, 300):
        values = rng.random((n, criteria))
        if kind == "tied":
            values = np.floor(values * 5)
        elif kind == "undominated":
            values[:, 0] = criteria - values[:, 1:].sum(axis=1)
        elif kind == "one tied column":
            values[:, -1] = np.floor(values[:, -1] * 2)
        assert pareto_front(values).tolist() == by_all_pairs(values)


def test_equal_variants_are_all_kept() -> None:
    assert pareto_front(np.ones((500, 3))).tolist() == list(range(500))
    assert pareto_front(np.array([[1.0, 2.0], [1.0, 2.0], [1.0, 3.0]])).tolist() == [0, 1]


def test_the_least_difference_decides() -> None:
    value = 0.1 + 0.2
    assert pareto_front(np.array([[value, 1.0], [np.nextafter(value, 0), 1.0]])).tolist() == [1]


@sparing(("criteria", "undominated"), [(2, False), (3, False), (4, False), (6, False), (2, True), (3, True)], every=6)
def test_a_hundred_thousand_variants(criteria: int, *, undominated: bool) -> None:
    values = np.random.default_rng(7).random((100_000, criteria))
    if undominated:
        values[:, 0] = criteria - values[:, 1:].sum(axis=1)
    start = time.process_time()
    front = pareto_front(values)
    assert time.process_time() - start < 3  # a third of it on an idle machine
    if undominated:
        assert len(front) == len(values)
    else:
        chosen = values[front]
        some = np.random.default_rng(8).choice(len(values), 200, replace=False)
        for k in some:
            beaten = np.any(np.all(chosen <= values[k], axis=1) & np.any(chosen < values[k], axis=1))
            assert beaten == (k not in front)


def test_faults() -> None:
    assert pareto_front(np.empty((0, 2))).size == 0
    for values in (np.array([[1.0, np.nan]]), np.array([1.0, 2.0]), np.empty((3, 0))):
        with pytest.raises(UsageError):
            pareto_front(values)
