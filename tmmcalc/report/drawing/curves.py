"""Diagrams over the input coordinate: curves in units that suit their size, positions as dots, marked extremes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, MaxNLocator, MultipleLocator

from tmmcalc.core.plane import Real
from tmmcalc.core.records import record
from tmmcalc.report.drawing.labels import Labels, signed
from tmmcalc.report.numbers import NOISE

TICKS = 13  # ticks of the input coordinate that fit beside each other on the page
DOTTED = 72  # more positions than this are not marked one by one
PREFIXES = ((1e7, 1e-6, "M"), (1e4, 1e-3, "k"))
SAME = 1e-3  # of the height of a diagram: nearer marks are one


@record
class Line:
    """One curve [SI]: dense values (m,), values at the positions (n,), extremes to mark as (phi, value)."""

    label: str
    values: Real
    nodes: Real
    style: dict[str, Any]
    marks: tuple[tuple[float, float], ...] = ()


@record
class Diagram:
    """Curves of one quantity over phi [rad or m]: dense (m,), and at the positions (n,)."""

    symbol: str
    unit: str
    turns: bool
    phi: Real
    phi_nodes: Real
    lines: tuple[Line, ...]
    digits: int = 4  # of marked values

    @property
    def scale(self) -> tuple[float, str]:
        """Factor from SI and the unit that is shown."""
        return suited(max(float(np.max(np.abs(line.values))) for line in self.lines), self.unit)

    def draw(self, axes: Axes, ticks: int = TICKS) -> None:
        """Curves and dots; texts follow by `label`, when the layout is settled."""
        factor, unit = self.scale
        x, nodes = coordinate(self.turns, self.phi), coordinate(self.turns, self.phi_nodes)
        for line in self.lines:
            axes.plot(x, line.values * factor, **{"linewidth": 1.3, "zorder": 4, **line.style})
            if len(nodes) <= DOTTED:
                dots = {"markersize": 2.2, "color": line.style["color"], "zorder": 5, "linestyle": ""}
                axes.plot(nodes, line.nodes * factor, "o", **dots)
        frame(axes, f"${self.symbol}$, {unit}", x, self.turns, ticks)
        low, high = (choice([choice(line.values) for line in self.lines]) * factor for choice in (np.min, np.max))
        if high > 0 and low > -NOISE * high:
            axes.set_ylim(0.0, 1.15 * high)

    def legend(self, axes: Axes, columns: int, **place: Any) -> None:
        """The names of the curves, by default in a row above."""
        handles = [Line2D([], [], label=line.label, **{"linewidth": 1.3, **line.style}) for line in self.lines]
        place = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.0), "ncols": columns, **place}
        axes.legend(handles=handles, handlelength=3, columnspacing=1.2, borderaxespad=0.3, **place)

    def label(self, axes: Axes) -> None:
        """Mark and name the extremes; one that two curves share is named once."""
        factor, _ = self.scale
        labels, x = Labels(axes), coordinate(self.turns, self.phi)
        for line in self.lines:
            labels.avoid(x + 1j * line.values * factor, 0.7)
        done: list[complex] = []
        low, high = axes.get_ylim()
        left, right = axes.get_xlim()
        for line in self.lines:
            for phi, value in line.marks:
                value = 0.0 if abs(value) < NOISE * np.max(np.abs(line.values)) else value
                at = complex(coordinate(self.turns, np.array(phi)), value * factor)
                paper = complex(at.real / (right - left), at.imag / (high - low))
                if all(abs(paper - other) > SAME for other in done):
                    done.append(paper)
                    mark(axes, labels, at, line.style, self.digits)


def coordinate(turns: bool, phi: Real) -> Real:
    """The input coordinate as it is drawn: degrees or mm."""
    return np.degrees(phi) if turns else phi * 1000


def frame(axes: Axes, label: str, x: Real, turns: bool, ticks: int) -> None:
    """Zero line, grid and ticks of one diagram; the numbers along x belong to the undermost alone."""
    axes.axhline(0, color="#333333", linewidth=0.8, zorder=1.5)
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_axisbelow(True)
    axes.set_xlim(x[0], x[-1])
    axes.margins(y=0.2)
    axes.set_ylabel(label)
    if turns:
        turn = abs(x[-1] - x[0])
        axes.xaxis.set_major_locator(MultipleLocator(next((s for s in (5, 10, 15, 30, 60) if turn / s <= ticks), 90)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda v, _: signed(v, 6)))
    axes.yaxis.set_major_locator(MaxNLocator(6))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda v, _: signed(v, 6)))
    axes.tick_params(length=2.5, labelbottom=False)


def bottom(panels: Sequence[Axes], turns: bool) -> None:
    """The numbers along x and their name."""
    panels[-1].tick_params(labelbottom=True)
    panels[-1].set_xlabel("$\\varphi$, °" if turns else "$s - s_0$, mm")


def suited(peak: float, unit: str) -> tuple[float, str]:
    """Factor and unit with a prefix that suits values of this size.

    >>> suited(25_000.0, "N"), suited(900.0, "N*m")
    ((0.001, 'kN'), (1.0, 'N·m'))
    """
    written = unit.replace("*", "·").replace("^2", "²")
    return next(((factor, prefix + written) for least, factor, prefix in PREFIXES if peak >= least), (1.0, written))


def mark(axes: Axes, labels: Labels, at: complex, style: dict[str, Any], digits: int = 4) -> None:
    """A diamond on an extreme value, with the number where it covers least."""
    color = style["color"]
    axes.plot(at.real, at.imag, "D", markersize=3.6, markerfacecolor="white", color=color, zorder=6, clip_on=False)
    prefer = 1j if at.imag >= 0 else -1j
    labels.put(signed(at.imag, digits), [at], size=7, prefer=prefer, gaps=(1.1, 1.8, 2.8, 4.0), color=color)
