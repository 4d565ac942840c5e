"""Specific sliding and pressure over the line of action (Fig. 4.24), under the mesh that they belong to.

The abscissa is the projection of the line of action on paper, so every point stands below its place in the mesh.
Outside of the contact A2A1 the curves are dashed; zones where two pairs of teeth touch are shaded.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter, MaxNLocator

from tmmcalc.core.plane import Real
from tmmcalc.core.records import record
from tmmcalc.gears.involute.quality.sliding import slide
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.pictures.placedpair import Mark, PlacedPair
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.style import CURVES, INK

SAMPLES = 1201
NEAR = 1e-6  # of the length, between N1 or N2 and the curves
LOWEST, DEEPEST = -2.0, -8.0  # ends of the ordinate of theta
ROOM = 1.25  # of the ordinate over the values of the contact
BEYOND = 1.15  # where there is no N2: how far the curves go, in parts of N1A1
DOUBLE = "#eaf3ea"
GUIDE: dict[str, Any] = {"color": "#7a7a7a", "linewidth": 0.5, "linestyle": (0, (4, 2)), "zorder": 1.5}
OUTSIDE: dict[str, Any] = {"linestyle": (0, (2.5, 2)), "linewidth": 0.9}


@record
class Course:
    """n points of the line of action."""

    rho1: Real  # (n,) [m]
    theta1: Real  # (n,)
    theta2: Real  # (n,)
    pressure: Real  # (n,) lambda


def course(found: MeshPair, rho1: Real) -> Course:
    """Sliding and pressure at distances (n,) from N1, none of them at N1 or N2 (4.71, 4.72)."""
    module, g = found.task.module, found.line.length
    if found.task.kind == "rack":
        pitch = found.line.pitch
        return Course(rho1, 1 - pitch / rho1, 1 - rho1 / pitch, module / rho1)
    rho2 = np.abs(g - rho1)
    theta1, theta2 = slide(rho1, rho2, found.task.teeth[1] / found.task.teeth[0])
    return Course(rho1, theta1, theta2, module * abs(g) / (rho1 * rho2))


def draw_course(upper: Axes, lower: Axes, pair: PlacedPair, limits: tuple[float, float]) -> None:
    """theta above and lambda below; ``limits`` are those of the mesh in x [m]."""
    found = pair.found
    line = found.line
    end = line.length if line.length > 0 else BEYOND * line.end
    # close to each other where the curves are steep, at N1 and N2 and where the picture begins
    shown = sorted(float((x - pair.base_point.real) / pair.direction.real) for x in limits)
    high = min(end, max(shown[1], line.end))
    rho = high * (NEAR + (1 - 2 * NEAR) * np.sin(np.pi / 2 * np.linspace(0, 1, SAMPLES)) ** 2)
    within = np.clip([line.begins, line.ends], rho[0], rho[-1])
    points = course(found, np.sort(np.concatenate([rho, within])))
    x = pair.on_line(points.rho1).real
    active = (points.rho1 >= within[0]) & (points.rho1 <= within[1])
    contact = course(found, within)
    _draw(upper, x, [(points.theta1, "$\\vartheta_1$"), (points.theta2, "$\\vartheta_2$")], active, 0)
    _draw(lower, x, [(points.pressure, "$\\lambda$")], active, 2)
    deepest = min(LOWEST, ROOM * min(float(contact.theta1.min()), float(contact.theta2.min())))
    upper.set_ylim(max(deepest, DEEPEST), 1.25)
    lower.set_ylim(0.0, max(2.0 * float(contact.pressure.min()), min(ROOM * float(contact.pressure.max()), 4.0)))
    for axes in (upper, lower):
        _frame(axes, pair, limits)
    upper.set_ylabel("specific sliding $\\vartheta$")
    lower.set_ylabel("specific pressure $\\lambda$")
    upper.set_xticks([])
    _name_marks(upper, pair, limits)
    _abscissa(lower, pair)


def singles(pair: PlacedPair) -> list[tuple[str, float]]:
    """B2 and B1 with their distances from N1, between which one pair of teeth touches alone; none: never."""
    line = pair.found.line
    double = line.ends - line.begins - pair.pitch
    return [("B2", line.begins + double), ("B1", line.ends - double)] if 0 < double < pair.pitch else []


def _draw(axes: Axes, x: Real, curves: list[tuple[Real, str]], active: np.ndarray, first: int) -> None:
    for k, (y, name) in enumerate(curves):
        color = CURVES[first + k]["color"]
        axes.plot(x, y, color=color, zorder=4, **OUTSIDE)
        axes.plot(x[active], y[active], color=color, linewidth=2.0, zorder=5, label=name)
        ends = np.flatnonzero(active)[[0, -1] if active.any() else []]
        axes.plot(x[ends], y[ends], "o", color=color, markersize=3.2, zorder=6)
    axes.legend(loc="lower center" if first == 0 else "upper center", ncols=2)


def _frame(axes: Axes, pair: PlacedPair, limits: tuple[float, float]) -> None:
    axes.set_xlim(*limits)
    axes.axhline(0, color="#333333", linewidth=0.8, zorder=2)
    axes.grid(True, axis="y", linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.yaxis.set_major_locator(MaxNLocator(7))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda v, _: signed(v, 4)))
    axes.tick_params(length=2.5)
    for mark in pair.marks:
        if limits[0] < mark.at.real < limits[1]:
            axes.axvline(mark.at.real, **GUIDE)
    line, alone = pair.found.line, singles(pair)
    if alone:
        (_, second), (_, first) = alone
        for zone in ((line.begins, second), (first, line.ends)):
            left, right = sorted(float(v) for v in pair.on_line(np.array(zone)).real)
            axes.axvspan(left, right, color=DOUBLE, linewidth=0, zorder=0.5)


def _name_marks(axes: Axes, pair: PlacedPair, limits: tuple[float, float]) -> None:
    """Names of the points above the diagram; those that stand too near one another in a second row."""
    marks = [*pair.marks, *(Mark(name, rho, complex(pair.on_line(rho))) for name, rho in singles(pair))]
    marks.sort(key=lambda mark: mark.at.real)
    shown = [mark for mark in marks if limits[0] < mark.at.real < limits[1]]
    near, rows = 0.024 * (limits[1] - limits[0]), [float("-inf")] * 3
    for mark in shown:
        row = next((k for k, last in enumerate(rows) if mark.at.real - last > near), len(rows) - 1)
        rows[row] = mark.at.real
        text = f"${mark.name[0]}_{mark.name[1]}$" if len(mark.name) > 1 else f"${mark.name}$"
        place: dict[str, Any] = {
            "xytext": (0, 3 + 10 * row),
            "textcoords": "offset points",
            "ha": "center",
            "va": "bottom",
        }
        axes.annotate(text, (mark.at.real, 1.0), xycoords=("data", "axes fraction"), size=8.5, **place)


def _abscissa(axes: Axes, pair: PlacedPair) -> None:
    """Ticks at round distances from N1."""
    limits = axes.get_xlim()
    slope = pair.direction.real
    shown = sorted((x - pair.base_point.real) / slope for x in limits)
    line = pair.found.line
    last = line.length if line.length > 0 else BEYOND * line.end
    low, high = 1e3 * max(shown[0], 0.0), 1e3 * min(shown[1], last)
    found = np.asarray(MaxNLocator(12, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high))
    ticks = found[(found >= low) & (found <= high)].tolist()
    axes.set_xticks([pair.base_point.real + 1e-3 * v * slope for v in ticks], [signed(v, 4) for v in ticks])
    axes.set_xlabel("$\\varrho_1 = N_1K$, mm; the contact moves from $A_2$ to $A_1$ when wheel 1 drives", color=INK)
