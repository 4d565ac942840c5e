"""The picture of the law of motion: displacement and its derivatives over the turn, and the phase portrait S'(S)."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees

import numpy as np

from tmmcalc.cams.lawresult import POINTS, LawResult
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.program import Program
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import DOTTED, input_axis, stacked
from tmmcalc.report.drawing.diagram import Axis, Diagram, one_scale, room
from tmmcalc.report.drawing.lettering import minus, width
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.pens import CURVES, INK, MARK, MIDDLE, WHITE, Pen
from tmmcalc.report.drawing.shapes import Drawing, Words, arrowhead
from tmmcalc.report.numbers import number

DENSE = 120  # points of a piece of the motion
HEIGHTS = (1.3, 1.0, 1.0, 0.9)  # of the diagrams of S, S', S'', S'''
JUMP = Pen("JUMPS", 0.2, (0.8, 0.8), "#6b6b6b")
JUMP_ON_FRAME = Pen("JUMPS_ON_FRAME", 0.35, (0.8, 0.8), WHITE)  # gaps in the frame's line
STROKE = Pen("STROKE", 0.25, colour=MARK.colour)
ENDS = Pen("ENDS_OF_PHASES", 0.18, colour="#b8b8b8")
HEADROOM = 1.6  # of the stroke, for the names of the phases
NAME_SIZE, BETWEEN = 1.9, 2.5  # of the names of the phases; least between two of them [mm]


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return law_drawing(cam_of(order), order.results["cam_law"])


def law_drawing(task: CamTask, result: LawResult) -> Drawing:
    """One sheet: four diagrams on the left, the phase portrait on the right."""
    drawing, box = titled(_heading(result), 3.2)
    left, right = box.split(1.6, 1.0, gap=5, across=True)
    pieces = _pieces(task.program)
    for order, frame in enumerate(stacked(left, [0] * 4, HEIGHTS)):
        diagram = _draw(drawing, frame, order, pieces, result)
        if order:
            _name_extremes(diagram, order, result)
        else:
            _name_stroke(diagram, result)
            _name_phases(diagram, result)
    _portrait(drawing, right, pieces, result)
    return drawing


def _heading(result: LawResult) -> str:
    laws = [f"{each.kind}: {each.constants.name}" for each in result.phases if each.constants is not None]
    speed = "" if result.speed is None else f", {number(result.speed * 30 / np.pi, 5)} rpm"
    size = f"{number(degrees(result.stroke), 5)}°" if result.turns else f"{number(1e3 * result.stroke, 5)} mm"
    symbol = "ψ_m" if result.turns else "h"
    return f"Law of motion of the follower, ${symbol}$ = {size}{speed}; {', '.join(laws)}"


def _symbol(result: LawResult, order: int) -> str:
    """The sign of a derivative, of the displacement itself with its Δ, inside a formula."""
    letter = "ψ" if result.turns else "S"
    return f"Δ{letter}" if order == 0 else letter + "'" * order


def _derived(result: LawResult, order: int) -> str:
    """The unit after a derivative by the angle of the cam; that of an angle by an angle has none."""
    if not result.turns:
        return ", mm"
    return ("", ", 1/rad", ", 1/rad²")[order - 1]


def _scale(result: LawResult, order: int) -> float:
    """Factor from SI to what is shown."""
    if not result.turns:
        return 1e3
    return degrees(1.0) if order == 0 else 1.0


def _pieces(program: Program) -> list[tuple[Values, Values]]:
    """Angles (m,) and the motion (4, m) of every piece, up to both its ends."""
    found = []
    for number_of, (low, high) in enumerate(zip(program.edges[:-1], program.edges[1:], strict=True)):
        phi = np.linspace(low, high, DENSE)
        found.append((phi, program.at(phi, np.full(DENSE, number_of))))
    return found


def _draw(drawing: Drawing, box: Box, order: int, pieces: list[tuple[Values, Values]], result: LawResult) -> Diagram:
    """One diagram with its curve, jumps, positions and the ends of the phases."""
    factor, pen = _scale(result, order), CURVES[order]._replace(dashes=())
    values = [factor * motion[order] for _, motion in pieces]
    low, high = room(values, 0.25, 0.25)
    if order == 0:
        low, high = -0.3 * factor * result.stroke, HEADROOM * factor * result.stroke
    unit = _derived(result, order) if order else ", °" if result.turns else ", mm"
    whole = np.degrees(np.array([0.0, pieces[-1][0][-1]]))
    name = f"${_symbol(result, order)}${unit}"
    diagram = Diagram(drawing, box, input_axis(True, whole), Axis(name, low, high), numbered=order == 3)
    for phase in result.phases:
        diagram.vertical(degrees(phase.begin), ENDS)
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
    factor, pen = _scale(result, order), CURVES[order]._replace(dashes=())
    for each in result.extremes:
        if each.order == order:
            value = factor * each.value
            diagram.mark(complex(degrees(each.phi), value), number(value, 4), pen)


def _name_stroke(diagram: Diagram, result: LawResult) -> None:
    """The points a, b, c, d at which the phases begin, and the stroke."""
    names, factor = _points(result), _scale(result, 0)
    top, place = factor * result.stroke, degrees(result.phases[0].end)
    foot, head = diagram.place(complex(place)), diagram.place(complex(place, top))
    diagram.drawing.vector(foot, head, STROKE, level=5)
    diagram.drawing.add(arrowhead(foot, -1j, STROKE), level=5)
    diagram.labels.avoid([foot, head])
    for phase in result.phases:
        at = diagram.point(complex(degrees(phase.begin), factor * phase.low), MIDDLE)
        diagram.labels.put(f"${names[phase.kind]}$", [at], height=2.3, prefer=1 + 1j if phase.low else -1 - 1j)
    symbol = "$ψ_m$" if result.turns else "$h$"
    diagram.labels.put(symbol, [foot + 0.4 * (head - foot)], height=2.3, prefer=1 + 0j, colour=MARK.colour)


def _name_phases(diagram: Diagram, result: LawResult) -> None:
    """The names of the phases with their angles in a row along the top of the first diagram."""
    texts = [f"{phase.kind}\n{number(degrees(phase.end - phase.begin), 5)}°" for phase in result.phases]
    halves = [width(text, NAME_SIZE) / 2 for text in texts]
    box = diagram.box
    middles = [diagram.place(complex(degrees(phase.begin + phase.end) / 2)).real - box.left for phase in result.phases]
    for text, at in zip(texts, spread(middles, halves, box.width), strict=True):
        diagram.drawing.add(Words(complex(box.left + at, box.top - 1.0), text, NAME_SIZE, 1j), level=5)


def spread(middles: Sequence[float], halves: Sequence[float], end: float) -> list[float]:
    """Middles of texts in a row from 0 to ``end`` [mm], moved as little to the sides as keeps them apart.

    >>> spread([2.0, 3.0, 50.0], [4.0, 4.0, 10.0], 60.0)
    [4.0, 14.5, 50.0]
    """
    found, free = [], 0.0
    for middle, half in zip(middles, halves, strict=True):
        found.append(max(middle, free + half))
        free = found[-1] + half + BETWEEN
    free = end
    for k in reversed(range(len(found))):
        found[k] = min(found[k], free - halves[k])
        free = found[k] - halves[k] - BETWEEN
    return found


def _points(result: LawResult) -> dict[str, str]:
    """The names of the points at which the phases begin; two names where a dwell takes no angle."""
    kinds = [phase.kind for phase in result.phases]
    names: dict[str, str] = dict(POINTS)
    if "high dwell" not in kinds:
        names["return"] = "b, c"
    if "low dwell" not in kinds:
        names["rise"] = "a, d"
    return names


def _portrait(drawing: Drawing, box: Box, pieces: list[tuple[Values, Values]], result: LawResult) -> None:
    """S' against S in one unit, of a rocker radians: rise above, return below."""
    scale = _scale(result, 1)
    curves = [(scale * motion[0] + 1j * scale * motion[1], motion[1, DENSE // 2] >= 0) for _, motion in pieces]
    every = np.concatenate([z for z, _ in curves])
    words = _symbol(result, 1), _symbol(result, 0)
    unit, air = "rad" if result.turns else "mm", 0.14
    ends = [
        (float(v.min()) - air * float(np.ptp(v)), float(v.max()) + air * float(np.ptp(v)))
        for v in (every.real, every.imag)
    ]
    x, y = Axis(f"${words[1]}$, {unit}", *ends[0]), Axis(f"${words[0]}${_derived(result, 1)}", *ends[1])
    frame = box.inset(14, 9, 1, 7)
    if not result.turns:
        x, y = one_scale(frame, x, y)  # an angle of a ray is a pressure angle then
    title = f"Phase portrait ${words[0]}$(${words[1]}$)"
    drawing.add(Words(complex(frame.middle.real, box.top - 1.0), title, 2.8, 1j))
    diagram = Diagram(drawing, frame, x, y)
    diagram.vertical(0.0, MIDDLE)
    diagram.labels.avoid(diagram.paper([complex(x.low), complex(x.high)]), 0.5)
    for z, rising in curves:
        diagram.curve(z, CURVES[0 if rising else 1])
    if len(result.positions.phi) <= DOTTED:
        diagram.dots(scale * result.motion[0], scale * result.motion[1], Pen("POINTS", 0.13, colour=INK))
    for name, end in (("a, d", 0.0), ("b, c", scale * result.stroke)):
        at = diagram.point(complex(end), MIDDLE)
        diagram.labels.put(f"${name}$", [at], height=2.3, prefer=1 + 1j if end else -1 - 1j)
    for each in result.extremes:
        if each.order == 1:
            row = int(np.argmin(np.abs(result.positions.phi - each.phi)))
            at = diagram.place(scale * complex(result.motion[0, row], each.value))
            diagram.labels.put(minus(number(scale * each.value, 4)), [at], height=2.2, prefer=1j * each.value)
