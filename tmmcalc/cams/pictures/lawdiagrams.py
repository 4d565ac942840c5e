"""Diagrams of the follower's motion one under another: displacement and its derivatives over the turn of the cam."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees

import numpy as np

from tmmcalc.cams.lawresult import POINTS, LawResult
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pictures.phasenames import PhaseRow, draw_phases, line_phases, phase_row
from tmmcalc.cams.pictures.toscale import FACTORS, ends_to_scale, heights_to_scale, turn_to_scale, write_factors
from tmmcalc.cams.program import Program
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import DOTTED, input_axis, stacked
from tmmcalc.report.drawing.diagram import Axis, Diagram, room
from tmmcalc.report.drawing.pens import CURVES, MARK, MIDDLE, WHITE, Pen
from tmmcalc.report.drawing.shapes import Drawing, arrowhead
from tmmcalc.report.language import tr_unit
from tmmcalc.report.numbers import number

DENSE = 120  # points of a piece of the motion
JUMP = Pen("JUMPS", 0.2, (0.8, 0.8), "#6b6b6b")
JUMP_ON_FRAME = Pen("JUMPS_ON_FRAME", 0.35, (0.8, 0.8), WHITE)  # gaps in the frame's line
STROKE = Pen("STROKE", 0.25, colour=MARK.colour)
ENDS = Pen("ENDS_OF_PHASES", 0.18, colour="#b8b8b8")
POINT = 2.5  # between the names of the phases and the highest curve, for the names of its points [mm]
AIR = 0.16  # of the height of a curve, above and below it

Pieces = list[tuple[Values, Values]]


def draw_laws(
    drawing: Drawing,
    box: Box,
    program: Program,
    result: LawResult,
    orders: Sequence[int],
    heights: Sequence[float] = (),
    *,
    to_scale: bool = False,
) -> list[Diagram]:
    """Diagrams of derivatives of these orders, the phases named in the first; 0 is the displacement itself.

    ``to_scale``: scale factors are standard ones, and stand above.
    """
    pieces = pieces_of(program)
    inner = box.inset(0, 0, 0, FACTORS if to_scale else 0)
    frames = stacked(inner, [0] * len(orders), heights)
    row = _row(result, (turn_to_scale(frames[0]) if to_scale else frames[0]).width)
    if to_scale:
        spans = [float(np.ptp(_ends(pieces, order, result))) for order in orders]
        heights = heights_to_scale(spans, sum(frame.height for frame in frames) - row.height)
        heights[0] += row.height
        frames = [turn_to_scale(frame) for frame in stacked(inner, [0] * len(orders), heights)]
    along = input_axis(True, np.degrees(np.array([0.0, pieces[-1][0][-1]])))
    found = []
    for k, (order, frame) in enumerate(zip(orders, frames, strict=True)):
        low, high = _ends(pieces, order, result)
        ends = low, low + (high - low) * frame.height / (frame.height - row.height * (k == 0))
        if to_scale:
            ends = ends_to_scale(ends, frame.height)
        up = Axis(axis_name(result, order), *ends)
        diagram = _draw(drawing, frame, order, pieces, result, along, up, numbered=k + 1 == len(orders))
        if order:
            _name_extremes(diagram, order, result)
        else:
            _name_stroke(diagram, result)
        if k == 0:
            draw_phases(diagram, row, ENDS)
        else:
            line_phases(diagram, row.ends, ENDS)
        found.append(diagram)
    if to_scale:
        write_factors(drawing, box, found, [(symbol(result, order), unit_of(result, order)) for order in orders])
    return found


def _row(result: LawResult, room: float) -> PhaseRow:
    """The names of the phases over a diagram as wide as ``room`` [mm]."""
    ends = np.degrees([result.phases[0].begin, *(phase.end for phase in result.phases)])
    row = phase_row([phase.kind for phase in result.phases], ends, room)
    return row._replace(height=row.height + POINT)


def symbol(result: LawResult, order: int) -> str:
    """The sign of a derivative, of the displacement itself with its Δ, inside a formula."""
    letter = "ψ" if result.turns else "S"
    return f"Δ{letter}" if order == 0 else letter + "'" * order


def unit_of(result: LawResult, order: int) -> str:
    """The unit of a derivative by the angle of the cam; that of an angle by an angle has none."""
    return tr_unit(("°", "", "1/rad", "1/rad²")[order] if result.turns else "mm")


def axis_name(result: LawResult, order: int) -> str:
    """The name of the ordinate with its unit."""
    unit = unit_of(result, order)
    return f"${symbol(result, order)}$, {unit}" if unit else f"${symbol(result, order)}$"


def shown_scale(result: LawResult, order: int) -> float:
    """Factor from SI to what is shown."""
    if not result.turns:
        return 1e3
    return degrees(1.0) if order == 0 else 1.0


def pieces_of(program: Program) -> Pieces:
    """Angles (m,) and the motion (4, m) of every piece, up to both its ends."""
    found = []
    for number_of, (low, high) in enumerate(zip(program.edges[:-1], program.edges[1:], strict=True)):
        phi = np.linspace(low, high, DENSE)
        found.append((phi, program.at(phi, np.full(DENSE, number_of))))
    return found


def _ends(pieces: Pieces, order: int, result: LawResult) -> tuple[float, float]:
    """The ends of an ordinate."""
    factor = shown_scale(result, order)
    low, high = room([factor * motion[order] for _, motion in pieces], AIR, AIR)
    if order == 0:
        low, high = min(-0.2 * factor * result.stroke, low), max(1.15 * factor * result.stroke, high)
    return low, high


def _draw(
    drawing: Drawing,
    box: Box,
    order: int,
    pieces: Pieces,
    result: LawResult,
    along: Axis,
    up: Axis,
    *,
    numbered: bool,
) -> Diagram:
    """One diagram with its curve, jumps, positions and the ends of the phases."""
    factor, pen = shown_scale(result, order), CURVES[order]._replace(dashes=())
    values = [factor * motion[order] for _, motion in pieces]
    diagram = Diagram(drawing, box, along, up, numbered=numbered)
    for (phi, _), heights in zip(pieces, values, strict=True):
        diagram.curve(np.degrees(phi) + 1j * heights, pen)
    _jumps(diagram, order, [phi for phi, _ in pieces], values)
    rows = result.positions
    if len(rows.phi) <= DOTTED:
        diagram.dots(np.degrees(rows.phi), factor * result.motion[order], pen)
    return diagram


def _jumps(diagram: Diagram, order: int, angles: list[Values], values: list[Values]) -> None:
    """Dashed lines where a derivative jumps; at the ends of the turn gaps in the frame."""
    largest = max(float(np.max(np.abs(each))) for each in values)
    for before, phi, after in zip(values, [*angles[1:], angles[0]], [*values[1:], values[0]], strict=True):
        if not order or abs(after[0] - before[-1]) <= 1e-9 * largest:
            continue
        inner = bool(phi[0])
        for at in (degrees(phi[0]),) if inner else (diagram.x.low, diagram.x.high):
            ends = diagram.paper([complex(at, before[-1]), complex(at, after[0])])
            diagram.drawing.line(ends, JUMP if inner else JUMP_ON_FRAME, level=3)


def _name_extremes(diagram: Diagram, order: int, result: LawResult) -> None:
    factor, pen = shown_scale(result, order), CURVES[order]._replace(dashes=())
    for each in result.extremes:
        if each.order == order:
            value = factor * each.value
            diagram.mark(complex(degrees(each.phi), value), number(value, 4), pen)


def _name_stroke(diagram: Diagram, result: LawResult) -> None:
    """The points a, b, c, d at which the phases begin, and the stroke."""
    names, factor = _points(result), shown_scale(result, 0)
    top, place = factor * result.stroke, degrees(result.phases[0].end)
    foot, head = diagram.place(complex(place)), diagram.place(complex(place, top))
    diagram.drawing.vector(foot, head, STROKE, level=5)
    diagram.drawing.add(arrowhead(foot, -1j, STROKE), level=5)
    diagram.labels.avoid([foot, head])
    for phase in result.phases:
        at = diagram.point(complex(degrees(phase.begin), factor * phase.low), MIDDLE)
        diagram.labels.put(f"${names[phase.kind]}$", [at], height=2.3, prefer=1 + 1j if phase.low else -1 - 1j)
    letter = "$ψ_m$" if result.turns else "$h$"
    diagram.labels.put(letter, [foot + 0.4 * (head - foot)], height=2.3, prefer=1 + 0j, colour=MARK.colour)


def _points(result: LawResult) -> dict[str, str]:
    """The names of the points at which the phases begin; two names where a dwell takes no angle."""
    kinds = [phase.kind for phase in result.phases]
    names: dict[str, str] = dict(POINTS)
    if "high dwell" not in kinds:
        names["return"] = "b, c"
    if "low dwell" not in kinds:
        names["rise"] = "a, d"
    return names
