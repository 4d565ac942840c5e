"""The blocking contour of a pair: strict, and with the undercut tolerated that leaves the active flank whole."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

import numpy as np

from tmmcalc.errors import AccuracyError, NoSolutionError
from tmmcalc.gears.involute.contour.bounds import LOWER, UPPER, cuts
from tmmcalc.gears.involute.contour.frame import Frame, frame_of
from tmmcalc.gears.involute.contour.task import LINES, Task
from tmmcalc.gears.involute.contour.trace import Region, regions, scan
from tmmcalc.records import record

BRANCHES = (0, 1, 2, 3)
LOW: tuple[tuple[int, ...], ...] = ((), (1,), (0,), (0, 1))  # of each branch: wheels with the tip inside r


@record
class Contour:
    """All admissible shifts of a task."""

    strict: bool  # no undercut at all
    frame: Frame
    main: Region | None  # both tip circles outside the reference circles; None: nothing is admissible there
    pieces: tuple[
        Region, ...
    ]  # meshes with contact on one side of the pitch point only, and parts cut off the main region
    untraced: tuple[
        int, ...
    ] = ()  # 1, 2, 3: tip of wheel 2, 1, both inside the reference circle; pieces there whose outline is not found

    @property
    def task(self) -> Task:
        """What was asked."""
        return self.frame.task

    @property
    def region(self) -> Region:
        """The main region; raises `NoSolutionError` with the best contact ratio within reach if there is none."""
        if self.main is None:
            raise NoSolutionError(
                self.reason,
                where="blocking contour",
                value=self.best_contact_ratio,
                limit=self.task.contact_ratio,
                remedy=self._remedy,
            )
        return self.main

    @cached_property
    def best(self) -> tuple[float, float, float]:
        """x1, x2 and the contact ratio of point E, where it is largest; of an empty contour without its own limit."""
        from tmmcalc.gears.involute.contour.points import largest_contact_ratio

        if self.main is not None:
            return largest_contact_ratio(self)
        free = contour(replace(self.task, contact_ratio=0.0), self.strict, pieces=False)
        return (0.0, 0.0, 0.0) if free.main is None else largest_contact_ratio(free)

    @property
    def best_contact_ratio(self) -> float:
        """The largest eps_alpha that the other conditions leave; 0 if they leave nothing."""
        return self.best[2]

    @property
    def reason(self) -> str:
        """Why there is no main region, with the best contact ratio."""
        kind = "without undercut" if self.strict else "even with tolerated undercut"
        pair = f"z = {self.task.first.teeth}/{self.task.second.teeth}"
        if not self.best_contact_ratio:
            return f"no shifts of {pair} give a mesh {kind}"
        return (
            f"no shifts of {pair} reach the contact ratio {self.task.contact_ratio:g} {kind}; "
            f"the best within the other conditions is {self.best_contact_ratio:.4f}"
        )

    @property
    def _remedy(self) -> str:
        if self.best_contact_ratio:
            return "a smaller contact ratio or tip thickness, or more teeth"
        return "a smaller tip thickness, more teeth, or the tolerated contour"


def contour(task: Task, strict: bool = True, *, pieces: bool = True) -> Contour:
    """The strict or the tolerated contour, or its main region only; main is None if no shifts meet all conditions."""
    return _contours(task, (strict,), BRANCHES if pieces else (0,))[0]


def contours(task: Task) -> tuple[Contour, Contour]:
    """The strict and the tolerated contour."""
    strict, tolerated = _contours(task, (True, False))
    return strict, tolerated


def _contours(task: Task, kinds: tuple[bool, ...], branches: tuple[int, ...] = BRANCHES) -> list[Contour]:
    frame = frame_of(task)
    found: dict[bool, list[Region]] = {kind: [] for kind in kinds}
    untraced: dict[bool, list[int]] = {kind: [] for kind in kinds}
    mains: dict[bool, Region | None] = dict.fromkeys(kinds)
    for branch in branches:
        if any(frame.sides[i].least > 0 for i in LOW[branch]):
            continue  # the wheel whose tip is low would be undercut far into its flank
        if branch == 3 and frame.neck <= 0:
            continue  # only a deep flank leaves room for two low tips
        w = scan(frame, branch)
        if not w.size:
            continue
        scanned = cuts(frame, w, branch, tolerated=False in kinds)
        for kind in kinds:
            try:
                parts = list(regions(frame, branch, kind, scanned))
            except AccuracyError:
                if branch == 0:
                    raise
                untraced[kind].append(branch)
                continue
            if branch == 0 and parts:
                mains[kind] = max(parts, key=lambda part: part.area)
                parts.remove(mains[kind])  # type: ignore[arg-type]
            found[kind] += parts
    return [Contour(kind, frame, mains[kind], tuple(found[kind]), tuple(untraced[kind])) for kind in kinds]


@record
class Interval:
    """Admissible x1 on a line x1 + x2 = const, and the conditions (keys of LINES) at its ends."""

    total: float  # x1 + x2
    low: float
    high: float
    low_line: str
    high_line: str

    def __str__(self) -> str:
        return f"x1 = {self.low:.4f} ({LINES[self.low_line][1]}) ... {self.high:.4f} ({LINES[self.high_line][1]})"


def interval(frame: Frame, total: float, strict: bool = True) -> Interval:
    """Admissible x1 on the line of a sum of shifts; raises `NoSolutionError` if there are none.

    >>> from tmmcalc.gears.involute.wheel import Wheel
    >>> found = interval(frame_of(Task(Wheel(14), Wheel(17))), 1.1)
    >>> found.low_line, round(found.low, 5)
    ('undercut1', 0.18116)
    """
    w = frame.angle_of(np.array([total]))
    if not w[0] > 0:
        least = float(frame.sums(np.array([0.0])).total[0])
        raise NoSolutionError(
            f"there is no pair with the sum of shifts {total:.4f}: the base circles would overlap",
            where="blocking contour",
            value=total,
            limit=least,
            remedy=f"a sum of shifts above {least:.4f}",
        )
    low, high, below, above = cuts(frame, w, tolerated=not strict).ends(strict)
    found = Interval(total, float(low[0]), float(high[0]), LOWER[below[0]], UPPER[above[0]])
    if found.low > found.high:
        raise NoSolutionError(
            f"no shifts with the sum {total:.4f} are admissible: {LINES[found.low_line][1]} "
            f"excludes {LINES[found.high_line][1]}",
            where="blocking contour",
            value=found.high - found.low,
            limit=0.0,
            remedy="another centre distance, a smaller contact ratio or tip thickness, or the tolerated contour",
        )
    return found
