"""The positions of the rocker with the ends of the turned velocities, and the zone of the axis (figures 5.17, 5.18).

In every position l2 psi' is laid off from the roller along the rocker, to K at l2 (1 - delta psi') from the pivot. The
line through K, leaning by [theta] from the perpendicular of the rocker, is where the axis would make theta reach its
limit. One scale for lengths and velocities.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.pictures.toscale import closed_up
from tmmcalc.cams.pictures.wording import deg, limit_name, mm
from tmmcalc.cams.pictures.zone import (
    BASE,
    HATCH,
    HEIGHT,
    LIMIT,
    OTHER,
    PASSING,
    ZONE,
    Angle,
    axis_of_cam,
    dimension,
    limit_point,
    mark_angle,
    name_angle,
    name_limit,
    swept_of,
    textbook_choice,
)
from tmmcalc.cams.synthesis.halfplanes import Family, Lines, families
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import AXIS, CURVES, INK, THICK, WHITE
from tmmcalc.report.drawing.scales import length_scale
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr
from tmmcalc.report.numbers import round_scale

POINTS = 181
STEPS, LINES = 8, 4  # positions of a phase that are drawn, and lines of a side beside the one that bounds the zone
FAINT = 0.25  # how much names keep clear of these lines
MARKED = 14.0  # radius of the arcs of the allowed angles [mm]
BEYOND = 1.5  # length of a line against the distance of the axis
NEAR = 1e-6  # [rad] a side belongs to this angle of the cam
TINY = 1e-300


class Placed:
    """The plane of the rocker (pivot 0, lowest roller at 1) in the user's axes: O is 0, A on the x axis [m]."""

    def __init__(self, result: Synthesis) -> None:
        self.follower = result.follower
        self.turn = np.exp(1j * self.follower.start)

    def at(self, points: Complex) -> Complex:
        """Points of the rocker's plane in units of l2, placed."""
        arm = self.turn * points * self.follower.rocker
        above = self.follower.sense * self.follower.assembly > 0
        return np.asarray(self.follower.centres - (np.conj(arm) if above else arm))


def rocker_board(
    drawing: Drawing, box: Box, task: CamTask, result: Synthesis, margin: float, *, to_scale: bool
) -> Board:
    """The drawing in a rectangle; ``to_scale``: at a standard scale of lengths."""
    content = _content(task, result)
    if to_scale:
        box = closed_up(box, content, margin)
    board = Board(drawing, box, content, margin, scale=length_scale if to_scale else round_scale)
    _draw_rockers(board, task, result)
    return board


def _content(task: CamTask, result: Synthesis) -> Complex:
    """Points [m] that the drawing has to show."""
    placed, follower = Placed(result), result.follower
    swing = np.exp(1j * np.linspace(0, task.program.stroke, 9))
    tips = [placed.at(_velocity_ends(task, result, kind)) for kind in ("rise", "return")]
    circle = follower.base * np.exp(1j * np.linspace(0, 2 * np.pi, 13))
    return np.concatenate((*tips, placed.at(swing), circle, np.array([0.0, follower.centres])))


def _draw_rockers(board: Board, task: CamTask, result: Synthesis) -> None:
    """Zone, positions, velocities, lines of the limit, the axis with its base circle."""
    placed = Placed(result)
    _draw_zone(board, placed, task, result)
    names = _draw_lines(board, placed, task, result)
    _draw_positions(board, placed, task, result)
    _draw_axis(board, placed, task, result)
    for text, tip, angle in names:
        name_limit(board, tip, text, tip - result.follower.centres, HEIGHT)
        if angle is not None:
            name_angle(board, angle)


def _draw_zone(board: Board, placed: Placed, task: CamTask, result: Synthesis) -> None:
    """What the pressure angle admits, less the places from which the cam sweeps over the pivot."""
    region = result.region
    if region is None or not len(region.x):
        return
    corners = (region.x + 1j * region.y) / result.follower.rocker
    board.filled(placed.at(corners.astype(complex)), ZONE, hatch=HATCH)
    swept = swept_of(task, result)
    if swept is not None:
        branch, border = (placed.at(points) for points in swept)
        board.filled(border, WHITE, level=-2.5)
        board.line(branch, PASSING, level=6)


def _draw_lines(
    board: Board, placed: Placed, task: CamTask, result: Synthesis
) -> list[tuple[str, complex, Angle | None]]:
    """On both sides the line that bounds the zone next to the axis, and faint the others of its phase and side.

    The names of the points K at which the former begin, with their places and the angles that are marked there.
    """
    found = []
    bounds, program = _bounds(result), task.program
    for family in families(task):
        held = [phi for phi, side in bounds if side == family.side and _in_phase(task, family.kind, phi)]
        if not held:
            continue
        k = next(k for k, phase in enumerate(program.phases) if phase.kind == family.kind)
        others = family.at(np.linspace(program.starts[k], program.starts[k + 1], LINES + 1))
        board.lines(_strokes(placed, task, family, others), OTHER, weight=FAINT, level=2)
        lines = family.at(np.array(held[:1]))
        strokes = _strokes(placed, task, family, lines)
        board.lines(strokes, LIMIT, level=6)
        tip = complex(placed.at(_ends_on_lines(family, lines))[0])
        limit_point(board, tip)
        angle = _mark_limit(board, placed, family, (tip, strokes[0][1] - tip))
        found.append((tr("$K$ at {angle}", angle=deg(held[0], 4)), tip, angle))
    return found


def _mark_limit(board: Board, placed: Placed, family: Family, line: tuple[complex, complex]) -> Angle | None:
    """The allowed pressure angle between a line and the perpendicular of the rocker at its point K."""
    tip, along = line
    across = 1j * (tip - placed.follower.centres)
    if not across:
        return None
    across *= 1 if (across * along.conjugate()).real > 0 else -1
    across /= abs(across)
    board.line([tip, tip + 1.2 * MARKED * board.mu * across], OTHER, level=6)
    return mark_angle(
        board, tip, (across, along / abs(along)), MARKED, f"{limit_name(family.kind)} = {deg(family.limit)}"
    )


def _strokes(placed: Placed, task: CamTask, family: Family, lines: Lines) -> list[list[complex]]:
    """Pieces of lines from K to the axis and beyond it."""
    tips, along = _ends_on_lines(family, lines), 1j * lines.normal
    down = -1j * np.exp(0.5j * task.program.stroke)
    along = np.where((along * np.conj(down)).real < 0, -along, along)
    axis = placed.follower.centres / placed.follower.rocker / placed.turn
    far = BEYOND * np.abs(axis - tips)
    return [[complex(a), complex(b)] for a, b in zip(placed.at(tips), placed.at(tips + along * far), strict=True)]


def _ends_on_lines(family: Family, lines: Lines) -> Complex:
    """The points K on the rockers that the lines go through: u w of the head of `halfplanes`."""
    lean = np.pi - family.limit if family.side > 0 else family.limit
    return np.asarray(lines.normal * np.exp(-1j * lean) * (-family.side * lines.bound / np.cos(family.limit)))


def _draw_positions(board: Board, placed: Placed, task: CamTask, result: Synthesis) -> None:
    program = task.program
    pivot = complex(placed.at(np.zeros(1, complex))[0])
    swing = np.exp(1j * np.linspace(0, program.stroke, 61))
    board.line(placed.at(swing), OTHER._replace(width=0.3), level=5)
    for kind, pen in (("rise", CURVES[0]), ("return", CURVES[2])):
        board.line(placed.at(_velocity_ends(task, result, kind)), pen._replace(width=0.6), weight=1.5, level=8)
        k = next(k for k, phase in enumerate(program.phases) if phase.kind == kind)
        phi = np.linspace(program.starts[k], program.starts[k + 1], STEPS + 1)
        y, y1 = program.at(phi)[:2]
        u = np.exp(1j * y)
        pieces = [placed.at(u), placed.at(u * (1 - task.asked.assembly * y1))]
        laid_off = [[complex(a), complex(b)] for a, b in zip(*pieces, strict=True)]
        board.lines(laid_off, pen._replace(width=0.25, dashes=()), weight=0.3, level=7)
        board.lines([[pivot, complex(c)] for c in pieces[0]], OTHER, weight=0.2, level=3)
    for point, name in ((swing[0], "$C_0$"), (swing[-1], "$C_m$")):
        z = complex(placed.at(np.array([point]))[0])
        board.line([pivot, z], THICK._replace(width=0.6), level=9)
        board.circle(z, 0.9, level=14)
        board.labels.put(name, board.paper([z]), height=2.6, prefer=z - pivot)
    board.circle(pivot, 1.2, level=14)
    board.labels.put("$A$", board.paper([pivot]), height=2.6, prefer=1 - 1j)


def _draw_axis(board: Board, placed: Placed, task: CamTask, result: Synthesis) -> None:
    follower = result.follower
    pivot, roller = complex(follower.centres), complex(placed.at(np.ones(1, complex))[0])
    board.line([0, pivot], AXIS._replace(colour=INK), level=6)
    board.line(follower.base * np.exp(1j * np.linspace(0, 2 * np.pi, 181)), BASE, weight=0.6, level=5)
    book = next((each for each in result.designs if each.name.startswith("textbook (")), None)
    if book is not None:
        at = book.centres / follower.rocker * np.exp(-1j * book.start)
        textbook_choice(board, complex(placed.at(np.array([at]))[0]), "$O^*$")
    distance = f"$l_0$ = {mm(follower.centres, 6)}"
    board.labels.put(distance, board.paper([part * pivot for part in (0.5, 0.65, 0.35)]), height=HEIGHT, prefer=-1j)
    axis_of_cam(board, 0j)
    dimension(board, 0j, roller, f"$R_0$ = {mm(follower.base, 6)}")


def _velocity_ends(task: CamTask, result: Synthesis, kind: str) -> Complex:
    """The points K of a phase in units of l2."""
    program = task.program
    k = next(k for k, phase in enumerate(program.phases) if phase.kind == kind)
    y, y1 = program.at(np.linspace(program.starts[k], program.starts[k + 1], POINTS))[:2]
    return np.asarray(np.exp(1j * y) * (1 - task.asked.assembly * y1))


def _bounds(result: Synthesis) -> list[tuple[float, int]]:
    """Of either sign of theta the angle and the sign of the side of the zone that is nearest to the axis."""
    region = result.region
    if region is None or not len(region.x):
        return []
    begin = region.x + 1j * region.y
    along = np.roll(begin, -1) - begin
    axis = result.follower.centres * np.exp(-1j * result.follower.start)
    part = ((axis - begin) * np.conj(along)).real / np.maximum(np.abs(along) ** 2, TINY)
    away = np.abs(axis - begin - np.clip(part, 0.0, 1.0) * along)
    found = []
    for side in (1, -1):
        own = np.flatnonzero(region.side == side)
        if own.size:
            found.append((float(region.phi[own[np.argmin(away[own])]]), side))
    return found


def _in_phase(task: CamTask, kind: str, phi: float) -> bool:
    starts = task.program.starts
    k = next(k for k, phase in enumerate(task.program.phases) if phase.kind == kind)
    return bool(starts[k] - NEAR <= phi <= starts[k + 1] + NEAR)
