"""The picture of the transloader: speeds over the time of a way, the loads of each case, stresses of the parts."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from tmmcalc.extras.loadcases import CASES, LOADS
from tmmcalc.extras.transloader import MINUTE, Drive, Transloader
from tmmcalc.report.drawing.axes import diagram
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES, MARK, PLATE, THIN


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return transloader_figure(order.results["transloader"])


def transloader_figure(result: Transloader) -> Figure:
    """Ways of trolley and hoist above, the loads of the cases and the stresses of the parts below."""
    figure, (sheet,) = blank(1)
    sheet.suptitle("Grab transloader", fontsize=10)
    rows = (1 if result.drives else 0) + 1
    grid = sheet.add_gridspec(rows, 2, height_ratios=[1, 1.4][-rows:])
    for k, drive in enumerate(result.drives):
        _way(sheet.add_subplot(grid[0, k if len(result.drives) > 1 else slice(None)]), drive)
    _loads(sheet.add_subplot(grid[-1, 0 if result.checks else slice(None)]), result)
    if result.checks:
        _stresses(sheet.add_subplot(grid[-1, 1]), result)
    settle(figure)
    return figure


def _way(axes: Axes, drive: Drive) -> None:
    """The speed over the time, beside the way that is nothing but acceleration and braking."""
    top, reached = drive.shortest / 2, min(drive.speed, drive.peak)
    t = np.array(sorted({0.0, top, drive.shortest, reached / drive.acceleration, drive.time}))
    t = np.unique(np.concatenate((t, drive.time - t[t <= drive.time])))
    t = t[t >= 0]
    rising = MINUTE * drive.acceleration
    slow = np.clip(np.minimum(rising * np.minimum(t, drive.time - t), MINUTE * reached), 0.0, None)
    fast = np.clip(rising * np.minimum(t, drive.shortest - t), 0.0, None)
    lines = [(f"{drive.what}, {drive.time:.3g} s", slow), (f"up to the peak, {drive.shortest:.3g} s", fast)]
    diagram(axes, t, lines, "v, m/min")
    axes.set_xlabel("$t$, s")


def _loads(axes: Axes, result: Transloader) -> None:
    """A cell for each load and case: its size where it acts."""
    for row, load in enumerate(result.loads):
        for column, case in enumerate(CASES):
            acting, left_blank = case in load.cases, case in load.blank
            colour = PLATE if acting else "#ffffff"
            corner = column - 0.5, row - 0.5
            axes.add_patch(Rectangle(corner, 1, 1, facecolor=colour, edgecolor=THIN, linewidth=0.5))
            text = (f"{load.value / 1000:.4g}" if acting else "") + ("?" if left_blank else "")
            axes.text(column, row, text, ha="center", va="center", fontsize=7)
    axes.set_xlim(-0.5, len(CASES) - 0.5)
    axes.set_ylim(len(result.loads) - 0.5, -0.5)
    axes.set_xticks(range(len(CASES)), list(CASES))
    axes.set_yticks(range(len(result.loads)), [LOADS[each.load].meaning for each in result.loads], fontsize=7)
    axes.tick_params(length=0)
    axes.set_title("loads by case, kN", fontsize=8)


def _stresses(axes: Axes, result: Transloader) -> None:
    """Bars of the stresses, with what is allowed as marks."""
    places = range(len(result.checks))
    stress, allowed, other = (
        [1e-6 * getattr(each, name) for each in result.checks] for name in ("stress", "allowed", "other")
    )
    axes.barh(places, stress, height=0.6, zorder=3, color=CURVES[0]["color"], label="stress")
    factors = ("sum", "product") if result.factors == "sum" else ("product", "sum")
    axes.plot(allowed, places, "|", markersize=14, markeredgewidth=2, color=MARK, label=f"allowed, {factors[0]}")
    axes.plot(other, places, "|", markersize=9, color=THIN, label=f"allowed, {factors[1]}")
    names = [f"{each.part}, {each.case} {each.kind}" for each in result.checks]
    axes.set_yticks(places, names, fontsize=7)
    axes.invert_yaxis()
    axes.grid(True, axis="x", linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_xlabel("stress, MPa")
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=3, borderaxespad=0.3)
