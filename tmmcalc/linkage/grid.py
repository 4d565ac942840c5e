"""Positions of the input: uniform, two-step, with extra positions; and their labels.

Positions are counted from position 0 in the sense of the motion; the last one closes the cycle. No angle is
summed up step by step. An extra position between the positions 6 and 7 is labelled 6', a second one 6''.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.model import Grid, Mechanism
from tmmcalc.linkage.results import OutputSummary

SAME = 1e-6  # an extra position nearer than this part of a step to a position is that position


def analysed_range(mechanism: Mechanism, start: float) -> tuple[float, float]:
    """Lowest and highest input coordinate [rad or m] of all positions that the grid names, from position 0 on."""
    grid = mechanism.grid
    span = _span(grid)
    ends = (0.0, span) if _whole(mechanism) else (0.0, span, *grid.extra)
    low, high = sorted(start + _sense(mechanism) * end for end in (min(ends), max(ends)))
    return low, high


def positions(mechanism: Mechanism, summaries: Sequence[OutputSummary], start: float) -> tuple[Real, tuple[str, ...]]:
    """Distances phi (n,) of all positions from position 0 [rad or m], in the order of the travel, and their labels.

    The strokes are those of the first output of ``summaries``; the dead centres of all are added where they are asked.
    They follow the sense of the motion. A spec has spans above zero and extra positions within the span; a plain
    `Mechanism` may also go against the motion (span below zero) and name extra positions in other turns.
    """
    grid, sense = mechanism.grid, _sense(mechanism)
    span = _span(grid)
    way = math.copysign(1.0, span)
    extra = [way * e for e in grid.extra]
    if grid.extremes:
        extra += [way * sense * (centre.x - start) for summary in summaries for centre in summary.dead_centres]
    if _whole(mechanism):
        extra = [e if 0 <= e <= TURN else e % TURN for e in extra]
    base = _base(grid, abs(span), summaries[0] if summaries else None)
    along, labels = _merged(base, _added(base, extra))
    return way * sense * along + 0.0, labels  # no -0.0


def _sense(mechanism: Mechanism) -> float:
    return math.copysign(1.0, mechanism.input.speed)


def _span(grid: Grid) -> float:
    return grid.span if grid.span is not None else TURN


def _whole(mechanism: Mechanism) -> bool:
    """Whether the positions go over exactly one turn of a crank."""
    turns = mechanism.joint(mechanism.input.joint).kind == "revolute"
    return turns and abs(abs(_span(mechanism.grid)) - TURN) < 1e-9


def _added(base: Real, extra: list[float]) -> Real:
    """The extra positions (m,), ascending, that are not there already."""
    least = SAME * float(np.min(np.diff(base)))
    added: list[float] = []
    for e in sorted(extra):
        if np.min(np.abs(np.append(base, added) - e)) > least:
            added.append(e)
    return np.array(added)


def _base(grid: Grid, span: float, summary: OutputSummary | None) -> Real:
    if grid.working is None or grid.idle is None:
        return span * np.arange(grid.positions + 1) / grid.positions
    if summary is None or summary.working_angle is None:
        count = len(summary.dead_centres) if summary else 0
        raise NoSolutionError(
            f"a grid of working and idle steps needs an output with exactly two dead centres; it has {count}",
            where="kinematics, grid.working",
            remedy="use grid.positions instead",
        )
    working, first, second = summary.working_angle, grid.working, grid.idle
    back = working + (TURN - working) * np.arange(1, second + 1) / second
    return np.concatenate((working * np.arange(first + 1) / first, back))


def _merged(base: Real, extra: Real) -> tuple[Real, tuple[str, ...]]:
    labels = [str(i) for i in range(len(base))]
    seen: dict[int, int] = {}
    for i in np.maximum(np.searchsorted(base, extra) - 1, 0).tolist():
        seen[i] = seen.get(i, 0) + 1
        labels.append(str(i) + "'" * seen[i])
    everything = np.concatenate((base, extra))
    order = np.argsort(everything, kind="stable")
    return everything[order], tuple(labels[i] for i in order)
