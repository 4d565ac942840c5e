"""Characteristic functions and R-functions against worked numbers, Boolean logic and derivatives."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmmcalc import UsageError
from tmmcalc.feasibility.logic import FORMS, Form, characteristic, complement, conjunction, disjunction, negation

CASES = json.loads((Path(__file__).parents[1] / "cases" / "force-groups-and-linkage-synthesis.json").read_text())
ROWS = next(case for case in CASES if case["id"] == "B-CHAR-01")["expected"]["rows"]


@pytest.mark.parametrize("row", ROWS)
def test_two_regions(row: dict[str, Any]) -> None:
    x, y = row["point"]
    f, g = 1 - x**2 - y**2, x - 0.25
    assert characteristic(f) == row["X_f"]
    assert characteristic(g) == row["X_g"]
    assert complement(characteristic(f)) == row["X_not_f"]
    assert characteristic(conjunction(f, g)) == row["X_and"]
    assert characteristic(disjunction(f, g)) == row["X_or"]
    assert conjunction(f, g, "R0") == pytest.approx(row["R0_and"], abs=1e-9)
    assert disjunction(f, g, "R0") == pytest.approx(row["R0_or"], abs=1e-9)


@pytest.mark.parametrize("form", FORMS)
def test_signs_are_those_of_the_logic(form: Form) -> None:
    """On a fine grid of signs and sizes, down to where a plain sum would cancel."""
    sizes = np.concatenate((-np.logspace(-12, 6, 40), [0.0], np.logspace(-12, 6, 40)))
    f, g = np.meshgrid(sizes, sizes)
    assert np.array_equal(conjunction(f, g, form, 2) >= 0, (f >= 0) & (g >= 0))
    assert np.array_equal(disjunction(f, g, form, 2) >= 0, (f >= 0) | (g >= 0))


@pytest.mark.parametrize("form", FORMS)
def test_the_laws_of_de_morgan(form: Form) -> None:
    f, g = np.random.default_rng(3).normal(size=(2, 50))
    both = conjunction(f, g, form)
    assert negation(both) == pytest.approx(disjunction(negation(f), negation(g), form), rel=1e-13)


def test_r_functions_in_extended_precision() -> None:
    f, g = (np.exp(np.random.default_rng(k).normal(size=200) * 8) for k in (1, 2))
    a, b = f.astype(np.longdouble), g.astype(np.longdouble)
    exact = 2 * a * b / (a + b + np.sqrt(a * a + b * b))
    assert np.max(np.abs(conjunction(f, g, "R0") / exact - 1)) < 1e-15


def test_rm_is_smooth_where_both_vanish() -> None:
    """Derivatives of R0 jump at f = g = 0, those of Rm do not."""
    step = 1e-6
    slopes = {}
    for form in ("R0", "Rm"):
        ahead, behind = (float(conjunction(sign * step, 0.0, form, 2)) for sign in (1.0, -1.0))
        slopes[form] = abs(ahead / step - behind / -step)
    assert slopes["R0"] > 1
    assert slopes["Rm"] < 1e-9


def test_a_form_that_there_is_not() -> None:
    form: Any = "R9"
    with pytest.raises(UsageError, match="no form 'R9'"):
        conjunction(1.0, 2.0, form)


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("m", [1, 9])
def test_signs_outlive_overflow_and_underflow(form: Form, m: int) -> None:
    sizes = np.concatenate((-np.logspace(-300, 300, 61), [0.0], np.logspace(-300, 300, 61)))
    f, g = np.meshgrid(sizes, sizes)
    with np.errstate(all="raise", under="ignore"):
        both, either = conjunction(f, g, form, m), disjunction(f, g, form, m)
    assert np.array_equal(both >= 0, (f >= 0) & (g >= 0))
    assert np.array_equal(either >= 0, (f >= 0) | (g >= 0))
    assert np.isfinite(both).all()
    assert np.isfinite(either).all()
