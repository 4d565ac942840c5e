"""Polar hodographs: the path of the tip of a reaction over the cycle, to a round scale."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.core.records import record
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.model import FRAME, Mechanism
from tmmcalc.linkage.pictures.course import DiagramCourse
from tmmcalc.linkage.pictures.forcepolygon import scale_of_forces
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import ROW, key_above, key_rows
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import CURVES, MIDDLE, Pen
from tmmcalc.report.drawing.polar import AROUND, name_axes, number_tips
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr

MARGIN = 7.0  # free border [mm]
TITLE = 9.0  # height of the title [mm]
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


def draw_hodograph(
    drawing: Drawing, box: Box, result: Forces, course: DiagramCourse, drawn: Hodograph, link: int
) -> None:
    """Draw in a rectangle; ``link`` is the crank."""
    axes_of = np.conj(course.turn) if drawn.turning else np.ones_like(course.turn)
    paths = {j: course.reaction[j] * axes_of for j in drawn.pairs}
    everything = np.concatenate([*paths.values(), [0j]])
    peak = float(np.max(np.abs(everything)))
    names = _names(result, drawn)
    head = TITLE + ROW * len(key_rows(names, box.width))
    field = Board(drawing, box.inset(*AROUND, head), everything, MARGIN)
    symbols = ("R_∥", "R_⊥") if drawn.turning else ("R_x", "R_y")
    name_axes(field, symbols, peak, "N")
    for k, path in enumerate(paths.values()):
        _draw(field, path.reshape(course.panels, -1), CURVES[k % len(CURVES)], peak)
    field.circle(0j, 0.8, MIDDLE, level=9)
    same = all(np.max(np.abs(path - paths[drawn.pairs[0]])) <= JUMP * peak for path in paths.values())
    for j, pen in zip(drawn.pairs[:1] if same else drawn.pairs, CURVES, strict=False):
        _number(field, result, j, drawn.turning, course, pen)
    title = (
        tr("Hodograph in the axes of crank {link}", link=link) if drawn.turning else tr("Hodograph in the fixed axes")
    )
    title += f"\n{scale_of_forces(field.mu)}"
    drawing.add(Words(complex(field.box.middle.real, box.top), title, 2.3, 1j))
    key_above(drawing, field.box, names)


def _names(result: Forces, drawn: Hodograph) -> list[tuple[str, Pen]]:
    pairs = [result.pairs[j] for j in drawn.pairs]
    return [
        (f"$R_{{{pair.joint}}}$ ({pair.links[0]}–{pair.links[1]})", CURVES[k % len(CURVES)])
        for k, pair in enumerate(pairs)
    ]


def _draw(board: Board, panels: Plane, pen: Pen, peak: float) -> None:
    """Smooth pieces as curves, jumps between them as thin dotted lines."""
    jump = Pen("JUMPS", 0.25, (0.3, 0.6), pen.colour)
    piece = [panels[0]]
    for before, after in pairwise(panels):
        if abs(after[0] - before[-1]) > JUMP * peak:
            board.line(np.concatenate(piece), pen, weight=0.5, level=5)
            board.line((before[-1], after[0]), jump, level=4)
            piece = []
        piece.append(after)
    board.line(np.concatenate(piece), pen, weight=0.5, level=5)


def _number(board: Board, result: Forces, j: int, turning: bool, course: DiagramCourse, pen: Pen) -> None:
    """Positions as dots, some of them numbered where there is room."""
    at = result.reaction[j]
    if turning:
        at = at * np.conj(course.turn[0] * np.exp(1j * result.phi))
    number_tips(board, result.labels, at, pen)
