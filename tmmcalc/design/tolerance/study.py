"""The whole study of tolerances: by derivatives, in the worst case, by samples, against constraints."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.design.differences import Slope
from tmmcalc.design.tolerance.balance import Balance, Law, balanced
from tmmcalc.design.tolerance.linear import Linear, linear, straight
from tmmcalc.design.tolerance.sampling import REPLICATES, Estimate, Statistics, points, share, statistics
from tmmcalc.design.tolerance.sources import Sources, Values
from tmmcalc.design.tolerance.worst import Results, Worst, worst_cases
from tmmcalc.design.tolerance.yields import Rule, Widenings, widenings

Solved = Callable[[Values], tuple[Values, Sequence[str]]]  # keys (n, k) -> results (n, m), why one has none (n,)

CHUNK = 4096  # samples of which the changes by every part are held at once
FEWER = 2**14  # samples by which the linear model tells of the yield
LEAST = 1024  # samples of tolerances that are balanced


@record
class Refusal:
    """Samples without all results, by the reason of the first of them."""

    reason: str
    count: int
    sample: int  # number of the first one, from 1


@record
class Bend:
    """A key along which no straight line stands for a result: a kink, a jump, an end, or what does not settle."""

    name: str
    key: str
    slope: Slope


@record
class Tolerated:
    """What tolerances do to m results, by n parts that vary; ``keys`` are told with their units."""

    names: tuple[str, ...]
    nominal: Values  # (m,)
    keys: tuple[str, ...]
    sources: Sources
    linear: Linear  # of the first results, those that are asked for and no course
    bends: tuple[Bend, ...]
    worst: tuple[Worst, ...]  # of these
    statistics: tuple[Statistics | None, ...]  # of these, None where too few samples have the result
    samples: int
    seed: int
    refusals: tuple[Refusal, ...]  # the most frequent first
    good: Estimate | None  # the yield; None without constraints
    failing: dict[str, int]  # samples beyond the limits, by constraint
    widenings: Widenings | None
    balance: Balance | None
    values: Values  # (samples, m)
    band: tuple[int, ...]  # columns of the course over the positions of a turn


def study(
    names: Sequence[str],
    keys: Sequence[str],
    nominal: Values,
    found: Values,
    sources: Sources,
    slopes: Sequence[Sequence[Slope]],
    results: Results,
    solved: Solved,
    rule: Rule | None,
    *,
    samples: int,
    seed: int,
    band: Sequence[int] = (),
    law: Law | None = None,
) -> Tolerated:
    """Of results that are ``found`` (m,) where the keys are ``nominal`` (k,).

    ``slopes`` are derivatives by results, then by keys; those beyond the results that have them are of the course in
    the columns ``band`` alone. ``results`` is asked for the worst case and for samples of tolerances that are balanced
    by a ``law``, ``solved`` once for all samples, so that it may keep them.
    """
    own = len(slopes)
    lines = np.array([[straight(each) for each in row] for row in slopes])
    drawn = points(sources, samples, seed)
    values, reasons = solved(nominal + moved(sources, drawn))
    told = linear(sources, found[:own], lines)
    widened = balance = None
    if rule is not None and rule.columns and np.isfinite(lines[rule.columns]).all():
        parts = np.concatenate([sources.parts(some) @ lines.T for some in _chunks(drawn[:FEWER])])
        widened = widenings(rule.holds, sources.names, found[:own], parts, told.shares[rule.columns])
        if law is not None and told.shares[rule.columns].any():
            few = max(samples // 4, min(samples, LEAST))
            some, before = _fewer(drawn, few), _fewer(values, few)

            def sampled(factors: Values) -> Estimate:
                if np.all(factors == 1):
                    return share(rule.holds(before))
                return share(rule.holds(results(nominal + moved(sources.scaled(factors), some))))

            def by_lines(factors: Values) -> float:
                return float(rule.holds(found[:own] + np.einsum("npm,p->nm", parts, factors)).mean())

            balance = balanced(law, told.shares[rule.columns], by_lines, sampled, len(some))
    held = None if rule is None else rule.holds(values)
    return Tolerated(
        tuple(names),
        found,
        tuple(keys),
        sources,
        told,
        tuple(
            Bend(names[m], keys[k], each)
            for m, row in enumerate(slopes)
            for k, each in enumerate(row)
            if each.side != "both"
        ),
        worst_cases(lambda places: results(places)[:, :own], sources, nominal, seed),
        tuple(_statistics(column) for column in values.T[:own]),
        len(values),
        seed,
        refusals(reasons),
        None if held is None else share(held),
        {} if rule is None else rule.failing(values),
        widened,
        balance,
        values,
        tuple(band),
    )


def moved(sources: Sources, drawn: Values) -> Values:
    """Changes (n, keys) at points (n, count) of the unit cube."""
    return np.concatenate([sources.parts(some).sum(axis=1) for some in _chunks(drawn)])


def _fewer(many: Values, count: int) -> Values:
    """Of samples (n, ...) in replicates one after the other the first ones of each, so many together."""
    return np.concatenate([block[: count // REPLICATES] for block in np.split(many, REPLICATES)])


def _chunks(drawn: Values) -> Iterator[Values]:
    return (drawn[at : at + CHUNK] for at in range(0, len(drawn), CHUNK))


def ranges(sources: Sources) -> Values:
    """Half of the range of every key (k,)."""
    found = np.zeros(sources.keys)
    for each in sources.dimensions:
        found[each.key] += (each.high - each.low) / 2
    for pair in sources.clearances:
        for key, scale in zip(pair.keys, pair.scale, strict=True):
            found[key] += pair.largest * scale
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
