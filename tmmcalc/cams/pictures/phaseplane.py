"""The diagram S'(dS) with the tangents at +-[theta] and the admissible zone of the axis (figures 5.14, 5.15).

Abscissa dS, ordinate S', one scale, in mm. The axis of the cam stands at (-S0, -e): the ray from it to a point of the
curve is inclined by the pressure angle there. The sense is the canonical one: e > 0 steepens the rise.
"""

from __future__ import annotations

from math import atan, cos, sin

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.pictures.zone import (
    HATCH,
    HEIGHT,
    LIMIT,
    OTHER,
    ZONE,
    axis_of_cam,
    dimension,
    limit_point,
    name_limit,
    textbook_choice,
)
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.cams.synthesis.translatingsizes import Line, lines_of, region_of
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.drawing.polar import name_axes
from tmmcalc.report.drawing.shapes import Words
from tmmcalc.report.numbers import number

POINTS = 241
FAR = 5.0  # S0 to which the zone is drawn
BEYOND = 0.22  # of S0 + h, what is shown around


def content_of(task: CamTask, result: Synthesis) -> Complex:
    """Points [mm] that the drawing has to show."""
    o, curves = _axis(result), np.concatenate([_curve(task, kind) for kind in ("rise", "return")])
    reach = BEYOND * (abs(o.real) + 1e3 * task.program.stroke)
    ends = [min(o.real, _apex(result).real) - 1.6 * reach, o - 1j * reach, o + 1j * reach]
    return np.concatenate((curves, curves.max(keepdims=True) + 0.5 * reach, np.array(ends)))


def draw_plane(board: Board, task: CamTask, result: Synthesis) -> None:
    """Zone, curve, tangents, the axis with S0 and e, the textbook's choice."""
    box = board.box
    name_axes(board, ("ΔS", "S'"), 1.0, "mm")
    e = "e" if result.follower.sense > 0 else "−e"  # in the user's sense
    words = f"$S_0$ to the left of zero, ${e}$ below it"
    board.drawing.add(Words(complex(box.right, box.bottom - 4.5), words, 2.1, 1 + 1j))
    low, high = board.data(complex(box.left, box.bottom)), board.data(complex(box.right, box.top))
    for ends in ((low.real, high.real), (1j * low.imag, 1j * high.imag)):
        board.labels.avoid(board.paper(list(ends)), 2.0)
    lines = lines_of(task)
    region = region_of(lines, (0.0, FAR * result.follower.start))  # to beyond the border of the drawing
    board.filled(np.asarray(-1e3 * (region.y + 1j * region.x), complex), ZONE, hatch=HATCH)
    for kind, pen in (("rise", CURVES[0]), ("return", CURVES[2])):
        board.line(_curve(task, kind), pen._replace(width=0.6), weight=1.5, level=8)
    held = () if result.region is None else zip(result.region.phi.tolist(), result.region.side.tolist(), strict=True)
    bounding = set(held)
    for line in lines:
        _draw_tangent(board, task, line, (line.phi, line.side) in bounding)
    _draw_axis(board, result)
    for line in lines:
        if (line.phi, line.side) in bounding:
            _name_tangent(board, task, line)


def _draw_tangent(board: Board, task: CamTask, line: Line, bounds: bool) -> None:
    """The tangent through its point of the curve, from beyond it to the border of the drawing."""
    at, along = _touching(task, line)
    left, right = board.data(complex(board.box.left)).real, board.data(complex(board.box.right)).real
    over = min(0.12 * (right - left), (right - at.real) / along.real)
    ends = [at + over * along, at - (at.real - left) / along.real * along]
    board.line(ends, LIMIT if bounds else OTHER, level=6 if bounds else 2)
    if bounds:
        limit_point(board, at)


def _touching(task: CamTask, line: Line) -> tuple[complex, complex]:
    """The point of the curve [mm] at which a tangent touches it, and its direction."""
    y, y1 = task.program.at(np.array([line.phi]))[:2, 0]
    lean = atan(1 / line.slope)
    return 1e3 * complex(y, y1), complex(cos(lean), sin(lean))


def _name_tangent(board: Board, task: CamTask, line: Line) -> None:
    """The angle of the cam at its point, and the limit along it."""
    at, along = _touching(task, line)
    left = board.data(complex(board.box.left)).real
    name_limit(board, at, f"{minus(number(np.degrees(line.phi), 4))}°", complex(1, line.side))
    places = board.paper([at - part * (at.real - left) * along for part in (0.3, 0.4, 0.5, 0.2)])
    text = f"{'+' if line.side > 0 else '−'}[$θ$]"
    board.labels.put(text, places, height=HEIGHT, prefer=1j * line.side, colour=LIMIT.colour)


def _draw_axis(board: Board, result: Synthesis) -> None:
    o = _axis(result)
    high = board.data(complex(0, board.box.bottom)).imag + 7 * board.mu
    for z in (o, complex(0, o.imag)):
        board.line([z, complex(z.real, high - 2 * board.mu)], OTHER, level=3)
    dimension(board, complex(o.real, high), complex(0, high), f"$S_0$ = {minus(number(-o.real, 6))}")
    axis_of_cam(board, o)
    book = next((each for each in result.designs if each.name.startswith("textbook (")), None)
    if book is not None:
        textbook_choice(board, -1e3 * complex(book.start, book.offset), "$O^*$ (5.44)")
    e = result.follower.sense * result.follower.offset * 1e3 + 0.0
    dimension(board, complex(o.real, 0), o, f"$e$ = {minus(number(e, 6))}")


def _axis(result: Synthesis) -> complex:
    return -1e3 * complex(result.follower.start, result.follower.offset)


def _apex(result: Synthesis) -> complex:
    region = result.region
    return _axis(result) if region is None or not len(region.y) else -1e3 * complex(region.y.min(), 0)


def _curve(task: CamTask, kind: str) -> Complex:
    """S'(dS) of a phase [mm]."""
    program = task.program
    k = next(k for k, phase in enumerate(program.phases) if phase.kind == kind)
    phi = np.linspace(program.starts[k], program.starts[k + 1], POINTS)
    y, y1 = program.at(phi)[:2]
    return np.asarray(1e3 * (y + 1j * y1))
