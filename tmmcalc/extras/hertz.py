"""Hertz's contact of two elastic bodies whose gap is a paraboloid, in closed form."""

from __future__ import annotations

from math import pi
from typing import NamedTuple

import numpy as np

from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record


@record
class Hertz:
    """The contact of two paraboloids in closed form."""

    along_x: float = quantity("a_x[m]", "half-axis of Hertz's ellipse along x")
    along_y: float = quantity("a_y[m]", "half-axis of Hertz's ellipse along y")
    peak: float = quantity("p0[Pa]", "largest pressure by Hertz", symbol="p_0")
    approach: float = quantity("delta_H[m]", "approach by Hertz")


def composite_modulus(young: tuple[float, float], poisson: tuple[float, float]) -> float:
    """E* [Pa] of two bodies: 1/E* = sum of (1 - nu^2)/E.

    >>> round(composite_modulus((206e9, 206e9), (0.3, 0.3)) / 1e9, 3)
    113.187
    """
    return 1 / sum((1 - nu**2) / e for e, nu in zip(young, poisson, strict=True))


def hertz(load: float, modulus: float, radii: tuple[float, float]) -> Hertz:
    """The elliptical contact of the gap x^2/(2 Rx) + y^2/(2 Ry); K. L. Johnson, Contact Mechanics, (4.26)-(4.28).

    With k = b/a the ratio of curvatures is R_D(0, 1, k^2)/R_D(0, k^2, 1); Carlson's forms lose no digit at k = 1.

    >>> found = hertz(1.0, 1.0, (1.0, 1.0))
    >>> round(found.along_x, 5), round(found.peak * found.along_x**2, 6), round(found.approach / found.along_x**2, 12)
    (0.90856, 0.477465, 1.0)
    """
    from scipy.optimize import brentq
    from scipy.special import elliprd, elliprf

    large, small = max(radii), min(radii)

    def excess(log_ratio: float) -> float:
        k2 = np.exp(2 * log_ratio)
        return float(np.log(elliprd(0.0, 1.0, k2) / elliprd(0.0, k2, 1.0) * small / large))

    ratio = float(np.exp(brentq(excess, -2 * np.log(large / small) - 1, 0.0, xtol=1e-15))) if large > small else 1.0
    major = float(load * large * elliprd(0.0, ratio**2, 1.0) / (pi * modulus)) ** (1 / 3)
    minor = ratio * major
    peak = 1.5 * load / (pi * major * minor)
    axes = (major, minor) if radii[0] >= radii[1] else (minor, major)
    return Hertz(*axes, peak, float(peak * minor * elliprf(0.0, ratio**2, 1.0) / modulus))


class Integrals(NamedTuple):
    """What the formulas of an elliptical contact hold beside its half-axes."""

    eccentricity: float  # e = sqrt(1 - b^2/a^2)
    first: float  # K(e), complete elliptic integral
    second: float  # E(e)


def integrals(found: Hertz) -> Integrals:
    """The eccentricity of a contact ellipse and its complete elliptic integrals.

    >>> integrals(Hertz(2.0, 1.0, 1.0, 1.0))
    Integrals(eccentricity=0.8660254037844386, first=2.156515647499643, second=1.2110560275684594)
    """
    from scipy.special import ellipe, ellipkm1

    ratio = min(found.along_x, found.along_y) / max(found.along_x, found.along_y)
    square = (1 - ratio) * (1 + ratio)
    return Integrals(square**0.5, float(ellipkm1(ratio**2)), float(ellipe(square)))
