"""A tooth by the textbook's points: coordinates of the involute and the fillet (4.77 to 4.95) beside the exact outline.

The axes are those of the tooth: origin on the base circle, Y along the tooth from the centre of the wheel. The fillet
of an external wheel is the envelope of the circles of the rack's rounding about S; of a wide rounding across helical
teeth the circle stands for the ellipse, and the exact outline lies beside the points.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.meshing.booktables import CENTRE, CUT, MAIN, RADIUS, ROLL, BookTable, BookTables, X, Y
from tmmcalc.gears.meshing.halftooth import half_tooth
from tmmcalc.gears.meshing.members import Toothed
from tmmcalc.gears.pictures.toothdrawing import CENTRE_PATH, OUTLINE, WheelDrawing, runs_of
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.key import samples_in_rows
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.pens import MARK, THIN, Pen
from tmmcalc.report.drawing.scales import scale_text
from tmmcalc.report.drawing.shapes import Arc, Drawing, Words
from tmmcalc.report.drawing.tables import draw_table
from tmmcalc.report.language import tr, tr_number, tr_unit

Row = tuple[str, complex, float | None, float, complex | None]
INTERVALS = 6  # equal steps of each curve
TABLE = 0.42  # part of the width that the table takes at most
MARGIN, FOOT = 6.0, 12.0  # free border, and room of the key under the drawing [mm]
DOT, NAME = 0.8, 2.6  # radius of a point and height of its number [mm]
APART = 2.4  # a point nearer than this to one with a number goes without [mm]
LETTERS = 3.5  # height of the letters of the table at most [mm]
THROUGH = Pen("TEXTBOOK_POINTS", 0.5, (2.4, 0.8), MARK.colour)
ROUNDING = Pen("ROUNDINGS", 0.18, (), "#5b87a6")
AXES = Pen("AXES", 0.25, (6.0, 1.5, 1.0, 1.5))


@record
class TextbookPoint:
    """A numbered point of the profile; lengths in metres."""

    number: str  # with the letter of a notable one
    at: complex  # X + i Y from the centre of the wheel
    roll: float | None  # phi [rad]; None: of an arc that nothing rolls
    radius: float  # of curvature
    centre: complex | None  # S of the rounding that cuts it; None: of the involute, or of a ring


def textbook_points(tables: BookTables) -> list[TextbookPoint]:
    """The points from the tip down the involute, then along the fillet to the root; the one in common once."""
    base = 1j * abs(tables.member.wheel.base) * tables.member.module
    main = [*_rows(tables.main, MAIN, base)]
    fillet = sorted(_rows(tables.fillet, "", base), key=lambda row: -abs(row[1]) * _outward(tables))
    joined = [row for row in fillet if abs(row[1] - main[-1][1]) > 1e-9 * tables.member.module]
    found = []
    for k, (letter, at, roll, radius, centre) in enumerate([*main, *joined], 1):
        found.append(TextbookPoint(f"{k}{letter}", at, roll, radius, centre))
    return found


def _outward(tables: BookTables) -> int:
    return -1 if tables.member.shape == "ring" else 1


def _rows(table: BookTable, of: str, base: complex) -> Iterator[Row]:
    """Letter, place, roll, radius and centre of the rounding of every point of a table."""
    keys = (X.of(of=of).key, Y.of(of=of).key, RADIUS.of(of=of).key)
    assert of or keys == CUT
    centres = X.of(of=CENTRE).key, Y.of(of=CENTRE).key
    rolled = bool(np.any(table.columns[ROLL.key]))
    for k, letter in enumerate(table.points):
        if not table.cut[k]:
            continue
        x, y, radius, roll = (float(table.columns[key][k]) for key in (*keys, ROLL.key))
        centre = None
        if not of and centres[0] in table.columns:
            centre = complex(*(float(table.columns[key][k]) for key in centres)) + base
        yield f" ({letter})" if letter else "", complex(x, y) + base, roll if rolled else None, radius, centre


def draw_tooth_points(drawing: Drawing, box: Box, tables: BookTables) -> Board:
    """The tooth with its numbered points, at its right their table."""
    points = textbook_points(tables)
    left = Box(box.left, box.bottom, box.left + (1 - TABLE) * box.width, box.top)
    board = draw_tooth(drawing, left, tables)
    base = abs(tables.member.wheel.base) * tables.member.module
    table = Box(left.right + MARGIN, box.bottom, box.right, box.top)
    head = tr("Point"), "$φ$, °", *(f"${name}$, {tr_unit('mm')}" for name in "XYR")
    rows = [
        (
            each.number,
            "" if each.roll is None else _fixed(degrees(each.roll), 3),
            *(_fixed(1e3 * value, 4) for value in (each.at.real, each.at.imag - base, each.radius)),
        )
        for each in points
    ]
    below = table.top - draw_table(drawing, table.inset(0, 3 * NAME, 0, 0), head, rows, LETTERS)
    drawing.add(Words(complex(table.left, below - 2.0), scale_text(board.mu), NAME, -1 + 1j))
    return board


def draw_tooth(drawing: Drawing, box: Box, tables: BookTables) -> Board:
    """The tooth with its numbered points, under it what the lines are."""
    points = textbook_points(tables)
    picture = _Points(drawing, box.inset(0, FOOT, 0, 0), tables.member, points, tables)
    samples = [(tr("exact outline"), OUTLINE), (tr("through the textbook's points"), THROUGH)]
    if any(each.centre is not None for each in points):
        samples.append((tr("rounding of the rack about $S$"), ROUNDING))
    samples_in_rows(drawing, Box(box.left, box.bottom, box.right, box.bottom + FOOT - 2), samples)
    return picture.board


class _Points(WheelDrawing):
    """The whole tooth, exact, and the points of its left flank."""

    def __init__(
        self, drawing: Drawing, box: Box, member: Toothed, points: list[TextbookPoint], tables: BookTables
    ) -> None:
        half = half_tooth(member)
        outline = np.concatenate([*runs_of(member, half).values()])
        whole = np.concatenate([outline, -np.conj(outline[::-1])])
        base = 1j * abs(member.wheel.base) * member.module
        super().__init__(drawing, box, member, np.concatenate([whole, [base]]), MARGIN)
        self.circles(half)
        board = self.board
        board.line(whole, OUTLINE, level=7)
        self.axis(np.concatenate([whole, [base]]))
        reach = 0.9 * float(np.max(np.abs(whole.real)))
        board.line([base - reach, base + reach], AXES, weight=0.4, level=5)
        board.line([each.at for each in points], THROUGH, weight=0.8, level=8)
        for each in points:
            if each.centre is not None:
                size = tables.radius
                board.arc(each.centre, size, ROUNDING, weight=0.1, level=4)
                board.dot(each.centre, 0.4, colour=CENTRE_PATH.colour, level=6)
        for each in points:
            at = board.place(each.at)
            drawing.add(Arc(at, DOT, THIN, fill="#ffffff"), level=12)
            board.labels.avoid([at], 3.0)
        board.labels.put("$Ω$", [board.place(base)], height=NAME, prefer=1 + 1j)
        board.labels.put("$Y$", [board.place(1j * float(whole.imag.max()) + 4j * board.mu)], height=NAME)
        board.labels.put("$X$", [board.place(base + reach)], height=NAME, prefer=1 + 0j)
        named: list[complex] = []
        for each in (points[0], points[-1], *points[1:-1]):
            at = board.place(each.at)
            if all(abs(at - other) > APART for other in named):
                named.append(at)
                board.name(each.number.partition(" ")[0], [each.at], height=NAME, prefer=-1 + 0j)


def _fixed(value: float, places: int) -> str:
    return tr_number(minus(f"{round(value, places) + 0.0:.{places}f}"))
