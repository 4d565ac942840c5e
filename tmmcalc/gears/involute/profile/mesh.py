"""Two wheels in mesh, placed at any phase: flanks touch at the pitch point P and stay in touch as they turn.

Line of centres = Y, first wheel at the origin, P = (0, r_w1). The second wheel stands above at (0, a_w); a ring around
the first wheel has its centre below it, at (0, -a_w). Outlines come with an element on +Y (see `outline`).
"""

from __future__ import annotations

from cmath import exp
from math import pi

from tmmcalc.core.plane import Plane
from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.pair import Pair
from tmmcalc.gears.involute.wheel import Wheel


@record
class Placing:
    """Where a wheel stands: turned counter-clockwise, then moved."""

    turn: float  # [rad]
    centre: complex  # [module]

    def __call__(self, points: Plane) -> Plane:
        """The points of the wheel in the axes of the pair."""
        return points * exp(1j * self.turn) + self.centre


def placings(pair: Pair, phase: float = 0.0) -> tuple[Placing, Placing]:
    """Both wheels of an external pair; the first has turned clockwise by ``phase`` [rad] since contact at P."""
    angle = float(pair.angle)
    first, second = _pitch_half_angle(pair.first, angle), _pitch_half_angle(pair.second, angle)
    turned = phase * pair.first.teeth / pair.second.teeth
    return Placing(-first - phase, 0j), Placing(pi - second + turned, 1j * float(pair.distance))


def ring_placings(
    pinion: Wheel, ring: Wheel, angle: float, distance: float, phase: float = 0.0
) -> tuple[Placing, Placing]:
    """Pinion and ring at the operating angle [rad] and centre distance [module] of their mesh; both turn clockwise.

    ``ring`` is the external wheel with the data of the ring, as in `ring_flank`.
    """
    first, second = _pitch_half_angle(pinion, angle), _pitch_half_angle(ring, angle)
    turned = phase * pinion.teeth / ring.teeth
    return Placing(-first - phase, 0j), Placing(-second - turned, -1j * distance)


def _pitch_half_angle(wheel: Wheel, angle: float) -> float:
    """Half the angle [rad] of a tooth on the operating pitch circle, psi - gamma."""
    return float(wheel.half_angle) - (float(involute(angle)) - float(involute(wheel.transverse_angle)))
