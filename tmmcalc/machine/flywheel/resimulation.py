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

from tmmcalc.core.numerics.panels import Values
from tmmcalc.machine.flywheel.curve import EnergyCurve, Touching

PASSES = 40
SETTLED = 4e-16  # change of their difference, relative to the speed


class Motion(NamedTuple):
    """Steady motions for m constant inertias, arrays (m,); meaningful where ``exists``."""

    spread: Values  # omega_max - omega_min [rad/s], with digits of its own
    exists: NDArray[np.bool_]  # False: the inertia cannot carry the machine through the cycle at this mean speed


def motions(curve: EnergyCurve, constant: Values, speed: float) -> Motion:
    """Exact motions with the ``constant`` inertias (m,) [kg*m^2] whose mean (omega_max + omega_min)/2 is ``speed``."""
    m = len(constant)
    upper = np.repeat((True, False), m)
    spread: Values = np.zeros(m)
    exists = constant + np.min(curve.inertia) > 0
    for _ in range(PASSES):
        slopes = np.concatenate((speed + spread / 2, speed - spread / 2)) ** 2 / 2
        at, before = curve.touching(slopes, upper), spread
        spread, possible = _spread(at, constant, speed)
        exists = exists & possible
        spread = np.where(exists, spread, 0.0)
        if np.all(np.abs(spread - before) <= SETTLED * speed):
            break
    return Motion(spread, exists)


def _spread(at: Touching, constant: Values, speed: float) -> tuple[Values, NDArray[np.bool_]]:
    """Difference (m,) of the speeds at two positions each (2 m,) with the given mean, from the energy between them.

    With D = w_a - w_b and w_a + w_b = 2 w the balance J_a w_a^2 - J_b w_b^2 = 2 (A_a - A_b) is the quadratic
    (J_a - J_b) D^2/4 + (J_a + J_b) w D = 2 (A_a - A_b) - (J_a - J_b) w^2, in which a large constant inertia takes no
    digits from the differences.
    """
    (work_a, work_b), (inertia_a, inertia_b) = at.work.reshape(2, -1), at.inertia.reshape(2, -1)
    usable = (inertia_a + constant > 0) & (inertia_b + constant > 0)
    apart, linear = inertia_a - inertia_b, np.where(usable, (inertia_a + inertia_b + 2 * constant) * speed, 1.0)
    gain = 2 * (work_a - work_b) - apart * speed**2
    spread = 2 * gain / (linear + np.sqrt(np.maximum(linear**2 + apart * gain, 0.0)))
    return spread, usable & (spread < 2 * speed)
