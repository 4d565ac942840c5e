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
QUANTILES = (0.00135, 0.05, 0.5, 0.95, 0.99865)
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
        _estimate(_sigma, blocks, whole),
        _estimate(_skewness, blocks, whole),
        tuple(_estimate(lambda x, q=q: np.quantile(x, q), blocks, whole) for q in QUANTILES),  # type: ignore[misc]
        float(whole.min()),
        float(whole.max()),
    )


def share(held: NDArray[np.bool_]) -> Estimate:
    """The part of samples (n,) that hold, in replicates one after the other.

    By what the replicates differ, where there are enough samples of both kinds; else by Wilson's interval of
    independent ones, which is wider than that of quasi-random ones.
    """
    many = int(held.sum())
    if min(many, len(held) - many) < FEW:
        return wilson(many, len(held))
    found = _estimate(np.mean, np.split(held.astype(float), REPLICATES), held.astype(float))
    return Estimate(found.value, max(found.low, 0.0), min(found.high, 1.0))


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


def _estimate(told: Callable[[Values], Any], blocks: Sequence[Values], whole: Values) -> Estimate:
    """Of all samples, with the interval by the scatter of the blocks."""
    value = float(told(whole))
    scatter = float(np.std([float(told(block)) for block in blocks], ddof=1))
    half = STUDENT * scatter / math.sqrt(len(blocks))
    return Estimate(value, value - half, value + half)


def _sigma(x: Values) -> float:
    return float(np.std(x, ddof=1))


def _skewness(x: Values) -> float:
    apart = x - x.mean()
    spread = float(np.mean(apart**2))
    return float(np.mean(apart**3)) / spread**1.5 if spread > 0 else 0.0
