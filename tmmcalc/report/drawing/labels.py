"""Texts that keep clear of what is drawn and of each other.

Everything is measured on paper in mm: a text tries places around its anchors and takes the one where it
covers least. The layout of the figure must be settled before.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.font_manager import FontProperties
from matplotlib.patheffects import withStroke
from matplotlib.textpath import TextPath

from tmmcalc.core.plane import Plane, Real
from tmmcalc.report.drawing.style import INK
from tmmcalc.report.numbers import number

MM = 25.4
NEAR = 20.0  # what lies farther from an anchor cannot be covered [mm]
BEYOND = 100.0  # of what is drawn beyond the axes so much counts as near to them [mm]
STEP = 0.5  # spacing of the points that stand for a line [mm]
CLEARLY = 0.8  # so much nearer to its own stroke than to another a name is told apart [mm]
ASTRAY = 15.0  # what a mm less costs
WRONG = 50.0  # and what it costs to be nearer to another one
RING = 0.33  # radius of the ring around a number, mm to a point of its size
NUMBERED = re.compile("([A-Za-z])([0-9]+'*)")  # a name that reads as a letter with an index
AROUND = np.exp(1j * np.radians([45, 135, -45, -135, 90, 0, 180, -90, 22, 68, 112, 158, -22, -68, -112, -158]))


class Labels:
    """The texts of one axes."""

    def __init__(self, axes: Axes) -> None:
        self.axes = axes
        self._to_mm = MM / axes.figure.dpi
        self._points: list[Plane] = []
        self._weights: list[Real] = []
        self._taken: list[tuple[float, float, float, float]] = []
        box = axes.get_window_extent()
        self._frame = tuple(v * self._to_mm for v in (box.x0, box.x1, box.y0, box.y1))

    def _paper(self, z: Plane) -> Plane:
        xy = self.axes.transData.transform(np.column_stack((z.real, z.imag))) * self._to_mm
        return np.asarray(xy[:, 0] + 1j * xy[:, 1])

    def _data(self, at: complex) -> tuple[float, float]:
        x, y = self.axes.transData.inverted().transform((at.real / self._to_mm, at.imag / self._to_mm))
        return float(x), float(y)

    def avoid(self, line: Iterable[complex], weight: float = 1.0) -> None:
        """Keep clear of this line (data coordinates), the more the greater the weight."""
        z = self._paper(np.atleast_1d(np.asarray(list(line), dtype=complex)))
        pieces = [z[:1]]
        for a, b in pairwise(z):
            first, last = self._within(a, b)
            count = max(1, int(abs(b - a) * (last - first) / STEP))
            pieces.append(a + (b - a) * (first + (last - first) * np.arange(1, count + 1) / count))
        points = np.concatenate(pieces)
        self._points.append(points)
        self._weights.append(np.full(len(points), weight))

    def _within(self, a: complex, b: complex) -> tuple[float, float]:
        """The part of a line on paper, from 0 to 1, that may come near to the axes.

        A steep curve leaves them by kilometres, which would take points by the hundred million.
        """
        x0, x1, y0, y1 = self._frame
        first, last = 0.0, 1.0
        for low, high, start, way in (
            (x0 - BEYOND, x1 + BEYOND, a.real, (b - a).real),
            (y0 - BEYOND, y1 + BEYOND, a.imag, (b - a).imag),
        ):
            if way:
                ends = sorted(((low - start) / way, (high - start) / way))
                first, last = max(first, ends[0]), min(last, ends[1])
            elif not low <= start <= high:
                return 0.0, 0.0
        return (first, last) if first < last else (0.0, 0.0)

    def _around(self, line: Plane, reach: float) -> tuple[Plane, Real]:
        """The points that stand for what is drawn, with their weights: those within ``reach`` mm of a line and more."""
        if len(self._points) > 1:
            self._points, self._weights = [np.concatenate(self._points)], [np.concatenate(self._weights)]
        (points,), (weights,) = self._points, self._weights
        beyond = reach + STEP  # a box that rounding cannot make too small
        inside = (points.real > line.real.min() - beyond) & (points.real < line.real.max() + beyond)
        inside &= (points.imag > line.imag.min() - beyond) & (points.imag < line.imag.max() + beyond)
        return points[inside], weights[inside]

    def crowded(self, line: Iterable[complex], reach: float) -> float:
        """How much of what is drawn lies within ``reach`` mm of a line (data coordinates), by weight."""
        z = self._paper(np.array(list(line), dtype=complex))
        first, last = self._within(z[0], z[-1])
        count = max(2, int(abs(z[-1] - z[0]) * (last - first) / STEP))
        along = z[0] + (z[-1] - z[0]) * np.linspace(first, last, count)
        points, weights = self._around(along, reach)
        near = np.min(np.abs(points[:, None] - along), axis=1) < reach
        x0, x1, y0, y1 = self._frame
        outside = (along.real < x0) | (along.real > x1) | (along.imag < y0) | (along.imag > y1)
        return float(weights[near].sum() + 60.0 * outside.any())

    def put(
        self,
        text: str,
        anchors: Iterable[complex],
        *,
        size: float = 8.0,
        gaps: tuple[float, ...] = (1.5, 2.4, 3.6),
        prefer: complex = 1 + 1j,
        ring: bool = False,
        own: Sequence[complex] = (),
        others: Sequence[Sequence[complex]] = (),
        **style: Any,
    ) -> None:
        """Write a text near one of the anchors (data coordinates), ``gaps`` mm away; a ``ring`` goes around it.

        ``own`` is the stroke, from end to end, that it names among the ``others``: it stands nearer to that one.
        """
        half = (RING * size, RING * size) if ring else half_size(text, size)
        strokes = [self._paper(np.array([line[0], line[-1]], dtype=complex)) for line in (own, *others) if len(line)]
        centres, costs = [], []
        for rank, anchor in enumerate(self._paper(np.array(list(anchors), dtype=complex))):
            tried, cost = self._tried(complex(anchor), half, gaps, prefer)
            if own:
                cost += _astray(tried, strokes)
            centres.append(tried)
            costs.append(cost + 0.4 * rank)
        at = complex(np.concatenate(centres)[int(np.argmin(np.concatenate(costs)))])
        self._taken.append((at.real - half[0], at.real + half[0], at.imag - half[1], at.imag + half[1]))
        box = {"boxstyle": "circle,pad=0.22", "fc": "white", "ec": INK, "lw": 0.6} if ring else None
        halo = [] if ring else [withStroke(linewidth=1.6, foreground="white")]
        level = "center" if text.startswith("$") else "center_baseline"
        style = {"color": INK, "zorder": 20, "path_effects": halo, **style}
        self.axes.text(*self._data(at), text, fontsize=size, ha="center", va=level, bbox=box, **style)

    def _tried(
        self, anchor: complex, half: tuple[float, float], gaps: tuple[float, ...], prefer: complex
    ) -> tuple[Plane, Real]:
        """Centres of the text around an anchor and what each would cost."""
        centres = np.concatenate([anchor + _outward(AROUND, half, gap) for gap in gaps])
        liking = np.tile((AROUND * np.conj(prefer / abs(prefer))).real, len(gaps))
        distance = np.repeat(np.arange(len(gaps)), len(AROUND))
        return centres, self._covered(anchor, centres, half) + 0.8 * distance - 0.5 * liking

    def _covered(self, anchor: complex, centres: Plane, half: tuple[float, float]) -> Real:
        width, height = half[0] + 0.4, half[1] + 0.4
        cost = np.zeros(len(centres))
        if self._points:
            points, weights = self._around(np.array([anchor]), NEAR + width)
            near = np.abs(points - anchor) < NEAR + width
            away = points[near][None, :] - centres[:, None]
            cost += ((np.abs(away.real) < width) & (np.abs(away.imag) < height)) @ weights[near]
        for x0, x1, y0, y1 in self._taken:
            over_x = np.minimum(centres.real + width, x1) - np.maximum(centres.real - width, x0)
            over_y = np.minimum(centres.imag + height, y1) - np.maximum(centres.imag - height, y0)
            cost += np.where((over_x > 0) & (over_y > 0), 12 + 4 * over_x * over_y, 0.0)
        x0, x1, y0, y1 = self._frame
        outside = (
            (centres.real - width < x0)
            | (centres.real + width > x1)
            | (centres.imag - height < y0)
            | (centres.imag + height > y1)
        )
        return np.asarray(cost + 60.0 * outside)


def _astray(centres: Plane, strokes: Sequence[Plane]) -> Real:
    """What it costs a text to stand nearer to another stroke than to its own, the first of them."""
    own, *others = (_distance(centres, stroke) for stroke in strokes)
    nearest = np.min(others, axis=0) if others else np.full(len(centres), np.inf)
    short = np.maximum(CLEARLY - (nearest - own), 0.0)
    return np.asarray(ASTRAY * short + WRONG * (nearest < own))


def _distance(at: Plane, stroke: Plane) -> Real:
    """Distances of places from a straight stroke between two ends."""
    tail, along = stroke[0], stroke[1] - stroke[0]
    size = abs(along) ** 2
    part = np.clip(((at - tail) * np.conj(along)).real / size, 0.0, 1.0) if size else 0.0
    return np.asarray(np.abs(at - tail - part * along))


def _outward(directions: Plane, half: tuple[float, float], gap: float) -> Plane:
    """Centre of a box whose border stands ``gap`` from the anchor along each direction."""
    return directions * gap + directions.real * half[0] + 1j * directions.imag * half[1]


def half_size(text: str, size: float) -> tuple[float, float]:
    """Half width and height of a line of text [mm]."""
    box = TextPath((0, 0), text, size=size, prop=FontProperties(family="DejaVu Sans")).get_extents()
    points = MM / 72
    return box.width * points / 2, max(box.height, 0.72 * size) * points / 2


def signed(value: float, digits: int = 7) -> str:
    """A number with a true minus sign."""
    return number(value, digits).replace("-", "\N{MINUS SIGN}")


def upright(name: str) -> str:
    """A name inside a formula; its underscores are letters there.

    >>> upright("B_0")
    '\\\\mathrm{B\\\\_0}'
    """
    return rf"\mathrm{{{escaped(name)}}}"


def escaped(name: str) -> str:
    """A name whose underscores do not begin an index."""
    return name.replace("_", r"\_")


def symbol(letter: str, index: str = "") -> str:
    """The sign of a force as a formula: one letter with its index, or a longer name as it is.

    >>> symbol("R", "21"), symbol("Q5"), symbol("gas")
    ('$R_{\\\\mathrm{21}}$', '$Q_{\\\\mathrm{5}}$', 'gas')
    """
    numbered = NUMBERED.fullmatch(letter)
    if not index and numbered:
        letter, index = numbered[1], numbered[2]
    if len(letter) > 1:
        return letter
    return f"${letter}_{{{upright(index)}}}$" if index else f"${letter}$"
