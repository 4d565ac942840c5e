"""The time scales of a motion: what an explicit method has to follow for the sake of stability alone.

A part of the solution goes as exp(lambda t) with an eigenvalue lambda of the linearised equations; 1/|lambda| is its
time constant. Where the fastest is far below the duration, fixed steps have to be as short all the time, long after
that part has died away: the equations are stiff.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record


@record
class TimeScales:
    """Time constants over a duration; those longer than it count as the duration."""

    fastest: float = quantity("fastest[s]", "shortest time constant 1/|lambda|")
    slowest: float = quantity("slowest[s]", "longest time constant 1/|lambda|")
    duration: float = quantity("duration[s]", "duration of the motion")
    stable_step: float = quantity(
        "stable_step[s]", "longest fixed step of Kutta-Merson that stays bounded, the duration at most"
    )
    steps: float = quantity("explicit_steps", "explicit steps that stability alone asks for")

    @derived("ratio", "slowest over fastest time constant")
    def ratio(self) -> float:
        """How stiff the equations are."""
        return self.slowest / self.fastest


def time_scales(values: Values, duration: float) -> TimeScales | None:
    """Time scales of the eigenvalues (m,) [1/s]; None if nothing changes within the ``duration`` [s].

    >>> time_scales(np.array([-1e4, -2.0]), 5.0).ratio
    5000.0
    """
    size = np.abs(values)
    told = size[size * duration >= 1]
    if not len(told):
        return None
    from tmmcalc.machine.transient.stability import stable_step  # a stored result is loaded without it

    step = min(stable_step("merson", values, duration), duration)
    return TimeScales(1 / float(told.max()), 1 / float(told.min()), duration, step, duration / step)
