"""The plane of the shifts: areas, lines and points of a blocking contour, to one scale in both directions."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.meshing.contours import Outline, PairContour
from tmmcalc.gears.pictures.contourlines import Stroke, strokes
from tmmcalc.gears.pictures.contourlook import BELT, HATCHED, PALE, STRICT, marker, together
from tmmcalc.gears.pictures.contournumbers import EDGE, number_stroke, seen
from tmmcalc.gears.pictures.contourpaths import outlines, smooth
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Axis, written
from tmmcalc.report.drawing.diagram import ticks as ticks_of
from tmmcalc.report.drawing.field import Board, clipped
from tmmcalc.report.drawing.lettering import width, wrapped
from tmmcalc.report.drawing.pens import GRID, MIDDLE, THIN, WHITE
from tmmcalc.report.drawing.regions import cut_to, parted
from tmmcalc.report.drawing.shapes import Area, Drawing, Hatching, Words
from tmmcalc.report.drawing.wording import corners
from tmmcalc.report.language import tr, tr_name

MARGIN = 13.0  # about the contour [mm]
EMPTY = np.array([-1.2 - 1.2j, 2.2 + 2.2j])  # what is shown of a pair without a contour
ROOM = 2.0  # the picture grows to points and the origin by at most this factor
PIECES = 0.3  # of the main region's size: how far pieces beyond it are shown
APART = 10.0  # least distance of grid lines [mm]
SIDES = (15.0, 11.0)  # room for numbers and names left and below [mm]
NUMBERS, NAMES = 2.3, 2.5  # heights of the numbers along the axes and of the names of points [mm]
HATCH = 2.0  # distance of the hatching's strokes [mm]
ONE = 1.2  # points that are nearer are one [mm]
GAPS = (1.3, 2.6, 5.0, 9.0, 15.0, 22.0)  # from a point to its name [mm]
PREFERRED = {"D": -1 + 1j}  # its neighbours are on the other side
PAD = 2.0  # about the reason [mm]
SAID, WIDE = 2.3, 95.0  # height of the reason and width of its lines [mm]


def content_of(pair: PairContour) -> Plane:
    """Two corners of what is to be seen: the contours, pieces near them, the points and the origin if not far."""
    mains = [area.main for area in (pair.strict, pair.tolerated) if area.main is not None]
    low, high = _extremes(np.concatenate([_closed(main) for main in mains]) if mains else EMPTY)
    reach = PIECES * _size(low, high)
    least, most = low - reach * (1 + 1j), high + reach * (1 + 1j)
    for outline in outlines(pair):
        z = _closed(outline)
        across = (z.real > least.real) & (z.real < most.real)
        near = z[across & (z.imag > least.imag) & (z.imag < most.imag)]
        low, high = _extremes(np.append(near, [low, high]))
    room = ROOM * _size(low, high)
    for at in (*(complex(point.x1, point.x2) for point in pair.points), 0j):
        grown = _extremes(np.array([low, high, at]))
        if _size(*grown) <= room:
            low, high = grown
    return np.array([low, high])


def _extremes(z: Plane) -> tuple[complex, complex]:
    return complex(z.real.min(), z.imag.min()), complex(z.real.max(), z.imag.max())


def _size(low: complex, high: complex) -> float:
    return max((high - low).real, (high - low).imag)


def _closed(outline: Outline) -> Plane:
    return np.asarray(outline.x1 + 1j * outline.x2)


def draw_plane(drawing: Drawing, box: Box, pair: PairContour) -> tuple[Stroke, ...]:
    """Draw in the rectangle, with numbers at its left and under it; returns the lines that are seen."""
    frame = box.inset(SIDES[0], SIDES[1], 0, 0)
    board = Board(drawing, frame, content_of(pair), MARGIN)
    low, high = board.data(complex(frame.left, frame.bottom)), board.data(complex(frame.right, frame.top))
    _frame(board, low, high)
    _areas(board, pair)
    loops = [board.paper(smooth(outline)) for outline in outlines(pair)]
    lines = tuple(s for s in strokes(pair, low, high) if any(seen(board, path, EDGE).size for path in s.paths))
    for stroke in lines:
        _stroke(board, stroke, loops)
    _borders(board, pair)
    points = together(pair.points, ONE * board.mu)
    for point, _ in points:
        at = board.place(complex(point.x1, point.x2))
        if _within(at, frame):
            drawing.add(marker(point, at), level=14)
            board.labels.avoid([at], 8.0)
    _say_empty(board, pair)
    for stroke in lines:
        number_stroke(board, stroke)
    for point, name in points:
        at = board.place(complex(point.x1, point.x2))
        if _within(at, frame):
            spot = complex(point.x1, point.x2)
            board.name(name, [spot], height=NAMES, gaps=GAPS, prefer=PREFERRED.get(name, 1 + 1j))
    return lines


def _within(at: complex, box: Box) -> bool:
    return box.left < at.real < box.right and box.bottom < at.imag < box.top


def _frame(board: Board, low: complex, high: complex) -> None:
    """The grid, equal in both directions, its numbers, and the axes through the origin if it is seen."""
    box, draw = board.box, board.drawing
    size = high - low
    most = max(2, int(max(box.width, box.height) / APART))
    longer = Axis("", 0.0, max(size.real, size.imag))
    first, second = ticks_of(longer, most)[:2]
    step = second - first
    for along, start, end in ((1, low.real, high.real), (1j, low.imag, high.imag)):
        values = [round(k * step, 9) for k in range(int(np.ceil(start / step)), int(np.floor(end / step)) + 1)]
        for value in values:
            at = board.place(value * along)
            if along == 1:
                draw.line([complex(at.real, box.bottom), complex(at.real, box.top)], GRID, level=-2)
                draw.add(Words(complex(at.real, box.bottom - 1.3), written(value, values), NUMBERS, 1j))
            else:
                draw.line([complex(box.left, at.imag), complex(box.right, at.imag)], GRID, level=-2)
                draw.add(Words(complex(box.left - 1.3, at.imag), written(value, values), NUMBERS, 1))
    edges = [complex(box.left, box.bottom), complex(box.right, box.bottom)]
    draw.line([*edges, complex(box.right, box.top), complex(box.left, box.top)], THIN, closed=True, level=-1)
    below = complex(box.middle.real, box.bottom - SIDES[1] + 0.5)
    draw.add(Words(below, tr("shift of wheel 1, $x_1$"), NAMES, -1j))
    aside = complex(box.left - SIDES[0] + 0.5, box.middle.imag)
    draw.add(Words(aside, tr("shift of wheel 2, $x_2$"), NAMES, 1j, np.pi / 2))
    if low.imag < 0 < high.imag:
        _axis(board, complex(low.real), complex(high.real), "$x_1$")
    if low.real < 0 < high.real:
        _axis(board, 1j * low.imag, 1j * high.imag, "$x_2$")


def _axis(board: Board, start: complex, tip: complex, name: str) -> None:
    across = (tip - start) / abs(tip - start)
    board.line([start, tip], MIDDLE, weight=0.3, level=2)
    board.arrowhead(tip, across, MIDDLE, 2.8, level=9)
    at = board.place(tip) - 3.5 * across
    board.labels.put(name, [at], height=2.8, gaps=(1.0, 1.8, 2.8), prefer=-1j if across.real > 0.5 else -1)


def _areas(board: Board, pair: PairContour) -> None:
    """The tolerated regions, the strict ones over them, pieces beyond a pinch point pale, and what is added hatched."""
    mains = (_of(pair.tolerated.main), _of(pair.strict.main))
    pieces = (pair.tolerated.pieces, pair.strict.pieces)
    for (tolerated, strict), fill in ((mains, STRICT.fill), (pieces, PALE.fill)):
        for outline in tolerated:
            board.face(smooth(outline), BELT.fill, level=1.0)
        loops = [cut_to(board.paper(smooth(outline)), board.box) for outline in (*tolerated, *strict)]
        if tolerated and (loops := [loop for loop in loops if len(loop)]):
            board.drawing.add(Hatching(tuple(loops), pitch=HATCH, pen=HATCHED), level=1.1)
        for outline in strict:
            board.face(smooth(outline), fill, level=1.05)


def _of(main: Outline | None) -> tuple[Outline, ...]:
    return () if main is None else (main,)


def _stroke(board: Board, stroke: Stroke, loops: Iterable[Plane]) -> None:
    """A line, thin all along and stronger in the contour."""
    within, beyond = stroke.pens
    every = list(loops)
    for path in stroke.paths:
        for part in clipped(board.paper(path), board.box):
            board.labels.avoid(part, 0.35)
            inside, outside = parted(part, every)
            for pieces, pen in ((inside, within), (outside, beyond)):
                for piece in pieces:
                    board.drawing.line(piece, pen, level=3)


def _borders(board: Board, pair: PairContour) -> None:
    """Strong about the strict region, lighter about the tolerated one, pale about pieces."""
    for area, look in ((pair.tolerated, BELT), (pair.strict, STRICT)):
        for piece in area.pieces:
            board.line(smooth(piece), PALE.border, weight=0.8, level=3.5)
        if area.main is not None:
            board.line(smooth(area.main), look.border, weight=0.6 + area.strict, level=4 + area.strict)


def _say_empty(board: Board, pair: PairContour) -> None:
    """The reason in a corner of the picture if nothing at all is admissible; numbers keep clear of it."""
    if pair.strict.main is None and pair.tolerated.main is None:
        box = board.box
        said = wrapped(tr_name(pair.tolerated.reason or pair.strict.reason), WIDE, SAID)
        wide = max(width(line, SAID) for line in said)
        words = Words(complex(box.right - 2 * PAD - wide, box.bottom + 2 * PAD), "\n".join(said), SAID, -1 - 1j)
        low, _, high, _ = corners(words).tolist()
        low, high = low - PAD * (1 + 1j), high + PAD * (1 + 1j)
        around = np.array([low, complex(high.real, low.imag), high, complex(low.real, high.imag)])
        board.drawing.add(Area(around, WHITE, MIDDLE), words, level=25)
        board.labels.keep(around)
        for y in np.linspace(low.imag, high.imag, 6).tolist():
            board.labels.avoid([complex(low.real, y), complex(high.real, y)], 4.0)
