"""The least distance of the centres for which l2, R0 and r2 in whole steps keep all constraints: ascending over l0.

Below the least l0 of any sizes there is nothing to look for (`rockershapes`). At every l0 above it the pressure angle
leaves l2 and R0 ranges in closed form, and of these all step points are tried whose r2 has an interval.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.optimum.margins import SLACK
from tmmcalc.cams.optimum.results import Level
from tmmcalc.cams.optimum.results import level as judged_level
from tmmcalc.cams.optimum.rockershapes import angles, bounds, thinned
from tmmcalc.cams.optimum.rockersizes import NUMBERS, RockerScene, Sizes, judge_rocker
from tmmcalc.cams.optimum.scene import WHERE
from tmmcalc.cams.task import Optimum
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.records import record

BELOW = 0.98  # of the least l0 of any sizes: from where steps are tried
BEYOND = 1.5  # of it: up to where they are
MORE = 20  # levels
ROUND = 1e-9  # of a step
DIGITS = 12  # of a size in metres: 18 mm is 0.018 and no rounding beside it
MANY = 1_000_000  # points of a search
FEW = 3000  # at a time


@record
class FoundSteps:
    """The feasible step points (n,) at the least l0, the best first."""

    sizes: Values  # (4, n) l2, R0, r2, l0 [m]
    margin: Values  # (8, n)
    examined: int  # points l2, R0 that were looked at
    excluded: int  # of them without an r2
    course: tuple[Level, ...]  # the l0 that were tried, ascending


def search_steps(of: RockerScene, asked: Optimum, least: float) -> FoundSteps:
    """All step points at the first l0 that has any, from about ``least`` [m] on.

    Raises `UsageError` for steps that are too fine, `NoSolutionError` where no step point is found near the least l0.
    """
    step, few = asked.step, thinned(of)
    first = max(int(np.floor(BELOW * least / step)), int(np.floor(least / step)) - MORE, 1)
    last = int(np.ceil(BEYOND * least / step)) + MORE
    if asked.centre_distances is not None:
        low, high = asked.centre_distances
        first, last = max(first, int(np.ceil(low / step - ROUND))), int(np.floor(high / step + ROUND))
    examined, excluded, course = 0, 0, list[Level]()
    for level in range(first, last + 1):
        centres = round(level * step, DIGITS)
        points = _points(few, asked, centres)
        examined += points.shape[1]
        if examined > MANY:
            raise _fine(step, examined)
        kept = _kept(few, points, step)
        excluded += points.shape[1] - kept.shape[1]
        sizes = _with_rollers(of, kept, step)
        if sizes.shape[1] > MANY:
            raise _fine(step, sizes.shape[1])
        if not sizes.shape[1]:
            course.append(Level(centres, points.shape[1], 0, 0))
            continue
        parts = [judge_rocker(of, Sizes(*sizes[:, i : i + FEW])).margin for i in range(0, sizes.shape[1], FEW)]
        margin = np.concatenate(parts, axis=1)
        holds = np.all(margin >= -SLACK, axis=0)
        course.append(judged_level(centres, points.shape[1], NUMBERS, margin, holds))
        good = np.flatnonzero(holds)
        if good.size:
            order = good[np.argsort(-np.min(margin[:, good], axis=0), kind="stable")]
            return FoundSteps(sizes[:, order], margin[:, order], examined, excluded, tuple(course))
    raise NoSolutionError(
        Phrase(
            "no sizes in whole steps of {step:g} mm keep all constraints with l0 up to {last:.6g} mm; of any sizes the "
            "least is l0 = {least:.6g} mm",
            step=1e3 * step,
            last=1e3 * last * step,
            least=1e3 * least,
        ),
        where=WHERE,
        value=last * step,
        limit=least,
        remedy="a smaller step in [cam.optimum], or wider ranges there",
    )


def _fine(step: float, count: int) -> UsageError:
    return UsageError(
        f"{count} points of whole steps are too many to try",
        where=WHERE,
        value=step,
        remedy=f"a larger [cam.optimum] step than {1e3 * step:g} mm",
    )


def _points(of: RockerScene, asked: Optimum, centres: float) -> Values:
    """Step points (4, n) of l2 and R0 at l0 that the pressure angle leaves, r2 being 0."""
    step = asked.step
    rocker = step * np.arange(1.0, int(centres / np.cos(of.scene.limits.rise) / step) + 2)
    rocker = np.round(rocker, DIGITS)
    if asked.rocker_lengths is not None:
        low, high = asked.rocker_lengths
        rocker = rocker[(rocker >= low * (1 - SLACK)) & (rocker <= high * (1 + SLACK))]
    ends = angles(of, rocker / centres)
    rocker, (low_angle, high_angle) = rocker[ends[1] > ends[0]], (end[ends[1] > ends[0]] for end in ends)
    near, far = (
        np.sqrt(centres**2 + rocker**2 - 2 * centres * rocker * np.cos(angle)) for angle in (low_angle, high_angle)
    )
    first = np.maximum(np.ceil(near / step - ROUND), 1).astype(int)
    count = np.maximum(np.floor(far / step + ROUND).astype(int) - first + 1, 0)
    if int(count.sum()) > MANY:
        raise _fine(step, int(count.sum()))
    rows = np.repeat(np.arange(len(rocker)), count)
    base = step * (np.arange(len(rows)) - np.repeat(np.cumsum(count) - count, count) + first[rows])
    base = np.round(base, DIGITS)
    return np.stack((rocker[rows], base, np.zeros(len(rows)), np.full(len(rows), centres)))


def _kept(of: RockerScene, points: Values, step: float) -> Values:
    """Those of the points whose interval of r2 holds a whole step."""
    parts = [points[:, i : i + FEW] for i in range(0, points.shape[1], FEW)]
    kept = []
    for part in parts:
        free = bounds(of, Sizes(*part))
        first, last = _whole(free.least, free.most, step)
        kept.append(part[:, first <= last])
    return np.concatenate(kept, axis=1) if kept else points


def _with_rollers(of: RockerScene, points: Values, step: float) -> Values:
    """The points with every r2 in whole steps of their interval by all nodes."""
    if not points.shape[1]:
        return points
    free = bounds(of, Sizes(*points))
    first, last = _whole(free.least, free.most, step)
    count = np.maximum(last - first + 1, 0)
    rows = np.repeat(np.arange(points.shape[1]), count)
    found = points[:, rows]
    steps = np.arange(len(rows)) - np.repeat(np.cumsum(count) - count, count) + first[rows]
    found[2] = np.round(step * steps, DIGITS)
    return found


def _whole(least: Values, most: Values, step: float) -> tuple[Values, Values]:
    """First and last whole step (n,) of an interval."""
    first = np.maximum(np.ceil(least / step - ROUND), 1).astype(int)
    return first, np.floor(np.maximum(most, 0.0) / step + ROUND).astype(int)
