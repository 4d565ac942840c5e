"""Natural frequencies and modes of the device, and everything in the coordinates of its modes.

With q = F eta, F' M F = 1, F' C F = w^2, the equations are eta'' + B eta' + w^2 eta = F' P.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.vibration.pencil import definite_pencil, scaled_factor
from tmmcalc.vibration.vibrator.energies import COUNT
from tmmcalc.vibration.vibrator.task import Damping

FORMED = 2.0  # roundings of a coefficient, beside those that cancel out
NOISE = 1e-12  # of the largest displacement of a mode: less is none


@record
class Modes:
    """The linear device in the coordinates of its modes."""

    frequency: Values  # w (7,) ascending [rad/s]
    shapes: Values  # F (7, 7), a mode in each column, F' M F = 1
    damping: Values  # F' B F (7, 7) [1/s]
    weight: Values  # (7,) what makes lengths of the coordinates: 1, of turns the rods' radius [m]
    error: float  # bound of the relative error of the frequencies


def modes_of(mass: Values, stiffness: Values, damping: Damping, arm: float) -> Modes:
    """Natural frequencies, modes and damping of M, C (7, 7); ``arm`` [m] is what turns are compared by.

    Raises `NoSolutionError` if M or C is not positive definite, `UsageError` for a negative damping.
    """
    scaled_factor(stiffness, "stiffness matrix of the device")
    pencil = definite_pencil(stiffness, mass, "mass matrix of the device")
    frequency = np.sqrt(pencil.mu)
    if damping.direct:
        shape: Values = pencil.y.T @ np.diag(damping.direct) @ pencil.y
    else:
        shape = np.diag(2 * damping.ratio * frequency)
    least = min((damping.ratio, *damping.direct))
    if least < 0:
        raise UsageError(
            f"a damping of {least:.6g} gives energy to the device",
            where="vibrator",
            value=least,
            limit=0.0,
            remedy="write a damping of at least 0",
        )
    weight = np.array([1.0, 1.0, arm, arm, arm, 1.0, arm])
    shapes = np.abs(pencil.y)
    strained, moved = (np.sum(shapes * (np.abs(part) @ shapes), axis=0) for part in (stiffness, mass))
    terms = strained / pencil.mu + moved
    error = pencil.error / pencil.mu + FORMED * EPS * terms
    return Modes(frequency, pencil.y, shape, weight, float(np.max(error)) / 2 + EPS)


def damping_matrix(modes: Modes, mass: Values, stiffness: Values, damping: Damping) -> Values:
    """B (7, 7) in the coordinates of the device [N*s/m] and [N*m*s/rad], in extended precision.

    The coefficients given, or 2 zeta S with S M^-1 S = C, which is M F w F' M of the modes but for their rounding. One
    step of Newton takes that out, in the coordinates of the modes (w_i + w_j) dS_ij = (F' (C - S M^-1 S) F)_ij.
    """
    if damping.direct:
        given: Values = np.diag(np.array(damping.direct, np.longdouble))
        return given
    shapes, w = modes.shapes.astype(np.longdouble), modes.frequency.astype(np.longdouble)
    back = mass @ shapes
    open_ = shapes.T @ (stiffness - back * w @ (shapes.T @ back) * w @ back.T) @ shapes
    root: Values = back @ (np.diag(w) + open_ / (w[:, None] + w)) @ back.T
    return damping.ratio * (root + root.T)


def shown_shapes(modes: Modes) -> Values:
    """Modes (7, 7) with their largest displacement 1; turns count by the arm that carries them."""
    sizes = np.abs(modes.shapes * modes.weight[:, None])
    at, columns = np.argmax(sizes, axis=0), np.arange(COUNT)
    found: Values = modes.shapes / (np.sign(modes.shapes[at, columns]) * sizes[at, columns])
    return np.where(sizes > NOISE * sizes[at, columns], found, 0.0)
