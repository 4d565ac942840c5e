"""Best by one criterion, ranking by weights, comparison of numbers of planets, and reasons."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from gears.criteria.worked import TEETH, lengths, sets
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.criteria.choice import costs, front, least, minima, ranked
from tmmcalc.gears.criteria.comparison import compare
from tmmcalc.gears.criteria.evaluate import Assumptions, Criteria, evaluate, ratio_error
from tmmcalc.gears.criteria.objectives import OBJECTIVES
from tmmcalc.gears.model import Values


def variants(mass: list[float], efficiency: list[float] | None = None) -> Criteria:
    """Variants that differ in mass and efficiency only."""
    n = len(mass)
    one, empty = np.ones(n), np.empty((n, 2))
    eta = one * 0.9 if efficiency is None else np.array(efficiency)
    return Criteria(np.array(mass), one, one, one, empty, one, one, eta, one * 0, empty, one * 0)


def test_least_and_its_runner_up() -> None:
    found = least(variants([3.0, 1.0, 2.0]), "mass")
    assert (found.winner, found.value, found.runner_up, found.runner_up_value, found.tied) == (1, 1.0, 2, 2.0, 0)


def test_efficiency_is_best_when_large() -> None:
    found = least(variants([1.0, 1.0, 1.0], [0.9, 0.95, 0.8]), "efficiency")
    assert (found.winner, found.value, found.runner_up_value) == (1, 0.95, 0.9)
    assert front(variants([1.0, 2.0, 3.0], [0.9, 0.95, 0.8]), ["mass", "efficiency"]).tolist() == [0, 1]


def test_the_first_of_equals() -> None:
    found = least(variants([2.0, 1.0, 1.0, 1.0]), "mass")
    assert (found.winner, found.runner_up, found.tied) == (1, 2, 2)
    alone = least(variants([2.0]), "mass")
    assert (alone.runner_up, alone.runner_up_value) == (None, None)


def test_weights() -> None:
    measured = variants([1.0, 2.0, 5.0], [0.80, 0.95, 0.96])
    only = ranked(measured, {"mass": 2.0})
    assert only.order.tolist() == [0, 1, 2]
    assert only.scores.tolist() == [0.0, 0.25, 1.0]
    both = ranked(measured, {"mass": 1.0, "efficiency": 3.0, "size": 4.0})
    assert both.weights == {"mass": 0.125, "efficiency": 0.375, "size": 0.5}
    truth = np.array([0.375, 0.125 / 4 + 0.375 * 0.01 / 0.16, 0.125])
    assert both.scores == pytest.approx(truth, rel=1e-12)
    assert both.parts.sum(axis=1).tolist() == both.scores.tolist()
    assert (both.reason.criterion, both.reason.winner, both.reason.runner_up) == ("weights", 1, 2)


def test_the_best_by_weights_is_on_the_front() -> None:
    train = sets("AI", [[20 + k, 120 - (k * 7) % 13, 17 + k % 5, 97 + k % 3] for k in range(40)], 3)
    rng = np.random.default_rng(3)
    found = evaluate(train, lengths(train, 0.002, 0.003), lengths(train, 0.02, 0.03), Fraction(30))
    for _ in range(20):
        weights = dict(zip(OBJECTIVES, rng.random(len(OBJECTIVES)), strict=True))
        assert ranked(found, weights).reason.winner in front(found, list(OBJECTIVES))
    assert [reason.criterion for reason in minima(found, ["mass", "size"])] == ["mass", "size"]


def test_costs_are_the_criteria() -> None:
    measured = variants([1.0, 2.0])
    assert costs(measured, ["mass", "efficiency"]).tolist() == [[1.0, -0.9], [2.0, -0.9]]
    for bad in ([], ["weight"]):
        with pytest.raises(UsageError):
            costs(measured, bad)
    for weights in ({"mass": 0.0}, {"mass": -1.0, "size": 2.0}):
        with pytest.raises(UsageError):
            ranked(measured, weights)
    for choose in (lambda: least(variants([]), "mass"), lambda: ranked(variants([]), {"mass": 1.0})):
        with pytest.raises(NoSolutionError):
            choose()


def test_numbers_of_planets() -> None:
    options = {2: variants([5.0, 4.0]), 3: variants([3.0, 3.5, 6.0]), 4: variants([])}
    found = compare(options, "mass")
    assert (found.winner, found.value, found.runner_up, found.runner_up_value) == (3, 3.0, 2, 4.0)
    assert [(best.option, best.count, best.index) for best in found.options] == [(2, 2, 1), (3, 3, 0), (4, 0, None)]
    assert found.options[1].values["mass"] == 3.0
    with pytest.raises(NoSolutionError):
        compare({"none": variants([])}, "mass")


def test_error_of_the_ratio_is_exact() -> None:
    train = sets("AI", TEETH["AI"], 3)
    u = [Fraction(118 * 97, 22 * 17), Fraction(136 * 112, 25 * 20)]
    for nominal in (u[0], Fraction("30.29"), Fraction(10**20 + 1, 3 * 10**18)):
        truth = [float(abs(each / nominal - 1)) for each in u]
        assert ratio_error(train, nominal) == pytest.approx(truth, rel=1e-15)
    assert ratio_error(train, u[0])[0] == 0.0


def test_error_with_the_carrier_driving() -> None:
    """Near U = 1 the error of i_H1 = 1/(1 - U) is the one that counts."""
    train = sets("AA", [[100, 101, 100, 99]])  # U = 0.9999, i_H1 = 10000
    assert ratio_error(train, Fraction("0.9998"), "H")[0] == pytest.approx(1.0, rel=1e-12)
    assert ratio_error(train, Fraction("0.9998"))[0] == pytest.approx(1e-4 / 0.9998, rel=1e-12)


def test_width_over_module() -> None:
    train = sets("AI", TEETH["AI"], 3)
    found = evaluate(train, lengths(train, 0.002, 0.004), np.array([[0.02, 0.016], [0.1, 0.04]]))
    assert found.slenderness.tolist() == [[10.0, 4.0], [50.0, 10.0]]
    assert found.width_deviation == pytest.approx([0.5, 0.25], rel=1e-14)
    assert found.error.tolist() == [0.0, 0.0]


def test_basis() -> None:
    train = sets("AI", TEETH["AI"], 3)
    module, width = lengths(train, 0.002, 0.004), lengths(train, 0.02, 0.04)
    plain, other = (
        evaluate(train, module, width),
        evaluate(train, module, width, basis=Assumptions(reduced_to="1", driver="H")),
    )
    assert other.inertia * other.ratio**2 == pytest.approx(plain.inertia, rel=1e-13)
    assert np.all(other.efficiency < plain.efficiency)
    assert not plain.locking.any()


@pytest.mark.parametrize("wrong", [np.ones((2, 1)), np.array([[1.0, 0.0], [1.0, 1.0]]), np.full((2, 2), np.nan)])
def test_lengths_that_do_not_fit(wrong: Values) -> None:
    train = sets("AI", TEETH["AI"], 3)
    with pytest.raises(UsageError, match="module"):
        evaluate(train, wrong, lengths(train, 0.02, 0.04))
    with pytest.raises(UsageError, match="width"):
        evaluate(train, lengths(train, 0.02, 0.04), wrong)
