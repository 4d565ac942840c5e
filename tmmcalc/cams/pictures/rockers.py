"""The positions of the rocker with the ends of the turned velocities, and the zone of the axis (figures 5.17, 5.18).

In every position l2 psi' is laid off from the roller along the rocker, to K at l2 (1 - delta psi') from the pivot. The
line through K, leaning by [theta] from the perpendicular of the rocker, is where the axis would make theta reach its
limit. One scale for lengths and velocities.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.pictures.zone import BASE, LIMIT, OTHER, PASSING, ZONE, axis_of_cam, dimension, swept_of
from tmmcalc.cams.synthesis.halfplanes import Family, Lines, families
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.style import CURVES, INK, THIN

POINTS = 181
STEPS = 8  # positions of a phase that are drawn
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


def content_of(task: CamTask, result: Synthesis) -> Complex:
    """Points [m] that the drawing has to show."""
    placed, follower = Placed(result), result.follower
    swing = np.exp(1j * np.linspace(0, task.program.stroke, 9))
    tips = [placed.at(_velocity_ends(task, result, kind)) for kind in ("rise", "return")]
    circle = 0.55 * follower.base * np.exp(1j * np.linspace(0, 2 * np.pi, 13))
    return np.concatenate((*tips, placed.at(swing), circle, np.array([0.0, follower.centres])))


def draw_rockers(board: Board, task: CamTask, result: Synthesis) -> None:
    """Zone, positions, velocities, lines of the limit, the axis with its base circle."""
    placed = Placed(result)
    _draw_zone(board, placed, task, result)
    _draw_lines(board, placed, task, result)
    _draw_positions(board, placed, task, result)
    _draw_axis(board, placed, task, result)


def _draw_zone(board: Board, placed: Placed, task: CamTask, result: Synthesis) -> None:
    """What the pressure angle admits, less the places from which the cam sweeps over the pivot."""
    region = result.region
    if region is None or not len(region.x):
        return
    corners = (region.x + 1j * region.y) / result.follower.rocker
    board.area(placed.at(corners.astype(complex)).tolist(), weight=0.0, **ZONE)
    swept = swept_of(task, result)
    if swept is not None:
        branch, border = (placed.at(points) for points in swept)
        board.area(border.tolist(), weight=0.0, facecolor="white", edgecolor="none", linewidth=0.0, zorder=1.2)
        board.line(branch, **PASSING)


def _draw_lines(board: Board, placed: Placed, task: CamTask, result: Synthesis) -> None:
    """On both sides the line that bounds the zone next to the axis, and faint the others of its phase and side."""
    bounds, program = _bounds(result), task.program
    for family in families(task):
        held = [phi for phi, side in bounds if side == family.side and _in_phase(task, family.kind, phi)]
        if not held:
            continue
        k = next(k for k, phase in enumerate(program.phases) if phase.kind == family.kind)
        others = family.at(np.linspace(program.starts[k], program.starts[k + 1], STEPS + 1))
        style = {"colors": OTHER["color"], "linewidths": OTHER["linewidth"], "zorder": 2}
        board.lines(_strokes(placed, task, family, others), weight=0.0, **style)
        lines = family.at(np.array(held[:1]))
        for stroke in _strokes(placed, task, family, lines):
            board.line(stroke, **LIMIT)
        tip = complex(placed.at(_ends_on_lines(family, lines))[0])
        dot = {"markersize": 4, "markerfacecolor": "white", "color": LIMIT["color"], "zorder": 12}
        board.axes.plot(tip.real, tip.imag, "o", **dot)
        text = f"$K$ at {signed(np.degrees(held[0]), 4)}°"
        board.labels.put(
            text, [tip], size=8, prefer=tip - result.follower.centres, gaps=(2.0, 3.5), color=LIMIT["color"]
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
    board.line(placed.at(swing), color=THIN, linewidth=0.8, zorder=5)
    for kind, style in (("rise", CURVES[0]), ("return", CURVES[2])):
        board.line(placed.at(_velocity_ends(task, result, kind)), zorder=8, linewidth=1.7, weight=1.5, **style)
        k = next(k for k, phase in enumerate(program.phases) if phase.kind == kind)
        phi = np.linspace(program.starts[k], program.starts[k + 1], STEPS + 1)
        y, y1 = program.at(phi)[:2]
        u = np.exp(1j * y)
        pieces = [placed.at(u), placed.at(u * (1 - task.asked.assembly * y1))]
        board.lines(
            [[complex(a), complex(b)] for a, b in zip(*pieces, strict=True)],
            weight=0.3,
            colors=style["color"],
            linewidths=0.8,
            zorder=7,
        )
        board.lines([[pivot, complex(c)] for c in pieces[0]], weight=0.2, colors=THIN, linewidths=0.5, zorder=3)
    for point, name in ((swing[0], "$C_0$"), (swing[-1], "$C_m$")):
        z = complex(placed.at(np.array([point]))[0])
        board.line([pivot, z], linewidth=1.6, zorder=9)
        board.circle(z, 1.1, zorder=14)
        board.labels.put(name, [z], size=9, prefer=z - pivot)
    board.circle(pivot, 1.5, zorder=14)
    board.labels.put("$A$", [pivot], size=9.5, prefer=1 - 1j)


def _draw_axis(board: Board, placed: Placed, task: CamTask, result: Synthesis) -> None:
    follower = result.follower
    pivot, roller = complex(follower.centres), complex(placed.at(np.ones(1, complex))[0])
    board.line([0, pivot], color=INK, linewidth=0.9, linestyle=(0, (8, 2, 1.5, 2)), zorder=6)
    board.labels.put(f"$l_0$ = {signed(1e3 * follower.centres, 6)}", [pivot / 2], size=8.5, prefer=-1j)
    circle = follower.base * np.exp(1j * np.linspace(0, 2 * np.pi, 181))
    board.line(circle, weight=0.6, **BASE)
    dimension(board, 0j, roller, f"$R_0$ = {signed(1e3 * follower.base, 6)}")
    book = next((each for each in result.designs if each.name.startswith("textbook (")), None)
    if book is not None:
        at = complex(placed.at(np.array([book.centres / follower.rocker * np.exp(-1j * book.start)]))[0])
        board.axes.plot(
            at.real, at.imag, "s", markersize=5, markerfacecolor="white", color=CURVES[3]["color"], zorder=14
        )
        board.labels.avoid([at], 3.0)
        board.labels.put("$O^*$ (5.50)", [at], size=8.5, prefer=1 + 1j, color=CURVES[3]["color"], gaps=(2.0, 3.0, 5.0))
    axis_of_cam(board, 0j)


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
