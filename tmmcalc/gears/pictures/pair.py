"""The sheets of a pair: the mesh to scale with its parameters, sliding and pressure under it, the whole pair."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.meshing.halftooth import fault_of
from tmmcalc.gears.meshing.members import both
from tmmcalc.gears.meshing.refusal import error_of_all
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.pictures.listing import list_rows
from tmmcalc.gears.pictures.mesh import draw_mesh
from tmmcalc.gears.pictures.pairtable import contact_values, parameters
from tmmcalc.gears.pictures.placedpair import Body, PlacedPair, placed_pair
from tmmcalc.gears.pictures.sketch import ACTION, ACTIVE, COLOURS, COLUMN, FACES, circle_pen
from tmmcalc.gears.pictures.slidingcurves import draw_course
from tmmcalc.gears.pictures.words import pair_title
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.lettering import minus, plain, width, wrapped
from tmmcalc.report.drawing.order import PHASE, Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.pens import AXIS, WHITE, Pen
from tmmcalc.report.drawing.scales import fitting_scale, scale_text
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr
from tmmcalc.report.numbers import number
from tmmcalc.report.rows import check_choice

HEAD = 9.0  # of the heading of a sheet [mm]
TABLE = 74.0  # width of the tables
GAP = 3.0  # between a column of radii and the table
HEADING, REMARK = 3.2, 2.4  # heights of the heading and of what stands at its right
TOLD = 2.5  # height of the reasons why there is no drawing
LEAST = 5.0  # radius on paper of a wheel whose rotation is shown [mm]
EDGE = Pen("WHEELS", 0.2)


def chosen(found: Pairs, choose: int | None) -> tuple[MeshPair, ...]:
    """All pairs, or the one of this number, from 1; raises `UsageError` if there is none."""
    if choose is None:
        return found.pairs
    check_choice(choose, len(found.pairs), "pair")
    return (found.pairs[choose - 1],)


def figure(order: Order) -> Drawing:
    """The drawing of the stage, of the pair that is chosen, in a phase of its mesh."""
    return pair_drawing(order.results["pair"], choose=order.choice, phase=order.angle(PHASE))


def pair_drawing(found: Pairs, *, choose: int | None = None, phase: float = 0.0) -> Drawing:
    """Two sheets a pair; the first wheel has turned clockwise by ``phase`` [rad] since the contact at P.

    ``choose`` is the number of a pair, from 1; None: all. A pair with a wheel that has no profile has one sheet, which
    tells why. Raises `UsageError` for a pair that there is not, `NoSolutionError` if no other pair can be drawn.
    """
    faulty, sound = list[tuple[MeshPair, list[NoSolutionError]]](), list[PlacedPair]()
    for one in chosen(found, choose):
        errors = [error for member in both(one) if (error := fault_of(member)) is not None]
        if errors:
            faulty.append((one, errors))
        else:
            sound.append(placed_pair(one, phase))
    if not sound:
        every = [error for _, errors in faulty for error in errors]
        raise error_of_all(every, 2 * len(faulty))
    drawing, boxes = sheets(2 * len(sound) + len(faulty), tr("Pairs of gears"))
    for k, pair in enumerate(sound):
        _draw_sheets(drawing, boxes[2 * k], boxes[2 * k + 1], pair)
    for box, (one, errors) in zip(boxes[2 * len(sound) :], faulty, strict=True):
        tell(drawing, box, tr("Mesh {pair} cannot be drawn", pair=pair_title(one.task)), errors)
    return drawing


def tell(drawing: Drawing, box: Box, title: str, errors: Sequence[NoSolutionError]) -> None:
    """A sheet in place of a drawing, with the reasons why there is none."""
    free = heading(drawing, box, title)
    said = [plain(f"{error.where}: {error.message}; remedy: {error.remedy}") for error in errors]
    lines = [line for text in said for line in wrapped(text, free.width, TOLD)]
    drawing.add(Words(complex(free.left, free.top), "\n".join(lines), TOLD, -1 + 1j))


def heading(drawing: Drawing, box: Box, title: str, remark: str = "") -> Box:
    """The heading of a sheet, with a remark at its right; what is free under them."""
    wide = width(title, HEADING) + width(remark, REMARK) + 6.0
    part = min(1.0, box.width / wide)
    y = box.top - 2.0
    drawing.add(Words(complex(box.left, y), title, part * HEADING, -1))
    if remark:
        drawing.add(Words(complex(box.right, y), remark, part * REMARK, 1))
    return box.inset(0, 0, 0, HEAD)


def _draw_sheets(drawing: Drawing, first: Box, second: Box, pair: PlacedPair) -> None:
    """Both sheets of a pair; the sliding curves stand under the mesh that they belong to."""
    free = first.inset(0, 0, 0, HEAD)
    frame = Box(free.left + COLUMN, free.bottom, free.right - TABLE - GAP - COLUMN, free.top)
    board = draw_mesh(drawing, frame, pair)
    heading(drawing, first, *_title(pair, board.mu))
    table = Box(free.right - TABLE, free.bottom, free.right, free.top)
    list_rows(drawing, table, parameters(pair.found), (57.0, TABLE))
    free = heading(drawing, second, tr("Specific sliding and specific pressure along the line of action"))
    upper, lower = Box(frame.left, free.bottom + 10, frame.right, free.top - 17).split(1.15, 1.0, gap=8)
    ends = board.data(complex(frame.left, frame.bottom)).real, board.data(complex(frame.right, frame.top)).real
    draw_course(drawing, (upper, lower), pair, ends)
    beside = Box(free.right - TABLE, free.bottom, free.right, free.top)
    whole, values = beside.split(1.2, 1.0, gap=8)
    draw_whole(drawing, whole, pair)
    list_rows(drawing, values, contact_values(pair), (26.0, 42.0, 58.0, TABLE))


def _title(pair: PlacedPair, mu: float) -> tuple[str, str]:
    found = pair.found
    title, scale = pair_title(found.task), scale_text(mu)
    head = tr("Mesh {pair}", pair=title) if found.task.name else tr("Mesh of {pair}", pair=title)
    if pair.phase:
        angle = minus(number(math.degrees(pair.phase), 4))
        head += tr(", turned by {angle}° since the contact at $P$", angle=angle)
    if found.task.helix:
        return head, tr("transverse section; {scale}; lengths in mm", scale=scale)
    return head, tr("{scale}; lengths in mm", scale=scale)


def draw_whole(drawing: Drawing, box: Box, pair: PlacedPair) -> None:
    """The whole pair, small, with its scale under it."""
    content = np.concatenate([body.whole for body in pair.bodies])
    frame = box.inset(0, 5, 0, 0)
    board = Board(drawing, frame, content, 3.0, fitting_scale(content, frame, 3.0))
    for body in pair.bodies[::-1]:
        _draw_wheel(board, body)
    at = np.array([body.centre for body in pair.bodies if body.sizes is not None])
    over = 4 * board.mu * 1j
    ends = np.concatenate([at, [pair.pitch_point]])
    low, high = ends.imag.min() * 1j, ends.imag.max() * 1j
    board.line([low - over, high + over], AXIS, weight=0.3, level=6)
    line = pair.found.line
    board.line(pair.on_line(np.array([min(0.0, line.length), max(line.end, line.length)])), ACTION, level=9)
    board.line(pair.on_line(np.array([line.begins, line.ends])), ACTIVE, level=10)
    for body in pair.bodies:
        if body.sizes is not None:
            board.circle(body.centre, 0.6, level=11)
            at_ = board.paper([body.centre])
            board.labels.put(f"$O_{body.number}$", at_, height=2.4, prefer=-1 + 0j, gaps=(1.0, 1.8, 3.0))
            _arrow(board, body)
    board.labels.put("$P$", board.paper([pair.pitch_point]), height=2.4, gaps=(1.2, 2.2, 3.6))
    drawing.add(Words(complex(box.right, box.bottom), scale_text(board.mu), 2.3, 1 - 1j))


def _draw_wheel(board: Board, body: Body) -> None:
    face, sizes = FACES[body.number - 1], body.sizes
    if sizes is None:
        board.area(np.concatenate([body.edge, body.back[::-1]]), EDGE, fill=face, weight=0.3, level=3)
        return
    if body.kind == "ring":
        board.circle(body.centre, abs(body.back[0] - body.centre) / board.mu, EDGE, fill=face, level=3)
        board.area(body.whole, EDGE, fill=WHITE, weight=0.1, level=3)
    else:
        board.area(body.whole, EDGE, fill=face, weight=0.1, level=3)
    board.arc(body.centre, sizes.operating, circle_pen("operating", COLOURS[body.number - 1]), weight=0.2, level=5)


def _arrow(board: Board, body: Body) -> None:
    """The sense of rotation while the first wheel drives."""
    if body.sizes is None or body.sizes.root < LEAST * board.mu:
        return
    sense = 1 if body.number == 1 or body.kind == "ring" else -1
    radius = (0.45 if body.kind == "external" else 0.8) * body.sizes.root
    arc = body.centre + radius * np.exp(1j * (math.radians(200) + sense * np.linspace(0, math.radians(50), 21)))
    colour = COLOURS[body.number - 1]
    pen = Pen("ROTATIONS", 0.4, (), colour)
    board.line(arc, pen, level=9, weight=0.5)
    board.arrowhead(complex(arc[-1]), complex(arc[-1] - arc[-2]), pen, 2.4)
    board.labels.put(
        f"$ω_{body.number}$", board.paper([complex(arc[10])]), height=2.4, gaps=(1.4, 2.2, 3.2), colour=colour
    )
