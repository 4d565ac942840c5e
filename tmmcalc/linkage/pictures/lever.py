"""Zhukovsky's lever: the plan of velocities turned by 90 degrees, forces at its vertices, their arms about the pole.

Lines of the plan are to its scale, arrows of forces are longer for larger forces but not to scale. An arm is a
dimension from the pole, perpendicular to the line of its force.
"""

from __future__ import annotations

import cmath
import math
from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.results import Forces, side_of
from tmmcalc.linkage.lever import Lever, LeverForce, levers, working
from tmmcalc.linkage.pictures.loaddiagram import HEAD, arrow_length, free_arrow
from tmmcalc.linkage.pictures.plans import scale_note
from tmmcalc.linkage.pictures.scheme import position_text
from tmmcalc.linkage.pictures.vectors import drawn_vectors, name_vertices
from tmmcalc.linkage.polygons import polygons
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.vectors import Polygon
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board, needed
from tmmcalc.report.drawing.lettering import NUMBERED, minus, width, wrapped
from tmmcalc.report.drawing.pens import FORCES, MIDDLE, THIN, VECTORS
from tmmcalc.report.drawing.scales import standard_scale
from tmmcalc.report.drawing.shapes import Dimension, Drawing, Stroke, Words
from tmmcalc.report.drawing.tables import draw_table
from tmmcalc.report.drawing.wording import corners
from tmmcalc.report.language import tr, tr_number, tr_unit
from tmmcalc.report.numbers import number

MARGIN = 22.0  # free border, for arrows and arms [mm]
TITLE = 12.0  # room of the heading and the scale [mm]
TABLE = 84.0  # width of the table of moments [mm]
FOOT = 24.0  # room under it for both drives [mm]
SEEN = 1e-4  # of the largest force: less is left out
LEAST = 1.0  # a shorter arm is not drawn [mm]
SHIFTS = 2.6  # from one place of a dimension to the next [mm]
TRIED = tuple(range(-11, 12))  # places of a dimension
CLEAR, ALONG = 1.4, 0.9  # nearer than this to other lines words cover them, and so does a dimension line [mm]
CROSSING = 6.0  # what it costs to strike words, by mm
LETTERS = 2.2  # height of the lengths of arms [mm]


class _Laid(NamedTuple):
    """The lever of a row in a rectangle: the turned plan with its fixed points, all that is drawn, what acts."""

    position: int
    turned: Polygon
    fixed: tuple[str, ...]
    content: Plane  # [m/s]
    found: Lever


def _laid(field: Box, statics: Statics, kinematics: Kinematics, result: Forces, row: int) -> _Laid:
    """The lever to the standard scale at which it fills the rectangle."""
    position = kinematics.labels.index(result.labels[row].removesuffix("-"))
    plan = polygons(statics.scene.chain.mechanism, kinematics, position)
    turned = Polygon("p", {name: -1j * tip for name, tip in plan.velocity.vertices.items()}, plan.velocity.vectors)
    at = np.array([result.theta[row]]), np.array([side_of(result, row)])
    shown = _shown(levers(statics, kinematics, *at, 1.0)[0])
    content = np.array([*turned.vertices.values(), *(complex(f.x, f.y) for f in shown), *map(_foot, shown)])
    mu = standard_scale(needed(content, field, MARGIN))
    return _Laid(position, turned, plan.fixed, content, levers(statics, kinematics, *at, mu)[0])


def lever_scale(box: Box, statics: Statics, kinematics: Kinematics, result: Forces, row: int) -> float:
    """The scale [(m/s)/mm] of the lever of a row that is drawn in a rectangle without its table."""
    return _laid(box.inset(0, 0, 0, TITLE), statics, kinematics, result, row).found.mu


def draw_lever(
    drawing: Drawing,
    box: Box,
    statics: Statics,
    kinematics: Kinematics,
    result: Forces,
    row: int,
    *,
    tabled: bool = True,
) -> tuple[Board, Lever]:
    """Draw the lever of a row of the forces in a rectangle, beside the table of its moments.

    Its board [m/s], and what is on it.
    """
    larger = drawing.letters
    field = box.inset(0, 0, TABLE * larger if tabled else 0.0, TITLE * larger)
    position, turned, fixed, content, found = _laid(field, statics, kinematics, result, row)
    mu, shown = found.mu, _shown(found)
    heading = tr("{position}: velocities turned by 90° clockwise", position=position_text(kinematics, position))
    half = width(heading, 2.5 * larger) / 2  # a long one stands over the table too
    title = complex(max(field.middle.real, box.left + half), box.top)
    drawing.add(Words(title, f"{heading}\n{scale_note('v', mu)}", 2.5 * larger, 1j))
    board = Board(drawing, field, content, MARGIN, mu)
    drawn = _Lever(board, turned, fixed)
    drawn.lines()
    drawn.forces([force for force in shown if math.hypot(force.x, force.y) > LEAST])
    drawn.arms([force for force in shown if abs(force.arm) > LEAST])
    drawn.names()
    if tabled:
        table = Box(field.right + 3.0, box.bottom, box.right, field.top)
        _draw_moments(drawing, table, found, shown, result.turns)
    return board, found


def _shown(found: Lever) -> list[LeverForce]:
    """The forces that are not left out."""
    every = working([*found.forces, *found.balancing])
    largest = max((force.force for force in every), default=0.0)
    return [force for force in every if force.force > SEEN * largest]


def _along(force: LeverForce) -> complex:
    return cmath.exp(1j * math.radians(force.direction))


def _foot(force: LeverForce) -> complex:
    """Where the perpendicular from the pole meets the line of a force [mm]."""
    return -1j * _along(force) * force.arm


class _Lever:
    """One lever while it is drawn."""

    def __init__(self, board: Board, turned: Polygon, fixed: tuple[str, ...]) -> None:
        self.board, self.turned, self.fixed = board, turned, fixed
        self.arrows: list[tuple[LeverForce, complex, complex]] = []

    def tip(self, force: LeverForce) -> complex:
        """Where a force acts [m/s]."""
        return complex(force.x, force.y) * self.board.mu

    def lines(self) -> None:
        """The turned velocities, and the lines of links between their ends."""
        for vector in drawn_vectors(self.turned):
            ends = [self.turned.vertices[vector.tail], self.turned.vertices[vector.head]]
            pen = VECTORS[vector.kind]._replace(width=0.35)
            self.board.line(ends, pen, level=3 if vector.kind == "absolute" else 4)
        self.board.circle(0j, 0.9, MIDDLE, level=25)

    def forces(self, drawn: list[LeverForce]) -> None:
        """Every force at the end of its velocity, the largest first."""
        largest = max((force.force for force in drawn), default=0.0)
        for force in sorted(drawn, key=lambda each: -each.force):
            size = arrow_length(self.board, force.force / largest)
            tail, head = free_arrow(self.board, self.tip(force), _along(force), size, (0.0,))
            self.board.vector(tail, head, FORCES[force.kind], HEAD, level=13)
            self.arrows.append((force, tail, head))

    def arms(self, drawn: list[LeverForce]) -> None:
        """The arm of every force; one of several at the same place stands for all of them."""
        done: list[complex] = []
        for force in sorted(drawn, key=lambda each: -abs(each.arm)):
            foot = _foot(force)
            if all(abs(foot - other) > LEAST for other in done):
                done.append(foot)
                self._arm(force, foot)

    def _arm(self, force: LeverForce, foot: complex) -> None:
        """Its dimension where it covers least, and the line of the force as far as it."""
        board, pole, e = self.board, self.board.place(0j), _along(force)
        tip, end = pole + complex(force.x, force.y), pole + foot
        if abs(tip - end) > LEAST:
            board.drawing.line([tip, end], THIN, level=2)
            board.labels.avoid([tip, end], 0.5)
        text, height = tr_number(f"{abs(force.arm):.2f}"), LETTERS * board.drawing.letters
        tried = [Dimension(pole, end, pole + shift * SHIFTS * e, text, height) for shift in TRIED]
        against = [self._against(dimension) + abs(shift) for dimension, shift in zip(tried, TRIED, strict=True)]
        dimension = tried[against.index(min(against))]
        board.drawing.add(dimension, level=10)
        for part in dimension.parts():
            if isinstance(part, Stroke):
                board.labels.avoid(part.points, 0.7)
            elif isinstance(part, Words):
                for k in range(4):  # words that lean: squares along them
                    board.labels.keep(corners(_part_of(part, k, 4)))

    def _against(self, dimension: Dimension) -> float:
        """What a dimension covers: lines that run along it or through its words, names that it strikes."""
        labels, cost = self.board.labels, 0.0
        for part in dimension.parts():
            if isinstance(part, Stroke):
                cost += CROSSING * labels.struck(part.points.tolist())
                cost += labels.crowded(part.points.tolist(), ALONG) / 2
            elif isinstance(part, Words):
                box = corners(part)
                middle = [(box[0] + box[3]) / 2, (box[1] + box[2]) / 2]
                cost += CROSSING * labels.struck(middle) + 2 * labels.crowded(middle, CLEAR)
        return cost

    def names(self) -> None:
        """Letters of the vertices, then those of the forces."""
        name_vertices(self.board, self.turned, self.fixed)
        for force, tail, head in self.arrows:
            anchors = sorted((tail, head), key=lambda end: -abs(end - self.tip(force)))
            self.board.labels.put(
                force_name(force),
                self.board.paper(anchors),
                colour=FORCES[force.kind].colour,
                prefer=anchors[0] - anchors[1],
                gaps=(0.9, 1.6, 2.6),
            )


def force_name(force: LeverForce) -> str:
    """Its sign; one of a pair of forces is the couple over the distance of both."""
    numbered = NUMBERED.fullmatch(force.name)
    index = numbered[2] if numbered else force.name[1:] if force.kind == "drive" else ""
    sign = f"{force.name[0]}_{{{index}}}" if index else force.name
    if force.point:
        return f"${sign}/l_{{{force.link}}}$" if index else f"{sign}/$l_{{{force.link}}}$"
    return f"${sign}$" if index else sign


def _draw_moments(drawing: Drawing, box: Box, found: Lever, shown: list[LeverForce], turns: bool) -> None:
    """Size, arm and moment of every force, their sum; the drive that balances it beside that of the force analysis."""
    peak, larger = max((abs(force.moment) for force in shown), default=0.0), drawing.letters
    head = [tr("force"), tr_unit("N"), f"$h$, {tr_unit('mm')}", f"$F h$, {tr_unit('N*mm')}"]
    given = [force for force in shown if force.kind != "drive"]
    rows = [_row(force, peak) for force in given]
    rows.append(["$ΣF h$", "", "", minus(number(found.moment, 7, peak))])
    rows += [_row(force, peak) for force in shown if force.kind == "drive"]
    high = draw_table(drawing, box.inset(0, FOOT * larger, 0, 0), head, rows, 2.2 * larger)
    unit, letter = (tr_unit("N*m"), "M_d") if turns else (tr_unit("N"), "F_d")
    largest = max(abs(found.drive), abs(found.kinetostatic))
    off = 100 * abs(found.difference) / largest if largest else 0.0
    lines = [
        tr("by the lever: ${letter}$ = {value} {unit}", letter=letter, value=_told(found.drive), unit=unit),
        tr(
            "by the force analysis: ${letter}$ = {value} {unit}",
            letter=letter,
            value=_told(found.kinetostatic),
            unit=unit,
        ),
        tr("difference {share} %", share=tr_number(f"{off:.4f}")),
        tr("an arm is positive that turns counter-clockwise"),
    ]
    told = [row for line in lines for row in wrapped(line, box.width, 2.1 * larger)]
    drawing.add(Words(complex(box.left, box.top - high - 2.5), "\n".join(told), 2.1 * larger, -1 + 1j))


def _row(force: LeverForce, peak: float) -> list[str]:
    arm = tr_number(minus(f"{force.arm:.2f}")) if abs(force.arm) >= 0.005 else "0"
    return [force_name(force), number(force.force, 5), arm, minus(number(force.moment, 7, peak))]


def _part_of(words: Words, k: int, count: int) -> Words:
    """The k-th part of so many of words that stand over their middle."""
    size = width(words.text, words.height) / count
    at = words.at + (k - (count - 1) / 2) * size * np.exp(1j * words.turn)
    return words._replace(at=complex(at), text=words.text[: max(1, len(words.text) // count)])


def _told(value: float) -> str:
    return minus(number(value, 6))
