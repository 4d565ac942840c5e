"""The lines of the picture of a blocking contour, cut to its window.

Lines 12 and 13 of the textbook, equal bending strength with either wheel driving, differ by the direction of friction,
for which it gives no rule: there is one line, of equal form factors with the load at the tip.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.gears.involute.contour.contour import Contour
from tmmcalc.gears.involute.contour.curves import (
    Line,
    across,
    contact_ratio_line,
    sliding_line,
    strength_line,
    thickness_line,
)
from tmmcalc.gears.involute.contour.points import largest_sum
from tmmcalc.gears.meshing.contours import ContourLine
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.model import Values

RATIOS = (1.0, 1.1, 1.2)  # contact ratios whose lines are drawn
THICKNESSES = (0.0, 0.25, 0.4)  # tip thicknesses, modules
MARGIN = 0.5  # of the window around the contour
PLANE = ((-1.2, 2.2), (-1.2, 3.0))  # window of a pair without a contour
SAME = 1e-12  # difference of sums of shifts that is none

Window = tuple[tuple[float, float], tuple[float, float]]  # least and largest x1, x2


def contour_lines(pair: MeshPair, both: tuple[Contour, Contour]) -> tuple[ContourLine, ...]:
    """All lines of an external pair that pass through the window."""
    window = _window(pair, both)
    frame, limits = both[0].frame, pair.task.limits
    w = _angles(both[0], window)
    lines: list[ContourLine] = []
    for ratio in sorted({*RATIOS, limits.contact_ratio}):
        lines += _cut(contact_ratio_line(frame, ratio, w), "contact ratio", window)
    for wheel in (1, 2):
        for least in sorted({*THICKNESSES, limits.tip_thickness}):
            lines += _cut(thickness_line(frame, wheel, least, w), f"tip thickness of wheel {wheel}, modules", window)
    area = next((area for area in both[::-1] if area.main is not None), None)
    if area is not None:
        lines += _cut(sliding_line(area), "equal specific sliding of both wheels", window)
        title = "equal tooth form factors, whichever wheel drives"
        lines += _cut(strength_line(area), title, window)
    return (*lines, *_sums(pair, both, window))


def _window(pair: MeshPair, both: tuple[Contour, Contour]) -> Window:
    """Around both contours and the chosen shifts."""
    regions = [area.main for area in both if area.main is not None]
    if not regions:
        ends = [np.array([*span, shift]) for span, shift in zip(PLANE, pair.shifts, strict=True)]
        return _span(ends[0]), _span(ends[1])
    edges = [np.concatenate([region.outline[k] for region in regions]) for k in (0, 1)]
    one, two = (_span(np.append(edge, shift)) for edge, shift in zip(edges, pair.shifts, strict=True))
    return (one[0] - MARGIN, one[1] + MARGIN), (two[0] - MARGIN, two[1] + MARGIN)


def _span(values: Values) -> tuple[float, float]:
    return float(values.min()), float(values.max())


def _angles(area: Contour, window: Window) -> Values:
    """Operating angles of the lines of constant sum that meet the window."""
    w = across(area.frame)
    least, most = (
        float(area.frame.angle_of(np.array([window[0][k] + window[1][k]]))[0]) for k in (0, 1)
    )  # nan: below all pairs
    low = max(float(w[0]), least) if np.isfinite(least) else float(w[0])
    return np.linspace(low, min(float(w[-1]), most), w.size)


def _cut(line: Line, title: str, window: Window) -> list[ContourLine]:
    """The parts of a line within the window."""
    (low1, high1), (low2, high2) = window
    inside = (line.x1 >= low1) & (line.x1 <= high1) & (line.x2 >= low2) & (line.x2 <= high2)
    marks = np.flatnonzero(np.diff(np.concatenate(([0], inside.astype(np.int8), [0]))))
    parts = [slice(int(a), int(b)) for a, b in zip(marks[::2], marks[1::2], strict=True) if b - a > 1]
    return [ContourLine(line.number, title, float(line.value), line.x1[part], line.x2[part]) for part in parts]


def _sums(pair: MeshPair, both: tuple[Contour, Contour], window: Window) -> list[ContourLine]:
    """Lines 14, 15 and 16 of constant sum."""
    chosen = float(sum(pair.shifts))
    wanted = [("14, 15" if abs(chosen) < SAME else "14", "x1 + x2 of the chosen shifts", chosen)]
    if abs(chosen) >= SAME:
        wanted.append(("15", "x1 + x2 = 0: reference and pitch circles coincide", 0.0))
    area = next((area for area in both if area.main is not None), None)
    if area is not None:
        kind = "strict" if area.strict else "tolerated"
        wanted.append(("16", f"largest x1 + x2 of the {kind} contour", float(sum(largest_sum(area)))))
    (low1, high1), (low2, high2) = window
    lines = []
    for number, title, total in wanted:
        low, high = max(low1, total - high2), min(high1, total - low2)
        if low < high:
            x1 = np.array([low, high])
            lines.append(ContourLine(number, title, total, x1, total - x1))
    return lines
