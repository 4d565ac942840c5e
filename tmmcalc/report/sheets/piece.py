"""What stands on a sheet: one picture with its heading, and the room that it needs."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from tmmcalc.report.drawing.box import Box
    from tmmcalc.report.drawing.shapes import Drawing

SHEETS = ("linkage", "forces", "gears", "cam")  # in their order


class Piece(NamedTuple):
    """One picture of a sheet; the layout writes the heading and gives a rectangle under it.

    ``draw(drawing, box)`` fills the rectangle, to a standard scale where the picture has one. It is not called with
    less than ``least``; ``good`` is the size at which all of it is easily read on A1, and its proportions.
    """

    sheet: str  # one of SHEETS
    heading: str  # in the language in force; its scale factor is written by what is drawn
    draw: Callable[[Drawing, Box], object]
    least: tuple[float, float]  # width and height without which it cannot be read [mm]
    good: tuple[float, float]
