"""The pictures of a six-bar with a dwell: the mechanism at dwell, both branches of Gamma, motion, forces."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tmmcalc.core.plane import Real
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.pictures.cycle import whole_cycle
from tmmcalc.linkage.pictures.scheme import draw_scheme, prepare
from tmmcalc.linkage.synthesis.dwell.results import Dwell
from tmmcalc.linkage.synthesis.results import Design
from tmmcalc.report.drawing.curves import Diagram, Line, bottom
from tmmcalc.report.drawing.key import Part, Sample, write_key
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES

DEGREE = math.degrees(1.0)
OWN: dict[str, Any] = {"linewidth": 1.1, "zorder": 12.5, **CURVES[2]}
OTHER: dict[str, Any] = {"linewidth": 1.1, "zorder": 12.4, **CURVES[3]}
DWELL = {"color": "#f2e6c9", "zorder": 0.5}
SKIPPED = ("x_E", "y_E", "x_D2", "y_D2", "x_F", "y_F")  # sizes that the key leaves to the table


def dwell_figure(mechanism: Mechanism, design: Design, dwell: Dwell) -> Figure:
    """A sheet with the mechanism in position 1, and one with the diagrams over the turn of the crank."""
    motion = solve_kinematics(mechanism)
    figure, (first, second) = blank(2)
    first.suptitle(f"{design.name}, dwell of {signed(DEGREE * dwell.dwell_angle, 5)}°", fontsize=10)
    grid = first.add_gridspec(1, 2, width_ratios=[2.4, 1.0])
    scheme, key = first.add_subplot(grid[0, 0]), first.add_subplot(grid[0, 1])
    key.set_axis_off()
    cycle = whole_cycle(chain_of(mechanism, motion), motion)
    prepare(scheme, cycle)
    left, right = second.subfigures(1, 2, squeeze=False)[0]
    drawn = [*_panels(left, _of_motion(dwell), dwell), *_panels(right, _of_forces(dwell), dwell)]
    settle(figure)
    board = draw_scheme(scheme, motion, cycle, [0])
    board.line(dwell.slots.own, weight=0.3, **OWN)
    board.line(dwell.slots.other, weight=0.3, **OTHER)
    for diagram, axes in drawn:
        diagram.label(axes)
    write_key(key, _key(design, dwell))
    return figure


def _key(design: Design, dwell: Dwell) -> list[Part]:
    sizes = [
        (_formula(size.symbol), _shown(size.value, size.unit)) for size in design.sizes if size.symbol not in SKIPPED
    ]
    checks = [(check.name.replace("|S|", "$|S|$"), _shown(check.achieved, check.unit)) for check in design.checks]
    samples = [
        Sample("slot $\\Gamma$ of the crank pin $A$ in link 5", OWN),
        Sample("its other branch", OTHER),
        Sample("dwell, in the diagrams", DWELL, fill=True),
    ]
    return [Part("Sizes", sizes), Part("By simulation", checks), Part("Lines", samples=samples)]


def _formula(symbol: str) -> str:
    letter, _, index = symbol.partition("_")
    greek = {"phi": "\\varphi", "psi": "\\psi", "alpha": "\\alpha"}.get(letter, letter)
    return f"${greek}_{{\\mathrm{{{index}}}}}$" if index else f"${greek}$"


def _shown(value: float, unit: str) -> str:
    if unit == "rad":
        return f"{signed(DEGREE * value, 6)}°"
    return f"{signed(1e3 * value, 6)} mm" if unit == "m" else signed(value, 5)


def _of_motion(dwell: Dwell) -> list[Diagram]:
    """S with the place of B, and both transfer functions."""
    factor, unit = (1e3, "mm") if dwell.output == "slider" else (DEGREE, "°")
    fine, rows = dwell.fine, dwell.motion
    ends = [(each.at, factor * each.value) for each in dwell.extremes]
    far = max(ends, key=lambda end: abs(end[1]))
    return [
        _diagram(dwell, "S", unit, [("$S$", factor * fine.s, factor * rows.s, (far,))]),
        _diagram(dwell, "x_B", "mm", [("$x_B$", 1e3 * fine.b.real, 1e3 * rows.b.real, ())]),
        _diagram(dwell, "S'", unit, [("$S'$", factor * fine.ds, factor * rows.ds, ())]),
        _diagram(dwell, "S''", unit, [("$S''$", factor * fine.dds, factor * rows.dds, ())]),
    ]


def _of_forces(dwell: Dwell) -> list[Diagram]:
    """Forces of the bars and the crank, pressure angle, driving moment."""
    fine, rows = dwell.fine, dwell.motion
    forces = [
        ("$R_{35}$", fine.f3, rows.f3, ()),
        ("$R_{45}$", fine.f4, rows.f4, ()),
        ("$R_{21}$", fine.r21, rows.r21, ()),
    ]
    return [
        _diagram(dwell, "R", "N", forces),
        _diagram(dwell, "\\delta", "°", [("$\\delta$", DEGREE * fine.delta, DEGREE * rows.delta, ())]),
        _diagram(dwell, "M_1", "N*m", [("$M_1$", fine.moment, rows.moment, ())]),
    ]


Curve = tuple[str, Real, Real, tuple[tuple[float, float], ...]]


def _diagram(dwell: Dwell, symbol: str, unit: str, curves: Sequence[Curve]) -> Diagram:
    lines = tuple(Line(name, v, at, style, marks) for (name, v, at, marks), style in zip(curves, CURVES, strict=False))
    return Diagram(symbol, unit, True, dwell.fine.phi, dwell.motion.phi, lines)


def _panels(part: Any, diagrams: Sequence[Diagram], dwell: Dwell) -> list[tuple[Diagram, Axes]]:
    """The diagrams one under another, the dwell shaded."""
    panels = np.ravel(part.subplots(len(diagrams), 1)).tolist()
    for diagram, axes in zip(diagrams, panels, strict=True):
        diagram.draw(axes)
        if len(diagram.lines) > 1:
            diagram.legend(axes, len(diagram.lines))
        for low, high in _rests(dwell):
            axes.axvspan(DEGREE * low, DEGREE * high, **DWELL)
    bottom(panels, True)
    return list(zip(diagrams, panels, strict=True))


def _rests(dwell: Dwell) -> list[tuple[float, float]]:
    """The dwell, turns of the crank along the motion: between the strokes."""
    ends = sorted((dwell.working, dwell.idle))
    after = max(end for _, end in ends)
    before = min(begin for begin, _ in ends)
    return [(low, high) for low, high in ((0.0, before), (after, 2 * math.pi)) if high - low > 1e-9]
