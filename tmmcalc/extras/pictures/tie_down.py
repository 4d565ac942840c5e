"""The picture of the tie-down: forces of the ties over the inertia, and where they slip, slacken and yield."""

from __future__ import annotations

import math

from tmmcalc.extras.tie_down import TieDown
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.panels import PLACE, Panel, panels
from tmmcalc.report.drawing.pens import AXIS, MARK
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr
from tmmcalc.report.numbers import number


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return tie_down_drawing(order.results["tie_down"])


def tie_down_drawing(result: TieDown) -> Drawing:
    """The diagram under a title."""
    drawing, box = titled(tr("Forces of the ties of a load"))
    draw_tie_down(drawing, box, result)
    return drawing


def draw_tie_down(drawing: Drawing, box: Box, result: TieDown) -> None:
    """Forces of a stretched and an opposite tie over k; thresholds by equilibrium are named, the load is a point."""
    lines = (
        (tr("$R$, approximate"), 1e-3 * result.forces),
        (tr("$R$ by equilibrium"), 1e-3 * result.balance),
        (tr("opposite tie by equilibrium"), 1e-3 * result.slackening),
    )
    rows = [Panel(tr("force of a tie, kN"), lines)]
    (field,) = panels(drawing, box, result.k, tr("inertia force over weight, $k$"), rows)
    at = result.thresholds
    for name, k in (
        (tr("slips"), at.slip),
        (tr("slack"), at.slack),
        (tr("yields"), at.yielding),
        (tr("tips"), at.tipping),
    ):
        if k is not None and 0 < k <= result.k[-1]:
            field.vertical(k, PLACE)
            place = complex(field.place(complex(k, 0.0)).real - 0.8, field.box.top - 1.5)
            words = Words(place, f"{name}, $k$ = {number(k, 4)}", 2.3, 1 - 1j, math.pi / 2, clear=True)
            drawing.add(words, level=8)
    if result.preload:
        field.level(1e-3 * result.preload, AXIS, "$P_0$")
        field.level(2e-3 * result.preload, AXIS, "$2 P_0$")
    field.point(complex(result.factor, 1e-3 * result.balanced), MARK, 0.9, MARK.colour)
