"""The speed of a ball whose radius decreases, in closed form while it does not turn back.

With xi = e^(lambda t) and a driving acceleration a the speed is a quotient of Bessel functions of
eta = 2 sqrt(alpha |a| xi/r0)/lambda: of modified ones where a drives the ball on, of J and Y where it brakes it.
"""

from __future__ import annotations

from collections.abc import Callable
from math import expm1, log, log1p, pi, sqrt
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record

Bessel = Callable[[int, Values], Values]  # by order and argument

ROUNDED = 8 * EPS  # of two Bessel functions, each with its factor
LARGE = 1e7  # argument of Bessel functions
NEAR, FAR = 0.05, 3.4  # steps of tau, and reach, within which a cylinder function of order 0 changes its sign


@record
class Fall:
    """A fall that never turns back, from t = 0: v0 >= 0, a driving acceleration, the radius it begins with."""

    radius: float
    drag: float
    decay: float
    drive: float
    orders: tuple[int, int]  # of the Bessel functions above and below
    initial: float

    def argument(self, t: Values) -> Values:
        """eta (n,), or tau of a braked ball."""
        begun = 2 * sqrt(self.drag * abs(self.drive) / self.radius) / self.decay
        return np.asarray(begun * np.exp(self.decay * t / 2))


class _Quotient(NamedTuple):
    """Numerator and denominator of the speed, and the sums of the sizes of their terms, (n,) each."""

    above: Values
    below: Values
    above_terms: Values
    below_terms: Values


def falling_speed(fall: Fall, t: Values) -> Values:
    """v (n,) [m/s] at t (n,) [s]; of a braked ball up to its stop."""
    if fall.drive == 0:
        return np.asarray(fall.initial / (1 + drag_ratio(fall) * np.expm1(fall.decay * t)))
    found = _quotient(fall, t)
    return np.asarray(2 * abs(fall.drive) / fall.decay / fall.argument(t) * found.above / found.below)


def speed_error(fall: Fall, t: Values) -> Values:
    """What rounding leaves of the speed (n,) [m/s]: of the terms of both sums, of J and Y also of their argument."""
    if fall.drive == 0:
        return np.asarray(ROUNDED * falling_speed(fall, t))
    found, eta = _quotient(fall, t), fall.argument(t)
    size = 2 * abs(fall.drive) / fall.decay / eta / np.abs(found.below)
    terms = found.above_terms + np.abs(found.above / found.below) * found.below_terms
    return np.asarray(size * terms * (ROUNDED + (EPS * eta if fall.drive < 0 else 0.0)))


def kinds(fall: Fall) -> tuple[Bessel, Bessel]:
    """Bessel functions of the first and the second kind: J and Y of a braked ball, else I e^-x and K e^x."""
    from scipy.special import jv, yv

    return (_rising, _fading) if fall.drive > 0 else (jv, yv)


def constants(fall: Fall) -> tuple[Values, Values]:
    """C and D (1,), by which the speed begins with v0; of a ball that is not braked over e^-eta0 and e^eta0."""
    first, second = kinds(fall)
    (n, m), begun = fall.orders, fall.argument(np.zeros(1))
    g, u = 2 * abs(fall.drive), fall.decay * fall.initial * begun
    sign = 1 if fall.drive > 0 else -1
    return sign * g * second(n, begun) + u * second(m, begun), g * first(n, begun) - u * first(m, begun)


def parts_of_speed(fall: Fall, t: float, *, scaled: bool) -> tuple[float, float]:
    """X and Z at t [s]: the speed is 2 |a| X/(lambda eta Z); of a ball that is driven on scaled over e^(eta - eta0)."""
    at = np.array([t])
    found = _quotient(fall, at)
    plain = fall.drive < 0 or scaled
    size = 1.0 if plain else float(np.exp(fall.argument(at) - fall.argument(np.zeros(1)))[0])
    return float(found.above[0]) * size, float(found.below[0]) * size


def _quotient(fall: Fall, t: Values) -> _Quotient:
    """The sums of the speed, scaled so that neither overflows."""
    first, second = kinds(fall)
    (n, m), eta = fall.orders, fall.argument(t)
    c, d = constants(fall)
    if fall.drive < 0:
        return _summed(c * first(n, eta), d * second(n, eta), c * first(m, eta), d * second(m, eta))
    faded = d * np.exp(-2 * (eta - fall.argument(np.zeros(1))))
    return _summed(c * first(n, eta), -faded * second(n, eta), c * first(m, eta), faded * second(m, eta))


def _summed(one: Values, two: Values, three: Values, four: Values) -> _Quotient:
    return _Quotient(one + two, three + four, np.abs(one) + np.abs(two), np.abs(three) + np.abs(four))


def _rising(order: int, x: Values) -> Values:
    """I_n(x) e^-x, by its asymptotic series where the library has no more digits."""
    from scipy.special import ive

    return np.where(
        x < LARGE, ive(order, np.minimum(x, LARGE)), (1 - (4 * order**2 - 1) / (8 * x)) / np.sqrt(2 * pi * x)
    )


def _fading(order: int, x: Values) -> Values:
    """K_n(x) e^x, likewise."""
    from scipy.special import kve

    return np.where(
        x < LARGE, kve(order, np.minimum(x, LARGE)), (1 + (4 * order**2 - 1) / (8 * x)) * np.sqrt(pi / (2 * x))
    )


def stop_time(fall: Fall) -> float:
    """The time [s] at which a braked ball stops: the first root of c J0 + Y0 behind tau0 (16)."""
    from scipy.optimize import brentq

    if fall.initial == 0:
        return 0.0
    begun = float(fall.argument(np.zeros(1))[0])
    if begun > LARGE:
        raise AccuracyError(
            f"tau0 = {begun:.4g}: Bessel functions have no digits left there",
            where="falling_ball",
            value=begun,
            limit=LARGE,
            remedy="write a larger decay, or a smaller drag",
        )

    def above(tau: Values) -> Values:
        return _quotient(fall, 2 / fall.decay * np.log(tau / begun)).above

    tau = begun + np.arange(0.0, FAR, NEAR)
    values = above(tau)
    k = int(np.flatnonzero(np.signbit(values[1:]) != np.signbit(values[:-1]))[0])
    root = brentq(lambda x: float(above(np.array([x]))[0]), tau[k], tau[k + 1], xtol=1e-15 * begun, rtol=1e-15)
    return 2 / fall.decay * log(root / begun)


def drag_ratio(fall: Fall) -> float:
    """k = alpha v0/(lambda r0): the drag at the beginning over lambda v0."""
    return fall.drag * fall.initial / (fall.decay * fall.radius)


def drag_way(fall: Fall, t: float) -> float:
    """The way [m] of a ball on which nothing but drag acts, S = r0/(alpha b) ln((1 - b e^(-lambda t))/(1 - b)).

    >>> fall = Fall(1e-3, 1e-4, 2 / 3, 0.0, (0, 1), 6.0)
    >>> round(drag_way(fall, 1.5), 5), round(drag_way(fall, float("inf")), 6)
    (5.87685, 9.482446)
    """
    k = drag_ratio(fall)
    if not k:
        return 0.0
    part, past = k - 1, -expm1(-fall.decay * t)
    size = fall.radius * k / fall.drag
    return size * (log1p(part * past) / part if part else past)
