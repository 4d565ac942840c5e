"""The plane of the shifts: areas, lines and points of a blocking contour, to one scale in both directions."""

from __future__ import annotations

from collections.abc import Iterable
from textwrap import fill
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.patches import PathPatch
from matplotlib.path import Path
from matplotlib.ticker import FuncFormatter, MultipleLocator

from tmmcalc.core.plane import Plane
from tmmcalc.gears.meshing.contours import ContourPoint, Outline, PairContour
from tmmcalc.gears.pictures.contourlines import Stroke, strokes
from tmmcalc.gears.pictures.contourlook import BELT, BORDER, FILL, HATCH, PALE, STRICT, STROKES, marker_of, together
from tmmcalc.gears.pictures.contournumbers import EDGE, corners, number_stroke, seen
from tmmcalc.gears.pictures.contourpaths import outlines, smooth
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.style import INK

MARGIN = 13.0  # about the contour [mm]
EMPTY = np.array([-1.2 - 1.2j, 2.2 + 2.2j])  # what is shown of a pair without a contour
ROOM = 2.0  # the picture grows to points and the origin by at most this factor
PIECES = 0.3  # of the main region's size: how far pieces beyond it are shown
STEPS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0)  # of the grid
APART = 8.0  # least distance of grid lines [mm]
WITHIN, BEYOND = 1.15, 0.55  # width of lines in the contour and outside
ONE = 1.2  # points that are nearer are one [mm]
NAMES = 8.0  # size of the names of points
GAPS = (1.6, 2.2, 3.0, 4.0)  # from a point to its name [mm]
PREFERRED = {"D": -1 + 1j}  # its neighbours are on the other side
PAD = 2.0  # about the reason [mm]
LETTERS = 72  # in a line of the reason


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


def draw_plane(axes: Axes, pair: PairContour) -> tuple[Stroke, ...]:
    """Draw on axes whose place must be settled; returns the lines that are seen."""
    board = Board(axes, content_of(pair), MARGIN)
    low, high = corners(board)
    _frame(board)
    _areas(board, pair)
    inside = _patch(axes, outlines(pair), facecolor="none")
    lines = tuple(s for s in strokes(pair, low, high) if any(seen(board, path, EDGE).size for path in s.paths))
    for stroke in lines:
        _stroke(board, stroke, inside)
    _borders(board, pair)
    points = together(pair.points, ONE * board.mu)
    for point, _ in points:
        axes.plot(point.x1, point.x2, **marker_of(point))
        board.labels.avoid([complex(point.x1, point.x2)], 8.0)
    _say_empty(board, pair)
    for stroke in lines:
        number_stroke(board, stroke)
    _name_points(board, points)
    return lines


def _frame(board: Board) -> None:
    """The grid, equal in both directions, and the axes through the origin if it is seen."""
    axes, (low, high) = board.axes, corners(board)
    step = next((step for step in STEPS if step >= APART * board.mu), STEPS[-1])
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MultipleLocator(step))
        axis.set_major_formatter(FuncFormatter(lambda v, _: signed(round(v, 9), 6)))
    axes.grid(True, linewidth=0.35, color="#cfcfcf")
    axes.set_axisbelow("line")
    axes.tick_params(length=2.5)
    if low.imag < 0 < high.imag:
        _axis(board, low.real, high.real, "$x_1$")
    if low.real < 0 < high.real:
        _axis(board, 1j * low.imag, 1j * high.imag, "$x_2$")


def _axis(board: Board, start: complex, tip: complex, name: str) -> None:
    across = tip / abs(tip) if tip else start / -abs(start)
    board.line([start, tip], linewidth=0.9, weight=0.3, zorder=2)
    board.arrowhead(tip, across, length=2.8, zorder=9)
    board.labels.put(name, [tip - 3.5 * board.mu * across], size=9, gaps=(1.2, 2.0), prefer=-1j if across == 1 else -1)


def _areas(board: Board, pair: PairContour) -> None:
    """The tolerated regions hatched, the strict ones over them, pieces beyond a pinch point pale."""
    for which in (_of(pair.tolerated.main), pair.tolerated.pieces):
        patch = _patch(board.axes, which, zorder=1.0, **BELT[FILL])
        if patch is not None:
            hatch = LineCollection(_hatching(board, which), zorder=1.1, **BELT[STROKES])
            board.axes.add_collection(hatch)
            hatch.set_clip_path(patch)
    _patch(board.axes, _of(pair.strict.main), zorder=1.2, **STRICT[FILL])
    _patch(board.axes, pair.strict.pieces, zorder=1.2, **PALE[FILL])


def _of(main: Outline | None) -> tuple[Outline, ...]:
    return () if main is None else (main,)


def _patch(axes: Axes, which: Iterable[Outline], **style: Any) -> PathPatch | None:
    """Closed curves as one patch; none if there are none."""
    rings = [np.column_stack((z.real, z.imag)) for z in map(smooth, which)]
    if not rings:
        return None
    codes = [[Path.MOVETO, *[Path.LINETO] * (len(ring) - 2), Path.CLOSEPOLY] for ring in rings]
    patch = PathPatch(Path(np.concatenate(rings), np.concatenate(codes)), edgecolor="none", **style)
    axes.add_patch(patch)
    return patch


def _hatching(board: Board, which: Iterable[Outline]) -> list[list[tuple[float, float]]]:
    """Strokes that rise at 45 degrees over what these curves enclose."""
    low, high = _extremes(np.concatenate([_closed(outline) for outline in which]))
    pitch = HATCH * board.mu * np.sqrt(2)
    # the intercepts are multiples of the pitch, so that neighbouring areas have common strokes
    first, last = np.floor((low.imag - high.real) / pitch), np.ceil((high.imag - low.real) / pitch)
    ends = low.real, high.real
    return [[(x, x + c) for x in ends] for c in pitch * np.arange(first, last + 1)]


def _stroke(board: Board, stroke: Stroke, inside: PathPatch | None) -> None:
    """A line, thin all along and stronger in the contour."""
    for path in stroke.paths:
        board.line(path, weight=0.35, zorder=3, linewidth=BEYOND, label=f"_{stroke.number}", **stroke.look)
        if inside is not None:
            (line,) = board.axes.plot(path.real, path.imag, zorder=3.1, linewidth=WITHIN, **stroke.look)
            line.set_clip_path(inside)


def _borders(board: Board, pair: PairContour) -> None:
    """Strong about the strict region, lighter about the tolerated one, pale about pieces."""
    for area, look in ((pair.tolerated, BELT), (pair.strict, STRICT)):
        for piece in area.pieces:
            board.line(smooth(piece), weight=0.8, zorder=3.5, **PALE[BORDER])
        if area.main is not None:
            board.line(smooth(area.main), weight=0.6 + area.strict, zorder=4 + area.strict, **look[BORDER])


def _name_points(board: Board, points: list[tuple[ContourPoint, str]]) -> None:
    low, high = corners(board)
    for point, name in points:
        if low.real < point.x1 < high.real and low.imag < point.x2 < high.imag:
            board.labels.put(
                name, [complex(point.x1, point.x2)], size=NAMES, gaps=GAPS, prefer=PREFERRED.get(name, 1 + 1j)
            )


def _say_empty(board: Board, pair: PairContour) -> None:
    """The reason in a corner of the picture if nothing at all is admissible; numbers keep clear of it."""
    if pair.strict.main is None and pair.tolerated.main is None:
        axes, said = board.axes, fill(pair.tolerated.reason or pair.strict.reason, LETTERS)
        look: dict[str, Any] = {"ha": "right", "va": "bottom", "multialignment": "left", "size": 8, "zorder": 25}
        frame = {"boxstyle": "round,pad=0.5", "fc": "white", "ec": INK, "lw": 0.6}
        box = axes.text(0.98, 0.03, said, transform=axes.transAxes, bbox=frame, **look).get_window_extent()
        (x0, y0), (x1, y1) = axes.transData.inverted().transform(box.get_points())
        pad = PAD * board.mu
        for y in np.linspace(y0 - pad, y1 + pad, 6).tolist():
            board.labels.avoid([complex(x0 - pad, y), complex(x1 + pad, y)], 4.0)
