"""Pieces that stand for real ones: a rectangle that fills its room, with the name of the piece in it."""

from __future__ import annotations

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.pens import THICK
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.sheets.piece import Piece


def toy(
    name: str, good: tuple[float, float], least: tuple[float, float] = (20.0, 20.0), sheet: str = "linkage"
) -> Piece:
    """A piece of this heading."""

    def draw(drawing: Drawing, box: Box) -> None:
        drawing.line(box.corners, THICK, closed=True)
        drawing.add(Words(box.middle, f"in {name}", 3.5))

    return Piece(sheet, name, draw, least, good)
