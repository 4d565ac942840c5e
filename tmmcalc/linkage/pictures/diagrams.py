"""Diagrams of the outputs over the input coordinate: displacement, velocity, acceleration, one under another."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.core.records import record
from tmmcalc.linkage.model import Output
from tmmcalc.linkage.outputs import coordinate_of, default_outputs
from tmmcalc.linkage.pictures.cycle import TURN, LinkageMotion, along, closed
from tmmcalc.linkage.results import Kinematics, OutputSummary
from tmmcalc.linkage.trace import unwrapped
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import (
    BELOW,
    DOTTED,
    along_input,
    input_axis,
    narrowed,
    scale_factor,
    sides,
    to_scale,
)
from tmmcalc.report.drawing.diagram import HEIGHT, Axis, Curve, Diagram, room
from tmmcalc.report.drawing.lettering import minus, width
from tmmcalc.report.drawing.pens import CURVES, Pen
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr_unit
from tmmcalc.report.numbers import number

NARROW = 0.08  # names of dead centres that stand closer than this part of the range would touch
FACTORS = 6.0  # room of the line of scale factors [mm]
SMALL = 2.0  # an output that goes less far is drawn in mm [m]
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
    pen: Pen


def columns_of(result: Kinematics, cycle: LinkageMotion) -> list[list[OutputCurve]]:
    """Outputs that share their panels: linear ones in one column, angular ones in another."""
    outputs = default_outputs(cycle.chain)
    curves = [_curve(result, cycle, k, output, outputs) for k, output in enumerate(outputs)]
    groups = ([c for c in curves if c.angular is angular] for angular in (False, True))
    return [[replace(c, pen=CURVES[k % len(CURVES)]) for k, c in enumerate(group)] for group in groups if group]


def _curve(result: Kinematics, cycle: LinkageMotion, k: int, output: Output, outputs: Sequence[Output]) -> OutputCurve:
    raw = coordinate_of(cycle.chain, output, cycle.configuration)
    value, rate, rate2 = (np.broadcast_to(v, cycle.x.shape) for v in raw)
    value = unwrapped(value) if output.link is not None else value
    twice = sum(other.name == output.name for other in outputs) > 1
    name = f"{output.name}, {number(math.degrees(output.direction), 4)}°" if twice else output.name
    summary = result.summaries[k] if k < len(result.summaries) else None
    nodes = (result.s[k], *result.in_time(result.ds[k], result.dds[k]))
    dense = (value - value[0], *result.in_time(rate, rate2))
    return OutputCurve(name, output.link is not None, dense, nodes, float(value[0]), summary, CURVES[0])


def draw_diagrams(
    drawing: Drawing,
    box: Box,
    result: Kinematics,
    cycle: LinkageMotion,
    curves: Sequence[OutputCurve],
    *,
    scaled: bool = False,
) -> list[Diagram]:
    """Three diagrams of these outputs in a rectangle; ``scaled``: to standard factors, which stand on top."""
    full, larger = closed(cycle.chain), drawing.letters
    x, nodes = (along_input(result.turns, v) for v in (cycle.x - result.x[0], result.phi))
    abscissa = input_axis(result.turns, x)
    names = len(curves) > 1
    inner = narrowed(box.inset(0, 0, 0, FACTORS * larger), x, larger) if scaled else box
    frames = inner.inset(0, BELOW * larger, 0, larger * (7.0 if names else 2.5)).split(1, 1, 1)
    panels: list[Diagram] = []
    factors: list[str] = []
    for kind, frame in enumerate(frames):
        factor, symbol, unit = _quantity(curves, kind)
        values = [curve.dense[kind] * factor for curve in curves]
        place = frame.inset(*sides(larger))
        ordinate = Axis(f"{symbol}, {tr_unit(unit)}", *room(values))
        if scaled:
            ordinate, mu = to_scale(ordinate, place.height)
            factors.append(scale_factor(_letter(curves[0], kind), mu, unit))
        panel = Diagram(drawing, place, abscissa, ordinate, numbered=kind == 2)
        panels.append(panel)
        centres = [(at, curve.pen) for curve in curves for at in _dead_centres(result, curve, full)]
        for at, pen in centres:
            panel.vertical(at, Pen("DEAD_CENTRES", 0.2, (1.6, 1.2), pen.colour))
        marked = [
            Curve(
                f"${_letter(curve, 0)}_{{{curve.name}}}$",
                value,
                curve.pen,
                tuple(complex(at, v * factor) for at, v in _extremes(result, curve, kind, full)),
            )
            for curve, value in zip(curves, values, strict=True)
        ]
        if len(nodes) <= DOTTED:
            for curve in curves:
                panel.dots(nodes, curve.nodes[kind] * factor, curve.pen)
        panel.draw(x, marked, key=False)
    if names:
        panels[0].key([(f"${_letter(c, 0)}_{{{c.name}}}$", c.pen) for c in curves], lift=3.5 * larger)
    _name_dead_centres(panels[0], result, curves, full)
    if scaled:
        _write_factors(drawing, box, panels[0], result.turns, factors)
    return panels


def _write_factors(drawing: Drawing, box: Box, panel: Diagram, turns: bool, factors: Sequence[str]) -> None:
    """The scale factors on top of the rectangle, that of the abscissa first."""
    along = abs(panel.x.high - panel.x.low) / panel.box.width
    text = ",   ".join([scale_factor("φ", along, "°") if turns else scale_factor("s", along, "mm"), *factors])
    at = complex(panel.box.left, box.top)
    drawing.add(Words(at, text, min(2.5 * drawing.letters, (box.right - at.real) / width(text)), -1 + 1j))


def _quantity(curves: Sequence[OutputCurve], kind: int) -> tuple[float, str, str]:
    """Factor from SI, symbol and unit of a panel."""
    letter = _letter(curves[0], kind)
    symbol = f"${letter}_{{{curves[0].name}}}$" if len(curves) == 1 else f"${letter}$"
    if curves[0].angular:
        return (180 / math.pi, 1.0, 1.0)[kind], symbol, ("°", "rad/s", "rad/s²")[kind]
    small = max(float(np.max(np.abs(c.dense[0]))) for c in curves) < SMALL
    if kind == 0 and small:
        return 1000.0, symbol, "mm"
    return 1.0, symbol, ("m", "m/s", "m/s²")[kind]


def _letter(curve: OutputCurve, kind: int) -> str:
    return ("Δφ", "ω", "ε")[kind] if curve.angular else "Sva"[kind]


def _dead_centres(result: Kinematics, curve: OutputCurve, full: bool) -> list[float]:
    if curve.summary is None:
        return []
    turned = [along(result, centre.x, full) for centre in curve.summary.dead_centres]
    return [float(along_input(result.turns, np.array(v))) for v in turned]


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
    return list(zip(along_input(result.turns, turned).tolist(), (extreme.value for extreme in pair), strict=True))


def _travelled(curve: OutputCurve, value: float) -> float:
    """Displacement at a dead centre from its coordinate; an angle on the branch of the curve."""
    s = value - curve.start
    if curve.angular:
        low, high = float(curve.dense[0].min()), float(curve.dense[0].max())
        s += TURN * round(((low + high) / 2 - s) / TURN)
    return s


def _name_dead_centres(panel: Diagram, result: Kinematics, curves: Sequence[OutputCurve], full: bool) -> None:
    """The coordinates of the dead centres above the uppermost panel; of two neighbours each gives way to its side.

    One that has no room beside that before it is left out; a table tells it.
    """
    span = abs(panel.x.high - panel.x.low)
    found = sorted(
        (abs(centre), centre, curve.pen.colour) for curve in curves for centre in _dead_centres(result, curve, full)
    )
    apart = [item for k, item in enumerate(found) if k == 0 or item[0] - found[k - 1][0] > 1e-3 * span]
    places = [item[0] for item in apart]
    height, free = 0.8 * HEIGHT * panel.drawing.letters, -math.inf
    for k, (place, centre, colour) in enumerate(apart):
        before = k > 0 and place - places[k - 1] < NARROW * span
        after = k + 1 < len(places) and places[k + 1] - place < NARROW * span
        side = 0 if before == after else -1 if before else 1
        text = minus(number(round(centre, 2), 6)) + ("°" if result.turns else "")
        at = complex(panel.place(complex(centre, 0)).real, panel.box.top + 0.9)
        wide = width(text, height)
        start = at.real - wide * (1 + side) / 2
        if start > free:
            free = start + wide
            panel.drawing.add(Words(at, text, height, side - 1j, colour=colour))
