"""Polar hodographs: the path of the tip of a reaction over the cycle, to a round scale."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, MaxNLocator

from tmmcalc.core.plane import Plane
from tmmcalc.core.records import record
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.model import FRAME, Mechanism
from tmmcalc.linkage.pictures.course import DiagramCourse
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.curves import DOTTED, suited
from tmmcalc.report.drawing.labels import signed, upright
from tmmcalc.report.drawing.style import CURVES
from tmmcalc.report.numbers import number

MARGIN = 7.0  # free border [mm]
APART = 5.0  # positions nearer than this to a numbered one go without a number [mm]
JUMP = 1e-3  # a step between panels above this part of the largest is a jump


@record
class Hodograph:
    """Pairs that share a hodograph, in the fixed axes or in those of the crank."""

    pairs: tuple[int, ...]  # rows of the result
    turning: bool


def hodographs_of(mechanism: Mechanism, result: Forces) -> list[Hodograph]:
    """Main bearing and crank pins in the fixed axes, crank pins in those of the crank.

    Of a driven slider: its pins, and the pivots on the frame.
    """
    link = _input_link(mechanism)
    pins = [j for j, pair in enumerate(result.pairs) if pair.kind == "revolute" and link in pair.links]
    moving = tuple(j for j in pins if FRAME not in result.pairs[j].links)
    if result.turns:
        return [Hodograph(tuple(pins), False), *([Hodograph(moving, True)] if moving else [])]
    pivots = tuple(j for j, p in enumerate(result.pairs) if p.kind == "revolute" and FRAME in p.links)
    return [Hodograph(pairs, False) for pairs in (moving, pivots) if pairs]


def _input_link(mechanism: Mechanism) -> int:
    joint = mechanism.joint(mechanism.input.joint)
    return next(link for link in joint.links if link != FRAME)


def prepare(axes: Axes) -> None:
    """Names of the axes, so that the layout reserves room for them."""
    axes.set_title("title\nscale")
    axes.set_xlabel("$R_x$, kN")
    axes.set_ylabel("$R_y$, kN")


def draw_hodograph(axes: Axes, result: Forces, course: DiagramCourse, drawn: Hodograph, link: int) -> None:
    """Draw on an axes whose place is settled; ``link`` is the crank."""
    axes_of = np.conj(course.turn) if drawn.turning else np.ones_like(course.turn)
    paths = {j: course.reaction[j] * axes_of for j in drawn.pairs}
    everything = np.concatenate([*paths.values(), [0j]])
    board = Board(axes, everything, MARGIN)
    peak = float(np.max(np.abs(everything)))
    _axes(axes, peak, drawn.turning)
    board.line((-2 * peak, 2 * peak), linewidth=0.7, color="#333333", weight=0.2)
    board.line((-2j * peak, 2j * peak), linewidth=0.7, color="#333333", weight=0.2)
    for k, path in enumerate(paths.values()):
        _draw(board, path.reshape(course.panels, -1), CURVES[k % len(CURVES)], peak)
    board.circle(0j, 0.8, zorder=9)
    same = all(np.max(np.abs(path - paths[drawn.pairs[0]])) <= JUMP * peak for path in paths.values())
    for j, style in zip(drawn.pairs[:1] if same else drawn.pairs, CURVES, strict=False):
        _number(board, result, j, drawn.turning, course, style["color"])
    _title(axes, result, drawn, board.mu, link)


def _draw(board: Board, panels: Plane, style: dict[str, Any], peak: float) -> None:
    """Smooth pieces as curves, jumps between them as thin dotted lines."""
    piece = [panels[0]]
    for before, after in pairwise(panels):
        if abs(after[0] - before[-1]) > JUMP * peak:
            board.line(np.concatenate(piece), linewidth=1.3, zorder=5, weight=0.5, **style)
            board.line((before[-1], after[0]), linewidth=0.8, zorder=4, color=style["color"], linestyle=(0, (1, 1.5)))
            piece = []
        piece.append(after)
    board.line(np.concatenate(piece), linewidth=1.3, zorder=5, weight=0.5, **style)


def _number(board: Board, result: Forces, j: int, turning: bool, course: DiagramCourse, color: str) -> None:
    """Positions as dots, some of them numbered where there is room."""
    if len(result.labels) > DOTTED:
        return
    at = result.reaction[j]
    if turning:
        at = at * np.conj(course.turn[0] * np.exp(1j * result.phi))
    board.axes.plot(at.real, at.imag, "o", markersize=2.2, color=color, zorder=8)
    numbered: list[complex] = []
    for label, tip in zip(result.labels, at.tolist(), strict=True):
        if all(abs(tip - other) > APART * board.mu for other in [0j, *numbered]):
            numbered.append(tip)
            board.labels.put(label, [tip], size=5.5, prefer=tip, gaps=(0.8, 1.4, 2.2), color=color)


def _axes(axes: Axes, peak: float, turning: bool) -> None:
    name_axes(axes, ("R_\\parallel", "R_\\perp") if turning else ("R_x", "R_y"), peak, "N")


def name_axes(axes: Axes, names: tuple[str, str], peak: float, unit: str) -> None:
    """Names, grid and ticks of a hodograph of values as large as ``peak``, which is drawn in SI."""
    factor, shown = suited(peak, unit)
    for axis, name in zip((axes.xaxis, axes.yaxis), names, strict=True):
        axis.set_major_locator(MaxNLocator(6, steps=[1, 2, 2.5, 5, 10]))
        axis.set_major_formatter(FuncFormatter(lambda v, _: signed(round(v * factor, 9), 6)))
        axis.set_label_text(f"${name}$, {shown}")
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.tick_params(length=2.5)


def _title(axes: Axes, result: Forces, drawn: Hodograph, mu: float, link: int) -> None:
    handles = [
        Line2D([], [], label=f"$R_{{{upright(pair.joint)}}}$ ({pair.links[0]}–{pair.links[1]})", **style)
        for pair, style in zip((result.pairs[j] for j in drawn.pairs), CURVES * 3, strict=False)
    ]
    axes.legend(handles=handles, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=4, handlelength=2.5)
    where = f"in the axes of crank {link}" if drawn.turning else "in the fixed axes"
    axes.set_title(f"Hodograph {where}\n$\\mu_F$ = {number(mu, 4)} N/mm", pad=18)
