"""What the pictures of balancing share: hodographs with circles and weights, sizes over a turn with rms levels."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import SubFigure
from matplotlib.lines import Line2D

from tmmcalc.core.plane import Plane
from tmmcalc.core.records import record
from tmmcalc.linkage.pictures.hodographs import name_axes
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.curves import DOTTED, Diagram, bottom, suited
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.numbers import NOISE, number

MARGIN = 8.0  # free border of a hodograph [mm]
APART = 5.0  # positions nearer than this to a numbered one go without a number [mm]
HEIGHTS = (1.5, 1.0)  # of the diagrams, one under another
COLUMNS = 3  # of a legend
RMS: dict[str, Any] = {"linewidth": 0.8, "linestyle": (0, (9, 4)), "zorder": 3}


@record
class Path:
    """A closed hodograph (m,), and its values at the positions (n,)."""

    label: str
    values: Plane
    nodes: Plane
    style: dict[str, Any]


@record
class Spot:
    """A place with its name, and an arrow to it from the origin, or none."""

    name: str
    at: complex
    style: dict[str, Any]
    arrow: bool = False


@record
class Ring:
    """A circle."""

    label: str
    centre: complex
    radius: float
    style: dict[str, Any]

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

    def prepare(self, axes: Axes) -> None:
        """Heading, legend, names and numbers of the axes, so that the layout reserves room for them."""
        axes.set_title(f"{self.heading}\n ", pad=20)
        axes.set_xlim(-self._peak, self._peak)
        axes.set_ylim(-self._peak, self._peak)
        name_axes(axes, self.names, self._peak, self.unit)
        named = [*((p.label, p.style) for p in self.paths), *((r.label, r.style) for r in self.rings)]
        handles = [Line2D([], [], label=label, **{"linewidth": 1.3, **style}) for label, style in named]
        axes.legend(handles=handles, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=COLUMNS, handlelength=2.5)

    def draw(self, axes: Axes) -> None:
        """Draw on an axes whose place is settled."""
        peak = self._peak
        board = Board(axes, self._everything, MARGIN)
        low, high = complex(axes.get_xlim()[0], axes.get_ylim()[0]), complex(axes.get_xlim()[1], axes.get_ylim()[1])
        for ends in ((low.real, high.real), (1j * low.imag, 1j * high.imag)):
            board.line(ends, linewidth=0.7, color="#333333", weight=0.3)
        for ring in self.rings:
            board.line(ring.points, weight=0.4, zorder=3, **ring.style)
        for path in self.paths:
            board.line([*path.values, path.values[0]], weight=0.5, **{"linewidth": 1.3, "zorder": 5, **path.style})
        board.circle(0j, 0.8, zorder=9)
        for spot in self.spots:
            _mark(board, spot, peak)
        for spot in self.spots:
            gaps, color = (1.2, 2.0, 3.0, 4.4), spot.style["color"]
            board.labels.put(spot.name, [spot.at], size=7.5, gaps=gaps, prefer=spot.at or 1, color=color)
        self._number(board)
        factor, unit = suited(peak, self.unit)
        axes.set_title(f"{self.heading}\n$\\mu$ = {number(board.mu * factor, 4)} {unit}/mm", pad=20)

    def _number(self, board: Board) -> None:
        """Positions as dots, some of them numbered where there is room."""
        first = self.paths[0]
        if not 0 < len(self.labels) <= DOTTED:
            return
        board.axes.plot(first.nodes.real, first.nodes.imag, "o", markersize=2.2, color=first.style["color"], zorder=8)
        numbered: list[complex] = []
        for label, tip in zip(self.labels, first.nodes.tolist(), strict=True):
            if all(abs(tip - other) > APART * board.mu for other in [0j, *numbered]):
                numbered.append(tip)
                style = {"size": 5.5, "prefer": tip, "gaps": (0.8, 1.4, 2.2), "color": first.style["color"]}
                board.labels.put(label, [tip], **style)


def _mark(board: Board, spot: Spot, peak: float) -> None:
    """A place as a cross, or an arrow to it."""
    if not spot.arrow:
        board.axes.plot(spot.at.real, spot.at.imag, "x", markersize=5, zorder=10, color=spot.style["color"])
        board.labels.avoid([spot.at], 4.0)
    elif abs(spot.at) > NOISE * peak:
        board.line((0j, spot.at), **{"linewidth": 1.3, "zorder": 7, **spot.style, "linestyle": "-"})
        board.arrowhead(spot.at, spot.at, facecolor=spot.style["color"])


@record
class Sizes:
    """A diagram of sizes over a turn with the rms level [SI] of each of its lines."""

    diagram: Diagram
    levels: tuple[float, ...]

    def draw(self, axes: Axes) -> None:
        """Curves, levels, and the legend with their values."""
        factor, unit = self.diagram.scale
        self.diagram.draw(axes)
        if not any(line.values.any() for line in self.diagram.lines):
            axes.set_ylim(-1.0, 1.0)
        for line, level in zip(self.diagram.lines, self.levels, strict=True):
            axes.axhline(level * factor, **RMS, color=line.style["color"])
        handles = [
            Line2D([], [], label=f"{line.label}: rms {signed(level * factor, 4)}", **{"linewidth": 1.3, **line.style})
            for line, level in zip(self.diagram.lines, self.levels, strict=True)
        ]
        handles.append(Line2D([], [], label=f"rms levels, {unit}", **RMS, color="#333333"))
        place: dict[str, Any] = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.0), "ncols": COLUMNS}
        axes.legend(handles=handles, handlelength=3, columnspacing=1.2, borderaxespad=0.3, **place)


def shaking_sheet(
    sheet: SubFigure, polar: Sequence[Polar], diagrams: Sequence[Sizes], abscissa: str
) -> Callable[[], None]:
    """Lay out hodographs on the left, sizes on the right; what is returned draws when the layout is settled."""
    left, right = sheet.subfigures(1, 2, squeeze=False, width_ratios=[1.0, 1.45])[0]
    places = left.subplots(len(polar), 1, squeeze=False)[:, 0].tolist()
    panels = right.subplots(len(diagrams), 1, sharex=True, squeeze=False, height_ratios=HEIGHTS[: len(diagrams)])
    lines = panels[:, 0].tolist()
    for axes, hodograph in zip(places, polar, strict=True):
        hodograph.prepare(axes)
    for axes, diagram in zip(lines, diagrams, strict=True):
        diagram.draw(axes)
    bottom(lines, True)
    lines[-1].set_xlabel(abscissa)

    def finish() -> None:
        for axes, hodograph in zip(places, polar, strict=True):
            hodograph.draw(axes)
        for axes, diagram in zip(lines, diagrams, strict=True):
            diagram.diagram.label(axes)

    return finish
