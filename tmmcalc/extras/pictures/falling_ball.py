"""The picture of the falling ball: speed and way over the time."""

from __future__ import annotations

from tmmcalc.extras.falling_ball import Ball
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.panels import Panel, marked, panels
from tmmcalc.report.drawing.shapes import Drawing


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return ball_drawing(order.results["falling_ball"])


def ball_drawing(result: Ball) -> Drawing:
    """Speed and way over the time; maximum and stop are marked."""
    drawing, box = titled("Fall of the ball")
    rows = [Panel("$v$, m/s", (("speed", result.v),)), Panel("$S$, m", (("way", result.way),), 1)]
    found = panels(drawing, box, result.t, "$t$, s", rows)
    marked(found, [each.t for each in (result.fastest, result.stop) if each is not None])
    return drawing
