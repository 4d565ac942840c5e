"""The picture of a map of feasible parameters: the region, and where the margin of every constraint is zero.

Borders run between the points of the grid as if margins were linear there. Of one parameter the margins are curves.
"""

from __future__ import annotations

import textwrap
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.patheffects import withTickedStroke

from tmmcalc.feasibility.logic import Values
from tmmcalc.feasibility.maps import RegionMap
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES, INK, THIN
from tmmcalc.report.numbers import number

REGION = "#d5ece2"
WRAP = 110  # characters of a line of the rule
DOTS = 2000  # points of a grid up to which they are marked
FINER = 8  # steps between two values, within which margins are linear
BEST = (0, (1.0, 2.0))
SCALE = 100.0  # [%] of the margins of one parameter, at most


def region_figure(result: RegionMap) -> Figure:
    """One sheet: over two parameters the plane with the borders, over one the margins as curves."""
    figure, (sheet,) = blank(1)
    share = f"{np.count_nonzero(result.feasible)} of {len(result.feasible)} points"
    heading = f"Feasible parameters: {share}"
    sheet.suptitle("\n".join([heading, *textwrap.wrap(f"rule: {result.rule}", WRAP)]), fontsize=10)
    axes = sheet.subplots()
    if len(result.parameters) == 1:
        _curves(axes, result)
    else:
        _plane(axes, result)
    axes.set_xlabel(result.parameters[0].header)
    _legend(axes, result)
    settle(figure)
    return figure


def _plane(axes: Axes, result: RegionMap) -> None:
    """The region filled, its borders with ticks to the side that fails, points without a solution crossed."""
    x, y = (np.array(each.values) for each in result.parameters)
    fine = _between(x), _between(y)
    blank = _plane_between((x, y), fine, result.solved.astype(float), result) < 1
    margins = [_plane_between((x, y), fine, each, result) for each in result.margins]
    for k, field in enumerate(margins):
        shown = np.ma.array(-field, mask=blank)
        if shown.count() and shown.min() <= 0 < shown.max():
            lines = axes.contour(*fine, shown, levels=[0.0], colors=[_colour(k)], linewidths=1.4)
            lines.set(path_effects=[withTickedStroke(spacing=8, angle=60, length=0.6)])
    region = np.ma.array(result.exact(margins), mask=blank)
    if region.count() and region.max() >= 0:
        axes.contourf(*fine, region, levels=[0.0, np.inf], colors=[REGION], zorder=0)
    _points(axes, result, np.repeat(x, len(y)), np.tile(y, len(x)))
    axes.set_ylabel(result.parameters[1].header)
    axes.set_xlim(x[0], x[-1])
    axes.set_ylim(y[0], y[-1])


def _between(x: Values) -> Values:
    """The values with others between them."""
    return np.interp(np.arange((len(x) - 1) * FINER + 1) / FINER, np.arange(len(x)), x)


def _plane_between(at: tuple[Values, Values], fine: tuple[Values, Values], values: Values, of: RegionMap) -> Values:
    """Values on the finer grid, bilinear, rows along the second parameter."""
    columns = np.array([np.interp(fine[1], at[1], row) for row in values.reshape(of.shape)])
    return np.array([np.interp(fine[0], at[0], row) for row in columns.T])


def _points(axes: Axes, result: RegionMap, x: Values, y: Values) -> None:
    if len(x) <= DOTS:
        axes.plot(x[result.solved], y[result.solved], ".", color=THIN, markersize=1.5, zorder=1)
    axes.plot(x[~result.solved], y[~result.solved], "x", color=THIN, markersize=4, markeredgewidth=0.7, clip_on=False)
    axes.plot(x[result.best], y[result.best], "o", color=INK, markersize=5, fillstyle="none", clip_on=False)


def _curves(axes: Axes, result: RegionMap) -> None:
    """Margins in percent, blank where there is no solution; the feasible part is filled."""
    x = np.array(result.parameters[0].values)
    for k, margins in enumerate(result.margins):
        axes.plot(x, np.where(result.solved, 100 * margins, np.nan), linewidth=1.3, **CURVES[k % len(CURVES)])
    largest = float(np.max(np.abs(100 * result.margins)))
    scale = min(1.1 * largest, SCALE) or 1.0
    fine = _between(x)
    region = result.exact([np.interp(fine, x, each) for each in result.margins]) >= 0
    region &= np.interp(fine, x, result.solved) == 1
    axes.fill_between(fine, -scale, scale, where=region, color=REGION, zorder=0, linewidth=0)
    axes.axhline(0, color=INK, linewidth=0.9)
    axes.axvline(x[result.best], color=INK, linewidth=0.8, linestyle=BEST)
    axes.plot(x[~result.solved], np.zeros(np.count_nonzero(~result.solved)), "x", color=THIN, markersize=5)
    axes.set_ylim(-scale, scale)
    axes.set_xlim(x[0], x[-1])
    axes.set_ylabel("margin to the nearer limit, % of it")
    axes.grid(axis="y", color=THIN, linewidth=0.3, alpha=0.6)


def _colour(k: int) -> str:
    return str(CURVES[k % len(CURVES)]["color"])


def _legend(axes: Axes, result: RegionMap) -> None:
    flat = len(result.parameters) == 1
    dashes: list[Any] = [CURVES[k % len(CURVES)]["linestyle"] if flat else "-" for k in range(len(result.names))]
    handles: list[Artist] = [
        Line2D([], [], label=name, color=_colour(k), linestyle=dashes[k], linewidth=1.4)
        for k, name in enumerate(result.names)
    ]
    places = zip(result.parameters, result.at(result.best), strict=True)
    best = ", ".join(number(each.values[k], 5) for each, k in places)
    label = f"{'best' if result.feasible.any() else 'nearest'} point ({best})"
    handles.append(Patch(color=REGION, label="the rule holds"))
    if flat:
        handles.append(Line2D([], [], color=INK, linestyle=BEST, label=label))
    else:
        handles.append(Line2D([], [], color=INK, marker="o", linestyle="", fillstyle="none", label=label))
    if not result.solved.all():
        handles.append(Line2D([], [], marker="x", linestyle="", color=THIN, label="no solution"))
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.07), ncols=min(6, len(handles)))
