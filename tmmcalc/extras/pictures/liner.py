"""The picture of the liner: deflection, moment and stresses along the bore."""

from __future__ import annotations

from tmmcalc.extras.liner import Liner
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.panels import Panel, marked, panels
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return liner_drawing(order.results["liner"])


def liner_drawing(result: Liner) -> Drawing:
    """The diagrams under a title."""
    peak = result.largest
    values = {"stress": number(1e-6 * peak.stress, 5), "x": number(1e3 * peak.x, 5)}
    drawing, box = titled(
        tr("Cylinder liner, largest equivalent stress {stress} MPa at $x$ = {x} mm, inner surface", **values)
        if peak.surface == "inner"
        else tr("Cylinder liner, largest equivalent stress {stress} MPa at $x$ = {x} mm, outer surface", **values)
    )
    draw_liner(drawing, box, result)
    return drawing


def draw_liner(drawing: Drawing, box: Box, result: Liner) -> None:
    """Deflection, moment and stresses along the bore; the place of the largest equivalent stress is marked."""
    stresses = (
        (tr("bending, inner surface"), 1e-6 * result.axial),
        (tr("hoop, mean"), 1e-6 * result.hoop),
        (tr("equivalent, inner"), 1e-6 * result.inner),
        (tr("equivalent, outer"), 1e-6 * result.outer),
    )
    rows = [
        Panel(tr("$w$, µm"), ((tr("deflection outwards"), 1e6 * result.w),)),
        Panel(f"$M$, {tr_unit('N*m/m')}", ((tr("moment of bending"), result.bend),), 1),
        Panel(tr("stress, MPa"), stresses),
    ]
    marked(panels(drawing, box, 1e3 * result.x, tr("$x$ from the ring, mm"), rows), [1e3 * result.largest.x])
