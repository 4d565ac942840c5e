"""Functions joined point by point give what their values joined give, and serve an optimiser."""

from __future__ import annotations

import numpy as np
import pytest

import tmmcalc
from tmmcalc.feasibility import logic
from tmmcalc.feasibility.logic import FORMS, Form, Values

X, Y = np.meshgrid(np.linspace(-2, 2, 31), np.linspace(-2, 2, 29))


def disk(x: Values, y: Values) -> Values:
    return np.asarray(1 - x**2 - y**2)


def right(x: Values, y: Values) -> Values:
    return np.asarray(x - 0.25)


@pytest.mark.parametrize("form", FORMS)
def test_functions_join_as_their_values_do(form: Form) -> None:
    f, g = disk(X, Y), right(X, Y)
    assert np.array_equal(tmmcalc.conjunction(disk, right, form, 2)(X, Y), logic.conjunction(f, g, form, 2))
    assert np.array_equal(tmmcalc.disjunction(disk, g, form, 2)(X, Y), logic.disjunction(f, g, form, 2))
    assert np.array_equal(tmmcalc.disjunction(f, g, form), logic.disjunction(f, g, form))


def test_a_region_of_a_region() -> None:
    """The half disk without a hole, against plain logic."""
    hole = tmmcalc.negation(lambda x, y: 0.1 - (x - 0.5) ** 2 - y**2)
    region = tmmcalc.characteristic(tmmcalc.conjunction(tmmcalc.conjunction(disk, right), hole))
    outside = tmmcalc.complement(region)
    truth = (disk(X, Y) >= 0) & (X >= 0.25) & (0.1 - (X - 0.5) ** 2 - Y**2 <= 0)
    assert np.array_equal(region(X, Y), truth.astype(float))
    assert np.array_equal(outside(x=X, y=Y), 1.0 - truth)


def test_an_optimiser_finds_the_corner_of_a_smooth_region() -> None:
    """The highest point of disk and half plane is where their borders meet."""
    optimize = pytest.importorskip("scipy.optimize")
    region = tmmcalc.conjunction(disk, lambda x, y: x - 0.6, "R0")
    constraint = {"type": "ineq", "fun": lambda p: float(region(p[0], p[1]))}
    found = optimize.minimize(lambda p: -p[1], [0.7, 0.1], constraints=[constraint], method="SLSQP", tol=1e-12)
    assert found.x == pytest.approx([0.6, 0.8], abs=1e-4)
