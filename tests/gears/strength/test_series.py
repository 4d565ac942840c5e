"""Standard modules against enumeration in exact fractions, face widths, outcomes."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from sparing import sparing

from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.strength.series import EIGHTHS, Outcome, choose, choose_tied, eighths, round_up, tied
from tmmcalc.gears.strength.solve import adapted, face_width

SERIES = {rows: [Fraction(m, EIGHTHS) for m in eighths(rows)] for rows in (1, 2)}
PROPORTIONS = [(1, 1), (2, 3), (4, 7), (3, 4), (5, 8), (9, 14), (2, 1), (11, 13), (1, 40), (7, 5)]


def smallest_pair(required: tuple[float, float], mu: tuple[int, int], rows: int) -> tuple[float, float] | None:
    pairs = [(a, b) for a, b in product(SERIES[rows], repeat=2) if a * mu[1] == b * mu[0]]
    enough = [pair for pair in pairs if all(m >= r for m, r in zip(pair, required, strict=True))]
    best = min(enough, default=None)
    return None if best is None else (float(best[0]), float(best[1]))


@sparing("rows", [1, 2], every=2)
def test_pairs_against_enumeration(rows: int) -> None:
    rng = np.random.default_rng(3)
    required = np.exp(rng.uniform(np.log(0.3e-3), np.log(50e-3), (300, 2)))
    mu = np.array([PROPORTIONS[k] for k in rng.integers(0, len(PROPORTIONS), 300)])
    module, outcome = choose_tied(required, mu, rows, 0.0, scale=True)
    counts = {int(kind): 0 for kind in Outcome}
    for k in range(300):
        best = smallest_pair(tuple(required[k]), tuple(mu[k].tolist()), rows)
        counts[int(outcome[k])] += 1
        if best is None:
            assert outcome[k] in (Outcome.NO_MODULE, Outcome.NO_PAIR)
            assert (module[k] >= required[k] * (1 - 1e-12)).all()
            assert module[k, 0] * mu[k, 1] == pytest.approx(module[k, 1] * mu[k, 0], rel=1e-14)
        else:
            assert outcome[k] == Outcome.ACCEPTED
            assert tuple(module[k]) == best
    assert counts[Outcome.ACCEPTED] > 50
    assert counts[Outcome.NO_MODULE] > 5
    assert counts[Outcome.NO_PAIR] > 5


def test_three_tied_stages() -> None:
    module, outcome = choose_tied(np.array([[1.1e-3, 1e-3, 3.2e-3]]), np.array([[2, 3, 4]]), 2, 0.0, scale=True)
    assert list(module[0] * 1000) == [2, 3, 4]
    assert outcome[0] == Outcome.ACCEPTED


def test_modules_that_stages_choose_for_themselves() -> None:
    required = np.array([[1.1e-3, 2.3e-3], [1.1e-3, 41e-3]])
    module, outcome = choose(required, 2, 0.0)
    assert list(outcome) == [Outcome.ACCEPTED, Outcome.NO_MODULE]
    np.testing.assert_array_equal(module[0], [1.125e-3, 2.5e-3])
    assert module[1, 1] == 41e-3  # what is required stands where the table has nothing


def test_a_standard_module_is_enough_for_itself() -> None:
    for rows in (1, 2):
        series = np.array(eighths(rows)) / EIGHTHS
        for slip in (1.0, 1 + 2e-16, 1 - 2e-16):
            np.testing.assert_array_equal(round_up(series * slip, rows)[0], series)
        above, found = round_up(series * (1 + 1e-9), rows)
        np.testing.assert_array_equal(above[:-1], series[1:])
        assert list(found) == [True] * (len(series) - 1) + [False]


def test_layouts_with_tied_modules() -> None:
    assert {key for key, layout in LAYOUTS.items() if tied(layout)} == {"coaxial", "AI", "AA", "II", "AII"}


def test_rounding_of_widths() -> None:
    module = np.array([2e-3, 2e-3, 2e-3])
    psi = np.array([0.6, 0.61, 0.6 + 1e-13])
    np.testing.assert_array_equal(face_width(psi, module, 20 * np.ones(3)) * 1000, [24, 25, 24])
    np.testing.assert_array_equal(face_width(psi, module, 20 * np.ones(3), "floor1") * 1000, [25, 25, 25])


def test_width_keeps_b_d_squared() -> None:
    """b d^2 of the standard module is that of the required one at psi."""
    required, module, teeth, psi = np.array(1.758e-3), np.array(2e-3), 26.0, 0.6
    b = adapted(psi, required, module) * module * teeth
    assert b * (module * teeth) ** 2 == pytest.approx(psi * required * teeth * (required * teeth) ** 2, rel=1e-14)
