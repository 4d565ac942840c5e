"""From jets of a motion to its velocities and accelerations in time, with their changes and their errors."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.derivatives.closure import EPS, Moved
from tmmcalc.linkage.derivatives.rows import Placing
from tmmcalc.linkage.results import Kinematics

MARGIN = 8.0  # of the roundings of one solution, in units of the condition times the last digit


class Rates(NamedTuple):
    """How speed and acceleration of the input change, (K, 1) each, and what they are."""

    speed: float
    acceleration: float
    dspeed: Real
    dacceleration: Real

    def velocity(self, jet: Real, change: Real) -> Real:
        """Change of S' omega, of a jet and its change."""
        return change[1] * self.speed + jet[1] * self.dspeed

    def in_time(self, jet: Real, change: Real) -> Real:
        """Change of S'' omega^2 + S' eps."""
        steady = change[2] * self.speed**2 + 2 * jet[2] * self.speed * self.dspeed
        return steady + change[1] * self.acceleration + jet[1] * self.dacceleration

    def sizes(self, size: Real) -> Real:
        """Errors (5, K) of value, velocity, acceleration and both transfer functions, from those of a jet (3, K)."""
        w, eps = abs(self.speed), abs(self.acceleration)
        own = np.abs(self.dspeed[:, 0]), np.abs(self.dacceleration[:, 0])
        velocity = size[1] * w + EPS * own[0] * size[1]
        return np.stack([size[0], velocity, size[2] * w**2 + size[1] * eps + EPS * sum(own) * size[2], *size[1:]])


def size_of(kinematics: Kinematics, moved: Moved, along: Moved, dx: Real, placed: Placing) -> Real:
    """Errors (3, K) of changes of points [m] of each order."""
    base = np.array([kinematics.error.position, kinematics.error.velocity, kinematics.error.acceleration])
    rounding = np.maximum(np.maximum.accumulate(base), EPS)[:, None]
    shift = np.max(np.abs(dx), axis=1)
    condition = float(np.max(moved.condition))
    return MARGIN * rounding * condition * (moved.largest() + along.largest() * shift) + along.largest() * placed.error
