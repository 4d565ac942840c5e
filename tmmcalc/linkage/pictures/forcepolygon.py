"""The closed force polygon of a free body, to a standard scale; the inner reaction of a group is its chord.

Forces too short to be read stand once more, in their order, in an enlarged detail with a scale of its own; a circle on
the polygon shows where from.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.linkage.freebody import FreeBody
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board, needed
from tmmcalc.report.drawing.lettering import symbol
from tmmcalc.report.drawing.pens import AXIS, FORCES, INK, MIDDLE, THIN, Pen
from tmmcalc.report.drawing.scales import factor_text, standard_scale
from tmmcalc.report.drawing.shapes import Arc, Drawing, Words
from tmmcalc.report.language import tr

MARGIN = 8.0  # free border [mm]
HEAD = 3.0
TITLE = 6.0  # height of the line above [mm]
INNER = AXIS._replace(layer="FORCES_INNER", width=0.35)
BEFORE = Pen("OTHER_LIMIT", 0.3, (2.0, 1.0), "#8a8a8a")
NAMED = 4.0  # a shorter vector has no room for its name, and stands in a detail [mm]
STRIP = 0.32  # part of the width that details take, beside the polygon
DETAIL = (22.0, 48.0)  # least and greatest height of one [mm]
INSIDE = 4.5  # free border of one [mm]
LETTERS = "IJKLMN"  # of the details: none of a usual point


class ForceVector(NamedTuple):
    """One arrow of the polygon [N]; ``kind`` is that of the force, None: the chord that closes the forces of a link."""

    tail: complex
    value: complex
    kind: str | None
    name: str

    @property
    def ends(self) -> tuple[complex, complex]:
        """Tail and head."""
        return self.tail, self.tail + self.value


def draw_force_polygon(drawing: Drawing, box: Box, body: FreeBody, other: FreeBody | None) -> None:
    """Draw in a rectangle; ``other`` is the other limit, drawn dashed beneath."""
    title = complex(box.middle.real, box.top)
    if not body.forces:
        drawing.add(Words(title, tr("no forces"), 2.5 * drawing.letters, 1j))
        return
    drawn, field = vectors_of(body), box.inset(0, 0, 0, TITLE * drawing.letters)
    content = np.concatenate([body.vertices, *([other.vertices] if other else [])])
    left, strip = field.split(1 - STRIP, STRIP, gap=3.0, across=True)
    if not _short_runs(drawn, standard_scale(needed(content, field, MARGIN))):
        left = field
    chain = _Chain(drawing, left, content, drawn)
    drawing.add(Words(title, scale_of_forces(chain.board.mu), 2.5 * drawing.letters, 1j))
    if other:
        _draw_other(chain.board, other)
    chain.draw()
    runs = _short_runs(drawn, chain.board.mu)[: int(strip.height / DETAIL[0])]
    for k, run in enumerate(runs):
        high = min(DETAIL[1], strip.height / len(runs))
        place = Box(strip.left, strip.top - (k + 1) * high, strip.right, strip.top - k * high)
        chain.detail(place.inset(0, 1.5, 0, 0), run, LETTERS[k % len(LETTERS)])
    inside = [vector for run in runs for vector in run]
    chain.names([vector for vector in drawn if vector not in inside and (vector.kind or not chain.is_short(vector))])


def polygon_scale(box: Box, body: FreeBody) -> float:
    """The scale [N/mm] that the polygon of a body would have in a rectangle."""
    return standard_scale(needed(body.vertices, box.inset(0, 0, 0, TITLE), MARGIN))


def scale_of_forces(mu: float) -> str:
    """The scale as it is written beside a polygon."""
    return factor_text("μ_F", mu, "N/mm")


def vectors_of(body: FreeBody) -> list[ForceVector]:
    """The forces of a body in the order of its polygon, and the inner reaction of a group."""
    corners = body.vertices.tolist()
    found = [
        ForceVector(tail, force.value, force.kind, symbol(force.letter, force.index))
        for tail, force in zip(corners, body.forces, strict=False)
    ]
    if body.inner is not None:
        start = complex(corners[body.closing])
        across = complex(corners[body.parting]) - start
        found.append(ForceVector(start, across, None, symbol(body.inner.letter, body.inner.index)))
    return found


def _short_runs(vectors: Sequence[ForceVector], mu: float) -> list[list[ForceVector]]:
    """Forces too short for their names that follow each other."""
    runs: list[list[ForceVector]] = []
    follows = False
    for vector in vectors:
        short = vector.kind is not None and abs(vector.value) <= NAMED * mu
        if short and follows:
            runs[-1].append(vector)
        elif short:
            runs.append([vector])
        follows = short
    return runs


class _Chain:
    """A polygon, or the part of it that a detail shows, while it is drawn."""

    def __init__(
        self, drawing: Drawing, box: Box, content: Plane, vectors: Sequence[ForceVector], margin: float = MARGIN
    ) -> None:
        self.board = Board(drawing, box, content, margin, scale=standard_scale)
        self.vectors = list(vectors)

    def is_short(self, vector: ForceVector) -> bool:
        """Whether it has no room for its name."""
        return abs(vector.value) <= NAMED * self.board.mu

    def draw(self) -> None:
        """The vectors, and where they begin."""
        for vector in self.vectors:
            if vector.kind is not None:
                self.board.vector(*vector.ends, FORCES[vector.kind], HEAD, level=8)
            elif not self.is_short(vector):
                self.board.vector(*vector.ends, INNER, HEAD, level=6)
        self.board.circle(self.vectors[0].tail, 0.7, MIDDLE, level=15)

    def detail(self, box: Box, run: list[ForceVector], letter: str) -> None:
        """A run of short forces, enlarged; those that are short there too have leaders."""
        drawing, points = self.board.drawing, np.array([end for vector in run for end in vector.ends])
        middle = complex((points.real.min() + points.real.max()) / 2, (points.imag.min() + points.imag.max()) / 2)
        reach = float(np.max(np.abs(points - middle)))
        radius = max(1.6, reach / self.board.mu + 0.8)
        drawing.add(Arc(self.board.place(middle), radius, THIN), level=16)
        self.board.labels.put(letter, self.board.paper([middle]), gaps=(radius + 0.4, radius + 1.5, radius + 3.0))
        chain = _Chain(drawing, box.inset(0, 0, 0, TITLE - 1.5), points, run, INSIDE)
        drawing.line(box.corners, THIN, closed=True)
        title = complex(box.middle.real, box.top - 1.2)
        drawing.add(Words(title, f"{letter}:  {scale_of_forces(chain.board.mu)}", 2.2, 1j))
        chain.draw()
        chain.names(run)

    def names(self, vectors: Sequence[ForceVector]) -> None:
        """The names when all vectors are there, so that each stands at its own."""
        for vector in vectors:
            self._name(vector)

    def _name(self, vector: ForceVector) -> None:
        anchors = [vector.tail + t * vector.value for t in (0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9)]
        paper = self.board.paper
        self.board.labels.put(
            vector.name,
            paper(anchors),
            colour=INK if vector.kind is None else FORCES[vector.kind].colour,
            prefer=1j * vector.value,
            gaps=(0.6, 0.9, 1.6, 2.6),
            own=paper(vector.ends).tolist(),
            others=[paper(other.ends).tolist() for other in self.vectors if other is not vector],
        )


def _draw_other(board: Board, other: FreeBody) -> None:
    corners = other.vertices
    board.line(corners, BEFORE, weight=0.4, level=4)
    if other.inner is not None:
        board.line(corners[[other.closing, other.parting]], BEFORE, weight=0.3, level=4)
