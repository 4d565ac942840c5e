"""The diagram S'(dS) with the tangents at +-[theta] and the admissible zone of the axis (figures 5.14, 5.15).

Abscissa dS, ordinate S', one scale, in mm. The axis of the cam stands at (-S0, -e): the ray from it to a point of the
curve is inclined by the pressure angle there. The sense is the canonical one: e > 0 steepens the rise.
"""

from __future__ import annotations

from math import atan, cos, sin

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter, MaxNLocator

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.pictures.zone import LIMIT, OTHER, ZONE, axis_of_cam, dimension
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.cams.synthesis.translatingsizes import Line, lines_of, region_of
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.style import CURVES, INK, THIN

POINTS = 241
FAR = 5.0  # S0 to which the zone is drawn
BEYOND = 0.22  # of S0 + h, what is shown around


def content_of(task: CamTask, result: Synthesis) -> Complex:
    """Points [mm] that the drawing has to show."""
    o, curves = _axis(result), np.concatenate([_curve(task, kind) for kind in ("rise", "return")])
    reach = BEYOND * (abs(o.real) + 1e3 * task.program.stroke)
    ends = [min(o.real, _apex(result).real) - 1.6 * reach, o - 1j * reach, o + 1j * reach]
    return np.concatenate((curves, curves.max(keepdims=True) + 0.5 * reach, np.array(ends)))


def name_axes(axes: Axes, result: Synthesis) -> None:
    """What stands along the axes; e is said in the user's sense."""
    e = "e" if result.follower.sense > 0 else "-e"
    axes.set_xlabel("$\\Delta S$, mm  ($S_0$ to the left of zero)")
    axes.set_ylabel(f"$S'$, mm  (${e}$ below zero)")


def draw_plane(board: Board, task: CamTask, result: Synthesis) -> None:
    """Zone, curve, tangents, the axis with S0 and e, the textbook's choice."""
    axes = board.axes
    axes.axhline(0, color=INK, linewidth=0.8, zorder=3)
    axes.axvline(0, color=INK, linewidth=0.8, zorder=3)
    axes.grid(True, linewidth=0.35, color="#dddddd", zorder=0)
    axes.set_axisbelow(True)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(10))
        axis.set_major_formatter(FuncFormatter(lambda v, _: signed(v, 6)))
    for end in ((-1e6 + 0j, 1e6 + 0j), (-1e6j, 1e6j)):
        board.labels.avoid(
            np.clip(np.array(end).real, *axes.get_xlim()) + 1j * np.clip(np.array(end).imag, *axes.get_ylim()), 2.0
        )
    lines = lines_of(task)
    region = region_of(lines, (0.0, FAR * result.follower.start))  # to beyond the border of the drawing
    board.area((-1e3 * (region.y + 1j * region.x)).tolist(), weight=0.0, **ZONE)
    for kind, style in (("rise", CURVES[0]), ("return", CURVES[2])):
        board.line(_curve(task, kind), linewidth=1.7, zorder=8, **{"weight": 1.5, **style})
    held = () if result.region is None else zip(result.region.phi.tolist(), result.region.side.tolist(), strict=True)
    bounding = set(held)
    for line in lines:
        _draw_tangent(board, task, line, (line.phi, line.side) in bounding)
    _draw_axis(board, result)


def _draw_tangent(board: Board, task: CamTask, line: Line, bounds: bool) -> None:
    """The tangent through its point of the curve, from beyond it to the border of the drawing."""
    y, y1 = task.program.at(np.array([line.phi]))[:2, 0]
    lean = atan(1 / line.slope)
    at, along = 1e3 * complex(y, y1), complex(cos(lean), sin(lean))
    left, right = board.axes.get_xlim()
    over = min(0.12 * (right - left), (right - at.real) / along.real)
    board.line([at + over * along, at - (at.real - left) / along.real * along], **(LIMIT if bounds else OTHER))
    if not bounds:
        return
    board.axes.plot(at.real, at.imag, "o", markersize=4, markerfacecolor="white", color=LIMIT["color"], zorder=12)
    board.labels.put(f"{signed(np.degrees(line.phi), 4)}°", [at], size=7.5, prefer=complex(1, line.side))
    text = f"${'+' if line.side > 0 else '-'}[\\theta]$"
    board.labels.put(text, [at - 0.45 * (at.real - left) * along], size=8.5, color=LIMIT["color"])


def _draw_axis(board: Board, result: Synthesis) -> None:
    o = _axis(result)
    high = board.axes.get_ylim()[0] + 7 * board.mu
    for z in (o, complex(0, o.imag)):
        board.line([z, complex(z.real, high - 2 * board.mu)], color=THIN, linewidth=0.6, zorder=3)
    dimension(board, complex(o.real, high), complex(0, high), f"$S_0$ = {signed(-o.real, 6)}")
    e = result.follower.sense * result.follower.offset * 1e3 + 0.0
    dimension(board, complex(o.real, 0), o, f"$e$ = {signed(e, 6)}")
    book = next((each for each in result.designs if each.name.startswith("textbook (")), None)
    if book is not None:
        at = -1e3 * complex(book.start, book.offset)
        board.axes.plot(
            at.real, at.imag, "s", markersize=5, markerfacecolor="white", color=CURVES[3]["color"], zorder=14
        )
        board.labels.avoid([at], 3.0)
        board.labels.put("$O^*$ (5.44)", [at], size=8.5, prefer=1 + 1j, color=CURVES[3]["color"], gaps=(2.0, 3.0, 5.0))
    axis_of_cam(board, o)


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
