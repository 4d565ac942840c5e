"""Outlines of whole wheels: one element, a tooth or the space of a ring, mirrored and repeated about the centre.

The axis of the first element is +Y; everything runs counter-clockwise: right half of the element, arc of its crest,
left half, arc to the next element. The crest of a tooth is its tip, that of a space its bottom.
"""

from __future__ import annotations

from math import ceil, pi, sqrt
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.curves import Curve, chords, cubics
from tmmcalc.core.plane import Plane
from tmmcalc.core.records import record
from tmmcalc.gears.involute.profile.flank import Flank

FLAT = 1e-12  # [rad] half angle below which there is no arc


@record
class Element:
    """A tooth of a wheel or a space of a ring: its left half, from the crest to the middle of the gap."""

    teeth: int
    curves: tuple[Curve, ...]  # continuous, from the crest on
    crest: float  # radius of the arc over the crest
    gap: float  # radius of the arc between two elements


class Arc(NamedTuple):
    """An arc about the centre of the wheel, counter-clockwise."""

    radius: float
    start: float  # [rad] from +X
    sweep: float  # [rad]

    def points(self, tolerance: float) -> Plane:
        """Points inside the arc, without its ends, whose chords keep within ``tolerance`` of it."""
        turn = sqrt(8 * min(tolerance / self.radius, 0.1))  # sagitta r turn^2/8
        steps = max(ceil(self.sweep / turn), 1)
        return self.radius * np.exp(1j * (self.start + self.sweep * np.arange(1, steps) / steps))


class Pieces(NamedTuple):
    """One element as arcs and cubics: right half, crest, left half, gap; cubics as control points (n, 4)."""

    right: Plane
    crest: Arc
    left: Plane
    gap: Arc


def tooth(flank: Flank) -> Element:
    """The tooth with a flank; raises `NoSolutionError` if neighbouring fillets overlap."""
    return checked(Element(flank.wheel.teeth, flank.curves, flank.tip, float(flank.wheel.root)))


def checked(element: Element) -> Element:
    """The element itself; raises `NoSolutionError` if it is wider than its share of the circle."""
    crest, gap = arcs(element)
    if min(crest.sweep, gap.sweep) < -1e-9:
        raise NoSolutionError(
            Phrase("neighbouring flanks overlap by {overlap:.3g} rad", overlap=-min(crest.sweep, gap.sweep)),
            where="tooth profile",
            value=min(crest.sweep, gap.sweep),
            limit=0.0,
            remedy="another shift or tip radius",
        )
    return element


def arcs(element: Element) -> tuple[Arc, Arc]:
    """The arcs over the crest and to the next element."""
    first, last = element.curves[0], element.curves[-1]
    top = float(np.angle(first.point(np.array([first.start]))[0])) - pi / 2
    end = float(np.angle(last.point(np.array([last.end]))[0]))
    width = 2 * (pi / 2 + pi / element.teeth - end)
    return _arc(element.crest, pi / 2 - top, 2 * top), _arc(element.gap, end, width)


def _arc(radius: float, start: float, sweep: float) -> Arc:
    return Arc(radius, start, 0.0 if abs(sweep) < FLAT else sweep)


def half(element: Element, points: int | None = None, tolerance: float | None = None) -> Plane:
    """The left half without its arcs (n,): ``points`` of them, or as many as the chord tolerance [module] asks for.

    The curves share the points in the proportion of their lengths. Raises `UsageError` unless one of both is given.
    """
    if (points is None) == (tolerance is None):
        raise UsageError(
            "either a number of points or a chord tolerance is needed", where="tooth profile", remedy="give one of them"
        )
    if tolerance is not None:
        runs = [chords(curve, tolerance) for curve in element.curves]
    else:
        runs = _shared(element.curves, points or 0)
    return np.concatenate([runs[0], *(run[1:] for run in runs[1:])])


def _shared(curves: tuple[Curve, ...], points: int) -> list[Plane]:
    if points < 2 * len(curves) + 1:
        raise UsageError(
            f"{points} points are too few for a flank",
            where="tooth profile",
            value=points,
            limit=2 * len(curves) + 1,
            remedy=f"at least {2 * len(curves) + 1}",
        )
    lengths = np.array([np.abs(np.diff(curve.point(np.linspace(curve.start, curve.end, 9)))).sum() for curve in curves])
    steps = np.maximum(np.round((points - 1) * lengths / lengths.sum()).astype(int), 1)
    steps[np.argmax(steps)] += points - 1 - steps.sum()
    return [
        curve.point(np.linspace(curve.start, curve.end, n + 1)) for curve, n in zip(curves, steps.tolist(), strict=True)
    ]


def mirrored(points: Plane) -> Plane:
    """The points mirrored in Y, in the opposite order."""
    return -np.conj(points)[..., ::-1]


def element_outline(
    element: Element, points: int | None = None, tolerance: float | None = None, arc_tolerance: float = 1e-3
) -> Plane:
    """One element (n,) counter-clockwise, to the end of the arc behind it; arguments as `half`.

    The arcs keep the tolerance, or ``arc_tolerance`` [module] where the number of points is given.
    """
    left = half(element, points, tolerance)
    crest, gap = arcs(element)
    fine = arc_tolerance if tolerance is None else tolerance
    right = mirrored(left)
    if crest.sweep == 0:
        right = right[:-1]
    if gap.sweep == 0:
        left = left[:-1]
    return np.concatenate([right, crest.points(fine), left, gap.points(fine)])


def outline(
    element: Element, points: int | None = None, tolerance: float | None = None, arc_tolerance: float = 1e-3
) -> Plane:
    """The whole wheel, a closed polygon (n,) counter-clockwise, its first point not repeated; arguments as `half`."""
    one = element_outline(element, points, tolerance, arc_tolerance)
    turns = np.exp(2j * pi * np.arange(element.teeth) / element.teeth)
    return (turns[:, None] * one).ravel()


def pieces(element: Element, tolerance: float) -> Pieces:
    """One element as arcs and cubics that keep within ``tolerance`` [module] of it."""
    left = np.concatenate([cubics(curve, tolerance) for curve in element.curves])
    crest, gap = arcs(element)
    return Pieces(-np.conj(left)[::-1, ::-1], crest, left, gap)
