"""The places of a curve that hold its smallest circle: Newton's method, and how errors of the curve move the centre.

At a contact the curve runs at right angles to the radius. The centre lies amid two contacts or as far from three. The
radius alone tells the centre to the root of rounding only, these equations tell it to rounding. The curve has to be of
a size of about one, for angles and places stand side by side in the equations.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.numerics.fourier import Series
from tmmcalc.core.plane import Real

NEWTON = 6  # steps, from nearly exact places


def stationary(curve: Series, t: Real, center: complex) -> tuple[Real, complex]:
    """Contacts (m,) and centre, exact but for rounding, from nearly exact ones; one contact is left as it is."""
    for _ in range(NEWTON if len(t) > 1 else 0):
        matrix, right = _system(curve, t, center)
        step = np.linalg.lstsq(matrix, -right, rcond=None)[0]
        t, center = t + step[:-2], center + complex(*step[-2:])
        if np.max(np.abs(step)) <= EPS:
            break
    return t, center


def moved(curve: Series, t: Real, center: complex, error: float) -> float:
    """How far an error of the curve, and rounding, may move the centre that contacts (m,) hold."""
    off = error + EPS * float(np.sqrt(1 + curve.highest)) * curve.rms  # a sum of the series has so many roundings
    if len(t) < 2:
        return off
    slope = curve.slope()
    turned = off * slope.rms / curve.rms  # of the slope: errors are spread over the orders as the curve is
    off_angle = np.abs(curve.at(t) - center) * turned + np.abs(slope.at(t)) * off
    inverse = np.linalg.pinv(_system(curve, t, center)[0])
    return float(np.hypot(*(np.abs(inverse[-2:]) @ (*off_angle, off, off)))) + off


def _system(curve: Series, t: Real, center: complex) -> tuple[Real, Real]:
    """Jacobian (m + 2, m + 2) and values (m + 2,) of the equations.

    Radii are at right angles to the curve; the centre lies amid two contacts, or all of three radii are equal.
    """
    slope = curve.slope()
    z, z1, z2 = curve.at(t), slope.at(t), slope.slope().at(t)
    m, d = len(t), z - center
    g = (np.conj(d) * z1).real
    matrix, right = np.zeros((m + 2, m + 2)), np.empty(m + 2)
    matrix[:m, :m] = np.diag(np.abs(z1) ** 2 + (np.conj(d) * z2).real)
    matrix[:m, m:] = np.stack((-z1.real, -z1.imag), axis=1)
    if m == 2:
        matrix[m:, :m] = -np.array((z1.real, z1.imag)) / 2
        matrix[m:, m:] = np.eye(2)
        off = center - z.mean()
        right[:] = *g, off.real, off.imag
    else:
        matrix[m:, 0], matrix[m:, 1:m] = -g[0], np.diag(g[1:])
        matrix[m:, m:] = -np.stack(((d[1:] - d[0]).real, (d[1:] - d[0]).imag), axis=1)
        right[:] = *g, *(np.abs(d[1:]) ** 2 - np.abs(d[0]) ** 2) / 2
    return matrix, right
