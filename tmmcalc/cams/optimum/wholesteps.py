"""The least height H2 for which S0 and r2 in whole steps keep all constraints: an exact search, ascending over H2.

Every step point has, from the ranges of its guide length, a least height in closed form. The heights are tried in
ascending order and each with all points whose range holds it, so that the first that has a feasible point is the
least: every other point is beyond a limit at some angle of the cam. A point with S0 cannot be lower than S0 + h + r2,
which tells when no larger S0 needs to be looked at.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.optimum.firstfeasible import FirstFeasible, first_feasible
from tmmcalc.cams.optimum.guidelength import SINGLE, TALL, Range, ranges
from tmmcalc.cams.optimum.margins import NUMBERS, SLACK, margins
from tmmcalc.cams.optimum.results import Level, merged
from tmmcalc.cams.optimum.results import level as judged_level
from tmmcalc.cams.optimum.scene import WHERE, Scene
from tmmcalc.cams.optimum.slipbounds import may_roll
from tmmcalc.cams.strength.formulas import rolling
from tmmcalc.cams.task import Optimum
from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record

FIRST = 4.0  # strokes: first stretch of S0
FARTHEST = (20.0, 0.2)  # so many strokes, or [m]: S0 beyond is looked for where nothing is found up to there
MANY = 100_000  # step points of a stretch
HIGHEST = 20.0  # heights above so many times the least bound of all are not looked at
PATIENCE = 8  # heights that are tried before those points are taken out that slip at any larger one; a power of 2
ROUND = 1e-9  # of a step: a height that is whole but for rounding


@record
class Candidates:
    """Step points (n,) that some guide suits, and the heights H2 between which it does."""

    start: Values  # [m]
    roller: Values
    least: Values
    most: Values
    examined: int  # step points that were looked at
    passed: dict[int, int]  # how many of them each constraint alone leaves, for some height
    # sizes that keep all constraints, where there are too many step points up to them
    far: FirstFeasible | None = None

    def joined(self, other: Candidates) -> Candidates:
        """Both stretches."""
        return Candidates(
            start=np.concatenate((self.start, other.start)),
            roller=np.concatenate((self.roller, other.roller)),
            least=np.concatenate((self.least, other.least)),
            most=np.concatenate((self.most, other.most)),
            examined=self.examined + other.examined,
            passed={key: self.passed[key] + other.passed[key] for key in self.passed},
        )


@record
class Found:
    """The feasible step points at the least height."""

    height: float  # H2 [m]
    start: Values  # S0 (n,) [m]
    roller: Values  # r2 (n,) [m]
    margin: Values  # (8, n)
    course: tuple[Level, ...] = ()  # the heights that were tried, ascending

    @property
    def best(self) -> int:
        """The point whose least margin is largest."""
        return int(np.argmax(np.min(self.margin, axis=0)))


def farthest(scene: Scene, asked: Optimum) -> float:
    """S0 [m] up to which all step points are looked at: as the heights allow, or some strokes."""
    if asked.heights is not None:
        return asked.heights[1] - scene.stroke - scene.guide.gap
    return max(FARTHEST[0] * scene.stroke, FARTHEST[1])


def search(scene: Scene, asked: Optimum) -> tuple[Found | None, Candidates]:
    """The least height in steps, None if there is none in the asked range; and all candidates, as the proof.

    Raises `UsageError` for steps that are too fine against the stroke.
    """
    far = farthest(scene, asked)
    high = min(FIRST * scene.stroke, far)
    known = _stretch(scene, asked.step, 0.0, high)
    found, known = _onwards(scene, asked, known, high, far)
    if found is not None or asked.heights is not None:
        return found, known
    first = first_feasible(scene, far)
    if first is None:
        return None, known
    last = first.height - scene.stroke - scene.guide.gap
    if _points(scene, asked.step, far, last) > MANY:
        return None, replace(known, far=first)
    return _onwards(scene, asked, known, far, last)


def _onwards(
    scene: Scene, asked: Optimum, known: Candidates, high: float, far: float
) -> tuple[Found | None, Candidates]:
    """The least height with S0 up to ``far``, of which the candidates up to ``high`` are known."""
    base, left = scene.stroke + scene.guide.gap, known
    course: list[Level] = []  # the heights that were tried
    while True:
        before = len(course)
        found = _lowest(scene, asked, left, course)
        bound = far if found is None else min(found.height - base, far)
        if bound <= high:
            return None if found is None else replace(found, course=merged(course, found.height)), known
        if found is not None:
            del course[before:]  # its points are judged again, with those farther out
        low, high = high, min(max(2 * high, 4 * asked.step), bound)
        fresh = _stretch(scene, asked.step, low, high)
        known, left = known.joined(fresh), fresh if found is None else left.joined(fresh)


def _stretch(scene: Scene, step: float, low: float, high: float) -> Candidates:
    """The candidates with S0 in (low, high]."""
    points = _points(scene, step, low, high)
    if points > MANY:
        raise UsageError(
            f"{points} points of whole steps are too many to try",
            where=WHERE,
            value=step,
            remedy=f"a larger [cam.optimum] step than {1e3 * step:g} mm",
        )
    start, first, count = _rollers(scene, step, low, high)
    rows = np.repeat(np.arange(len(start)), count)
    roller = step * (np.arange(len(rows)) - np.repeat(np.cumsum(count) - count, count) + first[rows])
    base = np.hypot(start, scene.follower.offset)
    return _candidates(scene, start[rows], roller, int(np.sum(np.floor(base / step + ROUND))))


def _points(scene: Scene, step: float, low: float, high: float) -> int:
    """How many points of whole steps have S0 in (low, high]; if its steps alone are too many, these."""
    starts = int((high - low) / step)
    return starts if starts > MANY else int(_rollers(scene, step, low, high)[2].sum())


def _rollers(scene: Scene, step: float, low: float, high: float) -> tuple[Values, Indices, Indices]:
    """S0 (n,) in whole steps in (low, high], the first step of r2 that the curvature leaves, and how many."""
    start = step * np.arange(int(low / step + ROUND) + 1, int(high / step + ROUND) + 1)
    bend, _ = rolling(scene.follower, scene.motion, start[:, None])
    most, least = np.max(bend, axis=1), np.min(bend, axis=1)
    limits, base = scene.limits, np.hypot(start, scene.follower.offset)
    convex = np.where(most > 0, 1 / np.where(most > 0, most, 1.0) - limits.convex, base)
    concave = np.where(least < 0, limits.concave + 1 / np.where(least < 0, least, -1.0), 0.0)
    if not limits.allow_concave:
        concave = np.where(least < 0, TALL, 0.0)
    first = np.maximum(np.ceil(concave / step - ROUND), 1).astype(int)
    last = np.floor(np.minimum(convex, base) / step + ROUND).astype(int)
    return start, first, np.maximum(last - first + 1, 0)


def _candidates(scene: Scene, start: Values, roller: Values, examined: int) -> Candidates:
    each = ranges(scene, start, roller)
    whole = Range(np.zeros(len(start)), np.full(len(start), TALL))
    for key in SINGLE:
        whole = whole.meet(each[key])
    base, keep = start + scene.stroke + roller + scene.guide.gap, whole.some
    passed = {key: int(np.count_nonzero(own.some)) for key, own in each.items()}
    return Candidates(
        start[keep], roller[keep], (base + whole.least)[keep], (base + whole.most)[keep], examined, passed
    )


def _lowest(scene: Scene, asked: Optimum, known: Candidates, course: list[Level]) -> Found | None:
    """The first height, ascending, at which a candidate keeps all constraints."""
    step = asked.height_step
    lower, upper = (0.0, np.inf) if asked.heights is None else asked.heights
    first = np.ceil(np.maximum(known.least, lower) / step - ROUND)
    last = np.floor(np.minimum(known.most, upper) / step + ROUND)
    left = np.flatnonzero(first <= last)
    if not left.size:
        return None
    highest = HIGHEST * float(np.min(first[left]))
    left = left[first[left] <= highest]
    last = np.minimum(last, highest)
    level, tried, levels = 0, 0, np.sort(first[left])
    while left.size and level <= np.max(last[left]):
        rows = left[(first[left] <= level) & (last[left] >= level)]
        if not rows.size:
            if level >= levels[-1]:
                return None
            level = int(levels[np.searchsorted(levels, level, side="right")])
            continue
        height = level * step
        margin = margins(scene, known.start[rows], known.roller[rows], np.full(len(rows), height))
        good = np.all(margin >= -SLACK, axis=0)
        course.append(judged_level(height, len(rows), NUMBERS, margin, good))
        if good.any():
            rows = rows[good]
            return Found(height, known.start[rows], known.roller[rows], margin[:, good])
        level, tried = level + 1, tried + 1
        if tried >= PATIENCE and tried & (tried - 1) == 0:
            low = step * np.maximum(first[left], level)
            high = step * np.maximum(last[left], level)
            left = left[may_roll(scene, known.start[left], known.roller[left], low, high)]
    return None
