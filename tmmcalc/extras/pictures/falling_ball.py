"""The picture of the falling ball: speed and way over the time."""

from __future__ import annotations

from matplotlib.figure import Figure

from tmmcalc.extras.falling_ball import Ball
from tmmcalc.report.drawing.axes import diagram, marked
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return ball_figure(order.results["falling_ball"])


def ball_figure(result: Ball) -> Figure:
    """Speed and way over the time; maximum and stop are marked."""
    figure, (sheet,) = blank(1)
    sheet.suptitle("Fall of the ball", fontsize=10)
    upper, lower = sheet.subplots(2, 1, sharex=True)
    diagram(upper, result.t, [("v", result.v)], "v, m/s")
    diagram(lower, result.t, [("S", result.way)], "S, m", first=1)
    for axes in (upper, lower):
        marked(axes, [each.t for each in (result.fastest, result.stop) if each is not None])
    lower.set_xlabel("$t$, s")
    settle(figure)
    return figure
