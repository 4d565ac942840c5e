"""What the pictures of balancing share: hodographs with circles and weights, sizes over a turn with rms levels."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.core.records import record
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import Graph, column, suited
from tmmcalc.report.drawing.diagram import ROW, Diagram, key_above, key_rows
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.lettering import minus, wrapped
from tmmcalc.report.drawing.pens import MIDDLE, Pen
from tmmcalc.report.drawing.polar import AROUND, name_axes, number_tips
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import NOISE, number

MARGIN = 8.0  # free border of a hodograph [mm]
HEIGHT, TITLE = 2.4, 4.2  # of the letters and of a row of its title
RMS = Pen("LEVELS", 0.25, (5.0, 2.2))


@record
class Path:
    """A closed hodograph (m,), and its values at the positions (n,)."""

    label: str
    values: Plane
    nodes: Plane
    pen: Pen


@record
class Spot:
    """A place with its name, and an arrow to it from the origin, or none."""

    name: str
    at: complex
    pen: Pen
    arrow: bool = False


@record
class Ring:
    """A circle."""

    label: str
    centre: complex
    radius: float
    pen: Pen

    @property
    def points(self) -> Plane:
        """Its line."""
        return np.asarray(self.centre + self.radius * np.exp(1j * np.linspace(0, 2 * np.pi, 181)))


@record
class Polar:
    """A hodograph: its heading, names of its axes, what is drawn in it; positions of the first path are numbered."""

    heading: str
    names: tuple[str, str]
    unit: str
    paths: tuple[Path, ...]
    labels: tuple[str, ...] = ()  # of the positions
    rings: tuple[Ring, ...] = ()
    spots: tuple[Spot, ...] = ()

    @property
    def _everything(self) -> Plane:
        """All that must lie on the board."""
        tips = [spot.at for spot in self.spots]
        return np.concatenate(
            [*(path.values for path in self.paths), *(ring.points for ring in self.rings), tips, [0j]]
        )

    @property
    def _peak(self) -> float:
        """The largest size, or one if there is nothing."""
        return float(np.max(np.abs(self._everything))) or 1.0

    def draw(self, drawing: Drawing, box: Box) -> None:
        """Draw in a rectangle, with the heading and the names of the lines above."""
        peak = self._peak
        names = [*((p.label, p.pen) for p in self.paths), *((r.label, r.pen) for r in self.rings)]
        wide, larger = box.width - AROUND[0] - AROUND[2], drawing.letters
        heading = wrapped(self.heading, wide, HEIGHT)
        room = TITLE * (1 + len(heading)) + ROW * larger * len(key_rows(names, wide, larger))
        board = Board(drawing, box.inset(*AROUND, room), self._everything, MARGIN)
        name_axes(board, self.names, peak, self.unit)
        for ring in self.rings:
            board.line(ring.points, ring.pen, weight=0.4, level=3)
        for path in self.paths:
            board.line([*path.values, path.values[0]], path.pen, weight=0.5, level=5)
        board.circle(0j, 0.8, MIDDLE, level=9)
        for spot in self.spots:
            _mark(board, spot, peak)
        for spot in self.spots:
            gaps, at = (1.0, 1.8, 2.8, 4.2), board.paper([spot.at])
            board.labels.put(spot.name, at, gaps=gaps, prefer=spot.at or 1, colour=spot.pen.colour)
        number_tips(board, self.labels, self.paths[0].nodes, self.paths[0].pen)
        factor, unit = suited(peak, self.unit)
        title = "\n".join(heading) + f"\n$μ$ = {number(board.mu * factor, 4)} {unit}/{tr_unit('mm')}"
        drawing.add(Words(complex(board.box.middle.real, box.top), title, HEIGHT, 1j))
        key_above(drawing, board.box, names)


def _mark(board: Board, spot: Spot, peak: float) -> None:
    """A place as a cross, or an arrow to it."""
    solid = spot.pen._replace(dashes=(), width=0.45)
    if not spot.arrow:
        reach = 1.2 * board.mu
        for way in (1 + 1j, 1 - 1j):
            board.line((spot.at - reach * way, spot.at + reach * way), solid, weight=2.0, level=10)
    elif abs(spot.at) > NOISE * peak:
        board.vector(0j, spot.at, solid, level=7)


@record
class Sizes:
    """A diagram of sizes over a turn with the rms level [SI] of each of its lines."""

    graph: Graph
    levels: tuple[float, ...]

    @property
    def named(self) -> Graph:
        """The diagram with the levels in its key, and with ends where all is zero."""
        factor, unit = self.graph.scale
        names = [
            (tr("{name}: rms {value}", name=line.label, value=minus(number(level * factor, 4))), line.pen)
            for line, level in zip(self.graph.lines, self.levels, strict=True)
        ]
        still = not any(line.values.any() for line in self.graph.lines)
        ends = (-1.0, 1.0) if still else self.graph.ends
        return replace(self.graph, key=(*names, (tr("rms levels, {unit}", unit=unit), RMS)), ends=ends)


def shaking_sheet(
    drawing: Drawing,
    box: Box,
    polar: Sequence[Polar],
    diagrams: Sequence[Sizes],
    heights: Sequence[float],
    *,
    across: bool = True,
) -> None:
    """Hodographs on the left, sizes on the right; or hodographs above, sizes below at the whole width."""
    first, second = box.split(1.0, 1.45, gap=4, across=across)
    for part, hodograph in zip(first.split(*(1.0 for _ in polar), gap=2, across=not across), polar, strict=True):
        hodograph.draw(drawing, part)
    draw_sizes(drawing, second, diagrams, heights)


def draw_sizes(drawing: Drawing, box: Box, diagrams: Sequence[Sizes], heights: Sequence[float]) -> list[Diagram]:
    """Sizes one under another, in these proportions, with their rms levels."""
    frames = column(drawing, box, [each.named for each in diagrams], heights)
    for frame, each in zip(frames, diagrams, strict=True):
        factor, _ = each.graph.scale
        for line, level in zip(each.graph.lines, each.levels, strict=True):
            frame.level(level * factor, RMS._replace(colour=line.pen.colour))
    return frames
