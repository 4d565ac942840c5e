"""The picture of the tie-down: forces of the ties over the inertia, and where they slip, slacken and yield."""

from __future__ import annotations

from matplotlib.figure import Figure

from tmmcalc.extras.tie_down import TieDown
from tmmcalc.report.drawing.axes import diagram, levels
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import MARK, THIN
from tmmcalc.report.numbers import number


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return tie_down_figure(order.results["tie_down"])


def tie_down_figure(result: TieDown) -> Figure:
    """Forces of a stretched and an opposite tie over k; thresholds by equilibrium are named, the load is a point."""
    figure, (sheet,) = blank(1)
    sheet.suptitle("Forces of the ties of a load", fontsize=10)
    axes = sheet.subplots()
    lines = [
        ("R by (3)", 1e-3 * result.forces),
        ("R by equilibrium", 1e-3 * result.balance),
        ("opposite tie by equilibrium", 1e-3 * result.slackening),
    ]
    diagram(axes, result.k, lines, "force of a tie, kN")
    at = result.thresholds
    named = ("slips", at.slip), ("slack", at.slack), ("yields", at.yielding), ("tips", at.tipping)
    for name, k in named:
        if k is not None and 0 < k <= result.k[-1]:
            axes.axvline(k, color=THIN, linewidth=0.7, linestyle=(0, (4, 3)), zorder=1)
            text = f"{name}, k = {number(k, 4)}"
            axes.annotate(
                text, (k, 1.0), xycoords=("data", "axes fraction"), xytext=(-2, -4), textcoords="offset points",
                rotation=90, ha="right", va="top", fontsize=6.5,
            )  # fmt: skip
    if result.preload:
        levels(axes, [1e-3 * result.preload, 2e-3 * result.preload], ["P0", "2 P0"])
    axes.plot([result.factor], [1e-3 * result.balanced], "o", color=MARK, markersize=5, zorder=5)
    axes.set_xlabel("inertia force over weight, $k$")
    settle(figure)
    return figure
