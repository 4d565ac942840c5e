"""The sheet of a wheel without a mate: how its tool cuts a space, half a tooth enlarged."""

from __future__ import annotations

from tmmcalc.gears.meshing.booktables import book_tables
from tmmcalc.gears.meshing.halftooth import half_tooth
from tmmcalc.gears.pictures.profile import draw_points, draw_sheet
from tmmcalc.gears.pictures.toothpoints import INTERVALS
from tmmcalc.gears.single.member import SingleMember
from tmmcalc.gears.single.results import SingleWheel
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return wheel_drawing(order.results["wheel"])


def wheel_drawing(found: SingleWheel) -> Drawing:
    """Two sheets, what cuts it and its points; raises `NoSolutionError` if the wheel has no profile."""
    member = SingleMember(found.task)
    half_tooth(member)
    tables = book_tables(member, "tooth", INTERVALS)
    assert tables is not None  # of a rack alone
    drawing, (first, second) = sheets(2, tr("A wheel by itself"))
    draw_sheet(drawing, first, member)
    draw_points(drawing, second, tables)
    return drawing
