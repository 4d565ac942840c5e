"""The sheet of a synthesis: all tooth sets by size and error of the ratio, and what each constraint removed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import SubFigure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, MaxNLocator

from tmmcalc.gears.advice import called, removals
from tmmcalc.gears.columns import ratios
from tmmcalc.gears.pictures.words import KINDS, layout_name, teeth_text
from tmmcalc.gears.search.measures import coprime_meshes
from tmmcalc.gears.trains import Request, Variant
from tmmcalc.report.drawing.labels import Labels, signed
from tmmcalc.report.drawing.style import INK, MARK

MANY = 3000  # more points than this are drawn as an image
COPRIME: dict[str, Any] = {"color": "#0072b2", "marker": "o", "linestyle": "", "markersize": 3.6}
OTHER: dict[str, Any] = {
    "color": "#d55e00",
    "marker": "^",
    "linestyle": "",
    "markersize": 3.4,
    "markerfacecolor": "none",
    "markeredgewidth": 0.7,
}
DRAWN: dict[str, Any] = {
    "color": INK,
    "marker": "s",
    "linestyle": "",
    "markersize": 8.5,
    "markerfacecolor": "none",
    "markeredgewidth": 1.2,
    "zorder": 7,
}
LEAST: dict[str, Any] = {**DRAWN, "marker": "D", "markersize": 7, "markeredgewidth": 0.8}
LIMIT: dict[str, Any] = {"color": MARK, "linewidth": 0.9, "linestyle": (0, (8, 2, 1.5, 2)), "zorder": 3}
BARS = {"candidates": "#c9c9c9", "removed": "#a9cbe2", "left": "#009e73"}
LEFT = 0.7  # end of the logarithmic axis, a little below one
ROOM = 1.3  # its length over that of the longest bar, for the numbers


def solutions_sheet(sheet: SubFigure, variant: Variant, row: int | None) -> Callable[[], None]:
    """Lay the sheet out; ``row`` is the set that is drawn elsewhere. What is returned draws the texts."""
    request, synthesis = variant.request, variant.synthesis
    held = "" if synthesis.complete else f", the {len(variant.sets)} smallest are held and shown"
    found = f"{synthesis.count} tooth sets" if synthesis.count else "no tooth set"
    sheet.suptitle(f"{layout_name(request.scheme, request.task.planets)}: {found}{held}", fontsize=10)
    if not len(variant.sets):
        _draw_removals(sheet.subplots(), variant)
        return lambda: None
    left, right = sheet.subfigures(1, 2, squeeze=False, width_ratios=[1.25, 1.0])[0]
    scatter = left.subplots()
    _draw_sets(scatter, variant, row)
    _draw_removals(right.subplots(), variant)

    def finish() -> None:
        _label_set(scatter, variant, row)

    return finish


def _sums(variant: Variant) -> np.ndarray:
    """Z1 + Z2, the size of the first stage, which the list is ordered by."""
    return np.asarray(variant.sets.teeth[:, 0] + variant.sets.teeth[:, 1])


def _draw_sets(axes: Axes, variant: Variant, row: int | None) -> None:
    x, y = _sums(variant), 100 * ratios(variant.request, variant.sets)[1]
    good = coprime_meshes(variant.sets)
    handles = []
    for label, mask, style in (("not coprime", ~good, OTHER), ("all meshes coprime", good, COPRIME)):
        axes.plot(x[mask], y[mask], zorder=4, rasterized=len(x) > MANY, **style)
        handles.append(Line2D([], [], label=f"{label}: {np.count_nonzero(mask)}", **style))
    for edge in _tolerance(variant.request):
        axes.axhline(edge, **LIMIT)
    handles.append(Line2D([], [], label="tolerance", **LIMIT))
    if row is not None:
        axes.plot(x[row], y[row], **DRAWN)
        handles.append(Line2D([], [], label=f"set {row + 1}, drawn", **DRAWN))
    axes.axhline(0, color="#333333", linewidth=0.8, zorder=1.5)
    _grid(axes)
    axes.margins(x=0.06, y=0.1)
    axes.set_xlabel("$z_1 + z_2$")
    axes.set_ylabel(f"error of ${KINDS[variant.request.kind]}$, %")
    axes.legend(
        handles=handles, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=4, columnspacing=1.2, handlelength=2
    )


def _tolerance(request: Request) -> tuple[float, float]:
    """Ends of the admitted ratios as errors [%]."""
    low, high = (
        float((end - request.nominal) / request.nominal) for end in (request.admitted.low, request.admitted.high)
    )
    return 100 * min(low, high), 100 * max(low, high)


def _label_set(axes: Axes, variant: Variant, row: int | None) -> None:
    """The teeth of the set that is drawn, and of the one with the least error."""
    x, y = _sums(variant), 100 * ratios(variant.request, variant.sets)[1]
    labels = Labels(axes)
    step = max(1, len(x) // MANY)
    for at in (x + 1j * y)[::step].tolist():
        labels.avoid([at], 2.0)
    best = int(np.argmin(np.abs(y)))
    for edge in (0.0, *_tolerance(variant.request)):
        labels.avoid([complex(end, edge) for end in axes.get_xlim()], 0.7)
    shown = [] if row is None else [row]
    if row is None or abs(y[best]) < abs(y[row]):
        axes.plot(x[best], y[best], **LEAST)
        shown.append(best)
    for k in shown:
        text = teeth_text(variant.sets.teeth[k].tolist())
        said = text if k == row else f"{text} (set {k + 1}, least error)"
        labels.put(said, [complex(x[k], y[k])], size=7, gaps=(2.2, 3.2, 4.4, 6.0))


def _draw_removals(axes: Axes, variant: Variant) -> None:
    """Candidates, what each constraint removed of them, what is left."""
    synthesis = variant.synthesis
    rows = [("candidates", synthesis.candidates, "candidates")]
    rows += [(called(name), removed, "removed") for name, removed, _ in removals(variant)]
    rows.append(("tooth sets", synthesis.count, "left"))
    rows.reverse()
    axes.set_xscale("log")
    largest = max(1, *(count for _, count, _ in rows))
    axes.set_xlim(LEFT, LEFT * (largest / LEFT) ** ROOM)
    axes.barh(
        range(len(rows)),
        [max(count, 0.0) for _, count, _ in rows],
        height=0.62,
        zorder=2,
        color=[BARS[kind] for _, _, kind in rows],
    )
    axes.set_yticks(range(len(rows)), [name for name, _, _ in rows])
    for k, (_, count, kind) in enumerate(rows):
        text = f"{count:,}".replace(",", "\N{THIN SPACE}")
        said = f"\N{MINUS SIGN}{text}" if kind == "removed" else text
        axes.text(max(count, LEFT) * 1.15, k, said, size=7.5, va="center", zorder=8)
    axes.grid(True, axis="x", which="major", linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_axisbelow(True)
    axes.set_title("What the constraints removed, in their order", loc="left")
    axes.set_xlabel("combinations of wheels")
    axes.tick_params(length=2.5)


def _grid(axes: Axes) -> None:
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_axisbelow(True)
    axes.xaxis.set_major_locator(MaxNLocator(8, integer=True))
    axes.yaxis.set_major_locator(MaxNLocator(8))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda v, _: signed(v, 6)))
    axes.tick_params(length=2.5)
