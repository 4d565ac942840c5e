"""The best point of the region of the axis of the cam: a corner of two of the lines of `halfplanes`, or on one.

Exchange: find the best point of few lines, then the angles where this point is farthest outside, exact by panels, and
add their lines. As the lines are tangents of their envelope this is Newton's method for the corner.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np

from tmmcalc.cams.synthesis.halfplanes import APART, Family, Lines, lines_at, outside
from tmmcalc.cams.synthesis.objectives import Objective
from tmmcalc.cams.synthesis.polygon import crossings
from tmmcalc.core.errors import AccuracyError, NoSolutionError
from tmmcalc.core.records import record

EXCHANGES = 40
EXACT = 4e-15  # relative: a point this little outside is on the line
GOOD = 1e-12  # what is accepted where rounding does not let it come nearer
INSIDE = 2e-14  # relative: a corner of two lines is checked against the others


@record
class Best:
    """The best point, the lines that hold it, how far outside it is."""

    point: complex
    lines: Lines
    over: float


def best(every: tuple[Family, ...], aim: Objective) -> Best:
    """The point of the region where ``aim`` is least.

    Raises `NoSolutionError` if the region is empty, naming the angles that exclude each other.
    """
    seeds = []
    for family in every:
        normal, bound = family.lines(family.motion)
        seeds.append(family.highest(aim.of(aim.within(normal, bound)))[1])
    lines, least, chosen = lines_at(every, seeds), np.inf, None
    for _ in range(EXCHANGES):
        point = _best_of(lines, aim)
        over, places = outside(every, point)
        better = over < least
        if better:
            least, chosen = over, point
        if over <= EXACT * (1 + abs(point)) or (not better and least <= GOOD * (1 + abs(point))):
            break
        lines = lines.joined(lines_at(every, places))
    if chosen is None or least > GOOD * (1 + abs(chosen)):
        raise AccuracyError(
            "the corner of the admissible region was not found to rounding",
            where="cam_synthesis",
            value=float(least),
            limit=GOOD,
            remedy="look for a law with a jump of velocity, or prescribe a size",
        )
    return Best(chosen, _active(lines, chosen), float(least))


def _active(lines: Lines, point: complex) -> Lines:
    """The lines that hold the point, of those that all but coincide the one nearest to it."""
    over = np.abs(lines.over(np.array(point)))
    kept: list[int] = []
    for k in np.argsort(over, kind="stable").tolist():
        apart = all(abs(lines.normal[k] - lines.normal[other]) > APART for other in kept)
        if over[k] <= GOOD * (1 + abs(point)) and apart:
            kept.append(k)
    return lines.chosen(np.array(kept, dtype=np.intp))


def _best_of(lines: Lines, aim: Objective) -> complex:
    """The best point of few half planes: on one line, or where two cross."""
    pairs = np.array(list(combinations(range(len(lines.bound)), 2)), dtype=np.intp)
    corners = crossings(lines.normal, lines.bound, pairs[:, 0], pairs[:, 1])
    points = np.concatenate((aim.within(lines.normal, lines.bound), corners))
    points = points[np.isfinite(points)]
    inside = np.max(lines.over(points), axis=1) <= INSIDE * (1 + np.abs(points))
    if not inside.any():
        raise empty(lines)
    points = points[inside]
    return complex(points[np.argmin(aim.of(points))])


def empty(lines: Lines) -> NoSolutionError:
    """The error of an empty region: three of its lines have no common point (Helly)."""
    for three in combinations(range(len(lines.bound)), 3):
        k = np.array(three)
        a, b = k[[0, 0, 1]], k[[1, 2, 2]]
        points = crossings(lines.normal, lines.bound, a, b)
        normal, bound = lines.normal[k], lines.bound[k]
        over = np.max((points[:, None] * np.conj(normal)).real - bound, axis=1)
        if np.all(np.isfinite(points)) and np.all(over > INSIDE * (1 + np.abs(points))):
            where = sorted({f"phi = {np.degrees(lines.phi[i]):.4g} deg" for i in three})
            return NoSolutionError(
                f"no place of the cam's axis keeps the pressure angle: {', '.join(where)} exclude each other",
                where="cam_synthesis",
            )
    return NoSolutionError("no place of the cam's axis keeps the pressure angle", where="cam_synthesis")
