"""The document of a study of tolerances: yield, what did not assemble, every result, the shares of all that varies."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmmcalc.core.headers import key_and_unit
from tmmcalc.design.tolerance.balance import Balance
from tmmcalc.design.tolerance.sampling import OUTER, QUANTILES, Estimate, Statistics
from tmmcalc.design.tolerance.sources import SIGMAS, Clearance
from tmmcalc.design.tolerance.study import Tolerated
from tmmcalc.design.tolerance.worst import MOST_LOST, Worst
from tmmcalc.design.tolerance.yields import MOST
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number, percent

RULES = {
    "cost": "least cost, if all cost the same as they are and each as the reciprocal of its width",
    "share": "equal shares in the variance",
}
SHOWN = 5  # reasons, and parts that are told in words
OFF = 0.1  # of sigma: by more the linear model is said to be off
NO_SHARE = 5e-4  # of the variance: less is shown as 0
DIGITS, MOST_DIGITS = 7, 15  # of a value with its interval
ENDS = QUANTILES[0], QUANTILES[-1]
HEADERS = "result", "nominal", "worst least", "worst largest", "mean", "sigma", "linear sigma"
INTERVALS = "result", "of samples", "value", "from", "to"


def tolerance_document(result: Tolerated, title: str) -> Document:
    """Yield, refusals, a row a result; then the intervals of what the samples tell, the shares, balanced tolerances."""
    notes = (*_notes(result), *_assumptions(result))
    facts = (_samples(result), *_refusals(result), *_yield(result), *_widths(result))
    shown = range(len(result.worst))
    table = _table((*HEADERS, *_outer(result)), [_row(result, at) for at in shown])
    values = {result.names[at]: _values(result, at) for at in shown}
    told = Fact("results", f"{len(shown)}, with {len(result.sources.names)} parts that vary", values)
    parts = [*_intervals(result), _shares(result)]
    if result.balance is not None:
        parts.append(_balance(result.balance, result.sources.names))
    return Document(title, (*facts, told), notes, table, parts=tuple(parts))


def _samples(result: Tolerated) -> Fact:
    lost = sum(each.count for each in result.refusals)
    text = f"{result.samples}, seed {result.seed}, {lost or 'none'} of them without a result"
    return Fact("samples", text, {"samples": result.samples, "seed": result.seed, "without_result": lost})


def _refusals(result: Tolerated) -> Iterator[Fact]:
    for at, each in enumerate(result.refusals[:SHOWN], 1):
        values = {"reason": each.reason, "samples": each.count, "sample": each.sample}
        yield Fact(f"without a result: {each.count}", f"sample {each.sample}: {each.reason}", {f"refusal_{at}": values})
    if len(result.refusals) > SHOWN:
        yield Fact("other reasons", f"{len(result.refusals) - SHOWN} more kinds", {})


def _yield(result: Tolerated) -> Iterator[Fact]:
    if result.good is None:
        yield Fact("yield", "not known: the spec has no [[constraints]]", {})
        return
    good = result.good
    text = f"{percent(good.value)} ({percent(good.low)} to {percent(good.high)} at 95 %)"
    yield Fact("yield", text, {"yield": _plain(good)})
    for name, count in result.failing.items():
        text = f"{count} samples beyond its limits, {percent(count / result.samples)}"
        yield Fact(f"{name} fails", text, {f"failing_{name}": count})


def _widths(result: Tolerated) -> Iterator[Fact]:
    """Which tolerance is to be narrowed first, and which may be widened."""
    found = result.widenings
    if found is None:
        return
    values: dict[str, Any] = {
        "linear_yield": found.linear_yield,
        "loss": found.loss,
        "parts": [{"name": each.name, "widening": each.factor, "gain_at_half": each.gain} for each in found.parts],
    }
    yield Fact("yield of the linear model", percent(found.linear_yield), values)
    useful = [each for each in found.parts if each.gain > 0][:SHOWN]
    if useful:
        text = "; ".join(f"{each.name}: half of it gains {percent(each.gain)}" for each in useful)
        yield Fact("to narrow first", text, {})
    wide = sorted((each for each in found.parts if each.factor > 1.0), key=lambda each: -each.factor)[:SHOWN]
    if wide:
        text = "; ".join(f"{each.name} {_times(each.factor)}" for each in wide)
        yield Fact(f"may be widened, each alone, at {percent(found.loss)} of yield", text, {})
    if len(found.together) > 1:
        text = f"{', '.join(found.together)} {_times(found.common)}"
        told = {"together": list(found.together), "together_widening": found.common}
        yield Fact("may be widened together", text, told)


def _balance(found: Balance, names: tuple[str, ...]) -> Document:
    """All tolerances at once, at equal yield: factors of their widths, the widest first."""
    factors = dict(sorted(zip(names, found.factors.tolist(), strict=True), key=lambda each: -each[1]))
    good, before = found.after, found.before
    ends = f"{percent(good.low)} to {percent(good.high)} at 95 %"
    facts = (
        Fact("rule", RULES[found.law], {"rule": found.law, "factors": factors}),
        Fact(
            "yield",
            f"{percent(good.value)} ({ends}), {percent(before.value)} before, by {found.samples} samples",
            {"yield": _plain(good), "yield_before": _plain(before), "samples": found.samples},
        ),
        Fact("cost", f"{percent(found.cost)} of before", {"cost": found.cost}),
    )
    columns: list[list[Any]] = [[*factors], [number(factor, 3) for factor in factors.values()]]
    return Document("balanced at equal yield", facts, (), View(["varies", "times as wide"], columns), name="balance")


def _times(factor: float) -> str:
    return f"{MOST:g} times and more" if factor >= MOST else f"{factor:.3g} times"


def _row(result: Tolerated, at: int) -> tuple[Any, ...]:
    worst, told = result.worst[at], result.statistics[at]
    line = result.linear
    mean, sigma = ("", "") if told is None else map(number, (told.mean.value, told.sigma.value))
    quantiles = {} if told is None else told.told
    outer = [number(quantiles[end].value) if end in quantiles else "" for end in _outer(result).values()]
    ends = ("", "") if worst.how == "none" else map(number, (worst.least, worst.largest))
    straight = number(line.sigma[at]) if np.isfinite(line.sigma[at]) else ""
    return result.names[at], number(result.nominal[at]), *ends, mean, sigma, straight, *outer


def _outer(result: Tolerated) -> dict[str, float]:
    """The outermost quantiles, by what they are called, if there are samples enough for them of any result."""
    told = any(each is not None and each.count >= OUTER for each in result.statistics)
    return {percent(end): end for end in ENDS} if told else {}


def _table(headers: Sequence[str], rows: Sequence[tuple[Any, ...]]) -> View:
    return View(headers, [list(column) for column in zip(*rows, strict=True)])


def _values(result: Tolerated, at: int) -> dict[str, Any]:
    line, worst = result.linear, result.worst[at]
    told: dict[str, Any] = {"nominal": float(result.nominal[at]), "worst": _worst(worst, result.keys)}
    if np.isfinite(line.sigma[at]):
        told["linear"] = {
            "mean": float(line.mean[at]),
            "sigma": float(line.sigma[at]),
            "least": float(line.least[at]),
            "largest": float(line.largest[at]),
            "shares": dict(zip(result.sources.names, line.shares[at].tolist(), strict=True)),
        }
    if result.statistics[at] is not None:
        told["statistics"] = _moments(result.statistics[at])
    return told


def _worst(worst: Worst, keys: tuple[str, ...]) -> dict[str, Any]:
    found: dict[str, Any] = {"how": worst.how, "evaluations": worst.evaluations, "turned": list(worst.turned)}
    if worst.how != "none":
        found |= {"least": worst.least, "largest": worst.largest}
        found["at_least"] = dict(zip(keys, worst.at_least.tolist(), strict=True))
        found["at_largest"] = dict(zip(keys, worst.at_largest.tolist(), strict=True))
    return found


def _moments(told: Statistics | None) -> dict[str, Any]:
    assert told is not None
    quantiles = {f"quantile_{q:g}": _plain(each) for q, each in told.told.items()}
    return {
        "samples": told.count,
        "mean": _plain(told.mean),
        "sigma": _plain(told.sigma),
        "skewness": _plain(told.skewness),
        **quantiles,
        "least": told.least,
        "largest": told.largest,
    }


def _plain(found: Estimate) -> dict[str, float]:
    return {"value": found.value, "low": found.low, "high": found.high}


def _notes(result: Tolerated) -> Iterator[str]:
    """How each worst case was found, results of one kind together."""
    kinds: dict[tuple[str, tuple[str, ...]], list[str]] = {}
    for name, worst in zip(result.names, result.worst, strict=False):
        kinds.setdefault((worst.how, worst.turned), []).append(name)
    for (how, turned), names in kinds.items():
        some = result.worst[result.names.index(names[0])]
        of = ", ".join(names)
        why = f"the influence of {', '.join(turned)} changes its sign" if turned else "a corner is not the extreme"
        if how == "signs":
            yield f"worst case of {of}: by signs of the derivatives, which hold where they were tried in the whole box"
        elif how == "search":
            if some.lost:
                cut = ", so that the search was cut short" if some.lost >= MOST_LOST else ""
                lost = f"{some.lost} places of the box have no result{cut}"
                why = f"{why}, and {lost}" if turned else lost
            yield f"warning: worst case of {of}: {why}; the box was searched, {some.evaluations} evaluations in all"
        else:
            yield f"warning: worst case of {of}: no place of the box was found to have a result"
    yield from _bends(result)
    if any(each is None for each in result.statistics):
        names = [name for name, each in zip(result.names, result.statistics, strict=True) if each is None]
        yield f"warning: too few samples have {', '.join(names)} for statistics"
    few = [name for name, each in zip(result.names, result.statistics, strict=False) if each and each.count < OUTER]
    if few:
        ends = " and ".join(map(percent, ENDS))
        yield f"note: {ends} of {', '.join(few)} are left out: of fewer than {OUTER} samples not two lie beyond each"


def _bends(result: Tolerated) -> Iterator[str]:
    """Where the linear model does not stand for a result, by its derivatives and by the samples."""
    for each in result.bends:
        key = key_and_unit(each.key)[0]
        if each.slope.side == "kink":
            yield f"note: {each.name} has a kink along {key}: the linear model takes the middle of both sides"
        elif each.slope.side == "jump":
            yield f"warning: {each.name} jumps along {key}: there is no linear model of it"
        else:
            yield f"warning: {each.name} has no clear derivative along {key}: the linear model of it is in doubt"
    for name, told, mean, sigma in zip(
        result.names, result.statistics, result.linear.mean, result.linear.sigma, strict=False
    ):
        if told is None or not np.isfinite(sigma):
            continue
        shift, ratio = abs(told.mean.value - mean), told.sigma.value / sigma if sigma > 0 else 1.0
        if shift > OFF * told.sigma.value or abs(ratio - 1) > OFF:
            text = f"its mean is {number(shift, 3)} off, sigma of the samples {number(ratio, 3)} of it"
            yield f"warning: the linear model is no good for {name}: {text}"


def _assumptions(result: Tolerated) -> Iterator[str]:
    pairs = result.sources.clearances
    radii = [pair.radius for pair in pairs if pair.varies]
    if any(each.kind == "normal" for each in (*result.sources.dimensions, *radii)):
        beyond = percent(math.erfc(SIGMAS / math.sqrt(2)), 2)
        yield (
            f"normal: {SIGMAS:g} sigma from the middle of a tolerance to its ends, so that {beyond} of dimensions are "
            "made beyond these; the worst case does not count them"
        )
    if pairs:
        yield "clearances are massless links of half of the clearance: contact is never lost"
    if any(pair.pin for pair in pairs):
        yield (
            "pins rest in any direction that stays the same at all positions in the axes of their links, one as likely "
            "as another; of the worst case in the worst one"
        )
    if any(pair.sides for pair in pairs):
        yield "sliders lean on one or the other side of their guides, each as often; of the worst case on the worse one"
    told = [f"{pair.name.removeprefix('clearance of ')} ({_direction(pair)})" for pair in pairs if not pair.drawn]
    if told:
        yield f"pins rest where it is told, at all positions, angles in the axes of their links: {', '.join(told)}"


def _direction(pair: Clearance) -> str:
    assert pair.along is not None
    return f"{number(math.degrees(math.atan2(pair.along[1], pair.along[0])), 5)} deg"


def _intervals(result: Tolerated) -> Iterator[Document]:
    """A row a number that the samples tell of a result, with its interval."""
    rows = []
    for name, told in zip(result.names, result.statistics, strict=False):
        if told is None:
            continue
        every = {"mean": told.mean, "sigma": told.sigma} | {percent(q): each for q, each in told.told.items()}
        rows += [(name, of, *_written(each)) for of, each in every.items()]
    if rows:
        yield Document("intervals of 95 %", (), (), _table(INTERVALS, rows), name="intervals")


def _written(found: Estimate) -> list[str]:
    """A value and the ends of its interval, with as many digits as tell these apart."""
    size, wide = max(abs(found.low), abs(found.high)), found.high - found.low
    digits = math.ceil(math.log10(size / wide)) + 2 if size and wide else DIGITS
    return [number(each, min(max(digits, DIGITS), MOST_DIGITS)) for each in (found.value, found.low, found.high)]


def _shares(result: Tolerated) -> Document:
    """Per cent of the variance by the linear model, a row a part, a column a result; the most important first."""
    shares = result.linear.shares[: len(result.worst)]
    order = np.argsort(-shares.max(axis=0), kind="stable")
    headers = ["varies", *(f"{key_and_unit(name)[0]}[%]" for name in result.names[: len(shares)])]
    columns: list[list[Any]] = [[result.sources.names[k] for k in order]]
    columns += [[_share(float(row[k])) for k in order] for row in shares]
    return Document("shares of the variance", (), (), View(headers, columns))


def _share(part: float) -> float:
    return round(100 * part, 2) if part >= NO_SHARE / 10 else 0.0
