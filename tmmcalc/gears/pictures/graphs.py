"""The sheet of curves by which a train is chosen, with the points of the task on them.

Module ratio of equal strength (figures 4.4, 4.11), ratio and efficiency of planetary trains (4.8 to 4.10), limits of
the ratio by the number of planets (table 4.7).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from math import prod
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import SubFigure
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter

from tmmcalc.gears.bounds import single_planet_limits
from tmmcalc.gears.criteria.efficiency import MeshEfficiency
from tmmcalc.gears.kinds import from_tooth_ratio
from tmmcalc.gears.network.curves import Curve, efficiency_over_ratio, efficiency_over_reduction, ratio_over_inverted
from tmmcalc.gears.network.types import efficiency
from tmmcalc.gears.proportion import RANGE, RANGE_INTERNAL, curve, equal_strength
from tmmcalc.gears.radial import ratio_limits
from tmmcalc.gears.scheme import Layout
from tmmcalc.gears.trains import Request, Variant
from tmmcalc.report.drawing.labels import Labels, signed
from tmmcalc.report.drawing.style import CURVES, INK
from tmmcalc.report.numbers import number

PLANETS = range(3, 9)
TEXTBOOK = 0.9  # efficiency of the inverted train in the textbook's figures
LOWEST = -1.0  # efficiency that is shown
RATIO, REDUCTION, INVERTED, LARGEST = 20.0, 100.0, 8.0, 10.0  # limits of the figures
SAMPLES = 1600  # of a curve with a pole
ROOM = 1.15
POINT: dict[str, Any] = {
    "color": INK,
    "marker": "o",
    "markersize": 5,
    "markerfacecolor": "white",
    "linestyle": "",
    "zorder": 8,
    "clip_on": False,
}
COLUMNS = 3

Panel = Callable[[Axes], Callable[[], None]]  # draws; what it returns writes the texts


class Point(NamedTuple):
    """What the task asks of one layout."""

    layout: Layout
    u: float  # tooth ratio
    i_1h: float | None  # None: not planetary, or wheel 1 stands still


def graphs_of(variants: Sequence[Variant]) -> list[Panel]:
    """The curves that these variants ask for; none for trains with fixed axes in a row and AII."""
    requests = {variant.request.task.layout: variant.request for variant in variants}
    points = [_point(request) for request in requests.values()]
    moving = [point for point in points if point.layout.planetary and point.layout.sign]
    panels: list[Panel] = []
    if any(point.layout.stepped and point.u > 1 for point in points):
        panels.append(partial(_modules, points=points))
    if moving:
        eta0 = _inverted_efficiency(moving[0].layout)
        panels.append(partial(_ratios, points=moving))
        panels += [partial(draw, points=moving, eta0=eta0) for draw in (_by_wheel, _by_carrier)]
    limited = [each for each in requests.values() if each.scheme.branched and each.scheme.stages == 1]
    panels += [partial(_limits, request=each) for each in sorted(limited, key=lambda each: each.scheme.paired)]
    return panels


def graphs_sheet(sheet: SubFigure, panels: Sequence[Panel]) -> Callable[[], None]:
    """Lay the sheet out; what is returned draws the texts when the layout is settled."""
    sheet.suptitle("Curves of choice; circles: the task", fontsize=10)
    columns = 2 if len(panels) == 4 else min(len(panels), COLUMNS)
    rows = -(-len(panels) // columns)
    places = sheet.subplots(rows, columns, squeeze=False).ravel().tolist()
    finish = [panel(axes) for panel, axes in zip(panels, places, strict=False)]
    for axes in places[len(panels) :]:
        axes.set_axis_off()

    def write() -> None:
        for step in finish:
            step()

    return write


def _point(request: Request) -> Point:
    layout, u = request.scheme, request.task.nominal
    speed = from_tooth_ratio(layout, "i_1H", u) if layout.planetary and layout.sign else None
    return Point(layout, float(u), float(speed) if speed else None)


def _inverted_efficiency(layout: Layout) -> float:
    """eta_0 of general values for the meshes."""
    meshes = MeshEfficiency()
    return prod(meshes.internal if mesh.internal else meshes.external for mesh in layout.meshes)


def _modules(axes: Axes, points: Sequence[Point]) -> Callable[[], None]:
    """mu* over U for an external and an internal second mesh."""
    tied = [point for point in points if point.layout.stepped and point.u > 1]
    found: list[tuple[complex, str]] = []
    lines: list[np.ndarray] = []
    for k, (internal, ends, name) in enumerate(((False, RANGE, "AA, coaxial"), (True, RANGE_INTERNAL, "AI"))):
        own = [point for point in tied if bool(point.layout.rings) is internal]
        low = min([ends[0], *(point.u for point in own)])
        high = max([ends[1], *(ROOM * point.u for point in own)])
        drawn = curve(internal=internal, low=low, high=high)
        axes.plot(drawn.ratio, drawn.modules, linewidth=1.4, label=name, zorder=5, **CURVES[k])
        lines.append(drawn.ratio + 1j * drawn.modules)
        for point in own:
            value = float(equal_strength(point.u, internal=internal).modules[0])
            found.append((complex(point.u, value), f"{point.layout.key}: $\\mu^*$ = {number(value, 4)}"))
    _frame(axes, "Module ratio of equal strength", "tooth ratio $U$", "$\\mu^* = m_2/m_1$")
    axes.set_ylim(0.0, ROOM * max(float(line.imag.max()) for line in lines))
    axes.legend(loc="lower right")
    return _marked(axes, found, lines)


def _ratios(axes: Axes, points: Sequence[Point]) -> Callable[[], None]:
    """i_1H over i_13^H, and the reduction of a carrier that drives."""
    values = [1 - point.i_1h for point in points if point.i_1h is not None]
    low, high = min([-INVERTED, *(ROOM * v for v in values)]), max([INVERTED, *(ROOM * v for v in values)])
    bottom, top = min(-INVERTED, 1 - high), max(LARGEST, 1 - low)
    curves = ratio_over_inverted(low, high, top, points=SAMPLES)
    for k, name in ((0, "$i_{1H}$"), (1, "$|1/i_{1H}|$"), (2, "")):
        style = CURVES[min(k, 1)]
        axes.plot(curves[k].x, curves[k].y, linewidth=1.4, label=name or None, zorder=5, **style)
    axes.set_ylim(bottom, top)
    _frame(axes, "Ratio", "ratio of the inverted train $i_{13}^H$", "$i_{1H}$, $|1/i_{1H}|$")
    axes.legend(loc="upper right")
    found = [
        (complex(1 - point.i_1h, point.i_1h), f"{point.layout.key}: $i_{{1H}}$ = {signed(point.i_1h, 5)}")
        for point in points
        if point.i_1h is not None
    ]
    return _marked(axes, found, [each.x + 1j * each.y for each in curves])


def _by_wheel(axes: Axes, points: Sequence[Point], eta0: float) -> Callable[[], None]:
    """Efficiency over i_1H with wheel 1 driving."""
    values = [point.i_1h for point in points if point.i_1h is not None]
    low, high = min([-RATIO, *(ROOM * v for v in values)]), max([RATIO, *(ROOM * v for v in values)])
    lines = _pairs(axes, lambda eta: efficiency_over_ratio(eta, low, high, LOWEST), eta0)
    axes.axhspan(LOWEST, 0.0, color="#d55e00", alpha=0.08, linewidth=0, zorder=0)
    axes.text(0.98, 0.04, "self-locking", transform=axes.transAxes, ha="right", size=7.5, color="#b34700")
    axes.set_ylim(LOWEST, 1.2)
    axes.set_xlim(low, high)
    _frame(axes, "Wheel 1 drives", "$i_{1H}$", "$\\eta$")
    axes.legend(loc="center right", bbox_to_anchor=(1.0, 0.64))
    found = []
    for point in points:
        if point.i_1h is not None and (value := float(efficiency(point.i_1h, eta0))) >= LOWEST:
            found.append((complex(point.i_1h, value), f"{point.layout.key}: $\\eta$ = {signed(value, 3)}"))
    return _marked(axes, found, lines)


def _by_carrier(axes: Axes, points: Sequence[Point], eta0: float) -> Callable[[], None]:
    """Efficiency over the reduction |1/i_1H| with the carrier driving."""
    reducing = [point for point in points if point.i_1h is not None and abs(point.i_1h) < 1]
    largest = max([REDUCTION, *(2 / abs(point.i_1h) for point in reducing if point.i_1h)])
    lines = _pairs(axes, lambda eta: efficiency_over_reduction(eta, largest), eta0, each=True)
    axes.set_xscale("log")
    axes.set_ylim(0.0, 1.05)
    axes.set_xlim(1.0, largest)
    _frame(axes, "The carrier drives, $|i_{1H}| < 1$", "$|1/i_{1H}|$", "$\\eta$")
    axes.xaxis.set_major_locator(LogLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda v, _: number(v, 6)))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.legend(loc="upper right")
    found = []
    for point in reducing:
        if point.i_1h is not None:
            value = float(efficiency(point.i_1h, eta0, "H"))
            found.append((complex(1 / abs(point.i_1h), value), f"{point.layout.key}: $\\eta$ = {number(value, 3)}"))
    return _marked(axes, found, lines)


def _pairs(
    axes: Axes, curves: Callable[[float], tuple[Curve, ...]], eta0: float, *, each: bool = False
) -> list[np.ndarray]:
    """The curves for the train's own inverted efficiency and for the textbook's; ``each`` branch with its name."""
    lines = []
    for eta, thick in ((eta0, 1.5), (TEXTBOOK, 0.8)):
        for k, found in enumerate(curves(eta)):
            style = CURVES[k if each else 0] if thick > 1 else {**CURVES[k if each else 0], "color": "#8a8a8a"}
            name = f"$\\eta_0$ = {number(eta, 4)}"
            label = f"{_written(found.label)}, {name}" if each else name
            axes.plot(found.x, found.y, linewidth=thick, label=label if each or k == 0 else None, zorder=5, **style)
            lines.append(found.x + 1j * found.y)
    return lines


def _written(label: str) -> str:
    """A range of i_1H with true signs."""
    return label.replace("i_1H", "$i_{1H}$").replace("-1", "\N{MINUS SIGN}1")


def _limits(axes: Axes, request: Request) -> Callable[[], None]:
    """How large the ratio may be with each number of planets; the ratio of the task across."""
    task, known = request.task, list(PLANETS)
    if task.scheme.paired:
        bounds = [ratio_limits(k) for k in known]
        tops = [bound.high or 0.0 for bound in bounds]
        axes.bar(
            known,
            [top - bound.low for top, bound in zip(tops, bounds, strict=True)],
            bottom=[bound.low for bound in bounds],
            width=0.6,
            color="#a9cbe2",
            zorder=2,
            label="permissible",
        )
        value, name = 1 + float(task.nominal), "i_{1H}"
    else:
        gap = 2 * task.addendum + (task.demands.gap or 0)
        found = [single_planet_limits(k, sun=task.limits.least, tips=float(gap)) for k in known]
        tops = [limit.permissible or 0.0 for limit in found]
        axes.bar(known, tops, width=0.6, color="#dfe6ec", zorder=2, label="permissible, some sun")
        least = [max(limit.rational or 0.0, 0.0) for limit in found]
        axes.bar(known, least, width=0.6, color="#a9cbe2", zorder=3, label=f"sun of {task.limits.least} teeth")
        value, name = float(task.nominal), "U"
    axes.axhline(
        value,
        color=INK,
        linewidth=1.0,
        linestyle=(0, (8, 2, 1.5, 2)),
        zorder=5,
        label=f"task: ${name}$ = {number(value, 5)}",
    )
    for k, top in zip(known, tops, strict=True):
        axes.text(k, top, number(top, 3), ha="center", va="top", size=7, zorder=6)
    _frame(axes, f"{task.layout}: neighbours clear each other", "number of planets $K$", f"${name}$")
    axes.set_ylim(0.0, ROOM * max(*tops, value))
    axes.legend(loc="upper right")
    return lambda: None


def _frame(axes: Axes, title: str, x: str, y: str) -> None:
    axes.set_title(title, loc="left")
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    axes.axhline(0, color="#333333", linewidth=0.8, zorder=1.5)
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_axisbelow(True)
    for axis in (axes.xaxis, axes.yaxis):
        if axis.get_scale() == "linear":
            axis.set_major_locator(MaxNLocator(7))
            axis.set_major_formatter(FuncFormatter(lambda v, _: signed(v, 6)))
    axes.tick_params(length=2.5)


def _marked(axes: Axes, points: Sequence[tuple[complex, str]], lines: Sequence[np.ndarray]) -> Callable[[], None]:
    """Draw the points; what is returned writes their names."""
    for at, _ in points:
        axes.plot(at.real, at.imag, **POINT)

    def write() -> None:
        labels = Labels(axes)
        for line in lines:
            labels.avoid(line, 0.7)
        for at, text in points:
            labels.put(text, [at], size=7.5, gaps=(1.9, 2.8, 4.0, 5.5))

    return write
