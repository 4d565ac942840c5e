"""Names that keep clear of what is drawn and of each other.

Everything is in mm of paper: a name tries places around its anchors and takes the one where it covers least. Where
none is free it goes farther away, with a leader. What then still covers another name or a line stands in
`Labels.faults`, for the drawing's own warning.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.plane import Plane, Real
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import extent, width
from tmmcalc.report.drawing.pens import INK, THIN, WHITE
from tmmcalc.report.drawing.shapes import Arc, Drawing, Words

STEP = 0.5  # spacing of the points that stand for a line [mm]
AIR = 0.4  # between a name and what is around it [mm]
CLEARLY = 0.8  # so much nearer to its own stroke than to another a name is told apart [mm]
ASTRAY = 15.0  # what a mm less costs
WRONG = 50.0  # and what it costs to be nearer to another one
FURTHER = (4.0, 6.0, 8.5, 11.5, 15.0, 19.0, 24.0, 30.0)  # gaps of a name that found no free place nearby [mm]
FAR = 3.0  # a name that stands farther from its anchor has a leader [mm]
SLANT, FLAT = 0.3, 1.0  # slope of a leader below which it is level; what that costs
NO_STROKES = np.empty((0, 2), complex)
NINE = np.linspace(0.0, 1.0, 9)  # places along a leader
TOUCHING = 0.3  # strokes nearer than this all along are told apart by no name [mm]
AWAY, LIKED, SECOND = 0.8, 0.5, 0.4  # cost of each gap farther away, gain of the preferred side, cost of a later anchor
CROSSED = 3.0  # what it costs a leader to cross another name, by mm
OUTSIDE = 60.0  # what it costs to reach over the border
COVERED = 3.0  # covering more than this is a fault
LEVEL = 20.0  # names stand over all else
AROUND = np.exp(1j * np.radians([45, 135, -45, -135, 90, 0, 180, -90, 22, 68, 112, 158, -22, -68, -112, -158]))


class Fault(NamedTuple):
    """A name that found no free place."""

    text: str
    at: complex  # on paper
    cost: float


class Place(NamedTuple):
    """Where a name stands."""

    at: complex  # its middle
    anchor: complex
    cost: float  # of what it covers
    whole: float  # and of all that is said against the place


class Labels:
    """The names of one field."""

    def __init__(self, drawing: Drawing, box: Box) -> None:
        self.drawing, self.box = drawing, box
        self.faults: list[Fault] = []
        self.count = 0
        self._new: list[tuple[Plane, float]] = []  # points with their weight, not yet among those below
        self._points = np.empty((3, 0))  # x, y and weight of the points that stand for what is drawn, each in a row
        self._taken = np.empty((4, 0))  # left, right, bottom and top of what names and others take

    def avoid(self, line: Iterable[complex], weight: float = 1.0) -> None:
        """Keep clear of this line on paper, the more the greater the weight."""
        z = np.atleast_1d(np.asarray(list(line), dtype=complex))
        along = np.diff(z)
        counts = np.maximum(1, (np.abs(along) / STEP).astype(int))
        number = np.arange(1, counts.sum() + 1) - np.repeat(np.cumsum(counts) - counts, counts)
        between = np.repeat(z[:-1], counts) + np.repeat(along, counts) * number / np.repeat(counts, counts)
        self.avoid_points(np.r_[z[:1], between], weight)

    def avoid_points(self, points: Plane, weight: float = 1.0) -> None:
        """Keep clear of single points on paper."""
        self._new.append((points, weight))

    def keep(self, corners: Plane) -> None:
        """Keep a rectangle free of names, as of one that stands there."""
        x, y = corners.real, corners.imag
        self._take(x.min(), x.max(), y.min(), y.max())

    def crowded(self, line: Sequence[complex], reach: float) -> float:
        """How much of what is drawn lies within ``reach`` mm of a line on paper, by weight."""
        count = max(2, int(abs(line[-1] - line[0]) / STEP))
        along = line[0] + (line[-1] - line[0]) * np.linspace(0, 1, count)
        x, y, weights = self._around(along, reach, reach)
        apart = np.subtract.outer(along.real, x) ** 2 + np.subtract.outer(along.imag, y) ** 2
        near = apart.min(axis=0) < reach**2
        outside = (along.real < self.box.left) | (along.real > self.box.right)
        outside |= (along.imag < self.box.bottom) | (along.imag > self.box.top)
        return float(weights[near].sum() + OUTSIDE * outside.any())

    def struck(self, line: Sequence[complex]) -> float:
        """How many mm of a line on paper lie on names and what else is kept free."""
        count = max(2, int(abs(line[-1] - line[0]) / STEP) + 1)
        on = line[0] + (line[-1] - line[0]) * np.linspace(0.0, 1.0, count)
        return STEP * float(self._within(on).sum())

    def put(
        self,
        text: str,
        anchors: Iterable[complex],
        *,
        height: float = 2.5,
        gaps: tuple[float, ...] = (0.9, 1.7, 2.8),
        prefer: complex = 1 + 1j,
        ring: bool = False,
        colour: str = INK,
        own: Sequence[complex] = (),
        others: Sequence[Sequence[complex]] = (),
    ) -> complex:
        """Write a name near one of the anchors on paper, ``gaps`` mm away; a ``ring`` goes around it. Its middle.

        ``own`` is the stroke, from end to end, that it names among the ``others``: it stands nearer to that one, or
        has a leader.
        """
        height *= self.drawing.letters
        above, below = extent(text, height)
        half = (width(text, height) / 2, (above + below) / 2)
        radius = max(abs(complex(*half)) + 0.4, 0.95 * height)
        half = (radius, radius) if ring else half
        places = [complex(anchor) for anchor in anchors]
        best = self._best(places, half, gaps, prefer, _strokes(own, others))
        if best.cost > COVERED:
            best = min(best, self._best(places, half, FURTHER, prefer, NO_STROKES), key=lambda found: found.cost)
        at, anchor, cost, _ = best
        self.count += 1
        if cost > COVERED:
            self.faults.append(Fault(text, at, cost))
        self._lead(anchor, at, half, ring=ring)
        self._take(at.real - half[0], at.real + half[0], at.imag - half[1], at.imag + half[1])
        if ring:
            self.drawing.add(Arc(at, radius, THIN, fill=WHITE), level=LEVEL)
        self.drawing.add(Words(at, text, height, colour=colour, clear=not ring), level=LEVEL)
        return at

    def put_where_free(
        self,
        text: str,
        anchor: complex,
        *,
        height: float = 2.5,
        gaps: tuple[float, ...] = (0.9, 1.7, 2.8),
        prefer: complex = 1 + 1j,
        colour: str = INK,
    ) -> complex | None:
        """Write a name that may be left out: its middle, or None where no place around the anchor is free."""
        larger = height * self.drawing.letters
        above, below = extent(text, larger)
        if (
            self._best([anchor], (width(text, larger) / 2, (above + below) / 2), gaps, prefer, NO_STROKES).whole
            > COVERED
        ):
            return None
        return self.put(text, [anchor], height=height, gaps=gaps, prefer=prefer, colour=colour)

    def _best(
        self,
        anchors: Sequence[complex],
        half: tuple[float, float],
        gaps: tuple[float, ...],
        prefer: complex,
        strokes: Plane,
    ) -> Place:
        """Where a name covers least, and near its anchor."""
        way = prefer / abs(prefer) if prefer else 0.0
        liking = LIKED * (AROUND * np.conj(way)).real
        best = Place(anchors[0], anchors[0], np.inf, np.inf)
        for rank, anchor in enumerate(anchors):
            for step, gap in enumerate(gaps):
                against = AWAY * step + SECOND * rank
                if best.whole <= against - LIKED * abs(way):
                    break  # what is said against places so far away is more than all that the best one costs
                tried = anchor + _outward(AROUND, half, gap)
                cost = self._covered(tried, half)
                if len(strokes):
                    cost = cost + _astray(tried, strokes)
                if gaps[-1] > FAR:
                    cost = cost + self._crossed(anchor, tried, half)
                disliked = FLAT * (np.abs(AROUND.imag) < SLANT) - liking if gap > FAR else -liking
                at = int(np.argmin(cost + disliked))
                whole = float(cost[at] + disliked[at]) + against
                if whole < best.whole:
                    best = Place(complex(tried[at]), anchor, float(cost[at]), whole)
        return best

    def _take(self, left: float, right: float, bottom: float, top: float) -> None:
        self._taken = np.column_stack((self._taken, (left, right, bottom, top)))

    def _crossed(self, anchor: complex, centres: Plane, half: tuple[float, float]) -> Real:
        """What the leaders (n,) from an anchor to names at these places cost for the names that they cross."""
        along = centres - anchor
        edges = _edge(along, half)
        found = np.zeros(len(centres))
        led = edges * np.abs(along) > FAR
        if led.any():
            on = anchor + (edges[led] * along[led])[:, None] * NINE
            found[led] = CROSSED * self._within(on).sum(axis=(0, 2))
        return found

    def _within(self, on: Plane) -> NDArray[np.bool_]:
        """Which places lie on each rectangle that is taken, or close to it; (rectangles, *places)."""
        x0, x1, y0, y1 = self._taken.reshape(4, -1, *[1] * on.ndim)
        across = (on.real > x0 - AIR) & (on.real < x1 + AIR)
        return np.asarray(across & (on.imag > y0 - AIR) & (on.imag < y1 + AIR))

    def _lead(self, anchor: complex, at: complex, half: tuple[float, float], *, ring: bool) -> None:
        """The leader of a name that stands far from its anchor; a level one would read as a minus sign before it."""
        edge = float(_edge(np.array([at - anchor]), half)[0])
        if edge * abs(at - anchor) > FAR:
            end = anchor + edge * (at - anchor)
            way = end - anchor
            if not ring and abs(way.imag) < SLANT * abs(way.real):
                if abs(at.real - anchor.real) > half[0]:  # to the far corner of the nearer side
                    end = at + complex(-math.copysign(half[0], way.real), math.copysign(half[1], way.imag))
                else:
                    end = complex(anchor.real, end.imag)
            line = [anchor + 0.15 * (end - anchor), end]
            self.drawing.line(line, THIN, level=12)
            self.avoid(line, 0.5)

    def _around(self, line: Plane, wide: float, high: float) -> Real:
        """The points (3, n) that stand for what is drawn: those so near to a line on paper [mm], and more."""
        if self._new:
            rows = [np.array((points.real, points.imag, np.full(len(points), weight))) for points, weight in self._new]
            self._points = np.concatenate([self._points, *rows], axis=1)
            self._new.clear()
        x, y, _ = self._points
        at, up = line.real, line.imag
        wide, high = wide + STEP, high + STEP  # a box that rounding cannot make too small
        inside = (x > at.min() - wide) & (x < at.max() + wide) & (y > up.min() - high) & (y < up.max() + high)
        return self._points.compress(inside, axis=1)

    def _covered(self, centres: Plane, half: tuple[float, float]) -> Real:
        """What a name would cover with its middle at each of these places, by weight."""
        wide, high = half[0] + AIR, half[1] + AIR
        x, y, weights = self._around(centres, wide, high)
        under = np.abs(np.subtract.outer(centres.real, x)) < wide
        under &= np.abs(np.subtract.outer(centres.imag, y)) < high
        cost = under @ weights
        x0, x1, y0, y1 = self._taken[:, :, None]
        over_x = np.minimum(centres.real + wide, x1) - np.maximum(centres.real - wide, x0)
        over_y = np.minimum(centres.imag + high, y1) - np.maximum(centres.imag - high, y0)
        cost = cost + np.where((over_x > 0) & (over_y > 0), 12 + 4 * over_x * over_y, 0.0).sum(axis=0)
        box = self.box
        outside = (centres.real - wide < box.left) | (centres.real + wide > box.right)
        outside |= (centres.imag - high < box.bottom) | (centres.imag + high > box.top)
        return np.asarray(cost + OUTSIDE * outside)


def _strokes(own: Sequence[complex], others: Sequence[Sequence[complex]]) -> Plane:
    """Ends (n, 2) of a name's own stroke, then those of the others, but for one that its own lies upon."""
    if not len(own):
        return NO_STROKES
    every = np.array([(stroke[0], stroke[-1]) for stroke in (own, *others)], complex)
    apart = _distances(every[0], every).max(axis=1) > TOUCHING
    return every[(np.arange(len(every)) == 0) | apart]


def _edge(along: Plane, half: tuple[float, float]) -> Real:
    """What part (n,) of the way from an anchor to the middle of a name lies outside of its box."""
    with np.errstate(divide="ignore"):
        inside = np.minimum(half[0] / np.abs(along.real), half[1] / np.abs(along.imag))
    return np.asarray(np.maximum(1.0 - inside, 0.0))


def _astray(centres: Plane, strokes: Plane) -> Real:
    """What it costs a name to stand nearer to another stroke than to its own, the first of them."""
    own, *others = _distances(centres, strokes)
    nearest = np.min(others, axis=0) if others else np.full(len(centres), np.inf)
    short = np.maximum(CLEARLY - (nearest - own), 0.0)
    return np.asarray(ASTRAY * short + WRONG * (nearest < own))


def _distances(at: Plane, strokes: Plane) -> Real:
    """Distances (strokes, places) of places from straight strokes between two ends."""
    tails, along = strokes[:, :1], strokes[:, 1:] - strokes[:, :1]
    size = np.abs(along) ** 2
    part = ((at - tails) * np.conj(along)).real / np.where(size > 0.0, size, 1.0)
    return np.asarray(np.abs(at - tails - np.clip(part, 0.0, 1.0) * along))


def _outward(directions: Plane, half: tuple[float, float], gap: float) -> Plane:
    """Centre of a box whose border stands ``gap`` from the anchor along each direction."""
    return directions * gap + directions.real * half[0] + 1j * directions.imag * half[1]
