"""The look of a blocking contour: areas, borders, points, and numbers in circles."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.meshing.contours import ContourPoint
from tmmcalc.report.drawing.pens import INK, MARK, WHITE, Pen
from tmmcalc.report.drawing.shapes import Arc, Area, Shape, Words
from tmmcalc.report.language import tr_name

RING = 1.9  # radius of the circle around a number [mm]
NUMBER = 1.8  # height of the number
DOTS = {"chosen": 1.05, "corner": 0.75, "other": 0.95}  # radii of points [mm]
OUTLINE = Pen("POINTS", 0.25)
JOINT = " = "


@record
class Look:
    """How a region is filled and bordered."""

    fill: str
    border: Pen


STRICT = Look("#dfeaf4", Pen("STRICT_CONTOUR", 0.7))
BELT = Look("#faf6ec", Pen("TOLERATED_CONTOUR", 0.32))
PALE = Look("#eff3f7", Pen("PIECES", 0.32, (), "#7d8891"))
HATCHED = Pen("TOLERATED_HATCH", 0.18, (), "#8c8468")


def ring(at: complex, text: str, colour: str, part: float = 1.0) -> list[Shape]:
    """A number in a circle at a place on paper; ``part`` is its size."""
    around = Pen("NUMBERS", 0.25, (), colour)
    size = NUMBER * (1.0 if len(text) < 3 else 0.85)
    return [Arc(at, part * RING, around, fill=WHITE), Words(at, text, part * size)]


def marker(point: ContourPoint, at: complex) -> Shape:
    """The sign of a point at a place on paper: the chosen one, C, D, E, and the others."""
    if point.name == "chosen":
        return Arc(at, DOTS["chosen"], OUTLINE, fill=MARK.colour)
    if len(point.name) == 1:
        return Arc(at, DOTS["corner"], OUTLINE, fill=INK)
    return Area(at + DOTS["other"] * np.array([1, 1j, -1, -1j]), WHITE, OUTLINE)


def together(points: Sequence[ContourPoint], near: float) -> list[tuple[ContourPoint, str]]:
    """Points with their names; those that lie on an earlier one only add their name to its."""
    found: list[tuple[ContourPoint, str]] = []
    for point in points:
        for k, (other, name) in enumerate(found):
            if abs(complex(point.x1 - other.x1, point.x2 - other.x2)) < near:
                found[k] = other, f"{name}{JOINT}{tr_name(point.name)}"
                break
        else:
            found.append((point, tr_name(point.name)))
    return found
