"""Limits of lambda = a/l_k and of the angle of the step, which B alone decides.

beta_0 = pi/z2                            half the pitch: where the rollers stand in the dwell
delta_0 = atan2(sin beta_0, lambda - cos beta_0)
theta_1m = pi/2 - delta_0 - beta_0        (2)   pressure angle at the start of the step
lambda_min = 1 + 2 pi B/(z2 phi_p)        (7)   below it the groove crosses itself
lambda_max = sin(beta_0 + delta_0)/sin delta_0, delta_0 = pi/2 - beta_0 - theta_d          (8), (9)
phi_p,max = pi - 2 delta_0                (10)
phi_p,min = 2 pi B/(z2 (lambda - 1))      (11)
"""

from __future__ import annotations

from math import atan2, cos, pi, sin

from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record

TOLERATED = 1.015  # lambda_min/lambda_max that the author of the method still takes


@record
class Bounds:
    """The limits for one number of rollers, step and law; lambda of the last two is that of the mechanism."""

    ratio_min: float = quantity("lambda_min", "least lambda")
    ratio_max: float | None = quantity(  # None: any, because theta_1m stays below theta_d
        "lambda_max", "largest lambda"
    )
    step_min: float | None = None  # phi_p,min [rad]; None: lambda is not known
    step_max: float | None = None  # phi_p,max [rad], recommended; pi is the hard limit

    @property
    def excess(self) -> float:
        """lambda_min/lambda_max, above 1 where nothing lies between them."""
        return 0.0 if self.ratio_max is None else self.ratio_min / self.ratio_max


def start_angle(rollers: int, ratio: float) -> float:
    """delta_0 [rad]: polar angle at O1 of a roller in the dwell, from the line of centres.

    >>> from math import degrees
    >>> round(degrees(start_angle(6, 2.6)), 5)
    16.08517
    """
    half = pi / rollers
    return atan2(sin(half), ratio - cos(half))


def start_pressure(rollers: int, ratio: float) -> float:
    """theta_1m [rad]: pressure angle at the start of the step (2)."""
    return pi / 2 - start_angle(rollers, ratio) - pi / rollers


def least_ratio(peak: float, rollers: int, step: float) -> float:
    """lambda_min, at which the groove comes to a point (7)."""
    return 1 + 2 * pi * peak / (rollers * step)


def largest_ratio(rollers: int, limit: float) -> float | None:
    """lambda_max, at which theta_1m reaches the limit [rad] (8), (9); None: it never does."""
    half = pi / rollers
    start = pi / 2 - half - limit
    return sin(half + start) / sin(start) if start > 0 else None


def least_step(peak: float, rollers: int, ratio: float) -> float:
    """phi_p,min [rad], at which the groove comes to a point (11)."""
    return 2 * pi * peak / (rollers * (ratio - 1))


def largest_step(rollers: int, ratio: float) -> float:
    """phi_p,max [rad] (10)."""
    return pi - 2 * start_angle(rollers, ratio)


def bounds(peak: float, rollers: int, step: float, limit: float, ratio: float | None = None) -> Bounds:
    """All limits of a law by its B; those of the step at this lambda.

    >>> from math import radians
    >>> found = bounds(1.5, 6, radians(90), radians(50))
    >>> round(found.ratio_min, 6), round(found.ratio_max, 6)
    (2.0, 3.701666)
    """
    least, most = least_ratio(peak, rollers, step), largest_ratio(rollers, limit)
    if ratio is None:
        return Bounds(least, most)
    return Bounds(least, most, least_step(peak, rollers, ratio), largest_step(rollers, ratio))
