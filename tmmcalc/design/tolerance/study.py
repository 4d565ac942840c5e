"""The whole study of tolerances: by derivatives, in the worst case, by samples, against constraints."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.design.tolerance.linear import Linear, linear
from tmmcalc.design.tolerance.sampling import Estimate, Statistics, points, share, statistics
from tmmcalc.design.tolerance.sources import Sources, Values
from tmmcalc.design.tolerance.worst import Results, Worst, worst_cases
from tmmcalc.design.tolerance.yields import Rule, Widenings, widenings

Solved = Callable[[Values], tuple[Values, Sequence[str]]]  # keys (n, k) -> results (n, m), why one has none (n,)

SLOPE, CURVE = 0.02, 0.5  # of the range of a key: steps of first and of second differences


@record
class Refusal:
    """Samples without all results, by the reason of the first of them."""

    reason: str
    count: int
    sample: int  # number of the first one, from 1


@record
class Tolerated:
    """What tolerances do to m results, by n parts that vary; ``keys`` are told with their units."""

    names: tuple[str, ...]
    nominal: Values  # (m,)
    keys: tuple[str, ...]
    sources: Sources
    linear: Linear
    worst: tuple[Worst, ...]  # (m,)
    statistics: tuple[Statistics | None, ...]  # (m,), None where too few samples have the result
    samples: int
    seed: int
    refusals: tuple[Refusal, ...]  # the most frequent first
    good: Estimate | None  # the yield; None without constraints
    failing: dict[str, int]  # samples beyond the limits, by constraint
    widenings: Widenings | None
    values: Values  # (samples, m)


def study(
    names: Sequence[str],
    keys: Sequence[str],
    nominal: Values,
    sources: Sources,
    results: Results,
    solved: Solved,
    rule: Rule | None,
    *,
    samples: int,
    seed: int,
    columns: Sequence[int] | None = None,
) -> Tolerated:
    """Of results that are a function of keys with values ``nominal`` (k,).

    ``results`` is asked for differences and the worst case, ``solved`` once for all samples, so that it may keep them.
    The worst case is that of ``columns`` (None: all); the others, such as those of a course, have none.
    """
    own = list(range(len(names)) if columns is None else columns)
    first, slopes, curvatures = differences(results, sources, nominal)
    parts = sources.parts(points(sources, samples, seed))
    values, reasons = solved(nominal + parts.sum(axis=1))
    told = linear(sources, first, slopes, curvatures)
    widened = None
    if rule is not None and np.isfinite(slopes).all():
        changes = parts @ slopes.T
        limited = [column for column, _ in rule.limits.values()]
        widened = widenings(rule.holds, sources.names, first, changes, told.shares[limited])
    held = None if rule is None else rule.holds(values)
    return Tolerated(
        tuple(names),
        first,
        tuple(keys),
        sources,
        told,
        worst_cases(lambda places: results(places)[:, own], sources, nominal, seed),
        tuple(_statistics(column) for column in values.T),
        len(values),
        seed,
        refusals(reasons),
        None if held is None else share(held),
        {} if rule is None else rule.failing(values),
        widened,
        values,
    )


def differences(results: Results, sources: Sources, nominal: Values) -> tuple[Values, Values, Values]:
    """Results (m,) at the nominal place, their first and second derivatives (m, k) along every key.

    Central differences with steps by the ranges of the keys, the first ones extrapolated from two steps (h, 2 h); that
    of a key that does not move is 0.
    """
    spread = ranges(sources)
    places = [nominal]
    for at, width in enumerate(spread):
        for step in (SLOPE, 2 * SLOPE, CURVE):
            for side in (-1, 1):
                moved = nominal.copy()
                moved[at] += side * step * width
                places.append(moved)
    found = results(np.array(places))
    around = found[1:].reshape(len(spread), 3, 2, -1)
    width = spread[:, None]
    slope, coarse = ((around[:, k, 1] - around[:, k, 0]) / (2 * h * width) for k, h in ((0, SLOPE), (1, 2 * SLOPE)))
    curve = (around[:, 2, 1] - 2 * found[0] + around[:, 2, 0]) / (CURVE * width) ** 2
    return found[0], np.asarray((4 * slope - coarse) / 3).T, np.asarray(curve).T


def ranges(sources: Sources) -> Values:
    """Half of the range of every key (k,)."""
    found = np.zeros(sources.keys)
    for each in sources.dimensions:
        found[each.key] += (each.high - each.low) / 2
    for pair in sources.clearances:
        for key, scale in zip(pair.keys, pair.scale, strict=True):
            found[key] += pair.radius * scale
    return np.where(found > 0, found, 1.0)


def refusals(reasons: Sequence[str]) -> tuple[Refusal, ...]:
    """Reasons that differ in their numbers alone are one kind; the first of a kind is told."""
    kinds: dict[str, list[int]] = {}
    for at, reason in enumerate(reasons):
        if reason:
            kinds.setdefault(re.sub(r"[\d.e+-]+", "#", reason), []).append(at)
    found = [Refusal(reasons[rows[0]], len(rows), rows[0] + 1) for rows in kinds.values()]
    return tuple(sorted(found, key=lambda each: (-each.count, each.sample)))


def _statistics(values: Values) -> Statistics | None:
    try:
        return statistics(values)
    except ValueError:
        return None
