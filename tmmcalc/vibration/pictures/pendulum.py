"""The picture of the pendulum-rotor: mode shapes along the hanging rod, Campbell diagram, path of the lower end."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure, SubFigure

from tmmcalc.report.drawing.axes import diagram, thinned
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.style import CURVES, INK, MARK, PATH, THIN
from tmmcalc.report.numbers import number
from tmmcalc.vibration.pendulum.results import Campbell, PendulumResult
from tmmcalc.vibration.pendulum.swing import SwingCourse
from tmmcalc.vibration.pictures.sheets import Sheet, sheets_of

RPM = 30 / np.pi


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return pendulum_figure(order.results["pendulum"])


def pendulum_figure(result: PendulumResult) -> Figure:
    """A sheet each of shapes, Campbell diagram and motion, as far as there are results."""
    sheets: list[Sheet] = [("Mode shapes", lambda sheet: _shapes(sheet, result))]
    if result.campbell is not None:
        campbell = result.campbell
        sheets.append(("Campbell diagram", lambda sheet: _campbell(sheet, result, campbell)))
    if result.swing is not None:
        swing = result.swing
        sheets.append(("Motion of the lower end", lambda sheet: _swing(sheet, swing)))
    return sheets_of(sheets)


def _shapes(sheet: SubFigure, result: PendulumResult) -> None:
    grid: Any = sheet.subplots(1, len(result.modes), sharey=True, squeeze=False)[0]
    for axes, modes in zip(grid, result.modes, strict=True):
        axes.axvline(0, color=THIN, linewidth=0.8)
        for k, shape in enumerate(modes.shapes):
            hertz = float(modes.frequency[k]) / (2 * np.pi)
            style = CURVES[k % len(CURVES)]
            axes.plot(shape, 1e3 * result.place, linewidth=1.3, label=f"{k + 1}: {number(hertz, 5)} Hz", **style)
        axes.set_xlim(-1.15, 1.15)
        axes.grid(True, linewidth=0.35, color="#d0d0d0")
        axes.set_title(modes.name, fontsize=8)
        axes.set_xlabel("displacement, largest 1")
        axes.legend(loc="lower right", frameon=True, framealpha=0.9, edgecolor="none")
    grid[0].set_ylabel("$a$ along the rod, mm")
    grid[0].invert_yaxis()


def _campbell(sheet: SubFigure, result: PendulumResult, campbell: Campbell) -> None:
    """Frequencies over the spin with the line of the spin itself, and the whirl of the unbalance."""
    drawn = sheet.subplots(2 if len(campbell.whirl) else 1, 1, sharex=True, squeeze=False)[:, 0]
    axes = drawn[0]
    spin = campbell.spin * RPM
    for k in range(campbell.modes):
        for name, rows, style in (("forward", campbell.forward, CURVES[0]), ("backward", campbell.backward, CURVES[1])):
            label = name if k == 0 else None
            axes.plot(spin, rows[k] * RPM, linewidth=1.2, label=label, **style)
    axes.plot(spin, spin, color=INK, linewidth=1.0, label="spin")
    seen = [w for w in result.forward_critical.tolist() if campbell.spin[0] <= w <= campbell.spin[-1]]
    axes.plot(np.array(seen) * RPM, np.array(seen) * RPM, "D", markersize=4, markerfacecolor="white", color=MARK)
    axes.set_ylim(0, max(1.6 * float(spin[-1]), 1.3 * float(campbell.forward[0, -1]) * RPM))
    axes.set_xlim(float(spin[0]), float(spin[-1]))
    axes.grid(True, linewidth=0.35, color="#d0d0d0")
    axes.set_ylabel("whirl, 1/min")
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=4, handlelength=3, borderaxespad=0.3)
    if len(campbell.whirl):
        size = 1e3 * np.abs(campbell.whirl)
        low, high = 1e-2 * float(np.median(size)), 1e2 * float(np.median(size))
        drawn[1].semilogy(spin, np.clip(size, low, high), linewidth=1.2, **CURVES[2])
        drawn[1].set_ylim(low, high)
        drawn[1].grid(True, linewidth=0.35, color="#d0d0d0")
        drawn[1].set_ylabel("whirl of the unbalance, mm")
    drawn[-1].set_xlabel("spin, rpm")


def _swing(sheet: SubFigure, swing: SwingCourse) -> None:
    halves: Any = sheet.subfigures(1, 2)
    left, right = halves
    path = left.subplots()
    path.plot(1e3 * swing.v, 1e3 * swing.w, linewidth=0.9, color=PATH)
    path.plot(1e3 * swing.v[0], 1e3 * swing.w[0], "D", markersize=4, markerfacecolor="white", color=MARK)
    path.set_aspect("equal", adjustable="datalim")
    path.grid(True, linewidth=0.35, color="#d0d0d0")
    path.set_xlabel("$v$ from under the joint, mm")
    path.set_ylabel("$w$, mm")
    upper, lower = right.subplots(2, 1, sharex=True)
    rows = thinned(swing.t)
    t = swing.t[rows]
    diagram(upper, t, [("$v$", 1e3 * swing.v[rows]), ("$w$", 1e3 * swing.w[rows])], "mm")
    diagram(lower, t, [("$x_O$", swing.carrier_x[rows]), ("$y_O$", swing.carrier_y[rows])], "joint, m", first=2)
    lower.set_xlabel("$t$, s")
