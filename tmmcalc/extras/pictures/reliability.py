"""The picture of the reliability: its course over the time, the density of failures below it."""

from __future__ import annotations

from tmmcalc.extras.reliability import Reliability
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.panels import Panel, marked, panels
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr
from tmmcalc.report.numbers import number


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return reliability_drawing(order.results["reliability"])


def reliability_drawing(result: Reliability) -> Drawing:
    """The diagrams under a title."""
    drawing, box = titled(tr("Reliability, mean life {life}", life=number(result.mean, 6)))
    draw_reliability(drawing, box, result)
    return drawing


def draw_reliability(drawing: Drawing, box: Box, result: Reliability) -> None:
    """Reliability, and the density of failures below it; the mean life is marked."""
    rows = [
        Panel("$R$", ((tr("reliability"), result.kept),)),
        Panel(tr("1/unit of time"), ((tr("density $f$"), result.density), (tr("intensity"), result.intensity)), 1),
    ]
    marked(panels(drawing, box, result.t, "$t$", rows), [result.threshold, result.mean])
