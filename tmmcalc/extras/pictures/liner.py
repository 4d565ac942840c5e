"""The picture of the liner: deflection, moment and stresses along the bore."""

from __future__ import annotations

from tmmcalc.extras.liner import Liner
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.panels import Panel, marked, panels
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.numbers import number


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return liner_drawing(order.results["liner"])


def liner_drawing(result: Liner) -> Drawing:
    """Deflection, moment and stresses along the bore; the place of the largest equivalent stress is marked."""
    peak = result.largest
    told = f"{number(1e-6 * peak.stress, 5)} MPa at $x$ = {number(1e3 * peak.x, 5)} mm, {peak.surface} surface"
    drawing, box = titled(f"Cylinder liner, largest equivalent stress {told}")
    stresses = (
        ("bending, inner surface", 1e-6 * result.axial),
        ("hoop, mean", 1e-6 * result.hoop),
        ("equivalent, inner", 1e-6 * result.inner),
        ("equivalent, outer", 1e-6 * result.outer),
    )
    rows = [
        Panel("$w$, µm", (("deflection outwards", 1e6 * result.w),)),
        Panel("$M$, N·m/m", (("moment of bending", result.bend),), 1),
        Panel("stress, MPa", stresses),
    ]
    marked(panels(drawing, box, 1e3 * result.x, "$x$ from the ring, mm", rows), [1e3 * peak.x])
    return drawing
