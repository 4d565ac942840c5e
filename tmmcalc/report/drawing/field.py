"""A rectangle of paper with data in it: a board, whose scale is one round factor, or a diagram with two axes."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from tmmcalc.core.plane import Plane, Real
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.labels import Labels
from tmmcalc.report.drawing.pens import INK, MIDDLE, THICK, THIN, WHITE, Pen
from tmmcalc.report.drawing.regions import arcs_in, cut_to
from tmmcalc.report.drawing.shapes import ARROW, Arc, Area, Drawing, Hatching, arrowhead
from tmmcalc.report.numbers import round_scale

GAPS = (0.9, 2.0, 4.0, 7.0, 12.0)  # from an anchor to its name [mm]


class Field:
    """Data in a rectangle of paper: x + i y lies at ``box`` corner + (x - x0) kx + i (y - y0) ky."""

    def __init__(self, drawing: Drawing, box: Box, origin: complex, factors: tuple[float, float]) -> None:
        """``origin`` is the data at the lower left corner, ``factors`` are mm of paper to its units."""
        self.drawing, self.box = drawing, box
        self._origin, self._factors = origin, factors
        self.labels = Labels(drawing, box)
        drawing.fields.append(self)

    def paper(self, z: Plane | Sequence[complex]) -> Plane:
        """Places on paper of data."""
        shift = np.asarray(z, complex) - self._origin
        corner = complex(self.box.left, self.box.bottom)
        return np.asarray(corner + shift.real * self._factors[0] + 1j * shift.imag * self._factors[1])

    def place(self, z: complex) -> complex:
        """The place on paper of one datum."""
        return complex(self.paper([z])[0])

    def data(self, at: complex) -> complex:
        """The datum at a place on paper."""
        shift = at - complex(self.box.left, self.box.bottom)
        return self._origin + complex(shift.real / self._factors[0], shift.imag / self._factors[1])

    def name(self, text: str, anchors: Sequence[complex] | Plane, *, height: float = 2.5, **style: Any) -> None:
        """A name near one of these data, or farther away with a leader, see `Labels.put`."""
        self.labels.put(text, self.paper(anchors).tolist(), height=height, **{"gaps": GAPS, **style})

    def curve(self, z: Plane, pen: Pen, *, weight: float = 0.7, level: float = 4.0) -> None:
        """A polyline of data, cut off at the border; names keep clear of it by ``weight``."""
        for part in clipped(self.paper(z), self.box):
            self.drawing.line(part, pen, level=level)
            if weight:
                self.labels.avoid(part, weight)

    def filled(self, z: Plane, fill: str, *, hatch: Pen | None = None, level: float = -3.0) -> None:
        """A polygon of data filled with a colour, and hatched, cut off at the border."""
        corners = cut(self.paper(z), self.box)
        if len(corners) > 2:
            self.drawing.add(Area(corners, fill), level=level)
            if hatch is not None:
                self.drawing.add(Hatching((corners,), pen=hatch), level=level)


class Board(Field):
    """Data with equal axes whose scale on paper is a round number: ``mu`` units of data to a mm.

    Lengths of strokes and signs are in mm of paper, their places in data.
    """

    def __init__(
        self,
        drawing: Drawing,
        box: Box,
        content: Plane,
        margin: float,
        mu: float = 0.0,
        *,
        scale: Callable[[float], float] = round_scale,
    ) -> None:
        """Choose the scale, one of a series, so that the content keeps a margin [mm], or take ``mu``."""
        low = complex(content.real.min(), content.imag.min())
        high = complex(content.real.max(), content.imag.max())
        self.mu = mu or scale(needed(content, box, margin) or 1e-3)
        origin = (low + high) / 2 - self.mu * complex(box.width, box.height) / 2
        super().__init__(drawing, box, origin, (1 / self.mu, 1 / self.mu))

    def line(self, points: Iterable[complex], pen: Pen = THICK, *, weight: float = 1.0, level: float = 0.0) -> None:
        """A polyline; names keep clear of it by ``weight``."""
        self.curve(np.asarray(list(points), complex), pen, weight=weight, level=level)

    def lines(
        self, segments: Sequence[Sequence[complex]], pen: Pen, *, weight: float = 1.0, level: float = 0.0
    ) -> None:
        """Many polylines of one pen."""
        for segment in segments:
            self.line(segment, pen, weight=weight, level=level)

    def area(
        self,
        corners: Iterable[complex],
        pen: Pen | None = MIDDLE,
        *,
        fill: str = WHITE,
        weight: float = 1.0,
        level: float = 0.0,
    ) -> None:
        """A closed polygon."""
        z = self.paper(list(corners))
        self.drawing.add(Area(z, fill, pen), level=level)
        if weight:
            self.labels.avoid([*z, z[0]], weight)

    def face(self, corners: Iterable[complex], fill: str, *, level: float = 0.0) -> None:
        """A closed polygon of a colour without an outline, cut off at the border; names may stand on it."""
        z = cut_to(self.paper(list(corners)), self.box)
        if len(z):
            self.drawing.add(Area(z, fill), level=level)

    def arc(
        self,
        centre: complex,
        radius: float,
        pen: Pen = THIN,
        *,
        start: float = 0.0,
        end: float = 2 * math.pi,
        weight: float = 0.5,
        level: float = 0.0,
    ) -> list[Arc]:
        """A circle of data, or its part from angle to angle [rad], cut off at the border; what is drawn of it."""
        at, size = self.place(centre), radius / self.mu
        found = [Arc(at, size, pen, *ends) for ends in arcs_in(at, size, self.box, start, end)]
        self.drawing.add(*found, level=level)
        for each in found if weight else ():
            count = max(2, int((each.end - each.start) * size / ARROW))
            self.labels.avoid(at + size * np.exp(1j * np.linspace(each.start, each.end, count + 1)), weight)
        return found

    def circle(
        self, centre: complex, radius: float, pen: Pen = MIDDLE, *, fill: str = WHITE, level: float = 0.0
    ) -> None:
        """A circle of this radius on paper [mm]."""
        at = self.place(centre)
        self.drawing.add(Arc(at, radius, pen, fill=fill), level=level)
        self.labels.avoid([*(at + radius * np.exp(1j * np.linspace(0, 2 * np.pi, 13))), at], 2.0)

    def dot(self, at: complex, radius: float = 0.55, *, colour: str = INK, level: float = 0.0) -> None:
        """A filled point."""
        self.circle(at, radius, Pen("POINTS", 0.13, colour=colour), fill=colour, level=level)

    def arrowhead(
        self, tip: complex, direction: complex, pen: Pen, length: float = ARROW, *, level: float = 12.0
    ) -> None:
        """A filled arrowhead, its length on paper [mm]."""
        head = arrowhead(self.place(tip), direction / abs(direction), pen, length)
        self.drawing.add(head, level=level)
        self.labels.avoid([*head.points, head.points[0]])

    def vector(self, tail: complex, tip: complex, pen: Pen, head: float = ARROW, *, level: float = 12.0) -> None:
        """An arrow of data."""
        ends = self.place(tail), self.place(tip)
        self.drawing.vector(*ends, pen, head, level)
        self.labels.avoid(ends)


def needed(content: Plane, box: Box, margin: float) -> float:
    """The least scale at which the content keeps a margin [mm] within a rectangle; 0 for a single point."""
    wide, high = float(np.ptp(content.real)), float(np.ptp(content.imag))
    return max(wide / (box.width - 2 * margin), high / (box.height - 2 * margin))


def clipped(points: Plane, box: Box) -> list[Plane]:
    """The parts of a polyline inside a rectangle, each from end to end."""
    if len(points) < 2:
        return [points] if _inside(points, box).all() else []
    if _inside(points, box).all():
        return [points]
    found: list[list[complex]] = []
    for (a, b), (first, last) in zip(pairwise(points.tolist()), _within(points, box).tolist(), strict=True):
        if first < last:
            start, end = a + (b - a) * first, a + (b - a) * last
            if found and found[-1][-1] == start:
                found[-1].append(end)
            else:
                found.append([start, end])
    return [np.array(part) for part in found]


def cut(corners: Plane, box: Box) -> Plane:
    """A polygon cut off at the sides of a rectangle one after another (Sutherland and Hodgman); empty: all outside."""
    for side, turn in ((box.left, 1), (-box.right, -1), (box.bottom, -1j), (-box.top, 1j)):
        beyond = (corners * turn).real - side  # not below 0 inside of this side
        found: list[complex] = []
        for k, at in enumerate(corners.tolist()):
            before, here = float(beyond[k - 1]), float(beyond[k])
            if (before < 0) != (here < 0):
                found.append(corners[k - 1] + (at - corners[k - 1]) * before / (before - here))
            if here >= 0:
                found.append(at)
        corners = np.array(found, complex)
    return corners


def _inside(z: Plane, box: Box) -> Real:
    return np.asarray((z.real >= box.left) & (z.real <= box.right) & (z.imag >= box.bottom) & (z.imag <= box.top))


def _within(points: Plane, box: Box) -> Real:
    """Of every step (n - 1, 2) the part inside, from 0 to 1; empty where the second is not above the first."""
    a, way = points[:-1], np.diff(points)
    first, last = np.zeros(len(way)), np.ones(len(way))
    for start, step, low, high in (
        (a.real, way.real, box.left, box.right),
        (a.imag, way.imag, box.bottom, box.top),
    ):
        with np.errstate(divide="ignore", invalid="ignore"):
            ends = np.sort(np.stack(((low - start) / step, (high - start) / step)), axis=0)
        still = step == 0
        outside = still & ((start < low) | (start > high))
        first = np.where(still, first, np.maximum(first, ends[0]))
        last = np.where(outside, -1.0, np.where(still, last, np.minimum(last, ends[1])))
    return np.stack((first, last), axis=1)
