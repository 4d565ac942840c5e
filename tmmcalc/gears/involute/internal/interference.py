"""What can go wrong between a pinion and a ring, each with its margin; a negative margin is interference.

involute     the tip of the ring reaches beyond N1, where the pinion has no involute
fillet       the tip of one digs into the fillet of the other
trochoid     the tips collide outside the line of action, where the pinion's tip leaves the ring's space: few teeth
             of difference
trimming     the pinion cannot be moved radially out of the ring (nor a cutter be fed in): axial assembly only
"""

from __future__ import annotations

from collections.abc import Sequence
from math import acos, atan2, pi
from typing import Literal

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.roots import Indices, bracketed
from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.internal.pair import InternalPair
from tmmcalc.gears.involute.profile.form import junction
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.model import Values

Corner = tuple[float, float]  # radius of a point of the pinion's tip, and inv [rad] of the involute through it
Kind = Literal["involute", "fillet 1", "fillet 2", "trochoid", "trimming"]
_ONE = np.zeros(1, np.intp)  # the number of the only problem


@record
class Interference:
    """One kind of interference of an internal pair."""

    kind: Kind
    margin: float  # in normal modules; of trochoid and trimming the distance of the corners
    text: str  # in words, if the margin is negative

    @property
    def free(self) -> bool:
        """Whether it does not happen."""
        return self.margin >= -1e-12


def interferences(pair: InternalPair, fillet: Shape = "ellipse") -> tuple[Interference, ...]:
    """Every kind of interference of a pair whose tips lie above their base circles."""
    start, end = pair.segment
    form = float(junction(pair.pinion, fillet).curvature_radius)
    root = pair.ring.curvature_at(pair.ring.form) - pair.length
    return (
        _told("involute", start, "the tip of the ring reaches beyond the base point N1 of the pinion"),
        _told("fillet 1", start - form, "the tip of the ring cuts into the fillet of the pinion"),
        _told("fillet 2", root - end, "the tip of the pinion cuts into the fillet of the ring"),
        _told("trochoid", trochoid_margin(pair), "the tips collide outside the line of action"),
        _told("trimming", trimming_margin(pair), "the pinion cannot be moved radially into the ring"),
    )


def _told(kind: Kind, margin: float, text: str) -> Interference:
    if margin >= -1e-12:
        return Interference(kind, margin, "")
    return Interference(kind, margin, Phrase("{text} (margin {margin:.4g} modules)", text=text, margin=margin))


def _corner(pair: InternalPair) -> Corner:
    """The corner of the pinion's tip."""
    return pair.tips[0], float(involute(atan2(float(pair.pinion.curvature_at(pair.tips[0])), pair.pinion.base)))


def _ring_angles(pair: InternalPair) -> tuple[float, float]:
    """inv(alpha_a2), inv(alpha_tw)."""
    return float(involute(atan2(pair.ring.curvature_at(pair.tips[1]), pair.ring.base))), float(involute(pair.angle))


def trochoid_margin(pair: InternalPair, corners: Sequence[Corner] = ()) -> float:
    """Distance of the tips' corners where the pinion's tip circle crosses the ring's, along that circle.

    ``corners`` are the points of a rounded tip of the pinion, the first of them the outermost.
    """
    corners = corners or [_corner(pair)]
    tip2, a = pair.tips[1], pair.distance
    crossing = [corner for corner in corners if corner[0] + a > tip2]
    if not crossing:  # the pinion's tip stays within the ring's tip circle
        return tip2 - a - corners[0][0]
    return min(_beside(pair, corner) for corner in crossing)


def _beside(pair: InternalPair, corner: Corner) -> float:
    (tip1, inv1), tip2 = corner, pair.tips[1]
    inv2, inv = _ring_angles(pair)
    delta1, delta2 = _crossing(pair, tip1)
    return tip2 * ((delta1 + inv1 - inv) / pair.ratio - (delta2 + inv2 - inv))


def _crossing(pair: InternalPair, tip1: float) -> tuple[float, float]:
    """Angles [rad] at both centres from their line to where the circle of a radius of the pinion crosses the ring's."""
    tip2, a = pair.tips[1], pair.distance
    return (
        acos(max(-1.0, min(1.0, (tip2**2 - tip1**2 - a**2) / (2 * a * tip1)))),
        acos(max(-1.0, min(1.0, (tip2**2 + a**2 - tip1**2) / (2 * a * tip2)))),
    )


def tip_crossing(pair: InternalPair) -> tuple[float, float] | None:
    """The same of the tip circle of the pinion; None: it lies within the ring's."""
    tip = pair.tips[0]
    return _crossing(pair, tip) if tip + pair.distance > pair.tips[1] else None


def trimming_margin(pair: InternalPair, corners: Sequence[Corner] = ()) -> float:
    """Least sideways distance of the tips' corners as the pinion is drawn out along the line of centres.

    A corner of the pinion at the angle psi from that line stands beside the ring's corner at the angle
    z1/z2 (psi + inv(alpha_a1) - inv(alpha_tw)) - inv(alpha_a2) + inv(alpha_tw). Their distance falls with psi down to
    its least value; corners that are no deeper than the ring's tip need not pass it. ``corners`` as in
    `trochoid_margin`.
    """
    return min(_passing(pair, corner) for corner in corners or [_corner(pair)])


def _passing(pair: InternalPair, corner: Corner) -> float:
    (tip1, inv1), tip2, n = corner, pair.tips[1], 1 / pair.ratio
    inv2, inv = _ring_angles(pair)
    lead = n * (inv1 - inv) - inv2 + inv

    def narrowing(psi: Values, _: Indices) -> Values:
        return n * tip2 * np.cos(n * psi + lead) - tip1 * np.cos(psi)

    def depth(psi: Values, _: Indices) -> Values:
        return pair.distance + tip1 * np.cos(psi) - tip2 * np.cos(n * psi + lead)

    start, end = np.array([0.0]), np.array([pi / 2])
    psi = bracketed(narrowing, start, end) if narrowing(start, _ONE)[0] < 0 else start
    if depth(psi, _ONE)[0] < 0:
        psi = bracketed(depth, start, psi)
    return float(tip2 * np.sin(n * psi + lead)[0] - tip1 * np.sin(psi)[0])
