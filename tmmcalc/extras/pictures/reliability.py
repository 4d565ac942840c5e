"""The picture of the reliability: its course over the time, the density of failures below it."""

from __future__ import annotations

from matplotlib.figure import Figure

from tmmcalc.extras.reliability import Reliability
from tmmcalc.report.drawing.axes import diagram, marked
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.numbers import number


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return reliability_figure(order.results["reliability"])


def reliability_figure(result: Reliability) -> Figure:
    """Reliability, and the density of failures below it; the mean life is marked."""
    figure, (sheet,) = blank(1)
    sheet.suptitle(f"Reliability, mean life {number(result.mean, 6)}", fontsize=10)
    upper, lower = sheet.subplots(2, 1, sharex=True)
    diagram(upper, result.t, [("R", result.kept)], "R")
    diagram(lower, result.t, [("f", result.density), ("intensity", result.intensity)], "1/unit of time", first=1)
    for axes in (upper, lower):
        marked(axes, [result.threshold, result.mean])
    lower.set_xlabel("$t$")
    settle(figure)
    return figure
