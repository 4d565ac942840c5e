"""The picture of the falling ball: speed and way over the time."""

from __future__ import annotations

from tmmcalc.extras.falling_ball import Ball
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.panels import Panel, marked, panels
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr, tr_unit


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return ball_drawing(order.results["falling_ball"])


def ball_drawing(result: Ball) -> Drawing:
    """The diagrams under a title."""
    drawing, box = titled(tr("Fall of the ball"))
    draw_ball(drawing, box, result)
    return drawing


def draw_ball(drawing: Drawing, box: Box, result: Ball) -> None:
    """Speed and way over the time; maximum and stop are marked."""
    rows = [
        Panel(f"$v$, {tr_unit('m/s')}", ((tr("speed"), result.v),)),
        Panel(f"$S$, {tr_unit('m')}", ((tr("way"), result.way),), 1),
    ]
    found = panels(drawing, box, result.t, f"$t$, {tr_unit('s')}", rows)
    marked(found, [each.t for each in (result.fastest, result.stop) if each is not None])
