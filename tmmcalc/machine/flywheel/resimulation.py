"""The motion that a given constant inertia really has under forces of position, without any approximation.

With the initial energy T0 the speed is omega = sqrt(2 (T0 + A) / (J_F + J)) (textbook 3.48). The extreme speeds
belong to the two tangents from the point (-J_F, -T0) to the energy-mass curve. They are found by renewing the
touching points and the slopes in turn, which doubles the digits at every pass, because at a touching point the speed
is stationary.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.machine.flywheel.curve import EnergyCurve
from tmmcalc.numerics.panels import Values

PASSES = 40
SETTLED = 4e-16  # relative change of the extreme speeds


class Motion(NamedTuple):
    """Steady motions for m constant inertias, arrays (m,); meaningful where ``exists``."""

    fastest: Values  # omega_max [rad/s]
    slowest: Values  # omega_min [rad/s]
    theta_fastest: Values  # [rad]
    theta_slowest: Values  # [rad]
    energy: Values  # T0, kinetic energy at theta = 0 [J]
    exists: NDArray[np.bool_]  # False: the inertia cannot carry the machine through the cycle at this mean speed


def motions(curve: EnergyCurve, constant: Values, speed: float) -> Motion:
    """Exact motions with the ``constant`` inertias (m,) [kg*m^2] whose mean (omega_max + omega_min)/2 is ``speed``."""
    m = len(constant)
    upper = np.repeat((True, False), m)
    fast = slow = np.full(m, speed)
    exists = constant + np.min(curve.inertia) > 0
    for _ in range(PASSES):
        at = curve.touching(np.concatenate((fast, slow)) ** 2 / 2, upper)
        before = fast, slow
        fast, slow, possible = _speeds(at.work, at.inertia + np.tile(constant, 2), speed)
        exists = exists & possible
        fast, slow = np.where(exists, fast, speed), np.where(exists, slow, speed)
        if np.all(np.abs(fast - before[0]) + np.abs(slow - before[1]) <= SETTLED * speed):
            break
    energy = np.where(exists, fast**2 / 2 * (at.inertia[:m] + constant) - at.work[:m], 0.0)
    return Motion(fast, slow, at.theta[:m], at.theta[m:], energy, exists)


def _speeds(work: Values, inertia: Values, speed: float) -> tuple[Values, Values, NDArray[np.bool_]]:
    """Speeds (m,) at two positions each (2 m,) with the given mean, from the energy between them.

    J_a w_a^2 - J_b w_b^2 = 2 (A_a - A_b) and w_a + w_b = 2 w is a quadratic for w_b.
    """
    (work_a, work_b), (inertia_a, inertia_b) = work.reshape(2, -1), inertia.reshape(2, -1)
    usable = (inertia_a > 0) & (inertia_b > 0)
    j_a, j_b = np.where(usable, inertia_a, 1.0), np.where(usable, inertia_b, 1.0)
    c = 2 * (work_a - work_b) / j_a - 4 * speed**2
    root = np.sqrt(np.maximum(16 * speed**2 - 4 * (j_b / j_a - 1) * c, 0.0))
    slow = -2 * c / (4 * speed + root)
    return 2 * speed - slow, slow, usable & (slow > 0)
