"""Error estimate of an unsteady motion: that of the transfer functions, and what rounding of the law does to it.

The law is exact but for rounding: of the coordinate, and of the speed near the ends, a_m t or a_m (T - t), which does
not shrink with the speed. Both are carried to points by the transfer functions.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.timelaw import TimeLaw
from tmmcalc.linkage.lastdigit import LOST
from tmmcalc.linkage.results import ErrorEstimate, LastDigit, Trace

ROUNDINGS = 2.0  # of a sum or a product of three


def with_law(error: ErrorEstimate, law: TimeLaw, start: float, found: Trace, moved: Trace) -> ErrorEstimate:
    """The errors of what moves in time, from those of the transfer functions ``found`` that it moves by."""
    if not law.travel:
        return error
    off_x = ROUNDINGS * EPS * (abs(start) + abs(law.travel))
    off_v = ROUNDINGS * EPS * (law.speed + law.acceleration * law.duration)
    first, second = _largest(found.dr), _largest(found.ddr)
    bend = second * second / first if first else 0.0  # what the third transfer function is like
    v = law.speed
    own = off_x / (max(abs(start), abs(start + law.travel)) or 1.0)
    position = max(own, _relative(first * off_x, moved.r))
    velocity = max(off_v / v, _relative(first * off_v + second * v * off_x, moved.dr))
    acceleration = _relative(
        2 * second * v * off_v + (bend * v * v + second * law.acceleration) * off_x + EPS * law.acceleration * first,
        moved.ddr,
    )
    return ErrorEstimate(
        error.position + position,
        error.velocity + velocity,
        error.acceleration + acceleration,
        error.reference,
        None if error.last_digit is None else _in_time(error.last_digit, law, found, moved),
    )


def _in_time(digit: LastDigit, law: TimeLaw, found: Trace, moved: Trace) -> LastDigit:
    """What the last digit of the data does to motion in time, from what it does to the transfer functions."""
    first, second = digit.velocity * _largest(found.dr), digit.acceleration * _largest(found.ddr)
    off = second * law.speed**2 + first * law.acceleration
    return LastDigit(digit.position, digit.velocity, min(max(digit.acceleration, _relative(off, moved.ddr)), LOST))


def _largest(values: Plane | Real) -> float:
    return float(np.max(np.abs(values), initial=0.0))


def _relative(off: float, values: Plane) -> float:
    return off / (_largest(values) or 1.0)
