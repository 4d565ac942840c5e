"""Tolerances that are balanced at equal yield, against the closed forms of normal sums."""

from __future__ import annotations

import numpy as np
import pytest

from tmmcalc.design.differences import slope, steps
from tmmcalc.design.tolerance.balance import Law
from tmmcalc.design.tolerance.sources import Dimension, Sources, Values
from tmmcalc.design.tolerance.study import Tolerated, study
from tmmcalc.design.tolerance.yields import Rule

WIDTHS = (0.3, 0.2, 0.1)


def balanced(law: Law, samples: int = 2**15) -> Tolerated:
    """y = a + b + c, normal, within its limits; the result is linear."""
    sources = Sources(3, tuple(Dimension("abc"[at], at, -width, width) for at, width in enumerate(WIDTHS)))
    slopes = [[slope(1.0, 0.0, steps(1.0))] * 3]

    def results(x: Values) -> Values:
        return x.sum(axis=1, keepdims=True)

    rule = Rule("y", {"y": (0, (-0.2, 0.2))}, {})
    return study(
        ["y"], [*"abc"], np.zeros(3), np.zeros(1), sources, slopes, results, lambda x: (results(x), [""] * len(x)),
        rule, samples=samples, seed=1, law=law,
    )  # fmt: skip


@pytest.mark.parametrize(("law", "power"), [("cost", -1 / 3), ("share", -1 / 2)])
def test_equal_yield_is_equal_variance_of_a_sum(law: Law, power: float) -> None:
    found = balanced(law).balance
    assert found is not None
    variances = np.array(WIDTHS) ** 2
    exact = variances**power
    exact *= np.sqrt(variances.sum() / (variances @ exact**2))
    assert found.factors == pytest.approx(exact, rel=0.01 if found.rounds == 1 else 0.04)
    assert found.after.value == pytest.approx(found.before.value, abs=5e-3)  # of 8192 samples
    assert found.after.value >= found.before.value
    if law == "share":
        shares = variances * found.factors**2
        assert shares == pytest.approx(np.full(3, shares.mean()), rel=1e-9)


def test_least_cost_is_least() -> None:
    """No other widths of the same variance cost less: a thousand at random."""
    found = balanced("cost", 4096).balance
    assert found is not None
    variances = np.array(WIDTHS) ** 2
    others = np.exp(np.random.default_rng(2).normal(size=(1000, 3)))
    others *= np.sqrt((variances @ found.factors**2) / (others**2 @ variances))[:, None]
    assert found.cost == pytest.approx(np.mean(1 / found.factors))
    assert found.cost <= np.mean(1 / others, axis=1).min()
    assert found.cost < 1.0
