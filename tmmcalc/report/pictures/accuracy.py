"""Work-precision diagrams: error over run time, one panel a study, one curve a method."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from tmmcalc.accuracy.study import Accuracy, Series, Study
from tmmcalc.report.pictures.page import blank, settle
from tmmcalc.report.pictures.style import CURVES

COLUMNS, ROWS = 3, 2  # of panels on a sheet
MARKS = "osD^vP*X"
DOT: dict[str, Any] = {"markersize": 4.0, "markeredgewidth": 0.8, "linewidth": 1.1}


def accuracy_figure(result: Accuracy, heading: str) -> Figure:
    """As many sheets of six panels as the studies need."""
    studies = result.studies
    sheets = max(-(-len(studies) // (COLUMNS * ROWS)), 1)
    figure, pages = blank(sheets)
    for at, page in enumerate(pages):
        page.suptitle(heading, fontsize=10)
        shown = studies[at * COLUMNS * ROWS : (at + 1) * COLUMNS * ROWS]
        wide = min(len(shown), COLUMNS) or 1
        panels = page.subplots(-(-len(shown) // wide) or 1, wide, squeeze=False).ravel().tolist()
        for axes, study in zip(panels, shown, strict=False):
            _draw(axes, study)
        for axes in panels[len(shown) :]:
            axes.set_visible(False)
    settle(figure)
    return figure


def _draw(axes: Axes, study: Study) -> None:
    for k, series in enumerate(study.series):
        _curve(axes, series, {**CURVES[k % len(CURVES)], "marker": MARKS[k % len(MARKS)]})
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_title(f"{study.stage}: {study.quantity}")
    axes.set_xlabel("run time, ms")
    axes.set_ylabel("largest relative error")
    axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda time, _: f"{time:g}"))
    axes.yaxis.set_major_locator(LogLocator(numticks=9))
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_minor_formatter(NullFormatter())
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_axisbelow(True)
    axes.margins(0.08)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=2, frameon=False, fontsize=6.5, handlelength=3)


def _curve(axes: Axes, series: Series, style: dict[str, Any]) -> None:
    told = [(p.seconds * 1e3, p.error) for p in series.points if p.error is not None and p.seconds is not None]
    if not told:
        return
    times, errors = _split(told)
    name = series.method if series.order is None else f"{series.method} (order {series.order:.2g})"
    axes.plot(times, errors, label=name, zorder=4, **DOT, **style)


def _split(pairs: Sequence[tuple[float, float]]) -> tuple[list[float], list[float]]:
    return [a for a, _ in pairs], [b for _, b in pairs]
