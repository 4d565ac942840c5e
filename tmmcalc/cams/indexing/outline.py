"""The closed profile of a cam: lobe, dwell, groove, dwell; as pieces that files are made of.

In the axes of the cam, which turns counter-clockwise, the rollers run clockwise: phi grows along the lobe from flank A
over the tip to the back, along an arc about O1, along the groove half a turn from the lobe, and along an arc.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import pi

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.indexing.bounds import start_angle
from tmmcalc.cams.indexing.flanks import Drive, Flank, FlankName
from tmmcalc.cams.laws.law import Values
from tmmcalc.core.numerics.curves import Curve, cubics, knots
from tmmcalc.core.records import record
from tmmcalc.report.outlines import Bow, Cubics, Outline

SAME = 1e-12  # of the step
NAMES = {"A": "flank A", "back": "back of the lobe", "B": "groove B"}


@record
class Stretch:
    """A smooth part of the profile, in the order of phi."""

    name: str
    curve: Curve  # clockwise; of a flank by k, of an arc by phi
    phi: tuple[float, float]  # [rad] where it begins, and by how much phi grows with the parameter
    arc: Bow | None = None

    def angle(self, t: Values) -> Values:
        """phi (n,) [rad] at values of the parameter."""
        return np.asarray(self.phi[0] + self.phi[1] * (t - self.curve.start))

    def normal(self, t: Values) -> Complex:
        """Unit normal (n,) out of the cam."""
        rate = self.curve.rate(t)
        return np.asarray(1j * rate / np.abs(rate))


def stretches(
    drive: Drive, distance: float, end: float, rests: tuple[float, float] | None = None
) -> tuple[Stretch, ...]:
    """The profile, offset inwards by ``distance`` from the pitch curve, whose flank A ends at k = ``end``.

    ``rests`` [rad] are the dwells after the step of the lobe and after that of the groove; None: equal ones.
    """
    start, radius = start_angle(drive.rollers, drive.ratio), drive.base - distance
    first, last = rests or (pi - drive.step, pi - drive.step)
    after = pi if rests is None else drive.step + first
    return (
        *_flank(drive, "A", 0.0, end, distance),
        *_flank(drive, "back", 1 - end, 1.0, distance),
        _arc("dwell", drive.step, first, -start - drive.step, radius),
        *_flank(drive, "B", 0.0, 1.0, distance, after),
        _arc("dwell", after + drive.step, last, start - after - drive.step, radius),
    )


def _flank(
    drive: Drive, name: FlankName, low: float, high: float, distance: float, after: float = 0.0
) -> Iterator[Stretch]:
    """The smooth pieces of a flank, ``after`` an angle from the lobe; the groove in halves: its bottom may be sharp."""
    flank, half = Flank(drive, name), 0.5 if name == "B" else low
    inner = [b for b in (*drive.law.breaks.tolist(), half) if low + SAME < b < high - SAME]
    edges = [low, *sorted(dict.fromkeys(inner)), high]
    for first, last in pairwise(edges):
        yield Stretch(
            NAMES[name], _flank_curve(flank, first, last, distance, after), (after + drive.step * first, drive.step)
        )


def _flank_curve(flank: Flank, first: float, last: float, distance: float, after: float) -> Curve:
    # the groove is cut in the step of the other cam; half a turn on without the rounding of a half turn
    side = np.exp(-1j * after) if after not in (0.0, pi) else -1.0 if after else 1.0
    number = int(flank.drive.law.piece(np.array([(first + last) / 2]))[0])

    def point(k: Values) -> Complex:
        every = k.ravel()
        return side * flank.points(every, distance, np.full(every.size, number)).reshape(k.shape)

    def rate(k: Values) -> Complex:
        every = k.ravel()
        return side * flank.rates(every, distance, np.full(every.size, number)).reshape(k.shape)

    return Curve(point, rate, first, last)


def _arc(name: str, phi: float, angle: float, start: float, radius: float) -> Stretch:
    """An arc about O1 that begins at the polar angle ``start`` and runs clockwise."""

    def point(t: Values) -> Complex:
        return np.asarray(radius * np.exp(1j * (start + phi - t)))

    def rate(t: Values) -> Complex:
        return np.asarray(-1j * point(t))

    return Stretch(name, Curve(point, rate, phi, phi + angle), (phi, 1.0), Bow(0j, radius, start - angle, angle))


def outline(name: str, chain: tuple[Stretch, ...], tolerance: float) -> Outline:
    """The closed outline of a profile, counter-clockwise [m], within ``tolerance`` of it."""
    points = [stretch.curve.point(knots(stretch.curve, tolerance))[:-1] for stretch in chain]
    pieces = tuple(stretch.arc or Cubics(cubics(stretch.curve, tolerance)[::-1, ::-1]) for stretch in reversed(chain))
    return Outline(name, name, pieces, np.concatenate(points)[::-1], True)
