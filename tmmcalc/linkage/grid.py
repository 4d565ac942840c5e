"""Positions of the input: uniform, two-step, with extra positions; and their labels.

Positions are counted from position 0 in the sense of the motion; the last one closes the cycle. No angle is
summed up step by step. An extra position between the positions 6 and 7 is labelled 6', a second one 6''.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.errors import NoSolutionError
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.model import Grid
from tmmcalc.linkage.outputs import OutputSummary
from tmmcalc.linkage.plane import Real

SAME = 1e-6  # an extra position nearer than this part of a step to a position is that position


def distances(grid: Grid, span: float, summary: OutputSummary | None, start: float) -> tuple[Real, tuple[str, ...]]:
    """Distances (n,) >= 0 of all positions from position 0 along the motion [rad or m], and their labels."""
    base = _base(grid, span, summary)
    extra = [*grid.extra]
    if grid.extremes and summary is not None:
        extra += [abs(centre.x - start) for centre in summary.dead_centres]
    step = float(np.min(np.diff(base)))
    added = sorted({e for e in extra if np.min(np.abs(base - e)) > SAME * step})
    return _merged(base, np.array(added))


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
    before = np.searchsorted(base, extra) - 1
    seen: dict[int, int] = {}
    for i in before:
        seen[int(i)] = seen.get(int(i), 0) + 1
        labels.append(str(max(int(i), 0)) + "'" * seen[int(i)])
    everything = np.concatenate((base, extra))
    order = np.argsort(everything, kind="stable")
    return everything[order], tuple(labels[i] for i in order)
