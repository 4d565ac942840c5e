"""Two trains in series against a plain loop over all pairs."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from gears.criteria.worked import TEETH, lengths, sets, task
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.criteria import series as module
from tmmcalc.gears.criteria.choice import front, least
from tmmcalc.gears.criteria.comparison import compare
from tmmcalc.gears.criteria.evaluate import Criteria, evaluate
from tmmcalc.gears.criteria.objectives import OBJECTIVES
from tmmcalc.gears.criteria.series import series
from tmmcalc.gears.exact import around
from tmmcalc.gears.model import Interval, ToothSets
from tmmcalc.gears.stepping import stepped


def candidates(ratio: str, size: float) -> tuple[ToothSets, Criteria]:
    train = stepped(task("AIbar", ratio, "0.1", (1,), planets=3)).sets
    return train, evaluate(train, lengths(train, size), lengths(train, 10 * size))


def test_against_all_pairs(monkeypatch: pytest.MonkeyPatch) -> None:
    (one, a), (two, b) = candidates("4.59", 0.002), candidates("4.7", 0.004)
    nominal = Fraction("31.9")
    admitted = around(nominal, Fraction("0.01"), relative=True)
    truth = []
    for i, first in enumerate(one.teeth.tolist()):
        for j, second in enumerate(two.teeth.tolist()):
            r1, r2 = 1 + Fraction(first[2], first[0]), 1 + Fraction(second[2], second[0])
            if admitted.low <= r1 * r2 <= admitted.high:
                inertia = a.inertia[i] * float(r2) ** 2 + b.inertia[j]
                error = float(abs(r1 * r2 / nominal - 1))
                truth.append((i, j, a.mass[i] + b.mass[j], inertia, max(a.size[i], b.size[j]), error))
    monkeypatch.setattr(module, "PAIRS", 500)  # several blocks
    found = series((one, two), (a, b), nominal, admitted)
    assert 0 < len(found) < found.tried == len(one) * len(two)
    pairs = list(zip(found.first.tolist(), found.second.tolist(), strict=True))
    assert pairs == [row[:2] for row in truth]
    for column, values in enumerate((found.mass, found.inertia, found.size, found.error), 2):
        assert values == pytest.approx([row[column] for row in truth], rel=1e-14)
    assert found.efficiency == pytest.approx(a.efficiency[found.first] * b.efficiency[found.second], rel=1e-15)


def test_borders_of_the_product_are_admitted() -> None:
    one, two = sets("AIbar", [[20, 52, 124]], 3), sets("AIbar", [[25, 65, 155]], 3)  # both 7.2
    a, b = (evaluate(each, lengths(each, 0.002), lengths(each, 0.02)) for each in (one, two))
    border = Fraction("51.84")
    for interval in (Interval(border, border), Interval(border - 1, border), Interval(border, border + 1)):
        assert len(series((one, two), (a, b), border, interval)) == 1
    least_above = Interval(border + Fraction(1, 10**30), border + 1)
    with pytest.raises(NoSolutionError, match="none of 1 pairs"):
        series((one, two), (a, b), border, least_above)


def test_negative_ratio_and_long_fractions() -> None:
    """Products whose terms do not fit 64-bit comparisons are compared without limit."""
    teeth = [[149, 151, 127, 139], [137, 139, 149, 151]]
    one = two = sets("AA", teeth)
    criteria = evaluate(one, lengths(one, 0.002, 0.002), lengths(one, 0.02, 0.02))
    i = [1 - Fraction(z2 * z3, z1 * p) for z1, z2, p, z3 in teeth]
    product = i[0] * i[1]
    found = series((one, two), (criteria, criteria), product, Interval(product, product))
    assert sorted(zip(found.first.tolist(), found.second.tolist(), strict=True)) == [(0, 1), (1, 0)]
    mixed = sets("AI", TEETH["AI"][:1], 1)
    other = evaluate(mixed, lengths(mixed, 0.002, 0.002), lengths(mixed, 0.02, 0.02))
    product = i[0] * (1 + Fraction(118 * 97, 22 * 17))
    found = series((one, mixed), (criteria, other), product, Interval(product, product))
    assert found.ratio == pytest.approx([float(product)], rel=1e-14)


def test_locking_trains_do_not_make_a_good_one() -> None:
    train = sets("AA", [[100, 97, 20, 20]])
    criteria = evaluate(train, lengths(train, 0.002, 0.002), lengths(train, 0.02, 0.02))
    assert criteria.efficiency[0] < 0
    ratio = Fraction(3, 100) ** 2
    found = series((train, train), (criteria, criteria), ratio, Interval(ratio, ratio))
    assert found.efficiency[0] == criteria.efficiency[0]


def test_one_train_or_two() -> None:
    """The textbook's example: two trains AIbar weigh less and have less inertia than one AI of the same ratio."""
    single = sets("AI", [[25, 136, 20, 112], [28, 140, 19, 115]], 3)
    alone = evaluate(single, lengths(single, 0.002, 0.0035), lengths(single, 0.018, 0.041))
    one, two = sets("AIbar", [[24, 42, 108]], 3), sets("AIbar", [[24, 42, 108]], 3)
    a = evaluate(one, lengths(one, 0.002), lengths(one, 0.030))
    b = evaluate(two, lengths(two, 0.0035), lengths(two, 0.052))
    nominal = Fraction("30.25")
    pair = series((one, two), (a, b), nominal, around(nominal, Fraction("0.01"), relative=True))
    found = compare({"AI": alone, "AIbar + AIbar": pair}, "inertia")
    assert (found.winner, found.runner_up) == ("AIbar + AIbar", "AI")
    assert found.value == pytest.approx(a.inertia[0] * 5.5**2 + b.inertia[0], rel=1e-14)
    assert least(pair, "mass").winner == 0
    assert front(pair, list(OBJECTIVES)).tolist() == [0]
    assert np.all(pair.envelope >= pair.size)
