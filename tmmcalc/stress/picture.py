"""Observed error over the condition number, one panel a ladder, one curve a stage; what it expects dotted beside it."""

from __future__ import annotations

from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter

from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES
from tmmcalc.stress.results import LIMITS, Ladder, Stress

COLUMNS, ROWS = 3, 2  # of panels on a sheet
MARKS = "osD^vP*X"
SAME = 1.001  # ratio of conditions that are one
DOT: dict[str, Any] = {"markersize": 3.5, "markeredgewidth": 0.7, "linewidth": 1.0}


def stress_figure(result: Stress, heading: str) -> Figure:
    """As many sheets of six panels as the ladders need."""
    ladders = result.ladders
    sheets = max(-(-len(ladders) // (COLUMNS * ROWS)), 1)
    figure, pages = blank(sheets)
    for at, page in enumerate(pages):
        page.suptitle(heading, fontsize=10, parse_math=False)  # a title is the user's own text
        shown = ladders[at * COLUMNS * ROWS : (at + 1) * COLUMNS * ROWS]
        wide = min(len(shown), COLUMNS) or 1
        panels = page.subplots(-(-len(shown) // wide) or 1, wide, squeeze=False).ravel().tolist()
        for axes, ladder in zip(panels, shown, strict=False):
            _draw(axes, ladder)
        for axes in panels[len(shown) :]:
            axes.set_visible(False)
    settle(figure)
    return figure


def _draw(axes: Axes, ladder: Ladder) -> None:
    level = _level(ladder)
    drawn = False
    for k, stage in enumerate(ladder.stages()):
        style = {**CURVES[k % len(CURVES)], "marker": MARKS[k % len(MARKS)]}
        drawn |= _curve(axes, ladder, stage, style, level)
    for limit in LIMITS:
        axes.axhline(limit, linewidth=0.6, color="#a0a0a0", linestyle=(0, (4, 3)), zorder=1)
    axes.set_xscale("linear" if level else "log")
    axes.set_yscale("log")
    axes.set_title(ladder.name)
    axes.set_xlabel("what is varied" if level else ladder.condition)
    axes.set_ylabel("largest relative error")
    axes.yaxis.set_major_locator(LogLocator(numticks=9))
    for axis in (axes.yaxis,) if level else (axes.xaxis, axes.yaxis):
        axis.set_minor_formatter(NullFormatter())
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_axisbelow(True)
    axes.margins(0.08)
    if drawn:
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.18), ncols=3, frameon=False, fontsize=6.5)


def _level(ladder: Ladder) -> bool:
    """Whether the condition is the same on all rungs: then errors are drawn over what is varied."""
    met = [rung.condition for rung in ladder.rungs if rung.condition is not None]
    return len(met) > 0 and max(met) < SAME * min(met)


def _curve(axes: Axes, ladder: Ladder, stage: str, style: dict[str, Any], level: bool) -> bool:
    """The observed errors of a stage, and thin beside them its estimates with what the last digit of the data does."""
    told = [
        (rung.size if level else rung.condition, met.error, met.covered)
        for rung, met in ladder.track(stage)
        if met.error is not None and rung.condition is not None
    ]
    if not told:
        return False
    told.sort(key=lambda row: row[0])
    axes.plot([row[0] for row in told], [row[1] for row in told], label=stage, zorder=4, **DOT, **style)
    estimated = [(row[0], row[2]) for row in told if row[2]]
    if estimated:
        axes.plot(*zip(*estimated, strict=True), linewidth=0.7, linestyle=":", color=style.get("color"), zorder=3)
    return True
