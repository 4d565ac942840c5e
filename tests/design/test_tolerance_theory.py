"""What varies, samples and their intervals, linear theory, worst cases and yield, against closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tmmcalc.design.differences import slope, steps
from tmmcalc.design.tolerance.linear import linear
from tmmcalc.design.tolerance.sampling import points, share, statistics, wilson
from tmmcalc.design.tolerance.sources import Clearance, Dimension, Sources, Values
from tmmcalc.design.tolerance.study import study
from tmmcalc.design.tolerance.worst import worst_cases
from tmmcalc.design.tolerance.yields import MOST, Rule, widenings

MIXED = Sources(
    5,
    (
        Dimension("a", 0, -0.3, 0.3),
        Dimension("b", 1, -0.2, 0.4, "uniform"),
        Dimension("c", 2, -0.1, 0.1, "normal", (), "bores", 0.5),
        Dimension("d", 3, -0.1, 0.3, "triangular", (), "bores", 0.7),
        Dimension("e", 4, -1.0, 2.0, "measured", (-1.0, 0.0, 0.5, 2.0)),
    ),
)


def sampled(sources: Sources, count: int = 2**14, seed: int = 1) -> Values:
    return np.asarray(sources.parts(points(sources, count, seed)).sum(axis=1))


def test_samples_have_the_moments_of_their_distributions() -> None:
    found = sampled(MIXED, 2**15)
    assert found.mean(axis=0) == pytest.approx(MIXED.mean(), abs=2e-4)
    assert np.cov(found.T) == pytest.approx(MIXED.covariances().sum(axis=0), abs=2e-4)
    assert {*np.unique(found[:, 4])} == {-1.0, 0.0, 0.5, 2.0}
    assert found[:, 1].min() >= -0.2
    assert found[:, 1].max() <= 0.4
    for column, kurtosis in ((0, 3.0), (1, 1.8), (3, 2.4)):  # of normal, uniform, triangular
        apart = (found[:, column] - found[:, column].mean()) / found[:, column].std()
        assert float(np.mean(apart**4)) == pytest.approx(kurtosis, abs=0.03)


def test_the_same_seed_gives_the_same_samples() -> None:
    assert np.array_equal(sampled(MIXED, 256), sampled(MIXED, 256))
    assert not np.array_equal(sampled(MIXED, 256), sampled(MIXED, 256, seed=2))


def test_linear_and_sampled_agree_of_a_linear_function() -> None:
    slopes = np.array([[1.0, 2.0, 3.0, 4.0, 0.5]])
    found = statistics(sampled(MIXED) @ slopes[0])
    told = linear(MIXED, np.zeros(1), slopes)
    assert found.sigma.value == pytest.approx(told.sigma[0], rel=2e-3)
    assert abs(found.mean.value - told.mean[0]) < 3e-4
    assert told.shares.sum() == pytest.approx(1.0)


@pytest.mark.parametrize("correlation", [0.25, 0.8, 1.0])
def test_a_sum_and_a_difference_of_correlated_pairs(correlation: float) -> None:
    pair = [Dimension(name, at, -0.3, 0.3, "normal", (), "g", correlation) for at, name in enumerate("ab")]
    sources = Sources(2, tuple(pair))
    both = sampled(sources)
    for sign in (1, -1):
        exact = math.sqrt(0.02 * (1 + sign * correlation))
        assert linear(sources, np.zeros(1), np.array([[1.0, sign]])).sigma[0] == pytest.approx(exact, abs=1e-12)
        assert float(np.std(both @ [1, sign])) == pytest.approx(exact, rel=2e-3, abs=1e-12)


def test_a_product_of_lognormal_sizes_is_no_normal_one() -> None:
    """exp(x + y): mean and sigma of a lognormal distribution, which the linear model misses."""
    sources = Sources(2, (Dimension("x", 0, -0.9, 0.9), Dimension("y", 1, -1.2, 1.2)))
    variance = 0.3**2 + 0.4**2
    mean = math.exp(variance / 2)
    sigma = mean * math.sqrt(math.expm1(variance))
    skewness = (math.exp(variance) + 2) * math.sqrt(math.expm1(variance))
    found = statistics(np.exp(sampled(sources, 2**16).sum(axis=1)))
    assert found.mean.value == pytest.approx(mean, rel=1e-3)
    assert found.sigma.value == pytest.approx(sigma, rel=1e-2)
    assert found.skewness.value == pytest.approx(skewness, rel=0.1)
    median = found.quantiles[2]
    assert median.low < 1.0 < median.high
    told = linear(sources, np.ones(1), np.ones((1, 2)))
    assert told.sigma[0] == pytest.approx(math.sqrt(variance), rel=1e-12)
    assert told.sigma[0] < 0.9 * sigma


@pytest.mark.parametrize("k", [2, 3, 4])
def test_a_ball_is_its_part_of_a_cube(k: int) -> None:
    sources = Sources(k, tuple(Dimension(str(at), at, -1.0, 1.0, "uniform") for at in range(k)))
    found = share(np.sum(sampled(sources) ** 2, axis=1) <= 1)
    assert found.low < ball(k) < found.high
    assert found.high - found.low < 0.02


def ball(k: int) -> float:
    """Volume of the unit ball as a part of its cube."""
    return math.pi ** (k / 2) / math.gamma(k / 2 + 1) / 2**k


@pytest.mark.slow
def test_intervals_hold_the_truth_as_often_as_they_say() -> None:
    """200 seeds; by the binomial law 181 to 198 of 200 are within 3 sigma of 95 %; Wilson's intervals hold more.

    exp(0.3 x) of one normal x is the hardest kind: the outermost strata of one variable make all of the error, which is
    no normal one, and the interval of the mean holds 90 to 93 %. That of several variables holds what it says.
    """
    k = 5
    uniform = tuple(Dimension(str(at), at, -1.0, 1.0, "uniform") for at in range(k))
    normal = tuple(Dimension(name, k + at, -3.0, 3.0) for at, name in enumerate("xyz"))
    sources = Sources(k + 3, (*uniform, *normal))
    truth = {"ball": ball(k), "mean": math.exp(0.045), "sigma": math.exp(0.045) * math.sqrt(math.expm1(0.09))}
    truth |= {"5 %": math.exp(-0.3 * 1.6448536), "95 %": math.exp(0.3 * 1.6448536)}
    truth["several"] = math.exp(0.135)
    hits = dict.fromkeys(truth, 0)
    for seed in range(200):
        found = sampled(sources, 1024, seed)
        told = statistics(np.exp(0.3 * found[:, k]))
        estimates = {"ball": share(np.sum(found[:, :k] ** 2, axis=1) <= 1), "mean": told.mean, "sigma": told.sigma}
        estimates |= {"5 %": told.quantiles[1], "95 %": told.quantiles[3]}
        estimates["several"] = statistics(np.exp(0.3 * found[:, k:].sum(axis=1))).mean
        for name, each in estimates.items():
            hits[name] += each.low <= truth[name] <= each.high
    assert hits.pop("mean") >= 175, hits
    assert all(count >= 181 for count in hits.values()), str(hits)
    assert all(hits[name] <= 199 for name in ("ball", "sigma", "several")), hits


def test_wilson_covers_at_few_failures() -> None:
    assert wilson(0, 100).low == 0.0
    assert wilson(0, 100).high == pytest.approx(0.0370, abs=1e-4)
    assert share(np.ones(1024, bool)).low < 1.0


def test_the_worst_case_of_a_monotonic_function_is_a_corner() -> None:
    (found,) = worst_cases(lambda x: np.exp(x @ [[1.0], [-2.0], [3.0], [1.0], [1.0]]), MIXED, np.zeros(5), 1)
    assert found.how == "signs"
    assert found.turned == ()
    assert found.largest == pytest.approx(math.exp(0.3 + 0.4 + 0.3 + 0.3 + 2.0))
    assert found.least == pytest.approx(math.exp(-0.3 - 0.8 - 0.3 - 0.1 - 1.0))


def test_the_worst_case_of_one_that_turns_is_searched_and_found() -> None:
    sources = Sources(2, (Dimension("a", 0, -0.3, 0.3), Dimension("b", 1, -0.2, 0.4)))
    (found,) = worst_cases(lambda x: np.sin(20 * x[:, :1]) + x[:, 1:], sources, np.zeros(2), 1)
    assert found.how == "search"
    assert found.turned == ("a",)
    assert (found.least, found.largest) == pytest.approx((-1.2, 1.4), abs=1e-8)


def test_places_without_a_result_are_searched_around() -> None:
    sources = Sources(1, (Dimension("a", 0, -1.0, 1.0),))
    (found,) = worst_cases(lambda x: np.where(x > 0.5, np.nan, x), sources, np.zeros(1), 1)
    assert found.how == "search"
    assert found.lost > 0
    assert (found.least, found.largest) == pytest.approx((-1.0, 0.5), abs=1e-4)
    (found,) = worst_cases(lambda x: np.full_like(x, np.nan), sources, np.zeros(1), 1)
    assert found.how == "none"


def test_a_clearance_turns_to_where_it_is_worst() -> None:
    play = Dimension("A", 0, 0.1, 0.1)
    pin = Sources(2, (), (Clearance("A", (0, 1), play, None, False, (1.0, 1000.0)),))  # y in another unit
    angle = np.linspace(0, 2 * np.pi, 100_001)
    exact = (0.1 * np.cos(angle) - 2) ** 2 + 0.1 * np.sin(angle)
    (found,) = worst_cases(lambda x: (x[:, :1] - 2) ** 2 + x[:, 1:] / 1000, pin, np.zeros(2), 1)
    assert (found.least, found.largest) == pytest.approx((exact.min(), exact.max()), abs=1e-7)
    told = linear(pin, np.zeros(1), np.array([[3.0, 0.004]]))
    assert told.largest[0] == pytest.approx(0.5)
    assert told.sigma[0] == pytest.approx(0.5 / math.sqrt(2))
    guide = Sources(2, (), (Clearance("B", (0, 1), play, (0.6, 0.8), True),))
    assert np.unique(np.round(sampled(guide, 64), 12), axis=0).tolist() == [[-0.06, -0.08], [0.06, 0.08]]
    assert linear(guide, np.zeros(1), np.array([[1.0, 1.0]])).sigma[0] == pytest.approx(0.14)


def test_widening_and_narrowing_by_the_normal_law() -> None:
    """y = a + b within +-0.3: sigma is known, so is the factor of b at which 0.5 % of the yield are lost."""
    sources = Sources(2, (Dimension("a", 0, -0.3, 0.3), Dimension("b", 1, -0.03, 0.03)))
    rule = Rule("y", {"y": (0, (-0.25, 0.25))}, {})
    parts = sources.parts(points(sources, 2**15, 3)) @ np.ones((2, 1))
    told = linear(sources, np.zeros(1), np.ones((1, 2)))
    found = widenings(rule.holds, sources.names, np.zeros(1), parts, told.shares)
    before = math.erf(0.25 / told.sigma[0] / math.sqrt(2))
    assert found.linear_yield == pytest.approx(before, abs=2e-4)
    assert [each.name for each in found.parts] == ["a", "b"]
    factor = found.parts[1].factor
    after = math.erf(0.25 / math.hypot(0.1, 0.01 * factor) / math.sqrt(2))
    assert before - after == pytest.approx(0.005, abs=3e-4)
    assert found.parts[0].gain == pytest.approx(
        math.erf(0.25 / math.hypot(0.05, 0.01) / math.sqrt(2)) - before, abs=3e-4
    )
    assert found.together == ("b",)
    free = Rule("y", {"y": (0, (None, 1e9))}, {})
    assert widenings(free.holds, sources.names, np.zeros(1), parts, told.shares).common == MOST


def test_the_rule_is_that_of_the_constraints() -> None:
    rule = Rule("(low or not far) and fixed", {"low": (0, (None, 1.0)), "far": (1, (5.0, None))}, {"fixed": True})
    results = np.array([[0.0, 9.0], [2.0, 9.0], [2.0, 1.0], [np.nan, 1.0]])
    assert rule.holds(results).tolist() == [True, False, True, False]
    assert rule.failing(results) == {"low": 3, "far": 2}


def test_a_study_counts_what_did_not_assemble() -> None:
    sources = Sources(1, (Dimension("a", 0, -1.0, 1.0, "uniform"),))

    def results(x: Values) -> Values:
        return np.where(x > 0.5, np.nan, x)

    def solved(x: Values) -> tuple[Values, list[str]]:
        return results(x), [f"B: no assembly at {each:g} deg" if each > 0.5 else "" for each in x[:, 0]]

    rule = Rule("y", {"y": (0, (-0.5, None))}, {})
    slopes = [[slope(1.0, 0.0, steps(1.0))]]
    found = study(["y"], ["a"], np.zeros(1), np.zeros(1), sources, slopes, results, solved, rule, samples=1024, seed=1)
    (refused,) = found.refusals
    assert refused.count == 256
    assert found.good is not None
    assert found.good.value == pytest.approx(0.5, abs=1e-3)
    assert found.statistics[0] is not None
    assert found.statistics[0].count == 768
    assert found.worst[0].how == "search"
