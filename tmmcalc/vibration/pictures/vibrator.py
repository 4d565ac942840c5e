"""The picture of the vibratory device: modes, resonance curve, starts, paths of the part's points in space."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure

from tmmcalc.core.numerics.panels import Values
from tmmcalc.report.drawing.axes import diagram, levels, marked, spread
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.style import CURVES, INK, MARK
from tmmcalc.report.numbers import number
from tmmcalc.vibration.pictures.sheets import Sheet, sheets_of
from tmmcalc.vibration.vibrator.results import Curve, MotorStart, Start, VibratorResult
from tmmcalc.vibration.vibrator.task import COORDINATES, UNITS

SHIFTS = [k for k, unit in enumerate(UNITS) if unit == "m"]
TURNS = [k for k, unit in enumerate(UNITS) if unit == "rad"]
LOWEST = 1e-4  # of the largest amplitude that is drawn
RPM = 30 / np.pi
ENLARGED = 0.35  # of the part's size: how large the widest path is drawn


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return vibrator_figure(order.results["vibrator"])


def vibrator_figure(result: VibratorResult) -> Figure:
    """A sheet each of modes, resonance curve, starts and paths, as far as there are results."""
    sheets: list[Sheet] = [("Natural modes", lambda sheet: _modes(sheet, result))]
    if result.curve is not None:
        curve = result.curve
        sheets.append(("Resonance curve", lambda sheet: _curve(sheet, result, curve)))
    if result.run_up is not None:
        start = result.run_up
        sheets.append(("Start with a given angle of the rotor", lambda sheet: _start(sheet, result, start)))
    if result.drive is not None:
        drive = result.drive
        sheets.append(("Start by the motor", lambda sheet: _start(sheet, result, drive)))
    if result.paths:
        sheets.append(("Paths of points of the part in steady motion", lambda sheet: _paths(sheet, result)))
    return sheets_of(sheets)


def _modes(sheet: SubFigure, result: VibratorResult) -> None:
    """Bars of the shapes, turns by what they move at the rods' radius against the largest displacement."""
    grid = sheet.subplots(2, 4)
    arm = 1 / float(np.max(np.abs(result.shapes[TURNS]))) if np.any(result.shapes[TURNS]) else 1.0
    weights = [1.0 if unit == "m" else arm for unit in UNITS]
    names = ["$x$", "$y$", r"$\varphi$", r"$\theta_x$", r"$\theta_y$", "$z$", r"$\gamma$"]
    for k, axes in enumerate(grid.flat):
        if k >= len(COORDINATES):
            axes.axis("off")
            continue
        colors = [CURVES[0]["color"] if unit == "m" else CURVES[1]["color"] for unit in UNITS]
        axes.bar(names, result.shapes[:, k] * weights, color=colors, width=0.6, zorder=3)
        axes.axhline(0, color=INK, linewidth=0.8)
        axes.set_ylim(-1.15, 1.15)
        hertz = float(result.frequency[k]) / (2 * np.pi)
        axes.set_title(f"{k + 1}: {number(hertz, 5)} Hz, {number(60 * hertz, 5)} rpm", fontsize=8)
        axes.grid(True, axis="y", linewidth=0.35, color="#d0d0d0", zorder=0)


def _curve(sheet: SubFigure, result: VibratorResult, curve: Curve) -> None:
    upper, lower = sheet.subplots(2, 1, sharex=True)
    for axes, rows, factor, label, first in (
        (upper, SHIFTS, 1e3, "amplitude, mm", 0),
        (lower, TURNS, 180 / np.pi, "amplitude, °", 3),
    ):
        lines = [(COORDINATES[k], factor * curve.amplitude[k]) for k in rows if np.any(curve.amplitude[k] > 0)]
        if not lines:
            continue
        top = max(float(np.max(values)) for _, values in lines)
        diagram(axes, curve.omega * RPM, lines, label, first=first, logarithmic=True)
        axes.set_ylim(LOWEST * top, 2 * top)
        marked(axes, (result.frequency * RPM).tolist())
        if result.steady is not None:
            axes.axvline(result.steady.speed * RPM, color=MARK, linewidth=1.0, zorder=2)
    lower.set_xlabel("speed of the rotor, rpm")


def _start(sheet: SubFigure, result: VibratorResult, start: Start | MotorStart) -> None:
    speed, shifts, turns = sheet.subplots(3, 1, sharex=True)
    course = start.course
    diagram(speed, course.t, [("rotor", course.omega * RPM)], "speed, rpm")
    reached = float(np.max(course.omega)) * RPM
    own = [(k, w) for k, w in enumerate((result.frequency * RPM).tolist(), 1) if w < 1.15 * reached]
    levels(speed, [w for _, w in own], [str(k) for k, _ in own])
    diagram(shifts, course.t, _moved(course.q, SHIFTS, 1e3), "mm")
    diagram(turns, course.t, _moved(course.q, TURNS, 180 / np.pi), "°", first=3)
    turns.set_xlabel("$t$, s")


def _moved(q: Values, rows: list[int], factor: float) -> list[tuple[str, Values]]:
    return [(COORDINATES[k], factor * q[k]) for k in rows]


def _paths(sheet: SubFigure, result: VibratorResult) -> None:
    """In space and from above, enlarged about the places at rest."""
    space: Any = sheet.add_subplot(1, 2, 1, projection="3d")
    plan = sheet.add_subplot(1, 2, 2)
    places = np.array([each.at for each in result.paths])
    size = float(np.max(np.ptp(places, axis=0))) if len(places) > 1 else spread(float(np.max(np.abs(places))))
    widest = spread(max(each.major for each in result.paths))
    factor = ENLARGED * spread(size) / widest
    for k, each in enumerate(result.paths):
        at = 1e3 * (each.at + factor * each.path)
        style = CURVES[k % len(CURVES)]
        space.plot(at[:, 0], at[:, 1], at[:, 2], linewidth=1.2, label=each.name, **style)
        plan.plot(at[:, 0], at[:, 1], linewidth=1.2, label=each.name, **style)
        plan.plot(1e3 * each.at[0], 1e3 * each.at[1], "o", markersize=2.5, color=style["color"])
        plan.plot(at[0, 0], at[0, 1], "D", markersize=3.5, markerfacecolor="white", color=style["color"])
    space.set_xlabel("$x$, mm")
    space.set_ylabel("$y$, mm")
    space.set_zlabel("$z$, mm")
    space.set_title(f"paths {number(factor, 3)} times enlarged", fontsize=8)
    _plan(plan)


def _plan(axes: Axes) -> None:
    axes.set_aspect("equal", adjustable="datalim")
    axes.margins(0.12)
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_xlabel("$x$, mm")
    axes.set_ylabel("$y$, mm")
    axes.set_title(r"from above; a diamond is $\psi = 0$", fontsize=8)
    axes.legend(loc="upper right", ncols=4)
