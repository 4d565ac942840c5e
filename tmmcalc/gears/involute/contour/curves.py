"""The lines of the picture of a contour, as points (x1, x2): contact ratio, tip thickness, sliding, strength."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.bounds import NEVER, contact_ends, thickness_ends
from tmmcalc.gears.involute.contour.contour import Contour
from tmmcalc.gears.involute.contour.equalstrength import strength_split
from tmmcalc.gears.involute.contour.frame import Frame, Sums
from tmmcalc.gears.involute.contour.points import along, sliding_split
from tmmcalc.gears.involute.contour.trace import scan
from tmmcalc.gears.model import Values

POINTS = 200  # lines of constant sum across the plane
FINE = 1e-9  # difference of form factors that counts as none
SAME = 1e-9  # difference of sums that counts as none


@record
class Line:
    """A line of the picture within the main branch, in the order of its points."""

    number: str  # in the textbook's figures
    value: float  # of the quantity that is constant along it
    x1: Values  # (n,)
    x2: Values  # (n,)


def across(frame: Frame) -> Values:
    """Operating angles [rad] (n,) that cover the main branch; none if no mesh is there."""
    ends = scan(replace(frame, task=replace(frame.task, contact_ratio=0.0)), 0)[[0, -1]]
    return np.linspace(ends[0], ends[1], POINTS)


def contact_ratio_line(frame: Frame, value: float, w: Values | None = None) -> Line:
    """Points of one contact ratio (lines 4, 5): from wheel 2 strongly shifted, round the top, to wheel 1.

    ``w`` (ascending) are the operating angles to look at, by default those of the whole main branch.
    """
    other = replace(frame, task=replace(frame.task, contact_ratio=value))
    w = across(frame) if w is None else w

    def top(angles: Values) -> Values:
        sums = other.sums(angles)
        return other.overlap(sums, other.best_split(sums))[0]

    excess = top(w)
    last = np.flatnonzero((excess[:-1] >= 0) & (excess[1:] < 0))
    if last.size:  # closer to where both sides meet
        k = int(last[-1])
        end = along(top, float(w[k]), float(w[k + 1]))
        w = w[0] + (end - w[0]) * np.sin(np.linspace(0.0, pi / 2, w.size)) * (1 - 1e-12)
    sums = other.sums(w)
    left, right = contact_ends(other, sums, *_domain(other, sums))
    on_left, on_right = np.abs(left) < NEVER / 2, np.abs(right) < NEVER / 2
    x1 = np.concatenate((left[on_left], right[on_right][::-1]))
    total = np.concatenate((sums.total[on_left], sums.total[on_right][::-1]))
    return Line("5" if value == 1 else "4", value, x1, total - x1)


def thickness_line(frame: Frame, wheel: int, value: float, w: Values | None = None) -> Line:
    """Points of one tip thickness [normal modules] of wheel 1 or 2 (lines 9, 8, 7: 0, 0.25, 0.4)."""
    one, two = frame.sides
    sides = (replace(one, thickness=value), two) if wheel == 1 else (one, replace(two, thickness=value))
    other = replace(frame, sides=sides)
    sums = other.sums(across(frame) if w is None else w)
    low1, high1 = _domain(other, sums)
    low, high = (low1, high1) if wheel == 1 else (sums.total - high1, sums.total - low1)
    x = thickness_ends(other, wheel - 1, sums, low, high)[1]
    x1 = x if wheel == 1 else sums.total - x
    known = np.abs(x) < NEVER / 2
    number = {0.0: "9", 0.25: "8", 0.4: "7"}.get(value, "")
    prime = "'" if wheel == 2 and number else ""
    return Line(f"{number}{prime}", value, x1[known], (sums.total - x1)[known])


def _domain(frame: Frame, sums: Sums) -> tuple[Values, Values]:
    """x1 with both tips outside the reference circles."""
    reach = sums.modification + frame.addendum
    return sums.total - reach, reach


def sliding_line(contour: Contour) -> Line:
    """Points of equal specific sliding on the lines of constant sum that meet the main region (line 6)."""
    sums = contour.frame.sums(contour.region.angles)
    x1 = sliding_split(contour.frame, sums)
    return Line("6", 0.0, x1, sums.total - x1)


def strength_line(contour: Contour) -> Line:
    """Points of equal tooth form factors within the main region (one line for 12 and 13); none: arrays of length 0."""
    total, x1 = contour.strength_ends
    frame, totals, places = contour.frame, [total], [x1]
    for part in contour.region.parts:
        sums = frame.sums(part.angles)
        x1, left = strength_split(frame, sums, part.low, part.high)
        equal = np.abs(left) < FINE
        totals.append(sums.total[equal])
        places.append(x1[equal])
    total, x1 = np.concatenate(totals), np.concatenate(places)
    order = np.argsort(total, kind="stable")
    order = order[np.append(True, np.diff(total[order]) > SAME)[: order.size]]
    return Line("12, 13", 0.0, x1[order], (total - x1)[order])
