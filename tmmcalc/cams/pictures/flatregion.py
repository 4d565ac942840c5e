"""The region of the axis under a flat face: the displacement against S'', with its tangent at 45 degrees.

The radius of the profile is rho = S0 + dS + S'': on the lines that fall at 45 degrees dS + S'' is the same, and the
lowest of them that touches the curve has F_min. The axis O of the cam lies on the ordinate at -S0, at least r_m under
the place where that tangent cuts it (5.96, 5.97).
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.pictures.toscale import closed_up, scale_of_mm
from tmmcalc.cams.pictures.wording import deg, mm
from tmmcalc.cams.pictures.zone import (
    HATCH,
    LIMIT,
    OTHER,
    ZONE,
    axis_of_cam,
    dimension,
    limit_point,
    mark_angle,
    name_angle,
    name_limit,
)
from tmmcalc.cams.synthesis.results import Convexity, Synthesis
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.drawing.polar import AROUND, name_axes
from tmmcalc.report.drawing.shapes import Drawing

POINTS = 121  # of a piece of the motion
MARKED = 11.0  # radius of the arc of 45 degrees [mm]
ASIDE = 9.0  # of the dimensions from the ordinate [mm]


def draw_flat_region(
    drawing: Drawing, box: Box, task: CamTask, result: Synthesis, found: Convexity, margin: float
) -> Board:
    """Curve, tangent, region and axis, at a standard scale of lengths; data in mm."""
    start = 1e3 * result.follower.start
    curves = _curves(task)
    left, bottom, right = AROUND
    content = np.concatenate([*(z for _, z in curves), [-1j * start - 0.15j * abs(start)]])
    inner = closed_up(box.inset(left, bottom, right, 0), content, margin, unit=1e-3)
    board = Board(drawing, inner, content, margin, scale=scale_of_mm)
    name_axes(board, ("S''", "ΔS"), 1.0, "mm")
    low, high = (
        board.data(complex(*corner))
        for corner in ((board.box.left, board.box.bottom), (board.box.right, board.box.top))
    )
    for ends in ((low.real, high.real), (1j * low.imag, 1j * high.imag)):
        board.labels.avoid(board.paper(list(ends)), 2.0)
    _draw_region(board, 1e3 * (found.least.value - found.limit), low, high)
    for kind, z in curves:
        pen = CURVES[0] if kind == "rise" else CURVES[2]
        board.line(z, pen._replace(width=0.6), weight=1.5, level=8)
    cut = 1e3j * found.least.value
    _draw_tangent(board, cut, low, high)
    y, _, y2, _ = 1e3 * task.program.at(np.array([found.least.phi]))[:, 0]
    if abs(y + y2 - cut.imag) < 1e-6 * max(start, abs(cut.imag)):  # not on the other side of a jump
        limit_point(board, complex(y2, y))
        name_limit(board, complex(y2, y), deg(found.least.phi, 4), -1 - 1j)
    _draw_sizes(board, start, cut, found)
    return board


def _curves(task: CamTask) -> list[tuple[str, Complex]]:
    """dS over S'' of every piece of rise and return [mm]."""
    program, found = task.program, []
    for k, phase in enumerate(program.places[0].tolist()):
        if program.phases[phase].moves:
            phi = np.linspace(program.edges[k], program.edges[k + 1], POINTS)
            y, _, y2, _ = 1e3 * program.at(phi, np.full(POINTS, k))
            found.append((program.phases[phase].kind, np.asarray(y2 + 1j * y)))
    return found


def _draw_region(board: Board, top: float, low: complex, high: complex) -> None:
    """Under the line r_m below the tangent, where the axis may stand on the ordinate."""
    far = abs(high - low)
    corners = [complex(-far, top + far), complex(far, top - far), complex(far, -3 * far), complex(-far, -3 * far)]
    board.filled(np.array(corners), ZONE, hatch=HATCH)


def _draw_tangent(board: Board, cut: complex, low: complex, high: complex) -> None:
    """The tangent from border to border, and its angle with the ordinate."""
    far, along = abs(high - low), complex(1, -1)
    board.line([cut - far * along, cut + far * along], LIMIT, level=6)
    name_angle(board, mark_angle(board, cut, (1j, -along), MARKED, "45°"))


def _draw_sizes(board: Board, start: float, cut: complex, found: Convexity) -> None:
    """The axis of the cam, S0 and the least radius beside the ordinate."""
    o = -1j * start
    axis_of_cam(board, o)
    sides = ((-ASIDE, 0j, f"$S_0$ = {mm(start / 1e3, 6)}"), (ASIDE, cut, f"$ρ_{{min}}$ = {mm(found.radius, 6)}"))
    for side, top, text in sides:
        shift = side * board.mu
        for z in (o, top):
            board.line([z, z + 1.2 * shift], OTHER, level=3)
        dimension(board, o + shift, top + shift, text)
