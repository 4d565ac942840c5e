"""The picture of the motion stage: speed and moments over the cycle, and the motor's characteristic with its range."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from tmmcalc.core.numerics.panels import Panels, Values
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.facts.motion import unevenness
from tmmcalc.machine.motion import Motion
from tmmcalc.machine.pictures.characteristic import draw_motor, motor_curves
from tmmcalc.machine.power import Power
from tmmcalc.machine.regime import Regime
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import Graph, Line, along_input, column
from tmmcalc.report.drawing.diagram import Diagram
from tmmcalc.report.drawing.limits import places, with_limits
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.pens import AXIS, CURVES, Pen
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr
from tmmcalc.report.numbers import NOISE, number

MEAN = AXIS._replace(layer="MEAN")
NODAL = Pen("RECURRENCE", 0.3, colour="#009e73")
ROOM = 0.16  # of the range of the speeds, below and above them
STILL = 1e-9  # of the speed: one that varies less is a constant
HEADING = 11.0  # room of the heading [mm]


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return motion_drawing(order.results["motion"], order.results["power"], order.results["reduction"].cycle)


def motion_drawing(result: Motion, power: Power, cycle: Cycle) -> Drawing:
    """One sheet: diagrams over the cycle, and beside them the characteristic of a motor."""
    drawing, (box,) = sheets(1)
    drawing.add(Words(complex(box.middle.real, box.top), _heading(result), 3.0, 1j))
    free = box.inset(0, 0, 0, HEADING)
    if result.kind == "motor" and power.duty is not None:
        free, right = free.split(1.5, 1.0, gap=3, across=True)
        draw_motor(drawing, right, motor_curves(result, power.duty, power.transmission))
    _complete(column(drawing, free, _graphs(result, cycle), (1.5, 1.2, 0.8))[0], result)
    return drawing


def draw_speed(drawing: Drawing, box: Box, result: Motion, cycle: Cycle) -> Diagram:
    """The speed over the cycle, to scale."""
    speed, *_ = _graphs(result, cycle)
    (diagram,) = column(drawing, box, [replace(speed, mu="ω")])
    _complete(diagram, result)
    return diagram


def _complete(speeds: Diagram, result: Motion) -> None:
    """The speeds of the textbook at the positions."""
    if result.omega_textbook is not None:
        for at, value in zip(along_input(True, result.phi).tolist(), result.omega_textbook.tolist(), strict=True):
            speeds.point(complex(at, value), NODAL, 0.6)


def _heading(result: Motion) -> str:
    regime = result.regime
    under = {"motor": tr("under the motor"), "none": tr("under its loads")}.get(
        result.kind, tr("under a constant moment")
    )
    delta = unevenness(regime.delta, 4)
    if result.idle is None:
        first = tr("Steady motion {under}: $δ$ = {delta}", under=under, delta=delta)
    else:
        first = tr(
            "Steady motion {under}: $δ$ = {delta}, without technological loads {idle}",
            under=under,
            delta=delta,
            idle=number(result.idle.delta, 4, peak=1.0),
        )
    inertia, time = number(result.inertia.total, 5), number(regime.cycle_time, 5)
    return first + "\n" + tr("constant inertia {inertia} kg·m², cycle of {time} s", inertia=inertia, time=time)


def _graphs(result: Motion, cycle: Cycle) -> tuple[Graph, Graph, Graph]:
    """Speed, moments, acceleration."""
    sense, regime, panels = _sense(result), result.regime, cycle.panels
    theta, points = places(panels), regime.omega_at(panels.x.ravel()).reshape(panels.x.shape)
    load = cycle.moment + (cycle.viscous + cycle.quadratic * points) * points
    driving, omega = regime.panels.at(np.stack((regime.driving, regime.omega)), theta)
    inertia, slope = cycle.inertia + result.inertia.total, cycle.slope
    resisting, mass, change = with_limits(panels, np.stack((load, inertia, slope)))
    eps = (driving + resisting - change * omega**2 / 2) / mass
    moments = (
        Line(tr("drive $M_d$"), driving, result.driving, CURVES[0], _ends(sense, regime.panels, regime.driving)),
        Line(tr("load $M_c$"), resisting, result.load, CURVES[1], _ends(sense, panels, load)),
    )
    return (
        _of_speed(result, theta, _speeds(result, theta, omega)),
        _graph(result, theta, "M", "N*m", moments),
        _graph(result, theta, "ε", "rad/s^2", (Line("", eps, result.eps, CURVES[0]),)),
    )


def _speeds(result: Motion, theta: Values, omega: Values) -> tuple[Line, ...]:
    """Loaded, and idle beside it."""
    sense, idle, nodes = _sense(result), result.idle, result.omega_idle
    lines = [Line(tr("loaded"), omega, result.omega, CURVES[0], _marks(sense, result.regime))]
    if idle is not None and nodes is not None:
        lines.append(
            Line(tr("without technological loads"), idle.omega_at(theta), nodes, CURVES[1], _marks(sense, idle))
        )
    return tuple(lines)


def _of_speed(result: Motion, theta: Values, lines: tuple[Line, ...]) -> Graph:
    """Limits about the speeds alone; in the key the mean speed and the recurrence of the textbook."""
    everything = np.concatenate([line.values for line in lines])
    if result.by_energy is not None:  # off by the mean, while the recurrence may swing without limit
        everything = np.append(everything, result.by_energy.omega)
    low, high = float(everything.min()), float(everything.max())
    air = ROOM * (high - low) if high - low > STILL * abs(high) else 1e-3 * abs(high)
    names = [(line.label, line.pen) for line in lines]
    names.append((tr("mean $ω_m$ = {speed}", speed=number(result.regime.mean, 5)), MEAN))
    if result.omega_textbook is not None:
        circles = tr("by the recurrence: circles") if result.by_energy is None else tr("by the kinetic energy: circles")
        names.append((circles, NODAL))
    graph = _graph(result, theta, "ω", "rad/s", lines)
    mean = ((result.regime.mean, MEAN, ""),)
    return replace(graph, digits=5, ends=(low - air, high + air), key=tuple(names), levels=mean)


def _graph(result: Motion, theta: Values, symbol: str, unit: str, lines: tuple[Line, ...]) -> Graph:
    return Graph(symbol, unit, True, _sense(result) * theta, result.phi, lines)


def _sense(result: Motion) -> float:
    return math.copysign(1.0, result.phi[-1] - result.phi[0])


def _marks(sense: float, regime: Regime) -> tuple[tuple[float, float], ...]:
    return (sense * regime.theta_min, regime.omega_min), (sense * regime.theta_max, regime.omega_max)


def _ends(sense: float, panels: Panels, values: Values) -> tuple[tuple[float, float], ...]:
    """Extremes of a function on panels; none of a constant."""
    constant = np.ptp(values) <= NOISE * np.max(np.abs(values))
    return () if constant else tuple((sense * at, value) for value, at in panels.extremes(values))
