"""The line of equal bending strength: where both wheels have one tooth form factor, and where it leaves a region."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.roots import Indices, bracketed
from tmmcalc.gears.involute.contour.bounds import cuts
from tmmcalc.gears.involute.contour.frame import Frame, Sums
from tmmcalc.gears.involute.contour.trace import ContourPart
from tmmcalc.gears.involute.formfactor import tooth_form
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.model import Values

ON_LINE = 1e-9  # distance from a line that is none
EQUAL = 1e-9  # difference of form factors that counts as none
INSIDE = 1e-10  # [rad] from the first and the last line, where a line of constant sum has a length


def strength_split(frame: Frame, sums: Sums, low: Values, high: Values) -> tuple[Values, Values]:
    """x1 (n,) of equal tooth form factors between low and high, and the difference Y_F1 - Y_F2 left there.

    Where no split is equal the end with the smaller difference is given.
    """

    def difference(x1: Values, which: Indices) -> Values:
        return strength_gap(frame, sums.some(which), x1)

    x1 = bracketed(difference, low, high, absolute=1e-12)
    return x1, difference(x1, np.arange(x1.size))


def strength_gap(frame: Frame, sums: Sums, x1: Values) -> Values:
    """Y_F1 - Y_F2 (n,) at x1 on lines of constant sum."""
    one, two = frame.task.first, frame.task.second
    x2 = sums.total - x1
    first = tooth_form(Wheel(one.teeth, x1, one.helix, one.rack), frame.tip(0, sums, x1))
    second = tooth_form(Wheel(two.teeth, x2, two.helix, two.rack), frame.tip(1, sums, x2))
    return first.factor - second.factor


def strength_ends(frame: Frame, part: ContourPart, strict: bool) -> tuple[Values, Values]:
    """Sums of shifts and x1 (k,) at which the line of equal tooth form factors leaves a part.

    It leaves through the edge at which the difference changes its sign, or through the top, as with equal wheels.
    """
    w = part.angles
    sums = frame.sums(w)
    ends = np.array([strength_gap(frame, sums, x1) for x1 in (part.low, part.high)])
    holds = (ends[0] < 0) != (ends[1] < 0)
    change = np.flatnonzero(holds[1:] != holds[:-1])
    high = (ends[0, change] < 0) == (ends[0, change + 1] < 0)
    point = np.abs(ends[0]) < EQUAL  # the whole line of constant sum is a point there
    point[1:-1] = False
    if frame.neck > 0:  # across a tip line it goes on in the next part
        outer = ~np.all(
            [_on_tip(frame, sums.some(k), np.where(high, part.high[k], part.low[k])) for k in (change, change + 1)],
            axis=0,
        )
        change, high = change[outer], high[outer]
    if not change.size:
        return sums.total[point], part.low[point]

    def edge(angles: Values, which: Indices) -> tuple[Sums, Values]:
        found = cuts(frame, angles, part.branch, tolerated=not strict)
        least, most, _, _ = found.ends(strict)
        return found.sums, np.where(high[which], most, least)

    left, right = w[change], w[change + 1]
    left, right = np.where(change == 0, left + INSIDE, left), np.where(change == w.size - 2, right - INSIDE, right)
    at = bracketed(lambda angles, which: strength_gap(frame, *edge(angles, which)), left, right, absolute=1e-12)
    found, x1 = edge(at, np.arange(at.size))
    return np.append(found.total, sums.total[point]), np.append(x1, part.low[point])


def _on_tip(frame: Frame, sums: Sums, x1: Values) -> NDArray[np.bool_]:
    """Whether x1 (n,) lie on a line on which a tip circle is its reference circle."""
    reach = sums.modification + frame.addendum
    on: NDArray[np.bool_] = np.minimum(np.abs(x1 - reach), np.abs(sums.total - x1 - reach)) < ON_LINE
    return on
