"""The picture of the kinematics stage: scheme and diagrams; the vector polygons on a second sheet below."""

from __future__ import annotations

import math
from collections.abc import Sequence

from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.pictures.choice import check_positions, chosen
from tmmcalc.linkage.pictures.cycle import whole_cycle
from tmmcalc.linkage.pictures.diagrams import columns_of, draw_diagrams
from tmmcalc.linkage.pictures.scheme import draw_scheme
from tmmcalc.linkage.pictures.vectors import draw_notes, draw_polygon, scale_note
from tmmcalc.linkage.polygons import polygons
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.order import POLYGONS, POSITIONS, Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.numbers import number

NOTES = 26.0  # height of the notes beneath polygons [mm]


def figure(order: Order) -> Drawing:
    """The drawing of the stage: scheme and diagrams, and the polygons of a position that is asked for."""
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    result = order.results["kinematics"]
    rows, marked = order.rows(POSITIONS, result.labels), order.row(POLYGONS, result.labels)
    return kinematics_drawing(to_linkage(order.spec.linkage), result, rows, marked)


def kinematics_drawing(
    mechanism: Mechanism, result: Kinematics, positions: Sequence[int] | None, marked: int | None
) -> Drawing:
    """One sheet, or two with the polygons of the position ``marked``; raises `UsageError` for one that is not there."""
    check_positions(len(result.x), [*(positions or ()), *([] if marked is None else [marked])])
    drawing, boxes = sheets(1 if marked is None else 2)
    cycle = whole_cycle(chain_of(mechanism, result), result)
    columns = columns_of(result, cycle)
    widths = (1.35 if len(columns) < 2 else 1.5, *(1.0 for _ in columns))
    scheme, *others = boxes[0].split(*widths, gap=3.0, across=True)
    for box, curves in zip(others, columns, strict=True):
        draw_diagrams(drawing, box, result, cycle, curves)
    draw_scheme(drawing, scheme, result, cycle, chosen(cycle, result, positions, marked))
    if marked is not None:
        _polygons(drawing, boxes[1], mechanism, result, marked)
    return drawing


def _polygons(drawing: Drawing, box: Box, mechanism: Mechanism, result: Kinematics, marked: int) -> None:
    vectors = polygons(mechanism, result, marked)
    where = f"Position {result.labels[marked]}"
    if result.turns:
        where += f", $φ$ = {minus(number(math.degrees(result.phi[marked]), 5))}°"
    drawing.add(Words(complex(box.middle.real, box.top), where, 3.5, 1j))
    upper, notes = box.inset(0, 0, 0, 6).split(box.height - 6 - NOTES, NOTES)
    for half, letter, polygon in zip(
        upper.split(1, 1, gap=4, across=True), "va", (vectors.velocity, vectors.acceleration), strict=True
    ):
        board = draw_polygon(drawing, half.inset(0, 0, 0, 6), polygon, vectors.fixed)
        name = "Velocity polygon" if letter == "v" else "Acceleration polygon"
        title = f"{name},  {scale_note(letter, board.mu)}"
        drawing.add(Words(complex(half.middle.real, half.top), title, 3.0, 1j))
    draw_notes(drawing, notes, vectors)
