"""Clouds of points in diagrams, and the key of their signs.

More points than can be told apart are thinned evenly, and the key says so: thousands of signs make a file large and
nothing clearer.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.plane import Plane, Real
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import SIGNS, Axis, Diagram
from tmmcalc.report.drawing.lettering import width
from tmmcalc.report.drawing.pens import Pen
from tmmcalc.report.drawing.shapes import Arc, Area, Drawing, Words

MANY = 3000  # signs of a cloud that are drawn at most
WIDE = 30.0  # a larger relation of the largest to the least value takes a logarithmic axis
EDGE = 0.06  # room beyond the values on both sides, in parts of their range
KEY = 2.4  # height of the names in a key [mm]
ROW, BEFORE, LINE, AIR = 4.4, 1.6, 8.0, 5.0  # of a key: row, room before a name, length of a line, between names [mm]


class Mark(NamedTuple):
    """The sign of a kind of points; its pen is that of the outline."""

    kind: str  # one of `diagram.SIGNS`
    pen: Pen
    size: float  # width [mm]
    fill: str = ""  # colour inside; empty: open, so that what lies beneath is seen


def evenly(count: int, most: int = MANY) -> NDArray[np.intp]:
    """The places of ``most`` of so many points at most, spread evenly from the first to the last.

    >>> evenly(3).tolist(), evenly(10, 4).tolist()
    ([0, 1, 2], [0, 3, 6, 9])
    """
    return np.unique(np.linspace(0, count - 1, min(count, most)).round().astype(np.intp))


def shares(counts: Sequence[int], most: int = MANY) -> list[int]:
    """How many points of each of several clouds are drawn: of small ones all, the others share what is left.

    >>> shares([15, 9000, 3]), shares([4000, 5000])
    ([15, 2982, 3], [1500, 1500])
    """
    found, left = [0] * len(counts), most
    for done, k in enumerate(sorted(range(len(counts)), key=lambda k: counts[k])):
        found[k] = min(counts[k], left // (len(counts) - done))
        left -= found[k]
    return found


def draw_marks(field: Diagram, z: Plane, mark: Mark, weight: float = 1.0, fills: Sequence[str] = ()) -> None:
    """The same sign at every datum, in ``fills`` each with a colour of its own; names keep clear by ``weight``.

    Of a filled sign they keep clear of its middle, of an open one of its outline.
    """
    points = field.paper(z)
    for k, at in enumerate(points.tolist()):
        draw_mark(field.drawing, at, mark._replace(fill=fills[k]) if fills else mark)
        if not (mark.fill or fills):
            field.labels.avoid(at + mark.size / 2 * SIGNS[mark.kind], weight)
    if mark.fill or fills:
        field.labels.avoid_points(points, weight)


def draw_mark(drawing: Drawing, at: complex, mark: Mark) -> None:
    """A sign at a place on paper."""
    corners = at + mark.size / 2 * SIGNS[mark.kind]
    if mark.kind == "o":
        drawing.add(Arc(at, mark.size / 2, mark.pen, fill=mark.fill), level=6)
    elif mark.fill:
        drawing.add(Area(corners, mark.fill, mark.pen), level=6)
    else:
        drawing.line(corners, mark.pen, closed=True, level=6)


def key_rows(box: Box, names: Sequence[tuple[str, Mark | Pen]]) -> list[list[tuple[str, Mark | Pen]]]:
    """The names in rows that fit the width of a rectangle."""
    rows: list[list[tuple[str, Mark | Pen]]] = []
    at = np.inf
    for text, look in names:
        wide = _room(text, look)
        if at + wide - AIR > box.width:
            rows.append([])
            at = 0.0
        rows[-1].append((text, look))
        at += wide
    return rows


def write_key(drawing: Drawing, box: Box, names: Sequence[tuple[str, Mark | Pen]]) -> float:
    """Signs and lines with their names in rows, from the upper left corner of a rectangle; where the rows end."""
    rows = key_rows(box, names)
    for k, row in enumerate(rows):
        at = complex(box.left, box.top - (k + 0.5) * ROW)
        for text, look in row:
            if isinstance(look, Pen):
                drawing.line([at, at + LINE], look)
            else:
                draw_mark(drawing, at + look.size / 2, look)
            drawing.add(Words(at + _sample(look) + BEFORE, text, KEY, -1))
            at += _room(text, look)
    return box.top - len(rows) * ROW


def _sample(look: Mark | Pen) -> float:
    return LINE if isinstance(look, Pen) else look.size


def _room(text: str, look: Mark | Pen) -> float:
    return _sample(look) + BEFORE + width(text, KEY) + AIR


def fitted(name: str, values: Real) -> Axis:
    """An axis with room around all values, logarithmic where they differ by far."""
    low, high = float(values.min()), float(values.max())
    if low > 0 and high > WIDE * low:
        air = (high / low) ** EDGE
        return Axis(name, low / air, high * air, log=True)
    air = EDGE * ((high - low) or abs(high) or 1.0)
    return Axis(name, low - air, high + air)
