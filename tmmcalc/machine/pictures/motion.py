"""The picture of the motion stage: speed and moments over the cycle, and the motor's characteristic with its range."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure
from matplotlib.lines import Line2D

from tmmcalc.core.numerics.panels import Panels, Values
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.facts.motion import unevenness
from tmmcalc.machine.motion import Motion
from tmmcalc.machine.pictures.characteristic import (
    MotorCurves,
    draw_near,
    draw_whole,
    label_near,
    label_whole,
    legend,
    motor_curves,
)
from tmmcalc.machine.power import Power
from tmmcalc.machine.regime import Regime
from tmmcalc.report.drawing.curves import Diagram, Line, bottom, coordinate
from tmmcalc.report.drawing.limits import places, with_limits
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES, INK
from tmmcalc.report.numbers import NOISE, number

MEAN: dict[str, Any] = {"color": INK, "linewidth": 0.9, "linestyle": (0, (8, 2, 1.5, 2)), "zorder": 3}
NODAL: dict[str, Any] = {"color": "#009e73", "linestyle": "", "marker": "s", "markersize": 4, "markerfacecolor": "none"}
ROOM = 0.16  # of the range of the speeds, below and above them


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return motion_figure(order.results["motion"], order.results["power"], order.results["reduction"].cycle)


def motion_figure(result: Motion, power: Power, cycle: Cycle) -> Figure:
    """One sheet: diagrams over the cycle, and beside them the characteristic of a motor."""
    figure, (sheet,) = blank(1)
    sheet.suptitle(_heading(result), fontsize=10)
    motor = None
    left: SubFigure = sheet
    if result.kind == "motor" and power.duty is not None:
        motor = motor_curves(result, power.duty, power.transmission)
        left, right = sheet.subfigures(1, 2, squeeze=False, width_ratios=[1.5, 1.0])[0]
    panels = left.subplots(3, 1, sharex=True, height_ratios=[1.5, 1.2, 0.8]).tolist()
    diagrams = _diagrams(result, cycle)
    for axes, diagram in zip(panels, diagrams, strict=True):
        diagram.draw(axes, ticks=13 if motor is not None else 25)
    _finish_speed(panels[0], result, diagrams[0])
    diagrams[1].legend(panels[1], 3)
    bottom(panels, True)
    curves: list[tuple[Axes, float]] = []
    if motor is not None:
        curves = _draw_motor(right, motor)
    settle(figure)
    for axes, diagram in zip(panels, diagrams, strict=True):
        diagram.label(axes)
    if motor is not None:
        for (axes, factor), label in zip(curves, (label_near, label_whole), strict=False):
            label(axes, motor, factor)
    return figure


def _heading(result: Motion) -> str:
    regime = result.regime
    what = {"motor": "under the motor", "none": "under its loads"}.get(result.kind, "under a constant moment")
    first = f"Steady motion {what}: $\\delta$ = {unevenness(regime.delta, 4)}"
    if result.idle is not None:
        first += f", without technological loads {number(result.idle.delta, 4, peak=1.0)}"
    parts = f"constant inertia {number(result.inertia.total, 5)} kg·m², cycle of {number(regime.cycle_time, 5)} s"
    return f"{first}\n{parts}"


def _diagrams(result: Motion, cycle: Cycle) -> tuple[Diagram, Diagram, Diagram]:
    """Speed, moments, acceleration."""
    sense, regime, panels = _sense(result), result.regime, cycle.panels
    theta, points = places(panels), regime.omega_at(panels.x.ravel()).reshape(panels.x.shape)
    load = cycle.moment + (cycle.viscous + cycle.quadratic * points) * points
    driving, omega = regime.panels.at(np.stack((regime.driving, regime.omega)), theta)
    inertia, slope = cycle.inertia + result.inertia.total, cycle.slope
    resisting, mass, change = with_limits(panels, np.stack((load, inertia, slope)))
    eps = (driving + resisting - change * omega**2 / 2) / mass
    moments = (
        Line("drive $M_\\mathrm{d}$", driving, result.driving, CURVES[0], _ends(sense, regime.panels, regime.driving)),
        Line("load $M_\\mathrm{load}$", resisting, result.load, CURVES[1], _ends(sense, panels, load)),
    )
    return (
        replace(_diagram(result, theta, "\\omega", "rad/s", _speeds(result, theta, omega)), digits=5),
        _diagram(result, theta, "M", "N*m", moments),
        _diagram(result, theta, "\\varepsilon", "rad/s^2", (Line("", eps, result.eps, CURVES[0]),)),
    )


def _speeds(result: Motion, theta: Values, omega: Values) -> tuple[Line, ...]:
    """Loaded, and idle beside it."""
    sense, idle, nodes = _sense(result), result.idle, result.omega_idle
    lines = [Line("loaded", omega, result.omega, CURVES[0], _marks(sense, result.regime))]
    if idle is not None and nodes is not None:
        lines.append(Line("without technological loads", idle.omega_at(theta), nodes, CURVES[1], _marks(sense, idle)))
    return tuple(lines)


def _diagram(result: Motion, theta: Values, symbol: str, unit: str, lines: tuple[Line, ...]) -> Diagram:
    return Diagram(symbol, unit, True, _sense(result) * theta, result.phi, lines)


def _sense(result: Motion) -> float:
    return math.copysign(1.0, result.phi[-1] - result.phi[0])


def _marks(sense: float, regime: Regime) -> tuple[tuple[float, float], ...]:
    return (sense * regime.theta_min, regime.omega_min), (sense * regime.theta_max, regime.omega_max)


def _ends(sense: float, panels: Panels, values: Values) -> tuple[tuple[float, float], ...]:
    """Extremes of a function on panels; none of a constant."""
    constant = np.ptp(values) <= NOISE * np.max(np.abs(values))
    return () if constant else tuple((sense * at, value) for value, at in panels.extremes(values))


def _finish_speed(axes: Axes, result: Motion, diagram: Diagram) -> None:
    """Limits about the speeds alone, the mean speed, that of the textbook, the legend."""
    everything = np.concatenate([line.values for line in diagram.lines])
    if result.by_energy is not None:  # off by the mean, while the recurrence may swing without limit
        everything = np.append(everything, result.by_energy.omega)
    low, high = float(everything.min()), float(everything.max())
    axes.set_ylim(low - ROOM * (high - low), high + ROOM * (high - low))
    mean = result.regime.mean
    axes.axhline(mean, **MEAN)
    handles = [Line2D([], [], label=line.label, linewidth=1.3, **line.style) for line in diagram.lines]
    handles.append(Line2D([], [], label=f"mean $\\omega_\\mathrm{{m}}$ = {number(mean, 5)}", **MEAN))
    by_hand = result.omega_textbook
    if by_hand is not None:
        nodal = coordinate(True, result.phi), by_hand
        axes.plot(*nodal, **NODAL)
        label = "recurrence (3.57)" if result.by_energy is None else "energy (3.48)"
        handles.append(Line2D([], [], label=label, **NODAL))
    axes.legend(
        handles=handles, handlelength=3, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=4, columnspacing=1.2
    )


def _draw_motor(sheet: SubFigure, motor: MotorCurves) -> list[tuple[Axes, float]]:
    """The working range, and above it the whole curve if it is known; with the factors of their moments."""
    count = 1 if motor.kloss is None else 2
    axes = sheet.subplots(count, 1, squeeze=False)[:, 0].tolist()
    near = axes[0]
    drawn = [(near, draw_near(near, motor))]
    legend(near, motor)
    if count == 2:
        drawn.append((axes[1], draw_whole(axes[1], motor)))
    return drawn
