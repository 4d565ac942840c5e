"""The stage of wanted paths: nearest places of the paths over the range that kinematics analyses, and what is left.

Everything is found for V variants at once; one linkage by itself is a stack of one.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.notes import Phrase, listed
from tmmcalc.core.numerics.extended import CHAIN, EPS, MARGIN, WIDER
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.assembly import coordinate
from tmmcalc.linkage.chain import Chain, chain_of
from tmmcalc.linkage.grid import analysed_range
from tmmcalc.linkage.lastdigit import in_full
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.paths.deviations import Range, Reached, deviations, reached, states
from tmmcalc.linkage.paths.nearest import slopes_at
from tmmcalc.linkage.paths.results import PathDeviation, PathError, Paths
from tmmcalc.linkage.paths.task import WantedPath
from tmmcalc.linkage.results import Grade, Kinematics
from tmmcalc.linkage.survey import Evaluate, alone, survey

BEYOND = 1e-9  # of the range: so far an input coordinate may lie beyond its ends by rounding


def solve_paths(mechanism: Mechanism, asked: tuple[WantedPath, ...], kinematics: Kinematics) -> Paths:
    """How far the paths of points are from wanted ones, over the range that kinematics analyses.

    Raises `UsageError` for a prescribed input coordinate beyond that range.
    """
    chain = chain_of(mechanism, kinematics)
    start = float(kinematics.x[0] - kinematics.phi[0])
    low, high = analysed_range(mechanism, start)
    dense = survey(chain, low, high, start)
    for path in asked if not dense.full else ():
        _check_times(chain, path, start, (low, high))
    over = Range(dense.x[None], np.array([start]), math.copysign(1.0, mechanism.input.speed), dense.full)
    found = [reached(alone(chain), over, path) for path in asked]
    error = PathError(max(kinematics.error.position, CHAIN), CHAIN)
    if WIDER:
        error = errors_of(alone(in_full(chain)), over, found, asked)[0]
    (result,) = records_of(over, found, asked, chain.turns, [error])
    return result


def records_of(
    over: Range,
    found: Sequence[Reached],
    asked: Sequence[WantedPath],
    turns: bool,
    errors: Sequence[PathError],
) -> list[Paths]:
    """The results of V variants, from what was found of every path."""
    told = [deviations(over, each, path) for each, path in zip(found, asked, strict=True)]
    phi, wanted, place = joined(over, found)
    labels = labels_of(asked)
    results = []
    for v, error in enumerate(errors):
        paths = tuple(each.record(v, path) for each, path in zip(told, asked, strict=True))
        results.append(
            Paths(
                turns=turns,
                closed=over.closed,
                paths=paths,
                labels=labels,
                phi=phi[v].copy(),
                wanted=wanted[v].copy(),
                reached=place[v].copy(),
                error=error,
                grades=tuple(_grades(v, over, found, paths)),
                counters={"points": len(labels), "survey_positions": over.x.shape[1]},
            )
        )
    return results


def joined(over: Range, found: Sequence[Reached]) -> tuple[Real, Plane, Plane]:
    """Input coordinates from position 0, wanted points and places (V, n), the points of one path behind the other."""
    phi = np.concatenate([each.x - over.start[:, None] for each in found], axis=1)
    wanted = np.concatenate([each.wanted for each in found], axis=1)
    return phi, wanted, np.concatenate([each.place for each in found], axis=1)


def labels_of(asked: Sequence[WantedPath]) -> tuple[str, ...]:
    """Rows are called by the numbers of their points; of several paths by the name of the path before it."""
    before = [f"{path.name}:" if len(asked) > 1 else "" for path in asked]
    return tuple(f"{name}{k + 1}" for name, path in zip(before, asked, strict=True) for k in range(len(path.through)))


def errors_of(wide: Evaluate, over: Range, found: Sequence[Reached], asked: Sequence[WantedPath]) -> list[PathError]:
    """Estimated errors of V variants, from the same states in extended precision.

    A place that is the nearest one goes to where the exact path is nearest by another step of Newton.
    """
    count = len(over.x)
    far, step, size = (np.zeros(count) for _ in range(3))
    span = over.x[:, -1] - over.x[:, 0]
    for each, path in zip(found, asked, strict=True):
        variants = np.repeat(np.arange(count), each.x.shape[1])
        x = each.x.astype(np.longdouble)
        state: Any = wide(x.ravel(), variants, states(path.point), 2).reshape(3, *x.shape)
        slope, bend = slopes_at(state, each.wanted)
        onward = np.where(each.free & (bend > 0), -slope / np.where(bend > 0, bend, 1), 0)
        onward = np.clip(onward, -span[:, None], span[:, None])
        exact = wide((x + onward).ravel(), variants, states(path.point), 0)[0].reshape(x.shape)
        off = np.abs(np.abs(exact - each.wanted) - np.abs(each.place - each.wanted))
        far = np.maximum(far, np.max(off, axis=1).astype(float))
        step = np.maximum(step, np.max(np.abs(onward), axis=1).astype(float))
        size = np.maximum(size, np.max(np.maximum(np.abs(each.place), np.abs(each.wanted)), axis=1))
    size[size == 0] = 1.0
    return [
        PathError(max(MARGIN * d, EPS), max(MARGIN * s, EPS))
        for d, s in zip((far / size).tolist(), (step / span).tolist(), strict=True)
    ]


def _check_times(chain: Chain, path: WantedPath, start: float, ends: tuple[float, float]) -> None:
    """Raise `UsageError` for a prescribed input coordinate outside of the analysed range."""
    low, high = ends
    for k, at in enumerate(path.at):
        if not low - BEYOND * (high - low) <= start + at <= high + BEYOND * (high - low):
            raise UsageError(
                f"point {k + 1} is prescribed for {coordinate(chain, start + at)}, outside of the analysed range from "
                f"{coordinate(chain, low)} to {coordinate(chain, high)}",
                where=f"paths, {path.name}",
                remedy="prescribe an input coordinate from position 0 within grid.span, or change grid.span",
            )


def _grades(v: int, over: Range, found: Sequence[Reached], paths: Sequence[PathDeviation]) -> Iterator[Grade]:
    """What is worth knowing: points that are met out of their order, or nearest to an end of the path."""
    for each, path in zip(found, paths, strict=True):
        where = Phrase("path {name}", name=path.name)
        if not path.ordered:
            yield Grade("note", where, "the places nearest to its points do not follow in the order of the points")
        if not path.timed and not over.closed:
            numbers = _at_ends(over.x[v], each.x[v])
            if numbers:
                told = Phrase("nearest to an end of the path: points {numbers}", numbers=listed(numbers, ", "))
                yield Grade("note", where, told)


def _at_ends(survey_x: Real, x: Real) -> list[str]:
    """Numbers of the points that are nearest to an end."""
    ends = (x == survey_x[0]) | (x == survey_x[-1])
    return [str(k + 1) for k in np.flatnonzero(ends).tolist()]
