"""How far shapes reach on paper, and drawings without the blank over and under them."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.shapes import Arc, Dimension, Drawing, Hatching, Shape, Words
from tmmcalc.report.drawing.wording import corners

MARGIN, BLANK = 1.0, 5.0  # over and under what is drawn, and between two parts of it [mm]


def reach(shape: Shape) -> Box:
    """The smallest upright rectangle around a shape, whose lines are taken as thin.

    >>> from tmmcalc.report.drawing.pens import THIN
    >>> reach(Arc(1j, 2.0, THIN, 0.0, math.pi))
    Box(left=-2.0, bottom=1.0, right=2.0, top=3.0)
    """
    if isinstance(shape, Dimension):
        return around(map(reach, shape.parts()))
    z = corners(shape) if isinstance(shape, Words) else _extremes(shape) if isinstance(shape, Arc) else shape.points
    return Box(float(z.real.min()), float(z.imag.min()), float(z.real.max()), float(z.imag.max()))


def around(boxes: Iterable[Box]) -> Box:
    """The smallest rectangle around others."""
    left, bottom, right, top = zip(*boxes, strict=True)
    return Box(min(left), min(bottom), max(right), max(top))


def _extremes(arc: Arc) -> Plane:
    """Ends of an arc, and where it turns round on its way."""
    if arc.whole:
        return arc.points
    quarters = np.arange(math.ceil(2 * arc.start / math.pi), math.floor(2 * arc.end / math.pi) + 1) * math.pi / 2
    angles = np.concatenate([[arc.start, arc.end], quarters])
    return np.asarray(arc.centre + arc.radius * np.exp(1j * angles))


def trimmed(drawing: Drawing, margin: float = MARGIN, blank: float = BLANK) -> Drawing:
    """The drawing on paper that is no higher than its shapes need, with a margin [mm].

    What stands over a blank band from side to side comes down until no more than ``blank`` mm are left of it.

    >>> from tmmcalc.report.drawing.pens import THIN
    >>> drawing = Drawing(40.0, 90.0, "two circles")
    >>> drawing.add(Arc(20 + 20j, 5.0, THIN), Arc(20 + 70j, 5.0, THIN))
    >>> trimmed(drawing).height  # a margin, a circle, 5 mm, a circle, a margin
    27.0
    """
    if not drawing.shapes:
        return drawing
    placed = sorted(((reach(shape), k) for k, shape in enumerate(drawing.shapes)), key=lambda each: each[0].bottom)
    down, high, falls = max(0.0, placed[0][0].bottom - margin), placed[0][0].top, [0.0] * len(placed)
    for box, k in placed:
        down += max(0.0, box.bottom - high - blank)
        high = max(high, box.top)
        falls[k] = down
    found = Drawing(drawing.width, math.ceil(10 * (min(drawing.height, high + margin) - down)) / 10, drawing.title)
    found.add(*(lowered(shape, fall) for shape, fall in zip(drawing.shapes, falls, strict=True)))
    return found


def lowered(shape: Shape, by: float) -> Shape:
    """The shape so much lower on the paper [mm]."""
    down = 1j * by
    match shape:
        case Arc():
            return shape._replace(centre=shape.centre - down)
        case Words():
            return shape._replace(at=shape.at - down)
        case Hatching():
            return shape._replace(loops=tuple(loop - down for loop in shape.loops))
        case Dimension(first, second, line):
            return shape._replace(first=first - down, second=second - down, line=line - down)
    return shape._replace(points=shape.points - down)
