"""Wittenbauer's picture: the closed energy-mass curve, its two outer tangents, the segment GH on the axis of energies.

Abscissa is the reduced inertia J of the links, ordinate the change A of the kinetic energy since position 0. Both
tangents meet far to the left and below, in the origin of the whole inertia and the whole energy.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter, MaxNLocator

from tmmcalc.machine.flywheel.wittenbauer import EnergyMass
from tmmcalc.report.drawing.curves import suited
from tmmcalc.report.drawing.labels import Labels, signed
from tmmcalc.report.drawing.style import CURVES, INK
from tmmcalc.report.numbers import NOISE

CURVE: dict[str, Any] = {"linewidth": 1.5, "zorder": 5, **CURVES[0]}
FAST: dict[str, Any] = {"linewidth": 1.2, "zorder": 4, **CURVES[1]}
SLOW: dict[str, Any] = {"linewidth": 1.2, "zorder": 4, **CURVES[2]}
NUMBERED = 12  # places of the cycle that are named
LEFT, RIGHT = 0.16, 0.1  # of the largest inertia, beside the axis and the curve


def draw_energy_mass(axes: Axes, picture: EnergyMass) -> None:
    """Curve, tangents and the axis of energies."""
    factor, unit = scale(picture)
    widest = float(np.max(picture.links)) or abs(picture.inertia) or 1.0
    x = np.array([-LEFT * widest, (1 + RIGHT) * widest])
    for slope, intercept, style in zip(picture.slopes, picture.intercepts, (FAST, SLOW), strict=True):
        axes.plot(x, (intercept + slope * x) * factor, **style)
    axes.plot(picture.links, picture.work * factor, **CURVE)
    axes.axvline(0, color="#333333", linewidth=1.1, zorder=2)
    axes.axhline(0, color="#333333", linewidth=0.8, zorder=1.5)
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_axisbelow(True)
    axes.set_xlim(*x)
    axes.margins(y=0.1)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(6))
        axis.set_major_formatter(FuncFormatter(lambda v, _: signed(v, 6)))
    axes.set_xlabel("$J$ of the links, kg·m²")
    axes.set_ylabel(f"$A$, {unit}")
    axes.tick_params(length=2.5)
    axes.set_title(_meeting(picture), loc="left", fontsize=7.5)


def _meeting(picture: EnergyMass) -> str:
    factor, unit = suited(picture.energy, "J")
    origin = f"$J$ = {signed(-picture.inertia, 4)} kg·m², $A$ = {signed(-picture.energy * factor, 4)} {unit}"
    first = "Energy-mass curve; numbers: degrees of $\\varphi$; slopes: half the squares of the extreme speeds"
    return f"{first}\nthe tangents meet at {origin}"


def scale(picture: EnergyMass) -> tuple[float, str]:
    """Factor and unit of the energies."""
    return suited(max(float(np.max(np.abs(picture.work))), *map(abs, picture.intercepts)), "J")


def label_energy_mass(axes: Axes, picture: EnergyMass, sense: float) -> None:
    """Touching points, intercepts, and the angles along the curve; ``sense`` is that of the input."""
    factor, unit = scale(picture)
    labels = Labels(axes)
    labels.avoid(picture.links + 1j * picture.work * factor, 0.7)
    left, right = axes.get_xlim()
    x = np.array([left, right])
    for slope, intercept in zip(picture.slopes, picture.intercepts, strict=True):
        labels.avoid(x + 1j * (intercept + slope * x) * factor, 0.7)
    _mark_tangents(axes, labels, picture, factor, unit)
    _number(axes, labels, picture, factor, sense)


def _mark_tangents(axes: Axes, labels: Labels, picture: EnergyMass, factor: float, unit: str) -> None:
    """G and H with the segment between them, and the touching points."""
    high, low = (value * factor for value in picture.intercepts)
    axes.annotate("", (0, high), (0, low), arrowprops={"arrowstyle": "<->", "color": INK, "lw": 1.2, "shrinkA": 0})
    labels.avoid([complex(0, low), complex(0, high)], 1.0)
    for name, value, style in (("G", high, FAST), ("H", low, SLOW)):
        axes.plot(0, value, "o", markersize=4, markerfacecolor="white", color=style["color"], zorder=8)
        text = f"{name}: {signed(value, 5)} {unit}"
        labels.put(text, [complex(0, value)], size=7.5, gaps=(1.2, 2.0, 3.0), color=style["color"])
    named = ("max", picture.touching[0], FAST), ("min", picture.touching[1], SLOW)
    for word, theta, style in named:
        inertia, work = _at(picture, theta)
        axes.plot(inertia, work * factor, "D", markersize=4.2, markerfacecolor="white", color=style["color"], zorder=9)
        text = f"$\\omega_\\mathrm{{{word}}}$"
        labels.put(text, [complex(inertia, work * factor)], size=8, gaps=(1.2, 2.0, 3.0), color=style["color"])
    text = f"$GH$ = {signed(high - low, 5)} {unit}"
    labels.put(text, [complex(0, (high + low) / 2)], size=7.5, prefer=1, gaps=(1.2, 2.0, 3.0))


def _number(axes: Axes, labels: Labels, picture: EnergyMass, factor: float, sense: float) -> None:
    """Dots at equal steps of the input with their angles."""
    for theta in np.linspace(0.0, float(picture.theta[-1]), NUMBERED, endpoint=False).tolist():
        inertia, work = _at(picture, theta)
        at = complex(inertia, work * factor)
        axes.plot(at.real, at.imag, "o", markersize=2.6, color=CURVE["color"], zorder=7)
        degrees = math.degrees(theta)
        text = signed(round(sense * degrees if abs(degrees) > NOISE else 0.0, 6), 6)
        labels.put(text, [at], size=6, gaps=(0.8, 1.4, 2.2), color=CURVE["color"])


def _at(picture: EnergyMass, theta: float) -> tuple[float, float]:
    inertia, work = (float(np.interp(theta, picture.theta, v)) for v in (picture.links, picture.work))
    return inertia, work
