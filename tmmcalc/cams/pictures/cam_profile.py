"""The picture of the profile: the cam to scale with all its curves, sizes and the follower, curvature over the turn."""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.pictures.curvature import DENSE, draw_bends, draw_distance, names_of, pieces_of
from tmmcalc.cams.pictures.followersketch import AXES, centre_of, draw_follower, ring, top_of
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.pictures.profilemarks import LAID, draw_marks, marks_of, name_marks
from tmmcalc.cams.pictures.profilesizes import draw_phases, draw_sizes, name_phases, write_sizes
from tmmcalc.cams.pictures.toscale import closed_up, lengths_text
from tmmcalc.cams.pictures.wording import mm, sense_of, wall_name
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.results import Profile, Wall
from tmmcalc.cams.task import CamTask
from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import SIDES, stacked
from tmmcalc.report.drawing.diagram import key_rows
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.key import samples_in_rows
from tmmcalc.report.drawing.lettering import width
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.pens import INK, MARK, PATH, THICK, Pen
from tmmcalc.report.drawing.scales import length_scale
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import round_scale

MARGIN = 11.0  # [mm], for the dimensions
GAPS = (0.9, 1.7, 2.8, 4.0, 5.5)  # of the name of the roller
FOOT = 15.0  # room of the legend [mm]
BODY = "#eef2f5"
GROOVE = "#d3dbe2"
TOOL = Pen("TOOL_PATH", 0.3, (3.0, 1.0), "#009e73")
PENS = {
    "pitch": Pen("PITCH_CURVE", 0.3, (5.0, 1.2, 0.9, 1.2), PATH.colour),
    "inner": THICK._replace(layer="PROFILE"),
    "outer": THICK._replace(layer="PROFILE"),
    "tool": TOOL,
    "outer tool": TOOL,
    "base": Pen("BASE_CIRCLE", 0.25, (3.0, 1.0), "#6b6b6b"),
    "shaft": Pen("SHAFT", 0.35, colour=MARK.colour),
    "lost": Pen("UNDERCUT", 0.9, colour="#e99a63"),
}


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return profile_drawing(cam_of(order), order.results["cam_profile"])


def profile_drawing(task: CamTask, result: Profile) -> Drawing:
    """One sheet: the cam on the left, curvature (of a flat face the radius) on the right."""
    drawing, box = titled(_heading(result), 2.9)
    left, right = box.split(1.62, 1.0, gap=4, across=True)
    rim = Rim(result.follower, task.program)
    upper, lower = stacked(right, [len(key_rows(names_of(task, result), right.width - SIDES[0] - SIDES[2])), 0])
    draw_bends(drawing, upper, task, rim, result)
    draw_distance(drawing, lower, rim, result)
    draw_cam(drawing, left, task, result)
    return drawing


def draw_cam(drawing: Drawing, box: Box, task: CamTask, result: Profile, *, to_scale: bool = False) -> Board:
    """The cam with its follower and all sizes, under it what the lines are; ``to_scale``: at a standard scale."""
    board = _draw_cam(drawing, box.inset(0, FOOT, 0, 0), task, result, to_scale=to_scale)
    said = lengths_text(board.mu, to_scale)
    foot = board.box.bottom
    _legend(drawing, Box(box.left, foot - FOOT, box.right, foot - 1.0), task, result, said)
    return board


def height_of(task: CamTask, result: Profile, box: Box) -> float:
    """What the cam at a standard scale takes of the height of a rectangle."""
    _, every, around = _content(result, Rim(result.follower, task.program))
    return closed_up(box.inset(0, FOOT, 0, 0), np.append(every, around), MARGIN).height + FOOT


def _content(result: Profile, rim: Rim) -> tuple[dict[str, Plane], Plane, Plane]:
    """The curves of the walls by their names, the points of all curves, and what stands around them."""
    curves: dict[str, Plane] = {wall.name: _curve(rim, wall.distance) for wall in result.walls}
    frame = _frame_of(result)
    if result.pitch is None:
        return curves, np.concatenate([*curves.values()]), frame
    return (
        curves,
        np.concatenate([*curves.values(), _curve(rim, 0.0)]),
        np.append(frame, _curve(rim, -result.follower.roller)),
    )


def _heading(result: Profile) -> str:
    follower = result.follower
    sizes = [_size("R_0", follower.base)]
    if follower.kind == "translating":
        # e > 0 in the user's sense is on the right of O
        sizes.append(_size("e", follower.offset * follower.sense))
    if follower.kind == "oscillating":
        sizes += [_size("l_0", follower.centres), _size("l_2", follower.rocker)]
    if not result.flat:
        sizes.append(_size("r_2", follower.roller))
        if result.inner_reach is not None:
            sizes.append(tr("largest roller {radius} mm", radius=mm(result.inner_reach.distance)))
    return tr("Profile of the cam, which turns {sense}: {sizes}", sense=sense_of(follower), sizes=", ".join(sizes))


def _size(sign: str, value: float) -> str:
    return f"${sign}$ = {mm(value)} {tr_unit('mm')}"


def _curve(rim: Rim, distance: float) -> Plane:
    """A whole offset in the user's sense (m,)."""
    parts = [rim.at(phi, piece).offset(distance) for phi, piece in pieces_of(rim)]
    placed: Plane = rim.follower.placed(np.concatenate(parts))
    return placed


def _draw_cam(drawing: Drawing, box: Box, task: CamTask, result: Profile, *, to_scale: bool) -> Board:
    follower = result.follower
    rim = Rim(follower, task.program)
    curves, every, around = _content(result, rim)
    pitch = None if result.flat else _curve(rim, 0.0)
    content = np.append(every, around)
    if to_scale:
        box = closed_up(box, content, MARGIN)
    board = Board(drawing, box, content, MARGIN, scale=length_scale if to_scale else round_scale)
    for name, colour in (("outer", GROOVE), ("inner", BODY)):
        if name in curves:
            board.filled(curves[name], colour, level=0.5 if name == "outer" else 0.6)
    ring(board, 0j, follower.base, PENS["base"], weight=0.15)
    if task.limits.shaft:
        ring(board, 0j, task.limits.shaft, PENS["shaft"])
    if follower.offset:
        ring(board, 0j, abs(follower.offset), AXES, weight=0.15)
    marks = marks_of(task, result, rim)
    draw_marks(board, marks, follower)
    if pitch is not None and follower.roller:
        board.line([*pitch, pitch[0]], PENS["pitch"], weight=0.7, level=3)
    for wall in result.walls:
        points = curves[wall.name]
        board.line([*points, points[0]], PENS[wall.name], level=5)
        _draw_lost(board, rim, wall)
    draw_follower(board, follower, result.face)
    _draw_axis(board, result)
    draw_phases(board, task, result)
    sizes = draw_sizes(board, rim, result, every)
    _name_points(board, result)
    name_marks(board, marks)
    write_sizes(board, sizes)
    name_phases(board, task, result)
    return board


def _frame_of(result: Profile) -> Plane:
    """Places that the drawing has to hold beside the curves: the base circle, the follower at the start, the pivot."""
    follower = result.follower
    circle = follower.base * np.array([1, 1j, -1, -1j])
    if follower.kind == "oscillating":
        return np.append(circle, 1.04 * follower.centres)
    top = top_of(follower)
    reach = 0.0 if result.face is None else max(result.face.left, result.face.right) + result.face.margin
    return np.append(circle, [top - reach, top + reach])


def _draw_lost(board: Board, rim: Rim, wall: Wall) -> None:
    """What is undercut, and the points in which the wall crosses itself."""
    for begin, end in wall.loops:
        points = rim.follower.placed(rim.at(np.linspace(begin, end, DENSE)[1:-1]).offset(wall.distance))
        board.line(points, PENS["lost"], level=6)
    size = 1.0 * board.mu
    for crossing in wall.crossings:
        at = crossing.point
        board.lines([(at - way * size, at + way * size) for way in (1 + 1j, 1 - 1j)], MARK, level=8)


def _draw_axis(board: Board, result: Profile) -> None:
    """O, and the arrow of rotation."""
    board.circle(0j, 0.9, level=9)
    arc = _turn(result)
    board.line(arc[:-1], MARK._replace(width=0.4), level=7)
    board.arrowhead(complex(arc[-1]), complex(arc[-1] - arc[-3]), MARK)


def _turn(result: Profile) -> Plane:
    """The arrow's arc [m]."""
    radius, sense = min(0.25 * result.follower.base, 0.4 * result.nearest.value), -result.follower.sense
    turn = np.linspace(0.35 * np.pi, 0.35 * np.pi + sense * 0.9 * np.pi, 41) + (np.pi if sense < 0 else 0)
    return np.asarray(radius * np.exp(1j * turn))


def _name_points(board: Board, result: Profile) -> None:
    """O, the speed, the pivot and the roller."""
    follower, arc = result.follower, _turn(result)
    middle = complex(arc[len(arc) // 2])
    board.labels.put("$O$", board.paper([0j]), prefer=-1 - 1j)
    board.labels.put("$ω$", board.paper([middle]), prefer=middle, colour=MARK.colour)
    if follower.kind == "oscillating":
        board.labels.put("$A$", board.paper([complex(follower.centres)]), prefer=1 + 1j)
    if not result.flat:
        board.labels.put("$C$", board.paper([centre_of(follower)]), prefer=1 - 1j, gaps=GAPS)


def _legend(drawing: Drawing, box: Box, task: CamTask, result: Profile, scale: str) -> None:
    follower = result.follower
    entries = [] if result.flat or not follower.roller else [(tr("pitch curve"), PENS["pitch"])]
    entries += [(wall_name(wall.name), PENS[wall.name]) for wall in result.walls]
    entries.append((tr("base circle"), PENS["base"]))
    entries.append((tr("lift, laid off"), LAID))
    if task.limits.shaft:
        entries.append((tr("shaft"), PENS["shaft"]))
    if any(wall.loops for wall in result.walls):
        entries.append((tr("undercut"), PENS["lost"]))
    text = tr("scale {scale}; dots with numbers: follower at $i$ of the tables", scale=scale)
    if result.flat:
        text = tr("scale {scale}; dots with numbers: contact at $i$ of the tables", scale=scale)
    drawing.add(Words(complex(box.middle.real, box.top), text, min(2.2, box.width / width(text)), 1j, colour=INK))
    samples_in_rows(drawing, box.inset(0, 0, 0, 4.5), entries, 2.0)
