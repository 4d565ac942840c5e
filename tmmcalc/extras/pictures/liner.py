"""The picture of the liner: deflection, moment and stresses along the bore."""

from __future__ import annotations

from matplotlib.figure import Figure

from tmmcalc.extras.liner import Liner
from tmmcalc.report.drawing.axes import diagram, marked
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.numbers import number


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return liner_figure(order.results["liner"])


def liner_figure(result: Liner) -> Figure:
    """Deflection, moment and stresses along the bore; the place of the largest equivalent stress is marked."""
    figure, (sheet,) = blank(1)
    peak = result.largest
    told = f"{number(1e-6 * peak.stress, 5)} MPa at x = {number(1e3 * peak.x, 5)} mm, {peak.surface} surface"
    sheet.suptitle(f"Cylinder liner, largest equivalent stress {told}", fontsize=10)
    upper, middle, lower = sheet.subplots(3, 1, sharex=True)
    x = 1e3 * result.x
    diagram(upper, x, [("deflection outwards", 1e6 * result.w)], "w, um")
    diagram(middle, x, [("moment of bending", result.bend)], "M, N*m/m", first=1)
    stresses = [
        ("bending, inner surface", 1e-6 * result.axial),
        ("hoop, mean", 1e-6 * result.hoop),
        ("equivalent, inner", 1e-6 * result.inner),
        ("equivalent, outer", 1e-6 * result.outer),
    ]
    diagram(lower, x, stresses, "stress, MPa")
    for axes in (upper, middle, lower):
        marked(axes, [1e3 * peak.x])
    lower.set_xlabel("$x$ from the ring, mm")
    settle(figure)
    return figure
