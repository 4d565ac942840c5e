"""The diagram S'(dS) with the tangents at +-[theta] and the admissible zone of the axis (figures 5.14, 5.15).

Abscissa dS, ordinate S', one scale, in mm. The axis of the cam stands at (-S0, -e): the ray from it to a point of the
curve is inclined by the pressure angle there. The sense is the canonical one: e > 0 steepens the rise.
"""

from __future__ import annotations

import cmath
from math import atan, cos, sin

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.pictures.toscale import closed_up, scale_of_mm
from tmmcalc.cams.pictures.wording import deg, limit_name, mm
from tmmcalc.cams.pictures.zone import (
    HATCH,
    LIMIT,
    OTHER,
    ZONE,
    Angle,
    axis_of_cam,
    dimension,
    limit_point,
    mark_angle,
    name_angle,
    name_limit,
    textbook_choice,
)
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.cams.synthesis.translatingsizes import Line, lines_of, region_of
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.drawing.polar import AROUND, name_axes
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr
from tmmcalc.report.numbers import round_scale

POINTS = 241
FAR = 5.0  # S0 to which the zone is drawn
MARKED = 12.0  # radius of the arcs of the allowed angles [mm]
BEYOND = 0.22  # of S0 + h, what is shown around


def plane_board(
    drawing: Drawing, box: Box, task: CamTask, result: Synthesis, margin: float, *, to_scale: bool
) -> Board:
    """The drawing in a rectangle; ``to_scale``: at a standard scale of lengths."""
    left, bottom, right = AROUND
    inner, content = box.inset(left, bottom, right, 0), _content(task, result)
    if to_scale:
        inner = closed_up(inner, content, margin, unit=1e-3)
    board = Board(drawing, inner, content, margin, scale=scale_of_mm if to_scale else round_scale)
    _draw_plane(board, task, result)
    return board


def _content(task: CamTask, result: Synthesis) -> Complex:
    """Points [mm] that the drawing has to show."""
    o, curves = _axis(result), np.concatenate([_curve(task, kind) for kind in ("rise", "return")])
    reach = BEYOND * (abs(o.real) + 1e3 * task.program.stroke)
    ends = [min(o.real, _apex(result).real) - 1.6 * reach, o - 1j * reach, o + 1j * reach]
    return np.concatenate((curves, curves.max(keepdims=True) + 0.5 * reach, np.array(ends)))


def _draw_plane(board: Board, task: CamTask, result: Synthesis) -> None:
    """Zone, curve, tangents, the axis with S0 and e, the textbook's choice."""
    box = board.box
    name_axes(board, ("ΔS", "S'"), 1.0, "mm")
    words = tr("$S_0$ to the left of zero, $e$ below it")
    if result.follower.sense < 0:  # e in the user's sense
        words = tr("$S_0$ to the left of zero, $−e$ below it")
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
    angles = [_marked(board, task, line) for line in lines if (line.phi, line.side) in bounding]
    _draw_axis(board, result)
    for line in lines:
        if (line.phi, line.side) in bounding:
            at, _ = _touching(task, line)
            name_limit(board, at, deg(line.phi, 4), complex(1, line.side))
    for angle in angles:
        name_angle(board, angle)


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


def _marked(board: Board, task: CamTask, line: Line) -> Angle:
    """The allowed pressure angle, between a tangent and the direction of the abscissa."""
    at, along = _touching(task, line)
    foot = at - at.imag / along.imag * along  # on the axis of abscissas
    room = MARKED * board.mu
    left, right = board.data(complex(board.box.left)).real, board.data(complex(board.box.right)).real
    if not left < foot.real < right - room:
        foot = at - 0.5 * (at.real - left) * along
        board.line([foot, foot + 1.2 * room], OTHER, level=6)
    name = limit_name("rise" if at.imag >= 0 else "return")
    return mark_angle(board, foot, (1.0, along), MARKED, f"{name} = {deg(abs(cmath.phase(along)))}")


def _draw_axis(board: Board, result: Synthesis) -> None:
    o = _axis(result)
    high = board.data(complex(0, board.box.bottom)).imag + 7 * board.mu
    for z in (o, complex(0, o.imag)):
        board.line([z, complex(z.real, high - 2 * board.mu)], OTHER, level=3)
    dimension(board, complex(o.real, high), complex(0, high), f"$S_0$ = {mm(result.follower.start, 6)}")
    axis_of_cam(board, o)
    book = next((each for each in result.designs if each.name.startswith("textbook (")), None)
    if book is not None:
        textbook_choice(board, -1e3 * complex(book.start, book.offset), "$O^*$")
    if result.follower.offset:
        e = result.follower.sense * result.follower.offset
        dimension(board, complex(o.real, 0), o, f"$e$ = {mm(e, 6)}")
        dimension(board, o, 0j, f"$R_0$ = {mm(result.follower.base, 6)}")


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
