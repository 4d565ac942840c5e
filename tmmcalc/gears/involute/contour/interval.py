"""Admissible shifts x1 on a line x1 + x2 = const: the cuts of the line with all parts of a contour."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.bounds import LOWER, UPPER, cuts, edge_names
from tmmcalc.gears.involute.contour.frame import Frame
from tmmcalc.gears.involute.contour.regions import TIPS, Region
from tmmcalc.gears.involute.contour.task import LINES


@record
class ShiftInterval:
    """Admissible x1 on a line x1 + x2 = const, and the conditions (keys of LINES) at its ends."""

    total: float  # x1 + x2
    low: float
    high: float
    low_line: str
    high_line: str
    branches: tuple[int, ...] = (0,)  # that it runs through

    def __str__(self) -> str:
        return f"x1 = {self.low:.4f} ({LINES[self.low_line][1]}) ... {self.high:.4f} ({LINES[self.high_line][1]})"

    def distance(self, x1: float) -> float:
        """How far x1 is off; 0 within."""
        return max(self.low - x1, x1 - self.high, 0.0)


def intervals(frame: Frame, total: float, strict: bool = True) -> tuple[ShiftInterval, ...]:
    """All admissible intervals on the line of a sum, by ascending x1; those that adjoin are one."""
    w = frame.angle_of(np.array([total]))
    if not w[0] > 0:
        return ()
    found = [_cut(frame, float(w[0]), total, strict, branch) for branch in frame.branches]
    parts = sorted((each for each in found if each.low <= each.high), key=lambda each: each.low)
    joints = [False, *(frame.neck > 0 and one.high_line == two.low_line in TIPS for one, two in pairwise(parts))]
    result: list[ShiftInterval] = []
    for part, joint in zip(parts, joints, strict=False):
        if joint:
            last = result.pop()
            branches = (*last.branches, *part.branches)
            part = ShiftInterval(total, last.low, part.high, last.low_line, part.high_line, branches)
        result.append(part)
    return tuple(result)


def _cut(frame: Frame, w: float, total: float, strict: bool, branch: int) -> ShiftInterval:
    low, high, below, above = cuts(frame, np.array([w]), branch, tolerated=not strict).ends(strict)
    names = edge_names(LOWER[below[0]], UPPER[above[0]], branch)
    return ShiftInterval(total, float(low[0]), float(high[0]), *names, (branch,))


def interval(
    frame: Frame, total: float, strict: bool = True, *, region: Region | None = None, near: float | None = None
) -> ShiftInterval:
    """Admissible x1 on the line of a sum of shifts; raises `NoSolutionError` if there are none.

    Only intervals of ``region`` count, if it is known; else those that meet the main branch or are joined to it by a
    neck. Of several the one that holds ``near``, or is nearest to it; by default that of the main branch.

    >>> from tmmcalc.gears.involute.contour.frame import frame_of
    >>> from tmmcalc.gears.involute.contour.task import Task
    >>> from tmmcalc.gears.involute.wheel import Wheel
    >>> found = interval(frame_of(Task(Wheel(14), Wheel(17))), 1.1)
    >>> found.low_line, round(found.low, 5)
    ('undercut1', 0.18116)
    """
    found = [each for each in intervals(frame, total, strict) if _counts(frame, each, region)]
    if not found:
        raise _none(frame, total, strict)
    if near is not None:
        return min(found, key=lambda each: each.distance(near))
    return max(found, key=lambda each: (0 in each.branches, each.high - each.low))


def _counts(frame: Frame, each: ShiftInterval, region: Region | None) -> bool:
    if region is None:
        return frame.neck > 0 or 0 in each.branches
    return any(part.branch in each.branches and part.total[0] <= each.total <= part.total[-1] for part in region.parts)


def _none(frame: Frame, total: float, strict: bool) -> NoSolutionError:
    """Why there is no interval."""
    w = frame.angle_of(np.array([total]))
    if not w[0] > 0:
        least = float(frame.sums(np.array([0.0])).total[0])
        return NoSolutionError(
            Phrase("there is no pair with the sum of shifts {total:.4f}: the base circles would overlap", total=total),
            where="blocking contour",
            value=total,
            limit=least,
            remedy=f"a sum of shifts above {least:.4f}",
        )
    found = _cut(frame, float(w[0]), total, strict, 0)
    if found.low <= found.high:
        return NoSolutionError(
            Phrase(
                "the admissible shifts with the sum {total:.4f} lie apart from the main area of the contour",
                total=total,
            ),
            where="blocking contour",
            value=total,
            remedy="another centre distance, or given shifts",
        )
    return NoSolutionError(
        Phrase(
            "no shifts with the sum {total:.4f} are admissible: {low} excludes {high}",
            total=total,
            low=LINES[found.low_line][1],
            high=LINES[found.high_line][1],
        ),
        where="blocking contour",
        value=found.high - found.low,
        limit=0.0,
        remedy="another centre distance, a smaller contact ratio or tip thickness, or the tolerated contour",
    )
