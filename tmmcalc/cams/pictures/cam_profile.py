"""The picture of the profile: the cam to scale with all its curves and the follower, the curvature over the turn."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from tmmcalc.cams.pictures.curvature import DENSE, draw_bends, draw_distance, name_bends, name_distance, pieces_of
from tmmcalc.cams.pictures.followersketch import draw_follower
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.pictures.profilemarks import DOT, draw_marks, marks_of, name_marks, name_phases
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.results import WALLS, Profile, Wall
from tmmcalc.cams.task import CamTask
from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.curves import bottom
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import INK, MARK
from tmmcalc.report.numbers import number

MARGIN = 8.0  # [mm]
BODY = "#eef2f5"
GROOVE = "#d3dbe2"
STYLES: dict[str, dict[str, Any]] = {
    "pitch": {"color": "#0072b2", "linestyle": (0, (8, 2, 1.5, 2)), "linewidth": 0.9},
    "inner": {"color": INK, "linestyle": "-", "linewidth": 1.9},
    "outer": {"color": INK, "linestyle": "-", "linewidth": 1.9},
    "tool": {"color": "#009e73", "linestyle": (0, (5, 1.5)), "linewidth": 0.9},
    "outer tool": {"color": "#009e73", "linestyle": (0, (5, 1.5)), "linewidth": 0.9},
    "base": {"color": "#6b6b6b", "linestyle": (0, (6, 2)), "linewidth": 0.7},
    "shaft": {"color": MARK, "linestyle": "-", "linewidth": 1.0},
    "lost": {"color": MARK, "linestyle": "-", "linewidth": 2.6, "alpha": 0.75},
}


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return profile_figure(cam_of(order), order.results["cam_profile"])


def profile_figure(task: CamTask, result: Profile) -> Figure:
    """One sheet: the cam on the left, curvature (of a flat face the radius) on the right."""
    figure, (sheet,) = blank(1)
    sheet.suptitle(_heading(result), fontsize=10)
    left, right = sheet.subfigures(1, 2, width_ratios=[1.25, 1.0], squeeze=False)[0]
    drawing = left.subplots()
    drawing.set_axis_off()
    diagrams = right.subplots(2, 1, height_ratios=[1.0, 1.0]).tolist()
    rim = Rim(result.follower, task.program)
    draw_bends(diagrams[0], rim, result)
    draw_distance(diagrams[1], rim, result)
    bottom(diagrams, True)
    settle(figure)
    _draw_cam(drawing, task, result, rim)
    name_bends(diagrams[0], rim, result)
    name_distance(diagrams[1], rim, result)
    return figure


def _heading(result: Profile) -> str:
    follower = result.follower
    sizes = [f"$R_0$ = {number(1e3 * follower.base, 5)} mm"]
    if follower.kind == "translating":
        # e > 0 in the user's sense is on the right of O
        sizes.append(f"$e$ = {number(1e3 * follower.offset * follower.sense, 5)} mm".replace("-", "−"))
    if follower.kind == "oscillating":
        sizes += [f"$l_0$ = {number(1e3 * follower.centres, 5)} mm", f"$l_2$ = {number(1e3 * follower.rocker, 5)} mm"]
    if not result.flat:
        sizes.append(f"$r_2$ = {number(1e3 * follower.roller, 5)} mm")
        if result.inner_reach is not None:
            sizes.append(f"largest roller {number(1e3 * result.inner_reach.distance, 5)} mm")
    turns = "clockwise" if follower.sense > 0 else "counter-clockwise"
    return f"Profile of the cam, which turns {turns}: {', '.join(sizes)}"


def _curve(rim: Rim, distance: float) -> Plane:
    """A whole offset in the user's sense (m,)."""
    parts = [rim.at(phi, piece).offset(distance) for phi, piece in pieces_of(rim)]
    placed: Plane = rim.follower.placed(np.concatenate(parts))
    return placed


def _draw_cam(axes: Axes, task: CamTask, result: Profile, rim: Rim) -> None:
    follower = result.follower
    curves = {wall.name: _curve(rim, wall.distance) for wall in result.walls}
    pitch = None if result.flat else _curve(rim, 0.0)
    content = [*curves.values(), *([] if pitch is None else [_curve(rim, -follower.roller)]), _frame_of(result)]
    board = Board(axes, np.concatenate(content), MARGIN)
    for name, colour in (("outer", GROOVE), ("inner", BODY)):
        if name in curves:
            axes.fill(curves[name].real, curves[name].imag, facecolor=colour, edgecolor="none", zorder=0.5)
    _circle(board, follower.base, STYLES["base"])
    if task.limits.shaft:
        _circle(board, task.limits.shaft, STYLES["shaft"])
    marks = marks_of(task, result, rim)
    draw_marks(board, marks, follower)
    if pitch is not None and follower.roller:
        board.line([*pitch, pitch[0]], zorder=3, weight=0.7, **STYLES["pitch"])
    for wall in result.walls:
        points = curves[wall.name]
        board.line([*points, points[0]], zorder=5, weight=1.0, **STYLES[wall.name])
        _draw_lost(board, rim, wall)
    draw_follower(board, result.follower, result.face)
    _draw_axis(board, result)
    name_marks(board, marks)
    name_phases(board, task, result, rim)
    _legend(axes, task, result, board)


def _frame_of(result: Profile) -> Plane:
    """Places that the drawing has to hold beside the curves: the follower at the start, O, the pivot."""
    follower = result.follower
    if follower.kind == "oscillating":
        return np.array([0j, complex(1.08 * follower.centres)])
    top = follower.start + follower.roller + 0.5 * follower.base
    side = follower.offset * follower.sense
    reach = 0.0 if result.face is None else max(result.face.left, result.face.right) + result.face.margin
    return np.array([complex(side - reach, top), complex(side + reach, top)])


def _circle(board: Board, radius: float, style: dict[str, Any]) -> None:
    around = radius * np.exp(1j * np.linspace(0, 2 * np.pi, 241))
    board.line(around, zorder=2, weight=0.3, **style)


def _draw_lost(board: Board, rim: Rim, wall: Wall) -> None:
    """What is undercut, and the points in which the wall crosses itself."""
    for begin, end in wall.loops:
        points = rim.follower.placed(rim.at(np.linspace(begin, end, DENSE)[1:-1]).offset(wall.distance))
        board.line(points, zorder=6, weight=1.0, **STYLES["lost"])
    for crossing in wall.crossings:
        board.axes.plot(crossing.point.real, crossing.point.imag, "x", color=MARK, markersize=6, zorder=8)


def _draw_axis(board: Board, result: Profile) -> None:
    """O with its name, and the arrow of rotation."""
    board.circle(0j, 0.9, zorder=9)
    board.labels.put("O", [0j], size=9, prefer=-1 - 1j)
    radius, sense = min(0.3 * result.follower.base, 0.6 * result.nearest.value), -result.follower.sense
    turn = np.linspace(0.35 * np.pi, 0.35 * np.pi + sense * 0.9 * np.pi, 41) + (np.pi if sense < 0 else 0)
    arc = radius * np.exp(1j * turn)
    board.line(arc[:-1], color=MARK, linewidth=1.2, zorder=7)
    board.arrowhead(complex(arc[-1]), complex(arc[-1] - arc[-3]), facecolor=MARK)
    board.labels.put(r"$\omega$", [complex(arc[len(arc) // 2])], size=9, prefer=complex(arc[len(arc) // 2]), color=MARK)


def _legend(axes: Axes, task: CamTask, result: Profile, board: Board) -> None:
    follower = result.follower
    entries = [] if result.flat or not follower.roller else [("pitch curve", STYLES["pitch"])]
    entries += [(WALLS[wall.name], STYLES[wall.name]) for wall in result.walls]
    entries.append(("base circle", STYLES["base"]))
    if task.limits.shaft:
        entries.append(("shaft", STYLES["shaft"]))
    if any(wall.loops for wall in result.walls):
        entries.append(("undercut", STYLES["lost"]))
    entries.append((f"{'contact' if result.flat else 'follower'} at i of the tables", DOT))
    handles = [Line2D([], [], label=label, **style) for label, style in entries]
    scale = f"scale $\\mu_l$ = {number(1e3 * board.mu, 4)} mm/mm"
    axes.legend(
        handles=handles,
        loc="lower left",
        bbox_to_anchor=(0.0, 0.0),
        ncols=4,
        handlelength=3,
        title=scale,
        title_fontsize=7.5,
    )
