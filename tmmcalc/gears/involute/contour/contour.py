"""The blocking contour of a pair: strict, and with the undercut tolerated that leaves the active flank whole."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from itertools import zip_longest

import numpy as np

from tmmcalc.core.errors import AccuracyError, NoSolutionError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.bounds import Cuts, cuts
from tmmcalc.gears.involute.contour.equalstrength import strength_ends
from tmmcalc.gears.involute.contour.frame import Frame, Sums, frame_of
from tmmcalc.gears.involute.contour.regions import Region, regions_of
from tmmcalc.gears.involute.contour.task import Task
from tmmcalc.gears.involute.contour.trace import POINTS, ContourPart, parts_of, scan
from tmmcalc.gears.model import Values

ZOOM = 65  # points of a round that narrows a maximum
ROUNDS = 6
ASIDE = np.array([-1e-7, 1e-7])  # [rad] from a place that may be a maximum by itself
COARSE = 0.02  # by which the points of a part may miss its largest contact ratio
LEVEL = 1e-13  # of a contact ratio that grows no more


@record
class Contour:
    """All admissible shifts of a task."""

    strict: bool  # no undercut at all
    frame: Frame
    # with both tip circles outside the reference circles and what a neck joins to it; None: nothing is admissible there
    main: Region | None
    pieces: tuple[Region, ...]  # beyond the pinch points, with a tip inside its reference circle, or apart from main
    untraced: tuple[
        int, ...
    ] = ()  # 1, 2, 3: tip of wheel 2, 1, both inside the reference circle; pieces there whose outline is not found

    twin: Contour | None = None  # the strict contour, if undercut bounds nothing and both have the same main region

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
        if self.twin is not None:
            return self.twin.best
        if self.main is not None:
            return largest_contact_ratio(self.frame, self.main, self.strict)
        free = contour(replace(self.task, contact_ratio=0.0), self.strict, pieces=False)
        return (0.0, 0.0, 0.0) if free.main is None else free.best

    @cached_property
    def strength_ends(self) -> tuple[Values, Values]:
        """Sums of shifts and x1 (k,) at which the line of equal tooth form factors ends in the main region."""
        if self.twin is not None:
            return self.twin.strength_ends
        ends = [strength_ends(self.frame, part, self.strict) for part in self.region.parts]
        return np.concatenate([total for total, _ in ends]), np.concatenate([x1 for _, x1 in ends])

    @property
    def best_contact_ratio(self) -> float:
        """The largest eps_alpha that the other conditions leave; 0 if they leave nothing."""
        return self.best[2]

    @property
    def reason(self) -> Phrase:
        """Why there is no main region, with the best contact ratio."""
        kind = "without undercut" if self.strict else "even with tolerated undercut"
        teeth = f"{self.task.first.teeth}/{self.task.second.teeth}"
        if not self.best_contact_ratio:
            return Phrase("no shifts of z = {teeth} give a mesh {kind}", teeth=teeth, kind=kind)
        return Phrase(
            "no shifts of z = {teeth} reach the contact ratio {ratio} {kind}; "
            "the best within the other conditions is {best}",
            teeth=teeth,
            ratio=f"{self.task.contact_ratio:g}",
            kind=kind,
            best=f"{self.best_contact_ratio:.4f}",
        )

    @property
    def _remedy(self) -> str:
        if self.best_contact_ratio:
            return "a smaller contact ratio or tip thickness, or more teeth"
        return "a smaller tip thickness, more teeth, or the tolerated contour"


def contour(task: Task, strict: bool = True, *, pieces: bool = True, points: int = POINTS) -> Contour:
    """The strict or the tolerated contour, or its main region only; main is None if no shifts meet all conditions.

    ``points`` are those of an edge between two of its breaks, on which the accuracy of the area depends.
    """
    return contours(task, (strict,), pieces=pieces, points=points)[0]


def contours(
    task: Task, kinds: tuple[bool, ...] = (True, False), *, pieces: bool = True, points: int = POINTS
) -> list[Contour]:
    """The strict and the tolerated contour, or those of other ``kinds``, as `contour` finds one."""
    frame = frame_of(task)
    found: dict[bool, list[ContourPart]] = {kind: [] for kind in kinds}
    untraced: dict[bool, list[int]] = {kind: [] for kind in kinds}
    for branch in frame.branches if pieces or frame.neck > 0 else (0,):
        w = scan(frame, branch, [part for kind in kinds for part in found[kind]])
        if not w.size:
            continue
        scanned = cuts(frame, w, branch, tolerated=False in kinds)
        alike = len(kinds) > 1 and _alike(scanned)
        for kind in kinds:
            if alike and kind != kinds[0]:
                found[kind] += [part for part in found[kinds[0]] if part.branch == branch]
                untraced[kind] += [b for b in untraced[kinds[0]] if b == branch]
                continue
            try:
                found[kind] += parts_of(frame, branch, kind, scanned, points)
            except AccuracyError:
                if branch == 0:
                    raise
                untraced[kind].append(branch)
    first, *others = (_whole(kind, frame, found[kind], tuple(untraced[kind])) for kind in kinds)
    return [first, *(_like(first, other) for other in others)]


def _like(strict: Contour, tolerated: Contour) -> Contour:
    """The tolerated contour, with the main region of the strict one where both have the same parts."""
    if strict.main is None or tolerated.main is None:
        return tolerated
    same = all(one is other for one, other in zip_longest(strict.main.parts, tolerated.main.parts))
    return replace(tolerated, main=strict.main, twin=strict) if same else tolerated


def _alike(scanned: Cuts) -> bool:
    """Whether undercut bounds nothing, so that both contours have the same parts."""
    one, other = scanned.ends(strict=True), scanned.ends(strict=False)
    empty = (one[0] > one[1]) & (other[0] > other[1])
    return all(bool(np.all((a == b) | empty)) for a, b in zip(one, other, strict=True))


def _whole(strict: bool, frame: Frame, parts: list[ContourPart], untraced: tuple[int, ...]) -> Contour:
    regions = regions_of(frame, parts)
    central = (region for region in regions if any(part.branch == 0 for part in region.parts))
    main = max(central, key=lambda region: region.area, default=None)
    return Contour(strict, frame, main, tuple(region for region in regions if region is not main), untraced)


def largest_contact_ratio(frame: Frame, region: Region, strict: bool) -> tuple[float, float, float]:
    """x1, x2 and eps_alpha of the largest contact ratio of a region of the strict or the tolerated contour."""
    tops = [float(np.max(_best(frame, part.low, part.high, frame.sums(part.angles))[1])) for part in region.parts]
    close = (part for part, top in zip(region.parts, tops, strict=True) if top > max(tops) - COARSE)
    return max((_largest(frame, part, strict) for part in close), key=lambda found: found[2])


def _best(frame: Frame, low: Values, high: Values, sums: Sums) -> tuple[Values, Values]:
    """x1 and eps_alpha - eps_min (n,) of the best split between low and high."""
    x1 = np.clip(frame.best_split(sums), low, high)
    return x1, frame.overlap(sums, x1)[0]


def _largest(frame: Frame, part: ContourPart, strict: bool) -> tuple[float, float, float]:
    """Of one part: on every line of constant sum the split of equal tip pressure angles, or the end next to it."""

    def looked(w: Values) -> tuple[Values, Values]:
        found = cuts(frame, w, part.branch, tolerated=not strict)
        low, high, _, _ = found.ends(strict)
        x1, ratio = _best(frame, low, high, found.sums)
        return x1, np.where(low <= high, ratio, -np.inf)

    w = part.angles
    x1, ratio = _best(frame, part.low, part.high, frame.sums(w))
    k = int(np.argmax(ratio))
    if 0 < k < w.size - 1 and np.all(looked(w[k] + ASIDE)[1] < ratio[k]):
        w, x1, ratio, k = w[k : k + 1], x1[k : k + 1], ratio[k : k + 1], 0  # a corner
    for _ in range(ROUNDS):
        if k in (0, w.size - 1) or ratio[k] - min(ratio[k - 1], ratio[k + 1]) < LEVEL:
            break
        w = np.linspace(w[k - 1], w[k + 1], ZOOM)
        x1, ratio = looked(w)
        k = int(np.argmax(ratio))
    sums = frame.sums(w)
    return float(x1[k]), float(sums.total[k] - x1[k]), float(ratio[k]) + frame.task.contact_ratio
