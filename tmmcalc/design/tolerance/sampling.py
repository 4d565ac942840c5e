"""Seeded quasi-random samples, and what they tell of results: moments, quantiles, each with its interval.

Points are scrambled Sobol ones in several replicates, scrambled independently: what a statistic differs by from one to
the next gives its interval, by Student's distribution. Sobol's points, scrambled by Owen's way, see A. B. Owen,
Randomly permuted (t,m,s)-nets, 1995; scipy.stats.qmc.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record
from tmmcalc.design.tolerance.sources import Sources, Values

REPLICATES = 16
STUDENT = 2.131449545559323  # 0.975 of Student's distribution with 15 degrees of freedom
NORMAL = 1.959963984540054  # 0.975 of the normal one
QUANTILES: tuple[float, ...] = (0.00135, 0.05, 0.5, 0.95, 0.99865)
OUTER = 1500  # samples from which on the outermost of these are told: two lie beyond each
NOISE = 1e-9  # of what is compared
FEW = 5 * REPLICATES  # samples of the rarer kind below which a share has Wilson's interval


@record
class Estimate:
    """A number with its interval of 95 %."""

    value: float
    low: float
    high: float


@record
class Statistics:
    """Of one result over those samples that have it."""

    count: int
    mean: Estimate
    sigma: Estimate
    skewness: Estimate
    quantiles: tuple[Estimate, ...]  # at QUANTILES
    least: float
    largest: float

    @property
    def told(self) -> dict[float, Estimate]:
        """The quantiles that there are samples enough for."""
        some = enough(self.count)
        return dict(zip(QUANTILES[some], self.quantiles[some], strict=True))


def enough(count: int) -> slice:
    """Which of `QUANTILES` so many samples tell.

    >>> QUANTILES[enough(1024)]
    (0.05, 0.5, 0.95)
    """
    return slice(None) if count >= OUTER else slice(1, -1)


def sizes(samples: int) -> int:
    """Samples that are made where so many are asked for: a power of two in every replicate.

    >>> sizes(16384), sizes(1000)
    (16384, 1024)
    """
    return int(REPLICATES * 2 ** max(1, math.ceil(math.log2(max(samples, 1) / REPLICATES))))


def points(sources: Sources, samples: int, seed: int) -> Values:
    """Points (n, count) of the unit cube, the replicates one after the other."""
    from scipy.stats.qmc import Sobol

    each = sizes(samples) // REPLICATES
    seeds = np.random.SeedSequence(seed).spawn(REPLICATES)
    many = (Sobol(max(sources.count, 1), seed=np.random.default_rng(own)) for own in seeds)
    return np.concatenate([one.random_base2(each.bit_length() - 1) for one in many])


def statistics(values: Values) -> Statistics:
    """Of a result at samples (n,), in replicates one after the other; NaN where a sample has none.

    Raises ValueError where fewer than two samples of a replicate have it.
    """
    blocks = [block[np.isfinite(block)] for block in np.split(np.asarray(values, float), REPLICATES)]
    if min(len(block) for block in blocks) < 2:
        raise ValueError("too few samples have the result")
    whole = np.concatenate(blocks)
    return Statistics(
        len(whole),
        _estimate(np.mean, blocks, whole),
        _sigma(blocks, whole),
        _estimate(_skewness, blocks, whole),
        tuple(_quantile(blocks, whole, q) for q in QUANTILES),
        float(whole.min()),
        float(whole.max()),
    )


def share(held: NDArray[np.bool_]) -> Estimate:
    """The part of samples (n,) that hold, in replicates one after the other.

    By what the replicates differ, where there are enough samples of both kinds; else by Wilson's interval of
    independent ones, which is wider than that of quasi-random ones.
    """
    return _share(np.split(held, REPLICATES))


def wilson(held: int, count: int) -> Estimate:
    """Wilson's interval of a share, E. B. Wilson, 1927.

    >>> found = wilson(10, 10)
    >>> found.value, round(found.low, 4), found.high
    (1.0, 0.7225, 1.0)
    """
    part, z = held / count, NORMAL**2 / count
    middle = (part + z / 2) / (1 + z)
    half = math.sqrt(z * (part * (1 - part) + z / 4)) / (1 + z)
    return Estimate(part, 0.0 if held == 0 else middle - half, 1.0 if held == count else middle + half)


def _share(blocks: Sequence[NDArray[np.bool_]]) -> Estimate:
    held = np.concatenate(blocks)
    many = int(held.sum())
    if min(many, len(held) - many) < FEW:
        return wilson(many, len(held))
    found = _estimate(np.mean, [block.astype(float) for block in blocks], held.astype(float))
    return Estimate(found.value, max(found.low, 0.0), min(found.high, 1.0))


def _quantile(blocks: Sequence[Values], whole: Values, q: float) -> Estimate:
    """Between the quantiles at the ends of the interval of the share that is not above it.

    Quantiles of the few samples of a block have a bias that their scatter does not show. An interval ends at the
    outermost sample at the latest, so that of 0.135 % needs some thousand samples.
    """
    value = float(np.quantile(whole, q))
    part = _share([block <= value for block in blocks])
    ends = np.clip([q + part.low - part.value, q + part.high - part.value], 0.0, 1.0)
    low, high = np.quantile(whole, ends).tolist()
    return Estimate(value, low, high)


def _estimate(told: Callable[[Values], Any], blocks: Sequence[Values], whole: Values) -> Estimate:
    """Of all samples, with the interval by the scatter of the blocks."""
    value = float(told(whole))
    scatter = float(np.std([float(told(block)) for block in blocks], ddof=1))
    half = STUDENT * scatter / math.sqrt(len(blocks))
    return Estimate(value, value - half, value + half)


def _sigma(blocks: Sequence[Values], whole: Values) -> Estimate:
    """By the mean squares of blocks about the mean of all: of roots of few squares the mean would be too small.

    Mean squares are skewed, so that Student's interval is turned by P. Hall's cubic (On the removal of skewness by
    transformation, 1992).
    """
    squares = np.array([np.mean((block - whole.mean()) ** 2) for block in blocks])
    middle, spread, n = float(squares.mean()), float(squares.std(ddof=1)), len(squares)
    sigma = float(np.std(whole, ddof=1))
    if spread <= NOISE * middle:
        return Estimate(sigma, sigma, sigma)
    skew = _skewness(squares) * math.sqrt(n * (n - 1)) / (n - 2)
    ends = np.array([1.0, -1.0]) * STUDENT / math.sqrt(n)
    if abs(skew) > NOISE:
        ends = 3 / skew * (np.cbrt(1 + skew * (ends - skew / (6 * n))) - 1)
    low, high = np.sqrt(np.maximum(middle - spread * ends, 0.0)).tolist()
    return Estimate(sigma, min(low, sigma), max(high, sigma))


def _skewness(x: Values) -> float:
    apart = x - x.mean()
    spread = float(np.mean(apart**2))
    return float(np.mean(apart**3)) / spread**1.5 if spread > 0 else 0.0
