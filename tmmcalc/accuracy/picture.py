"""Work-precision diagrams: error over run time, one panel a study, one curve a method; ladders of stiffness.

A study of one setting, or whose settings are all exact, has nothing to compare and is left out.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from tmmcalc.core.studies.study import Accuracy, Ladder, Series, Study
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES, INK

COLUMNS, ROWS = 3, 2  # of panels on a sheet
MARKS = "osD^vP*X"
DOT: dict[str, Any] = {"markersize": 4.0, "markeredgewidth": 0.8, "linewidth": 1.1}
LEAST_TIMES, LEAST_ERRORS = 1.6, 3.0  # decades that an axis spans at least, so that the scatter of a clock stays small
ROOM = 0.08  # beyond the outermost points, of the span
NONE = "no result"
ROUNDING = 1e-12  # an error that is none
LONG, MANY = (
    26,
    5,
)  # characters of a name that takes the width of a legend, and names that need two columns all the same

Panel = Callable[[Axes], None]


def accuracy_figure(result: Accuracy, heading: str, tolerance: float | None = None) -> Figure:
    """As many sheets of six panels as the studies and ladders need; ``tolerance`` is drawn across them."""
    panels: list[Panel] = [
        partial(_study, study=study, tolerance=tolerance) for study in result.studies if _compares(study)
    ]
    panels += [partial(_ladder, ladder=ladder) for ladder in result.ladders]
    sheets = max(-(-len(panels) // (COLUMNS * ROWS)), 1)
    columns = 2 if len(panels) == 4 else min(max(len(panels), 1), COLUMNS)
    rows = ROWS if len(panels) > columns else 1
    figure, pages = blank(sheets)
    for at, page in enumerate(pages):
        page.suptitle(heading, fontsize=10, parse_math=False)  # a title is the user's own text
        shown = panels[at * COLUMNS * ROWS : (at + 1) * COLUMNS * ROWS]
        places = page.subplots(rows, columns, squeeze=False).ravel().tolist()
        for axes, draw in zip(places, shown, strict=False):
            draw(axes)
        for axes in places[len(shown) :]:
            axes.set_visible(False)
    settle(figure)
    return figure


def _compares(study: Study) -> bool:
    """Whether there are several settings, and not all of them exact."""
    points = [point for series in study.series for point in series.points]
    return len(points) > 1 and any(point.error is None or point.error > ROUNDING for point in points)


def _study(axes: Axes, study: Study, tolerance: float | None) -> None:
    for series, style in zip(study.series, _styles(len(study.series)), strict=True):
        _curve(axes, series, style)
    _scales(axes, f"{study.stage}: {study.quantity}", "run time, ms", "largest relative error")
    told = [p for series in study.series for p in series.points if p.error is not None]
    axes.set_xlim(*_span([(p.seconds or 0.0) * 1e3 for p in told], LEAST_TIMES))
    axes.set_ylim(*_span([p.error or 0.0 for p in told], LEAST_ERRORS))
    if tolerance is not None:
        axes.axhline(tolerance, color=INK, linewidth=0.7, linestyle=(0, (6, 3)), zorder=3, label="tolerance asked for")
    _legend(axes)


def _ladder(axes: Axes, ladder: Ladder) -> None:
    """Evaluations of the textbook's step and of the program's choice along the ladder."""
    values = [rung.value for rung in ladder.rungs]
    textbook, choice = _styles(2)
    steps = [rung.textbook_evaluations for rung in ladder.rungs]
    axes.plot(values, steps, label="fixed steps at the limit of stability", zorder=4, **DOT, **textbook)
    chosen = [rung.evaluations for rung in ladder.rungs]
    axes.plot(values, chosen, label="choice of the program", zorder=4, **DOT, **choice)
    _scales(axes, f"{ladder.stage}: {ladder.quantity}", f"value, {ladder.unit}", "evaluations")
    axes.set_xlim(*_span(values, LEAST_TIMES))
    axes.set_ylim(*_span(steps + chosen, LEAST_ERRORS))
    axes.xaxis.set_major_formatter(axes.yaxis.get_major_formatter())
    _legend(axes)


def _styles(count: int) -> list[dict[str, Any]]:
    return [{**CURVES[k % len(CURVES)], "marker": MARKS[k % len(MARKS)]} for k in range(count)]


def _span(values: Sequence[float], least: float) -> tuple[float, float]:
    """Limits of a logarithmic axis that holds the values and spans ``least`` decades."""
    decades = np.log10([value for value in values if value > 0] or [1.0])
    low, high = float(np.min(decades)), float(np.max(decades))
    half = max((high - low) * (1 + 2 * ROOM), least) / 2
    middle = (low + high) / 2
    return float(10 ** (middle - half)), float(10 ** (middle + half))


def _scales(axes: Axes, title: str, x: str, y: str) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_title(title)
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    axes.xaxis.set_major_locator(LogLocator(numticks=9))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda time, _: f"{time:g}"))
    axes.yaxis.set_major_locator(LogLocator(numticks=9))
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_minor_formatter(NullFormatter())
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_axisbelow(True)


def _legend(axes: Axes) -> None:
    names = axes.get_legend_handles_labels()[1]
    columns = 1 if max(map(len, names), default=0) > LONG and len(names) < MANY else 2
    place: dict[str, Any] = {"loc": "upper center", "bbox_to_anchor": (0.5, -0.16)}
    axes.legend(ncols=columns, frameon=False, fontsize=6.5, handlelength=3, **place)


def _curve(axes: Axes, series: Series, style: dict[str, Any]) -> None:
    told = [p for p in series.points if p.error is not None and p.seconds is not None]
    order = NONE if not told else "" if series.order is None else f"order {series.order:.2g}"
    name = f"{series.method} ({order})" if order else series.method
    times, errors = [(p.seconds or 0.0) * 1e3 for p in told], [p.error or 0.0 for p in told]
    axes.plot(times, errors, label=name, zorder=4, **DOT, **style)
