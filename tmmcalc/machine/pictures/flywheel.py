"""The picture of the flywheel stage: energy-mass curve with its tangents, work over the cycle, methods, search."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patheffects import withStroke
from matplotlib.ticker import FuncFormatter, MaxNLocator

from tmmcalc.core.plane import Real
from tmmcalc.machine.facts.flywheel import called
from tmmcalc.machine.facts.motion import unevenness
from tmmcalc.machine.flywheel.results import Flywheel, RequiredInertia, Row, Trial
from tmmcalc.machine.flywheel.wittenbauer import EnergyMass
from tmmcalc.machine.pictures.energymass import draw_energy_mass, label_energy_mass
from tmmcalc.report.drawing.curves import Diagram, Line, bottom
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES, INK
from tmmcalc.report.numbers import number

NEEDED: dict[str, Any] = {"color": "#d55e00", "linewidth": 1.4, "linestyle": "--", "zorder": 5}
AT_HAND: dict[str, Any] = {"color": "#6b6b6b", "linewidth": 1.4, "linestyle": ":", "zorder": 5}
ALLOWED: dict[str, Any] = {"color": INK, "linewidth": 0.9, "linestyle": (0, (8, 2, 1.5, 2)), "zorder": 3}
TRIED: dict[str, Any] = {"color": "#0072b2", "linestyle": "", "marker": "o", "markersize": 3.4, "zorder": 6}
CORRECTED: dict[str, Any] = {
    "color": "#009e73",
    "linestyle": "",
    "marker": "s",
    "markersize": 4.2,
    "markerfacecolor": "none",
    "zorder": 7,
}
METHODS: dict[str, Any] = {"color": "#cc79a7", "linestyle": "", "marker": "x", "markersize": 5, "zorder": 7}
HEADROOM = 1.12
BAR = "#a9cbe2"


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return flywheel_figure(order.results["flywheel"], order.results["reduction"].phi)


def flywheel_figure(result: Flywheel, phi: Real) -> Figure:
    """One sheet; ``phi`` (n,) are the positions, which say how the input shaft turns."""
    sense, required = math.copysign(1.0, phi[-1] - phi[0]), result.required
    figure, (sheet,) = blank(1)
    sheet.suptitle(_heading(result), fontsize=10)
    left, right = sheet.subfigures(1, 2, squeeze=False)[0]
    curve = left.subplots()
    heights = [1.2, 0.8] if required is None else [1.1, 0.8, 1.0]
    above, bars, *below = right.subplots(len(heights), 1, height_ratios=heights).tolist()
    work = _work(result, phi, sense)
    draw_energy_mass(curve, result.picture)
    work.draw(above)
    work.legend(above, 2)
    bottom([above], True)
    _draw_bars(bars, result)
    if required is not None:
        _draw_search(below[0], result, required)
    settle(figure)
    label_energy_mass(curve, result.picture, sense)
    work.label(above)
    return figure


def _heading(result: Flywheel) -> str:
    delta = f"$\\delta$ = {unevenness(result.delta, 4)}"
    if result.addition <= 0:
        return f"No flywheel is needed for {delta}: {number(result.inertia, 5)} kg·m² at hand do"
    first = f"Flywheel for {delta} under {result.under}: {number(result.addition, 5)} kg·m² at the input shaft"
    if result.ratio != 1:
        first += f" or {number(result.own, 5)} kg·m² on its own shaft"
    return f"{first}\n$J_\\mathrm{{F}}$ = {number(result.inertia, 5)} kg·m² with what is at hand"


def _work(result: Flywheel, phi: Real, sense: float) -> Diagram:
    """Work of all moments over the cycle, and what of it is left to the flywheel at the mean speed (Mertsalov)."""
    picture = result.picture
    half = sum(picture.slopes) / 2 / (1 + result.delta**2 / 4)
    own = picture.work - half * picture.links
    nodes = np.abs(phi - phi[0])
    lines = [
        _curve("$A$: work of all moments", picture, picture.work, nodes, sense, CURVES[0]),
        _curve("$A - J \\omega_\\mathrm{m}^2/2$: left to the flywheel", picture, own, nodes, sense, CURVES[1]),
    ]
    return Diagram("A", "J", True, sense * picture.theta, phi, tuple(lines))


def _curve(label: str, picture: EnergyMass, values: Real, nodes: Real, sense: float, style: dict[str, Any]) -> Line:
    low, high = int(np.argmin(values)), int(np.argmax(values))
    marks = tuple((sense * float(picture.theta[k]), float(values[k])) for k in (low, high))
    return Line(label, values, np.interp(nodes, picture.theta, values), style, marks)


def _draw_bars(axes: Axes, result: Flywheel) -> None:
    """J_F by every method, with the delta that it reaches; what is needed and what is at hand."""
    rows = result.rows[::-1]
    sizes = [row.positional.inertia for row in rows]
    axes.barh(range(len(rows)), sizes, height=0.62, color=BAR, zorder=2)
    axes.set_yticks(range(len(rows)), [called(row.positional) for row in rows])
    for k, row in enumerate(rows):
        halo, across = [withStroke(linewidth=2.5, foreground=BAR)], axes.get_yaxis_transform()
        said = _reached(row, result.under)
        axes.text(0.01, k, said, size=7, va="center", transform=across, path_effects=halo, zorder=8)
    axes.axvline(result.inertia, **NEEDED)
    axes.axvline(result.at_hand.total, **AT_HAND)
    axes.grid(True, axis="x", linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.xaxis.set_major_locator(MaxNLocator(7))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda v, _: signed(v, 6)))
    axes.set_xlabel("$J_\\mathrm{F}$, kg·m²")
    axes.tick_params(length=2.5)
    handles = [Line2D([], [], label="needed $J_\\mathrm{F}$", **NEEDED), Line2D([], [], label="at hand", **AT_HAND)]
    axes.legend(handles=handles, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=2, handlelength=3)


def _reached(row: Row, under: str) -> str:
    method = row.positional
    alone = "stalls" if method.delta is None else f"$\\delta$ = {number(method.delta, 4)}"
    text = f"{signed(method.inertia, 5)}: {alone}"
    if row.error is None:
        return text
    return f"{text}, {'stalls' if row.delta is None else number(row.delta, 4)} under {under}"


def _draw_search(axes: Axes, result: Flywheel, required: RequiredInertia) -> None:
    """delta against the constant inertia under the real drive: the search, the textbook's correction, the methods."""
    methods = [Trial(row.positional.inertia, row.delta) for row in result.rows if row.positional.addition > 0]
    together = sorted((*required.trials, *result.history, *methods), key=lambda trial: trial.inertia)
    axes.plot(*_points(together), color="#0072b2", linewidth=0.9, zorder=4)
    corrected = result.history if len(result.history) > 1 else ()
    drawn = [
        ("motions computed", required.trials, TRIED),
        ("correction (3.60)", corrected, CORRECTED),
        ("methods above", methods, METHODS),
    ]
    handles = []
    for label, trials, style in drawn:
        if trials:
            axes.plot(*_points(trials), **style)
            handles.append(Line2D([], [], label=label, **style))
    axes.axhline(result.delta, **ALLOWED)
    axes.axvline(result.inertia, **NEEDED)
    handles.append(Line2D([], [], label="allowed $\\delta$", **ALLOWED))
    handles.append(Line2D([], [], label="needed $J_\\mathrm{F}$", **NEEDED))
    if result.existing:
        axes.axvline(result.at_hand.total + result.existing, **AT_HAND)
        handles.append(Line2D([], [], label="with the one there", **AT_HAND))
    axes.set_xlim(left=0.0)
    axes.set_ylim(0.0, HEADROOM * max(result.delta, *_points(together)[1]))
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(7))
        axis.set_major_formatter(FuncFormatter(lambda v, _: signed(v, 6)))
    axes.set_xlabel("constant inertia, kg·m²")
    axes.set_ylabel(f"$\\delta$ under {result.under}")
    axes.tick_params(length=2.5)
    axes.legend(
        handles=handles, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=3, handlelength=2.4, columnspacing=1.2
    )


def _points(trials: Sequence[Trial]) -> tuple[list[float], list[float]]:
    """Inertias and deltas of the trials that do not stall."""
    found = [(trial.inertia, trial.delta) for trial in trials if trial.delta is not None]
    return [inertia for inertia, _ in found], [delta for _, delta in found]
