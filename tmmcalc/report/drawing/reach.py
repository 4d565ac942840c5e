"""How far shapes reach on paper, and drawings without the blank over and under them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.shapes import Arc, Dimension, Drawing, Hatching, Shape, Words
from tmmcalc.report.drawing.wording import corners

BLANK = 6.0  # height of a strip without anything that is left [mm]


def reach(shape: Shape) -> Box:
    """The smallest upright rectangle around a shape, whose lines are taken as thin.

    >>> from tmmcalc.report.drawing.pens import THIN
    >>> reach(Arc(1j, 2.0, THIN, 0.0, math.pi))
    Box(left=-2.0, bottom=1.0, right=2.0, top=3.0)
    """
    if isinstance(shape, Dimension):
        return around(map(reach, shape.parts()))
    if isinstance(shape, Arc) and shape.whole:
        at, r = shape.centre, shape.radius
        return Box(at.real - r, at.imag - r, at.real + r, at.imag + r)
    z = corners(shape) if isinstance(shape, Words) else _extremes(shape) if isinstance(shape, Arc) else shape.points
    return Box(float(z.real.min()), float(z.imag.min()), float(z.real.max()), float(z.imag.max()))


def around(boxes: Iterable[Box]) -> Box:
    """The smallest rectangle around others."""
    left, bottom, right, top = zip(*boxes, strict=True)
    return Box(min(left), min(bottom), max(right), max(top))


def _extremes(arc: Arc) -> Plane:
    """Ends of an arc that is no whole circle, and where it turns round on its way."""
    quarters = np.arange(math.ceil(2 * arc.start / math.pi), math.floor(2 * arc.end / math.pi) + 1) * math.pi / 2
    angles = np.concatenate([[arc.start, arc.end], quarters])
    return np.asarray(arc.centre + arc.radius * np.exp(1j * angles))


def trimmed(drawing: Drawing, margin: float = 1.0) -> Drawing:
    """The drawing on paper that is no higher than its shapes need, with a margin [mm], and as large as they reach.

    Words above or below all else stand no farther from it than `BLANK`.
    """
    if not drawing.shapes:
        return drawing
    boxes = [*map(reach, drawing.shapes)]
    box = around(boxes)
    low = min(max(0.0, box.bottom - margin), box.bottom)
    high = max(min(drawing.height, box.top + margin), box.top)
    strips = _blank(drawing.shapes, boxes)
    left, right = min(0.0, box.left), max(drawing.width, box.right)
    wide, tall = (math.ceil(10 * each) / 10 for each in (right - left, high - low - sum(strips.values())))
    found = Drawing(wide, tall, drawing.title)
    for shape, own in zip(drawing.shapes, boxes, strict=True):
        down = low + sum(size for place, size in strips.items() if own.bottom >= place)
        found.add(moved(shape, complex(-left, -down)))
    return found


def _blank(shapes: Sequence[Shape], boxes: Sequence[Box]) -> dict[float, float]:
    """Blank strips between words and all else: where what is above them begins, and how much they are too high [mm]."""
    other = [box for shape, box in zip(shapes, boxes, strict=True) if not isinstance(shape, Words)]
    if not other:
        return {}
    body = around(other)
    found, reached = {}, math.inf
    for box in sorted(boxes, key=lambda each: each.bottom):
        beside = reached < body.bottom or body.top <= reached < math.inf
        if beside and box.bottom - reached > BLANK:
            found[box.bottom] = box.bottom - reached - BLANK
        reached = box.top if math.isinf(reached) else max(reached, box.top)
    return found


def moved(shape: Shape, by: complex) -> Shape:
    """The shape so far away on the paper [mm]."""
    match shape:
        case Arc():
            return shape._replace(centre=shape.centre + by)
        case Words():
            return shape._replace(at=shape.at + by)
        case Hatching():
            return shape._replace(loops=tuple(loop + by for loop in shape.loops))
        case Dimension(first, second, line):
            return shape._replace(first=first + by, second=second + by, line=line + by)
    return shape._replace(points=shape.points + by)
