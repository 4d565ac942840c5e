"""The picture of the reduction stage: reduced moments of every cause and their sum, reduced inertia, its derivative."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from tmmcalc.core.numerics.panels import Values
from tmmcalc.linkage.facts.places import speed_text
from tmmcalc.linkage.results import Extreme
from tmmcalc.machine.reduction.results import Contribution, Reduction
from tmmcalc.report.drawing.curves import Diagram, Line, bottom, coordinate, suited
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.limits import places, with_limits
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES, INK
from tmmcalc.report.numbers import NOISE

SUM: dict[str, Any] = {"color": INK, "linestyle": "-", "linewidth": 1.9, "zorder": 6}
LUMPED: dict[str, Any] = {
    "color": "#d55e00",
    "linestyle": "",
    "marker": "s",
    "markersize": 4,
    "markerfacecolor": "none",
}
BESIDE: dict[str, Any] = {"loc": "upper left", "bbox_to_anchor": (1.0, 1.0)}


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return reduction_figure(order.results["reduction"])


def reduction_figure(result: Reduction) -> Figure:
    """One sheet of three diagrams, one under another."""
    figure, (sheet,) = blank(1)
    sheet.suptitle(_heading(result), fontsize=10)
    panels = sheet.subplots(3, 1, sharex=True, height_ratios=[2.0, 1.0, 1.0]).tolist()
    diagrams = (_moments(result), _inertia(result), _slope(result))
    for axes, diagram in zip(panels, diagrams, strict=True):
        diagram.draw(axes, ticks=25)
    title = "with the work $A$\n" + ("of a cycle" if result.whole else "over the range")
    diagrams[0].legend(panels[0], 1, title=title, **BESIDE)
    _draw_other(panels[1], result, diagrams[1])
    bottom(panels, result.turns)
    settle(figure)
    for axes, diagram in zip(panels, diagrams, strict=True):
        diagram.label(axes)
    return figure


def _heading(result: Reduction) -> str:
    what = "Reduced moments and reduced inertia" if result.turns else "Reduced forces and reduced mass"
    text = f"{what} at {speed_text(result)}".replace("-", "\N{MINUS SIGN}")
    # the moments are algebraic: power over the speed, which is negative here
    return text if result.speed > 0 else f"{text}; a positive {'moment' if result.turns else 'force'} resists"


def _phi(result: Reduction) -> Values:
    """The points of the panels with their edges (m,), along the positive input coordinate [rad or m]."""
    return math.copysign(1.0, result.speed) * places(result.cycle.panels)


def _diagram(result: Reduction, symbol: str, unit: str, lines: tuple[Line, ...]) -> Diagram:
    return Diagram(symbol, unit, result.turns, _phi(result), result.phi, lines)


def _moments(result: Reduction) -> Diagram:
    """Every contribution with its work in the legend, and the sum over them."""
    panels, sense = result.cycle.panels, math.copysign(1.0, result.speed)
    lines = [
        Line(_named(result, c.name, c), with_limits(panels, sense * part), nodes, CURVES[k % len(CURVES)])
        for k, (c, part, nodes) in enumerate(zip(result.contributions, result.parts, result.moment, strict=True))
    ]
    total = sense * result.parts.sum(axis=0)
    marks = tuple(_mark(result, Extreme(*found)) for found in panels.extremes(total))
    lines.append(Line(_named(result, "sum", None), with_limits(panels, total), result.total, SUM, marks))
    symbol, unit = ("M_\\mathrm{red}", "N*m") if result.turns else ("F_\\mathrm{red}", "N")
    return _diagram(result, symbol, unit, tuple(lines))


def _named(result: Reduction, name: str, contribution: Contribution | None) -> str:
    """A curve of the legend: its name, and below it the work per cycle."""
    works = [c.work for c in result.contributions]
    work = math.fsum(works) if contribution is None else contribution.work
    factor, unit = suited(max(map(abs, works), default=0.0), "J")
    extremes = (e.value for c in result.contributions for e in (c.least, c.largest))
    noise = NOISE * result.cycle.period * max(map(abs, extremes), default=0.0)
    if contribution is not None and contribution.kind == "damper":
        name += " (damping)"
    return f"{name}\n$A$ = {signed(work * factor if abs(work) > noise else 0.0, 5)} {unit}"


def _inertia(result: Reduction) -> Diagram:
    symbol, unit = ("J_\\mathrm{red}", "kg*m^2") if result.turns else ("m_\\mathrm{red}", "kg")
    marks = tuple(_mark(result, extreme) for extreme in result.inertia_range)
    line = Line("exact", with_limits(result.cycle.panels, result.cycle.inertia), result.inertia, CURVES[0], marks)
    return _diagram(result, symbol, unit, (line,))


def _slope(result: Reduction) -> Diagram:
    """Derivative against the positive input coordinate."""
    symbol, unit = ("dJ/d\\varphi", "kg*m^2/rad") if result.turns else ("dm/ds", "kg/m")
    slope = math.copysign(1.0, result.speed) * result.cycle.slope
    panels = result.cycle.panels
    marks = tuple(_mark(result, Extreme(*found)) for found in panels.extremes(slope))
    return _diagram(result, symbol, unit, (Line("", with_limits(panels, slope), result.slope, CURVES[0], marks),))


def _draw_other(axes: Axes, result: Reduction, diagram: Diagram) -> None:
    """The inertia with the rods the other way, at the positions alone; nothing where it is the same."""
    other, factor = result.other, diagram.scale[0]
    if other is None or np.max(np.abs(other - result.inertia)) <= NOISE * np.max(other):
        return
    rods = ", ".join(map(str, result.rod_links))
    lumped = f"link{'s' if len(result.rod_links) > 1 else ''} {rods} lumped\nin the pins"
    own, label = ("exact", lumped) if result.rods == "exact" else (lumped, "exact")
    axes.plot(coordinate(result.turns, result.phi), other * factor, label=label, **LUMPED)
    handles = [Line2D([], [], label=own, linewidth=1.3, **CURVES[0]), Line2D([], [], label=label, **LUMPED)]
    axes.legend(handles=handles, handlelength=3, **BESIDE)


def _mark(result: Reduction, extreme: Extreme) -> tuple[float, float]:
    return math.copysign(extreme.x, result.speed), extreme.value
