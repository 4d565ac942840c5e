"""Instantaneous efficiency, with the load against the motion (12) and with it (13).

    against   eta = (1 - f1 f2 - (f1 + f2) tan|vartheta|)/(1 + f1 cot sigma)
    aiding    eta = (1 - f1 cot sigma)/(1 - f1 f2 + (f1 + f2) tan|vartheta|)

f1 is the friction of the roller on the cam, f2 on its pin; sigma is the acute angle between the normal and the line
from O1 to the roller. Where a formula leaves 0 to 1 (self-locking; sigma near 0 at the ends of the step) it is cut off
there, which is flagged. The forms below are quotients without tangents, which grow without limit.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.cams.laws.law import Values

Flags = NDArray[np.bool_]
Terms = tuple[Values, Values]


def against(angle: Values, sigma: Values, f1: float, f2: float) -> tuple[Values, Flags]:
    """Efficiency (n,) with the load against the motion (12), and where it was cut off.

    >>> against(np.radians([20.0]), np.radians([35.0]), 0.18, 0.2286)[0].round(6).tolist()
    [0.644464]
    """
    return cut(*against_terms(angle, sigma, f1, f2))


def aiding(angle: Values, sigma: Values, f1: float, f2: float) -> tuple[Values, Flags]:
    """Efficiency (n,) with the load along the motion (13), and where it was cut off.

    >>> aiding(np.radians([20.0]), np.radians([35.0]), 0.18, 0.2286)[0].round(6).tolist()
    [0.670778]
    """
    return cut(*aiding_terms(angle, sigma, f1, f2))


def against_terms(angle: Values, sigma: Values, f1: float, f2: float) -> Terms:
    """Numerator and denominator of (12), the latter not negative."""
    cosine, sine, sigma = np.cos(angle), np.abs(np.sin(angle)), _felt(sigma, f1)
    gain = (1 - f1 * f2) * cosine - (f1 + f2) * sine
    return gain * np.sin(sigma), cosine * (np.sin(sigma) + f1 * np.cos(sigma))


def aiding_terms(angle: Values, sigma: Values, f1: float, f2: float) -> Terms:
    """Numerator and denominator of (13), which has no sense where the latter is not positive."""
    cosine, sine, sigma = np.cos(angle), np.abs(np.sin(angle)), _felt(sigma, f1)
    loss = (1 - f1 * f2) * cosine + (f1 + f2) * sine
    return (np.sin(sigma) - f1 * np.cos(sigma)) * cosine, np.sin(sigma) * loss


def _felt(sigma: Values, f1: float) -> Values:
    """sigma, or a right angle where the rollers have no friction on the cam and it does not matter."""
    return sigma if f1 else np.full_like(sigma, np.pi / 2)


def cut(above: Values, below: Values) -> tuple[Values, Flags]:
    """The quotient within 0 to 1, and where it was outside or is undefined."""
    low, high = (above <= 0) | (below <= 0), above > below
    inside: Any = ~(low | high)
    value = np.where(inside, above / np.where(inside, below, 1.0), np.where(low, 0.0, 1.0))
    return value, np.asarray(~inside)
