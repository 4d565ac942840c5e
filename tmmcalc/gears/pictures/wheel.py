"""The sheet of a wheel without a mate: how its tool cuts a space, half a tooth enlarged."""

from __future__ import annotations

from tmmcalc.gears.meshing.halftooth import half_tooth
from tmmcalc.gears.pictures.profile import draw_sheet
from tmmcalc.gears.single.member import SingleMember
from tmmcalc.gears.single.results import SingleWheel
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.shapes import Drawing


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return wheel_drawing(order.results["wheel"])


def wheel_drawing(found: SingleWheel) -> Drawing:
    """One sheet; raises `NoSolutionError` if the wheel has no profile."""
    member = SingleMember(found.task)
    half_tooth(member)
    drawing, (box,) = sheets(1, "A wheel by itself")
    draw_sheet(drawing, box, member)
    return drawing
