"""The picture of a map of feasible parameters: the region, and where the margin of every constraint is zero.

Borders run between the points of the grid as if margins were linear there. Of one parameter the margins are curves.
"""

from __future__ import annotations

import textwrap
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.plane import Plane
from tmmcalc.feasibility.logic import Values
from tmmcalc.feasibility.maps import RegionMap
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Axis, Diagram, key_rows
from tmmcalc.report.drawing.key import samples_in_rows
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.pens import CURVES, INK, Pen
from tmmcalc.report.drawing.shapes import Area, Drawing, Stroke
from tmmcalc.report.language import tr
from tmmcalc.report.numbers import number

REGION = "#d5ece2"
WRAP = 110  # characters of a line of the rule
DOTS = 2000  # points of a grid up to which they are marked
FINER = 8  # steps between two values, within which margins are linear
BEST = Pen("BEST", 0.3, (0.4, 0.8), INK)
POINTS = Pen("GRID_POINTS", 0.13, colour="#9a9a9a")
BARRED = Pen("NO_SOLUTION", 0.25, colour="#9a9a9a")
HOLDS = Pen("REGION", 2.2, colour=REGION)
TICKS = (2.2, 1.1)  # of a border, to the side that fails: from one to the next, and their length [mm]
SCALE = 100.0  # [%] of the margins of one parameter, at most


def region_drawing(result: RegionMap) -> Drawing:
    """One sheet: over two parameters the plane with the borders, over one the margins as curves."""
    found, count = int(np.count_nonzero(result.feasible)), len(result.feasible)
    heading = tr("Feasible parameters: {found} of {count} points", found=found, count=count)
    drawing, box = titled("\n".join([heading, *textwrap.wrap(tr("rule: {rule}", rule=result.rule), WRAP)]), 3.2)
    names = _names(result)
    foot = 4.8 * len(key_rows(names, box.width)) + 3
    frame = box.inset(18, 12 + foot, 4, 2)
    if len(result.parameters) == 1:
        _curves(drawing, frame, result)
    else:
        _plane(drawing, frame, result)
    samples_in_rows(drawing, Box(box.left, box.bottom, box.right, box.bottom + foot - 2), names)
    return drawing


def _plane(drawing: Drawing, box: Box, result: RegionMap) -> None:
    """The region filled, its borders with ticks to the side that fails, points without a solution crossed."""
    x, y = (np.array(each.values) for each in result.parameters)
    across, up = (Axis(each.header, v[0], v[-1]) for each, v in zip(result.parameters, (x, y), strict=True))
    field = Diagram(drawing, box, across, up)
    fine = _between(x), _between(y)
    blank = _plane_between((x, y), fine, result.solved.astype(float), result) < 1
    margins = [_plane_between((x, y), fine, each, result) for each in result.margins]
    for area in _filled(fine, np.where(blank, np.nan, result.exact(margins))):
        drawing.add(Area(field.paper(area), REGION), level=-3)
    for k, margin in enumerate(margins):
        for line in _lines(fine, np.where(blank, np.nan, margin)):
            _border(field, line, _pen(k))
    _points(field, result, np.repeat(x, len(y)), np.tile(y, len(x)))


def _filled(fine: tuple[Values, Values], values: Values) -> list[Plane]:
    """Areas where values are not below zero; what is not a number is left out."""
    from contourpy import FillType, contour_generator

    found = contour_generator(*fine, np.ma.masked_invalid(values), fill_type=FillType.OuterCode)
    parts: list[Plane] = []
    for points, codes in zip(*found.filled(0.0, np.inf), strict=True):
        # holes are cut in by a way there and back, so that one polygon tells the area
        starts = [*np.flatnonzero(codes == 1).tolist(), len(points)]
        loops = [points[a:b] @ np.array([1, 1j]) for a, b in pairwise(starts)]
        outer = loops[0]
        parts.append(np.concatenate([outer, *(np.append(hole, outer[-1:]) for hole in loops[1:])]))
    return parts


def _lines(fine: tuple[Values, Values], values: Values) -> list[Plane]:
    """Where values are zero, with what is above zero on the left."""
    from contourpy import contour_generator

    lines = contour_generator(*fine, np.ma.masked_invalid(values)).lines(0.0)
    return [np.asarray(line @ np.array([1, 1j])) for line in lines]


def _border(field: Diagram, line: Plane, pen: Pen) -> None:
    """A border with ticks to the side that fails."""
    field.curve(line, pen)
    z = field.paper(line)
    way = np.concatenate(([0.0], np.cumsum(np.abs(np.diff(z)))))
    for at in np.arange(TICKS[0] / 2, way[-1], TICKS[0]).tolist():
        k = min(int(np.searchsorted(way, at)), len(z) - 1)
        step = z[k] - z[k - 1]
        if step:
            foot = z[k - 1] + step * (at - way[k - 1]) / abs(step)
            side = -1j * np.exp(0.5j) * step / abs(step)  # to the right, where values are below zero
            field.drawing.add(Stroke(np.array([foot, foot + TICKS[1] * side]), pen._replace(width=0.2)), level=4)


def _between(x: Values) -> Values:
    """The values with others between them."""
    return np.interp(np.arange((len(x) - 1) * FINER + 1) / FINER, np.arange(len(x)), x)


def _plane_between(at: tuple[Values, Values], fine: tuple[Values, Values], values: Values, of: RegionMap) -> Values:
    """Values on the finer grid, bilinear, rows along the second parameter."""
    columns = np.array([np.interp(fine[1], at[1], row) for row in values.reshape(of.shape)])
    return np.array([np.interp(fine[0], at[0], row) for row in columns.T])


def _points(field: Diagram, result: RegionMap, x: Values, y: Values) -> None:
    z = x + 1j * y
    if len(x) <= DOTS:
        for at in z[result.solved].tolist():
            field.marker(at, "o", POINTS, 0.35)
    for at in z[~result.solved].tolist():
        field.marker(at, "X", BARRED, 1.1)
    field.marker(complex(z[result.best]), "o", Pen("POINTS", 0.3, colour=INK), 1.9, filled=False)


def _curves(drawing: Drawing, box: Box, result: RegionMap) -> None:
    """Margins in percent, blank where there is no solution; the feasible part is filled."""
    x = np.array(result.parameters[0].values)
    largest = float(np.max(np.abs(100 * result.margins)))
    scale = min(1.1 * largest, SCALE) or 1.0
    across = Axis(result.parameters[0].header, x[0], x[-1])
    field = Diagram(drawing, box, across, Axis(tr("margin to the nearer limit, % of it"), -scale, scale))
    fine = _between(x)
    region = result.exact([np.interp(fine, x, each) for each in result.margins]) >= 0
    region &= np.interp(fine, x, result.solved) == 1
    for low, high in _runs(region):
        field.band(float(fine[low]), float(fine[high]), REGION)
    for k, margins in enumerate(result.margins):
        for low, high in _runs(np.asarray(result.solved, bool)):
            field.curve(x[low : high + 1] + 100j * margins[low : high + 1], CURVES[k % len(CURVES)])
    field.vertical(float(x[result.best]), BEST)
    for at in x[~result.solved].tolist():
        field.marker(complex(at, 0.0), "X", BARRED, 1.2)


def _runs(mask: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First and last index of every row of neighbours that hold."""
    padded = np.concatenate(([False], mask, [False])).astype(int)
    starts, ends = np.flatnonzero(np.diff(padded) == 1), np.flatnonzero(np.diff(padded) == -1) - 1
    return list(zip(starts.tolist(), ends.tolist(), strict=True))


def _pen(k: int) -> Pen:
    return CURVES[k % len(CURVES)]._replace(dashes=())


def _names(result: RegionMap) -> list[tuple[str, Pen]]:
    flat = len(result.parameters) == 1
    names = [(name, CURVES[k % len(CURVES)] if flat else _pen(k)) for k, name in enumerate(result.names)]
    places = zip(result.parameters, result.at(result.best), strict=True)
    at = "; ".join(number(each.values[k], 5) for each, k in places)
    point = tr("best point ({at})", at=at) if result.feasible.any() else tr("nearest point ({at})", at=at)
    names += [(tr("the rule holds"), HOLDS), (point if flat else tr("{point}: circle", point=point), BEST)]
    return names if result.solved.all() else [*names, (tr("no solution: crosses"), BARRED)]
