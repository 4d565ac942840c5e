"""The sheet of a wheel without a mate: how its tool cuts a space, half a tooth enlarged."""

from __future__ import annotations

from matplotlib.figure import Figure

from tmmcalc.gears.meshing.halftooth import half_tooth
from tmmcalc.gears.pictures.profile import draw_sheet
from tmmcalc.gears.single.member import SingleMember
from tmmcalc.gears.single.results import SingleWheel
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return wheel_figure(order.results["wheel"])


def wheel_figure(found: SingleWheel) -> Figure:
    """One sheet; raises `NoSolutionError` if the wheel has no profile."""
    member = SingleMember(found.task)
    half_tooth(member)
    figure, (sheet,) = blank(1)
    draw = draw_sheet(sheet, member)
    settle(figure)
    draw()
    return figure
