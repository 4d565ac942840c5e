"""Diagrams over the input coordinate: curves in units that suit their size, positions as dots, marked extremes."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.core.records import record
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import AIR, ROW, Axis, Curve, Diagram, beside, key_above, key_rows, room, sample
from tmmcalc.report.drawing.lettering import width
from tmmcalc.report.drawing.pens import Pen
from tmmcalc.report.drawing.scales import factor_text, standard_scale
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr_unit
from tmmcalc.report.numbers import NOISE

DOTTED = 72  # more positions than this are not marked one by one
PREFIXES = ((1e7, 1e-6, "M"), (1e4, 1e-3, "k"))
SIDES = (17.0, 3.0, 3.0, 2.0)  # room for numbers and names around a frame: left, bottom, right, top [mm]
LONGER = 3.0  # and on the left for the numbers of an ordinate that a standard factor makes longer
BELOW = 9.5  # and for those of the abscissa under the lowest


@record
class Line:
    """One curve [SI]: dense values (m,), values at the positions (n,), extremes to mark as (phi, value)."""

    label: str
    values: Real
    nodes: Real
    pen: Pen
    marks: tuple[tuple[float, float], ...] = ()


@record
class Graph:
    """Curves of one quantity over phi [rad or m]: dense (m,), and at the positions (n,)."""

    symbol: str  # as a formula without its signs
    unit: str
    turns: bool
    phi: Real
    phi_nodes: Real
    lines: tuple[Line, ...]
    digits: int = 4  # of marked values
    title: str = ""  # above, on the right
    ends: tuple[float, float] | None = None  # of the ordinate [SI]; None: all curves and zero, with air
    key: tuple[tuple[str, Pen], ...] | None = None  # names above the frame; None: those of its lines
    abscissa: str = ""  # name of the axis along; empty: that of the input coordinate
    levels: tuple[tuple[float, Pen, str], ...] = ()  # heights [SI] with a line across and its name
    mu: str = ""  # letter of its scale factor: then that is a standard one, which stands above on the right

    @property
    def scale(self) -> tuple[float, str]:
        """Factor from SI and the unit that is shown."""
        return suited(max(float(np.max(np.abs(line.values))) for line in self.lines), self.unit)

    @property
    def named(self) -> list[tuple[str, Pen]]:
        """The names of its curves for a key."""
        return [(line.label, line.pen) for line in self.lines if line.label] if self.key is None else [*self.key]

    def draw(self, drawing: Drawing, box: Box, *, numbered: bool = True) -> Diagram:
        """The diagram in a frame, with a key above it where its curves have names."""
        factor, unit = self.scale
        up, mu = self.ordinate(box.height)
        x, nodes = along_input(self.turns, self.phi), along_input(self.turns, self.phi_nodes)
        values = [line.values * factor for line in self.lines]
        along = input_axis(self.turns, x)
        along = along._replace(name=self.abscissa or along.name)
        title = self.title
        if self.mu:
            along, title = _with_scale(along, self.turns, box.width), scale_factor(self.mu, mu, unit)
        diagram = Diagram(drawing, box, along, up, numbered=numbered)
        for height, pen, _ in self.levels:
            diagram.level(factor * height, pen)
        if 0 < len(nodes) <= DOTTED:
            for line in self.lines:
                diagram.dots(nodes, line.nodes * factor, line.pen)
        curves = []
        for line, value in zip(self.lines, values, strict=True):
            places = along_input(self.turns, np.array([phi for phi, _ in line.marks]))
            heights = [0.0 if abs(v) < NOISE * np.max(np.abs(line.values)) else v * factor for _, v in line.marks]
            marks = tuple(complex(at, height) for at, height in zip(places.tolist(), heights, strict=True))
            curves.append(Curve(line.label, value, line.pen, marks))
        diagram.draw(x, curves, key=False, digits=self.digits)
        larger = drawing.letters
        wide, row = self._key_of(title, box.width, larger)
        if self.named:
            key_above(drawing, box._replace(right=box.left + wide), self.named)
        for height, pen, name in self.levels:
            diagram.name_level(factor * height, name, pen.colour)
        if title:
            place = complex(box.right, box.top + larger * ROW * (row + 0.5) + 0.1)
            drawing.add(Words(place, title, 2.5 * larger, 1))
        return diagram

    def ordinate(self, high: float) -> tuple[Axis, float]:
        """The axis of a frame ``high`` mm high, and its scale factor; that is standard where it has a letter."""
        factor, unit = self.scale
        air = (0.05, 0.03) if self.mu else (0.18, 0.12)  # a standard factor leaves more
        values = [line.values * factor for line in self.lines]
        ends = room(values, *air) if self.ends is None else (factor * self.ends[0], factor * self.ends[1])
        axis = Axis(f"${self.symbol}$, {unit}".removesuffix(", "), *ends)
        return to_scale(axis, high) if self.mu else (axis, (axis.high - axis.low) / high)

    @property
    def head(self) -> str:
        """What stands above on the right: its title, or its scale factor, of which the longest is told."""
        return scale_factor(self.mu, 0.0025, self.scale[1]) if self.mu else self.title

    def rows(self, wide: float, larger: float) -> int:
        """Rows of words, so many times ``larger`` than usual, above a frame of this width [mm]."""
        wide_of_key, row = self._key_of(self.head, wide, larger)
        return max(len(key_rows(self.named, wide_of_key, larger)), row + 1 if self.head else 0)

    def _key_of(self, title: str, wide: float, larger: float) -> tuple[float, int]:
        """How wide its key is [mm], and above how many rows its title stands: in the last one, or above all of them."""
        left = wide - larger * _room_of(title)
        apart = any(sample(name, larger) - AIR > left for name, _ in self.named)
        rows = len(key_rows(self.named, wide if apart else left, larger))
        return (wide, rows) if apart else (left, max(rows - 1, 0))


def column(drawing: Drawing, box: Box, graphs: Sequence[Graph], heights: Sequence[float] = ()) -> list[Diagram]:
    """Diagrams of one abscissa, one under another, in these proportions; its numbers stand under the lowest.

    Those with a scale factor stand in the middle of the rectangle, narrower than it where that of the abscissa would
    not be standard.
    """
    larger = drawing.letters
    scaled = any(graph.mu for graph in graphs)
    if scaled:
        box = narrowed(box, along_input(graphs[0].turns, graphs[0].phi), larger)

    def above(wide: float) -> list[int]:
        return [graph.rows(wide, larger) for graph in graphs]

    def ordinates(high: Sequence[float]) -> list[Axis]:
        return [graph.ordinate(each)[0] for graph, each in zip(graphs, high, strict=True)]

    frames = fitted(box, above, ordinates, heights, larger, LONGER * larger if scaled else 0.0)
    return [
        graph.draw(drawing, place, numbered=k + 1 == len(graphs))
        for k, (graph, place) in enumerate(zip(graphs, frames, strict=True))
    ]


def narrowed(box: Box, x: Real, larger: float) -> Box:
    """The middle of a rectangle, so wide that frames have a standard factor along ``x`` [degrees or mm]."""
    left, _, right, _ = sides(larger)
    room, span = box.width - LONGER * larger - left - right, float(np.ptp(x))
    over = (room - span / standard_scale(span / room)) / 2
    return box.inset(LONGER * larger + over, 0, over, 0)


def sides(larger: float) -> tuple[float, float, float, float]:
    """Room around a frame whose words are so many times ``larger`` than usual: left, bottom, right, top [mm]."""
    left, bottom, right, top = SIDES
    return left * larger, bottom, right, top


def to_scale(axis: Axis, size: float) -> tuple[Axis, float]:
    """The axis with ends so far apart that its scale factor on ``size`` mm is standard, and that; 0 stays an end.

    >>> to_scale(Axis("", 0.0, 170.0), 50.0)
    (Axis(name='', low=0.0, high=200.0, degrees=False, log=False, whole=False), 4.0)
    """
    span = axis.high - axis.low
    mu = standard_scale(span / size)
    more = mu * size - span
    below = 0.0 if axis.low == 0 else more if axis.high == 0 else more / 2
    return axis._replace(low=axis.low - below, high=axis.high + more - below), mu


def scale_factor(letter: str, mu: float, unit: str) -> str:
    """A scale factor as it stands beside a drawing; ``unit`` is that of the data.

    >>> scale_factor("M", 25.0, "N*m"), scale_factor("ω", 0.04, "rad/s")
    ('$μ_{M}$ = 25 N·m/mm', '$μ_{ω}$ = 0.04 (rad/s)/mm')
    """
    return factor_text(f"μ_{{{letter}}}", mu, f"({unit})/mm" if "/" in unit else f"{unit}/mm")


def _room_of(title: str) -> float:
    """Width that a title takes of the row beside it [mm]."""
    return width(title, 2.5) + AIR if title else 0.0


def _with_scale(along: Axis, turns: bool, wide: float) -> Axis:
    """The axis of the input coordinate with its scale factor in the name."""
    factor = scale_factor("φ" if turns else "s", abs(along.high - along.low) / wide, "°" if turns else "mm")
    return along._replace(name=f"{along.name}; {factor}")


def stacked(box: Box, rows: Sequence[int], heights: Sequence[float] = (), larger: float = 1.0) -> list[Box]:
    """Frames of diagrams one under another, in these proportions, with so many rows of words above each of them.

    The words are so many times ``larger`` than usual. Numbers and names of the axes have room around; those of the
    abscissa stand under the lowest frame alone.
    """
    left, bottom, right, top = sides(larger)
    row_height = ROW * larger
    parts = heights or [1.0] * len(rows)
    free = box.height - BELOW * larger - row_height * sum(rows) - (top + bottom) * len(rows)
    found, at = [], box.top
    for row, part in zip(rows, parts, strict=True):
        high = at - top - row_height * row
        low = high - free * part / sum(parts)
        found.append(Box(box.left + left, low, box.right - right, high))
        at = low - bottom
    return found


def fitted(
    box: Box,
    rows: Callable[[float], Sequence[int]],
    ordinates: Callable[[Sequence[float]], Sequence[Axis]],
    heights: Sequence[float],
    larger: float,
    spare: float = 0.0,
) -> list[Box]:
    """Frames as `stacked` has them, narrower where their ordinates need more room than the usual and ``spare`` [mm].

    ``rows`` tells the rows of words above frames of a width [mm], ``ordinates`` the axes of frames of these heights.
    """
    left, _, right, _ = sides(larger)

    def frames_in(box: Box) -> list[Box]:
        return stacked(box, rows(box.width - left - right), heights, larger)

    frames = frames_in(box)
    high = [frame.height for frame in frames]
    needed = max(beside(axis, each, larger) for axis, each in zip(ordinates(high), high, strict=True))
    more = needed - left - spare
    return frames_in(box.inset(more, 0, 0, 0)) if more > 0 else frames


def along_input(turns: bool, phi: Real) -> Real:
    """The input coordinate as it is drawn: degrees or mm."""
    return np.degrees(phi) if turns else phi * 1000


def input_axis(turns: bool, x: Real) -> Axis:
    """The axis of the input coordinate."""
    return Axis("$φ$, °" if turns else f"$s − s_0$, {tr_unit('mm')}", float(x[0]), float(x[-1]), turns)


def suited(peak: float, unit: str) -> tuple[float, str]:
    """Factor and unit with a prefix that suits values of this size; one that has a prefix stays.

    >>> suited(25_000.0, "N"), suited(900.0, "N*m"), suited(25_000.0, "kg*m^2")
    ((0.001, 'kN'), (1.0, 'N·m'), (1.0, 'kg·m²'))
    """
    if unit.startswith("kg"):
        return 1.0, tr_unit(unit)
    found = ((factor, prefix) for least, factor, prefix in PREFIXES if peak >= least)
    factor, prefix = next(found, (1.0, ""))
    return factor, tr_unit(prefix + unit)
