"""What is drawn on paper, read back in the units of the data."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Diagram
from tmmcalc.report.drawing.field import Field
from tmmcalc.report.drawing.pens import GRID, MIDDLE, THIN, Pen
from tmmcalc.report.drawing.shapes import Arc, Drawing, Stroke, Words
from tmmcalc.report.drawing.wording import corners

OF_THE_FRAME = (GRID, THIN, MIDDLE)
NEAR = 1e-6  # mm


def diagram(drawing: Drawing, name: str) -> Diagram:
    """The one diagram with an axis of this name."""
    (found,) = [each for each in drawing.fields if isinstance(each, Diagram) and name in (each.x.name, each.y.name)]
    return found


def inside(z: Plane, box: Box) -> bool:
    """Whether places on paper lie in a rectangle."""
    wide = (z.real > box.left - NEAR) & (z.real < box.right + NEAR)
    return bool(np.all(wide & (z.imag > box.bottom - NEAR) & (z.imag < box.top + NEAR)))


def curves(field: Field, pen: Pen | None = None) -> list[Plane]:
    """Polylines in a field as data (n,), of a pen, or all but frame and grid, in the order in which they are drawn."""
    strokes = [shape for shape in field.drawing.shapes if isinstance(shape, Stroke) and inside(shape.points, field.box)]
    seen = [each for each in strokes if each.pen == pen or (pen is None and each.pen not in OF_THE_FRAME)]
    return [data(field, each.points) for each in seen]


def arcs(field: Field, pen: Pen | None = None) -> list[tuple[complex, float]]:
    """Centres and radii, as data, of circles and arcs in a field, of a pen or all."""
    shapes = [shape for shape in field.drawing.shapes if isinstance(shape, Arc) and inside(shape.points, field.box)]
    unit = abs(field.data(1.0) - field.data(0.0))
    return [(field.data(each.centre), each.radius * unit) for each in shapes if pen in (None, each.pen)]


def covered(drawing: Drawing, slack: float = 0.2) -> list[tuple[str, str]]:
    """Pairs of words of which one covers the other by more than so many mm in both directions."""
    boxes = [(words.text, corners(words)) for words in of_words(drawing) if words.text.strip()]
    found = []
    for k, (one, a) in enumerate(boxes):
        for other, b in boxes[k + 1 :]:
            over = [min(f(a).max(), f(b).max()) - max(f(a).min(), f(b).min()) for f in (np.real, np.imag)]
            if min(over) > slack:
                found.append((one, other))
    return found


def frames(drawing: Drawing) -> list[Field]:
    """Boards and diagrams in the order in which they were made."""
    return drawing.fields


def data(field: Field, places: Plane) -> Plane:
    """Places on paper as data."""
    return np.array([field.data(complex(at)) for at in places])


def written(drawing: Drawing, box: Box | None = None) -> list[str]:
    """All words, or those that stand in a rectangle, in the order in which they are drawn."""
    return [words.text for words in of_words(drawing) if box is None or inside(np.array([words.at]), box)]


def of_words(drawing: Drawing) -> Iterator[Words]:
    """All words."""
    return (shape for shape in drawing.shapes if isinstance(shape, Words))


def on_sheet(drawing: Drawing) -> list[str]:
    """What reaches over the edge of the paper: words, and points of other shapes."""
    page = Box(0.0, 0.0, drawing.width, drawing.height)
    found = [words.text for words in of_words(drawing) if not inside(corners(words), page)]
    others = [shape for shape in drawing.shapes if not isinstance(shape, Words)]
    return found + [type(shape).__name__ for shape in others if not inside(shape.points, page)]


def named_place(drawing: Drawing, words: Words) -> complex:
    """The place on paper that a name belongs to: where its leader comes from, without one its own."""
    box = corners(words)
    low, high = complex(box.real.min(), box.imag.min()), complex(box.real.max(), box.imag.max())
    for shape in drawing.shapes:
        if isinstance(shape, Stroke) and shape.pen == THIN and len(shape.points) == 2:
            start, end = map(complex, shape.points)
            beyond = [low.real - end.real, end.real - high.real, low.imag - end.imag, end.imag - high.imag]
            along = abs(((words.at - end) / (end - start)).imag) < NEAR
            if abs(max(beyond)) < 0.35 and (along or sorted(map(abs, beyond))[1] < 0.35):  # at a side, or a corner
                return start - 0.15 / 0.85 * (end - start)
    return words.at
