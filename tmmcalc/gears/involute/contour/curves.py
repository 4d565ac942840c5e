"""The lines of the picture of a contour, as points (x1, x2): contact ratio, tip thickness, sliding, strength, sums."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tmmcalc.gears.involute.contour.bounds import LOWER, NEVER, UPPER, cuts
from tmmcalc.gears.involute.contour.contour import Contour
from tmmcalc.gears.involute.contour.frame import Frame
from tmmcalc.gears.involute.contour.points import sliding_split, strength_split
from tmmcalc.gears.involute.contour.trace import scan
from tmmcalc.gears.model import Values
from tmmcalc.records import record

POINTS = 400  # lines of constant sum across the plane
FINE = 1e-9  # difference of form factors that counts as none


@record
class Line:
    """A line of the picture within the main branch, in the order of its points."""

    number: str  # in the textbook's figures
    value: float  # of the quantity that is constant along it
    x1: Values  # (n,)
    x2: Values  # (n,)


def contact_ratio_line(frame: Frame, value: float) -> Line:
    """Points of one contact ratio (lines 4, 5): from wheel 2 strongly shifted, round the top, to wheel 1."""
    other = replace(frame, task=replace(frame.task, contact_ratio=value))
    left1, left2 = _row(other, "contact_ratio", lower=True)
    right1, right2 = _row(other, "contact_ratio", lower=False)
    x1 = np.concatenate((left1, right1[::-1]))
    return Line("5" if value == 1 else "4", value, x1, np.concatenate((left2, right2[::-1])))


def thickness_line(frame: Frame, wheel: int, value: float) -> Line:
    """Points of one tip thickness [normal modules] of wheel 1 or 2 (lines 9, 8, 7: 0, 0.25, 0.4)."""
    one, two = frame.sides
    sides = (replace(one, thickness=value), two) if wheel == 1 else (one, replace(two, thickness=value))
    number = {0.0: "9", 0.25: "8", 0.4: "7"}.get(value, "") if wheel == 1 else ""
    return Line(number, value, *_row(replace(frame, sides=sides), f"thickness{wheel}", lower=wheel == 2))


def _row(frame: Frame, name: str, lower: bool) -> tuple[Values, Values]:
    w = scan(replace(frame, task=replace(frame.task, contact_ratio=0.0)), 0)
    w = np.linspace(w[0], w[-1], POINTS)
    found = cuts(frame, w)
    x1 = found.lower[LOWER.index(name)] if lower else found.upper[UPPER.index(name)]
    known = np.abs(x1) < NEVER / 2
    return x1[known], (found.sums.total - x1)[known]


def sliding_line(contour: Contour) -> Line:
    """Points of equal specific sliding on the lines of constant sum that meet the main region (line 6)."""
    sums = contour.frame.sums(contour.region.angles)
    x1 = sliding_split(contour.frame, sums)
    return Line("6", 0.0, x1, sums.total - x1)


def strength_line(contour: Contour) -> Line:
    """Points of equal tooth form factors within the main region (one line for 12 and 13); none: arrays of length 0."""
    region = contour.region
    sums = contour.frame.sums(region.angles)
    x1, left = strength_split(contour.frame, sums, region.low, region.high)
    equal = np.abs(left) < FINE
    return Line("12, 13", 0.0, x1[equal], (sums.total - x1)[equal])


def sum_line(contour: Contour, total: float) -> Line:
    """The line x1 + x2 = total (14; 15 for zero; 16 for the largest) across the window of the main region."""
    edge1, edge2 = contour.region.outline
    low, high = float(edge1.min()), float(edge1.max())
    low, high = min(low, total - float(edge2.max())), max(high, total - float(edge2.min()))
    x1 = np.array([low, high])
    return Line("15" if total == 0 else "14", total, x1, total - x1)
