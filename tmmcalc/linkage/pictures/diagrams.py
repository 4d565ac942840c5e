"""Diagrams of the outputs over the input coordinate: displacement, velocity, acceleration, one under another."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from tmmcalc.core.plane import Real
from tmmcalc.core.records import record
from tmmcalc.linkage.model import Output
from tmmcalc.linkage.outputs import coordinate_of, default_outputs
from tmmcalc.linkage.pictures.cycle import TURN, LinkageMotion, along, closed
from tmmcalc.linkage.results import Kinematics, OutputSummary
from tmmcalc.linkage.trace import unwrapped
from tmmcalc.report.drawing.curves import DOTTED, bottom, coordinate, frame, mark
from tmmcalc.report.drawing.labels import Labels, escaped, signed
from tmmcalc.report.drawing.style import CURVES
from tmmcalc.report.numbers import number

NARROW = 0.08  # names of dead centres that stand closer than this part of the range would touch
Row = tuple[Real, Real, Real]


@record
class OutputCurve:
    """One output: S, v, a over the dense cycle and at the positions, in SI."""

    name: str  # index of the symbols: the point or link, with the direction if there are two of a point
    angular: bool
    dense: Row
    nodes: Row
    start: float  # coordinate of the output in position 0
    summary: OutputSummary | None
    style: dict[str, Any]


def columns_of(result: Kinematics, cycle: LinkageMotion) -> list[list[OutputCurve]]:
    """Outputs that share their panels: linear ones in one column, angular ones in another."""
    outputs = default_outputs(cycle.chain)
    curves = [_curve(result, cycle, k, output, outputs) for k, output in enumerate(outputs)]
    groups = ([c for c in curves if c.angular is angular] for angular in (False, True))
    return [_restyled(group) for group in groups if group]


def _restyled(group: list[OutputCurve]) -> list[OutputCurve]:
    return [replace(c, style=CURVES[k % len(CURVES)]) for k, c in enumerate(group)]


def _curve(result: Kinematics, cycle: LinkageMotion, k: int, output: Output, outputs: Sequence[Output]) -> OutputCurve:
    raw = coordinate_of(cycle.chain, output, cycle.configuration)
    value, rate, rate2 = (np.broadcast_to(v, cycle.x.shape) for v in raw)
    value = unwrapped(value) if output.link is not None else value
    twice = sum(other.name == output.name for other in outputs) > 1
    name = escaped(output.name)
    name = rf"{name},{number(math.degrees(output.direction), 4)}^\circ" if twice else name
    summary = result.summaries[k] if k < len(result.summaries) else None
    nodes = (result.s[k], *result.in_time(result.ds[k], result.dds[k]))
    dense = (value - value[0], *result.in_time(rate, rate2))
    return OutputCurve(name, output.link is not None, dense, nodes, float(value[0]), summary, {})


def draw_diagrams(
    panels: Sequence[Axes], result: Kinematics, cycle: LinkageMotion, curves: Sequence[OutputCurve], ticks: int
) -> None:
    """Draw the curves of one column on its three panels, ``ticks`` wide; texts follow by `label_diagrams`."""
    full = closed(cycle.chain)
    x, x_nodes = (coordinate(result.turns, v) for v in (cycle.x - result.x[0], result.phi))
    for kind, axes in enumerate(panels):
        factor, label = _quantity(curves, kind)
        for curve in curves:
            axes.plot(x, curve.dense[kind] * factor, linewidth=1.3, zorder=4, **curve.style)
            if len(x_nodes) <= DOTTED:
                dots = {"markersize": 2.4, "color": curve.style["color"], "zorder": 5, "linestyle": ""}
                axes.plot(x_nodes, curve.nodes[kind] * factor, "o", **dots)
        frame(axes, label, x, result.turns, ticks)
    bottom(panels, result.turns)
    for curve in curves:
        for centre in _dead_centres(result, curve, full):
            for axes in panels:
                axes.axvline(centre, linestyle=(0, (4, 3)), linewidth=0.7, color=curve.style["color"], zorder=2)
    if len(curves) > 1:
        lines = [Line2D([], [], label=f"${_symbol(curve, 0)}$", linewidth=1.3, **curve.style) for curve in curves]
        place: dict[str, Any] = {"loc": "lower center", "bbox_to_anchor": (0.5, 1.07), "ncols": len(curves)}
        panels[0].legend(handles=lines, handlelength=3, borderaxespad=0, **place)


def _quantity(curves: Sequence[OutputCurve], kind: int) -> tuple[float, str]:
    """Factor from SI and label of a panel."""
    symbol = _symbol(curves[0], kind) if len(curves) == 1 else _letter(curves[0], kind)
    if curves[0].angular:
        return ((180 / math.pi, 1.0, 1.0)[kind], f"${symbol}$, {('°', 'rad/s', 'rad/s²')[kind]}")
    small = max(float(np.max(np.abs(c.dense[0]))) for c in curves) < 2.0
    if kind == 0 and small:
        return 1000.0, f"${symbol}$, mm"
    return 1.0, f"${symbol}$, {('m', 'm/s', 'm/s²')[kind]}"


def _letter(curve: OutputCurve, kind: int) -> str:
    return ("\\Delta\\varphi", "\\omega", "\\varepsilon")[kind] if curve.angular else "Sva"[kind]


def _symbol(curve: OutputCurve, kind: int) -> str:
    return f"{_letter(curve, kind)}_{{\\mathrm{{{curve.name}}}}}"


def _dead_centres(result: Kinematics, curve: OutputCurve, full: bool) -> list[float]:
    if curve.summary is None:
        return []
    turned = [along(result, centre.x, full) for centre in curve.summary.dead_centres]
    return [float(coordinate(result.turns, np.array(v))) for v in turned]


def label_diagrams(
    panels: Sequence[Axes], result: Kinematics, cycle: LinkageMotion, curves: Sequence[OutputCurve]
) -> None:
    """Mark and name extreme values and dead centres; the layout of the figure must be settled."""
    full = closed(cycle.chain)
    x = coordinate(result.turns, cycle.x - result.x[0])
    for kind, axes in enumerate(panels):
        factor, _ = _quantity(curves, kind)
        labels = Labels(axes)
        for curve in curves:
            labels.avoid(x + 1j * curve.dense[kind] * factor, 0.7)
            for centre in _dead_centres(result, curve, full):
                labels.avoid([complex(centre, v) for v in axes.get_ylim()], 0.3)
        for curve in curves:
            for at, value in _extremes(result, curve, kind, full):
                mark(axes, labels, complex(at, value * factor), curve.style)
    _name_dead_centres(panels[0], result, curves, full)


def _extremes(result: Kinematics, curve: OutputCurve, kind: int, full: bool) -> list[tuple[float, float]]:
    """Diagram coordinate and SI value of the extremes of one quantity."""
    if curve.summary is None:
        return []
    if kind == 0:
        places = _dead_centres(result, curve, full)
        values = (_travelled(curve, centre.value) for centre in curve.summary.dead_centres)
        return [(at, s) for at, s in zip(places, values, strict=True) if abs(s) > 1e-9 * np.ptp(curve.dense[0])]
    pair = curve.summary.velocity if kind == 1 else curve.summary.acceleration
    turned = np.array([along(result, extreme.x, full) for extreme in pair])
    return list(zip(coordinate(result.turns, turned).tolist(), (extreme.value for extreme in pair), strict=True))


def _travelled(curve: OutputCurve, value: float) -> float:
    """Displacement at a dead centre from its coordinate; an angle on the branch of the curve."""
    s = value - curve.start
    if curve.angular:
        low, high = float(curve.dense[0].min()), float(curve.dense[0].max())
        s += TURN * round(((low + high) / 2 - s) / TURN)
    return s


def _name_dead_centres(axes: Axes, result: Kinematics, curves: Sequence[OutputCurve], full: bool) -> None:
    """The coordinates of the dead centres above the uppermost panel; of two neighbours each gives way to its side."""
    span = abs(axes.get_xlim()[1] - axes.get_xlim()[0])
    found = sorted(
        (abs(centre), centre, curve.style["color"]) for curve in curves for centre in _dead_centres(result, curve, full)
    )
    apart = [item for k, item in enumerate(found) if k == 0 or item[0] - found[k - 1][0] > 1e-3 * span]
    places = [item[0] for item in apart]
    for k, (place, centre, color) in enumerate(apart):
        before = k > 0 and place - places[k - 1] < NARROW * span
        after = k + 1 < len(places) and places[k + 1] - place < NARROW * span
        side = "center" if before == after else "left" if before else "right"
        text = f"{signed(round(centre, 2), 6)}{'°' if result.turns else ''}"
        style = {"fontsize": 6.5, "ha": side, "va": "bottom", "color": color}
        axes.text(centre, 1.015, text, transform=axes.get_xaxis_transform(), **style)
