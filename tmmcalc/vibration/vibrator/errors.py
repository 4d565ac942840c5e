"""What rounding leaves of steady amplitudes: of the equations as they stand by residual, of their coefficients by size.

A residual in extended precision, over the dynamic stiffness, is the error against the matrices as they are; these are
sums of few products, each with some roundings, which the dynamic stiffness passes on likewise.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.extended import EPS, MARGIN
from tmmcalc.core.numerics.panels import Values
from tmmcalc.vibration.vibrator.forced import Steady
from tmmcalc.vibration.vibrator.modes import FORMED, Modes

Complex = NDArray[np.complexfloating[Any, Any]]


class Device(NamedTuple):
    """M, C and B (7, 7), and what makes lengths of the coordinates (7,)."""

    mass: Values
    stiffness: Values
    damping: Values
    ratio: float  # that B is made of; 0: of coefficients
    weight: Values


def amplitude_errors(device: Device, force: Complex, omega: Values, found: Complex) -> Values:
    """Errors of amplitudes (m, 7) at speeds w (m,), of every coordinate (m, 7), under ``force`` w^2 (7,)."""
    w = omega.astype(np.longdouble)[:, None, None]
    dynamic = device.stiffness - w**2 * device.mass + 1j * w * device.damping
    load = w[..., 0] ** 2 * force
    open_ = (load - np.einsum("mij,mj->mi", dynamic, found)).astype(complex)
    inverse = np.linalg.inv(dynamic.astype(complex))
    at = omega[:, None, None]
    sizes = at**2 * np.abs(device.mass) + np.abs(device.stiffness) + at * np.abs(device.damping).astype(float)
    terms = np.einsum("mij,mj->mi", sizes, np.abs(found)) + np.abs(load).astype(float)
    missed = MARGIN * np.abs(np.einsum("mij,mj->mi", inverse, open_))
    missed += FORMED * EPS * np.einsum("mij,mj->mi", np.abs(inverse), terms) + EPS * np.abs(found)
    return missed


def power_error(device: Device, modes: Modes, found: Steady, missed: Values) -> float:
    """Relative error of the power of the dampers, whose amplitudes miss (7,).

    Against w^2/2 x* B x of these amplitudes; with what they miss, and with what rounding of M and C changes of B:
    of 2 zeta S with S M^-1 S = C it is 2 zeta (dC_ij + w_i w_j dM_ij)/(w_i + w_j) in the coordinates of the modes.
    """
    if not found.power:
        return 0.0
    x, w, shapes = found.cosine - 1j * found.sine, modes.frequency, np.abs(modes.shapes)
    held = device.damping @ x
    power = np.longdouble(found.speed) ** 2 / 2 * np.vdot(x, held).real
    rounded = shapes.T @ np.abs(device.stiffness) @ shapes + np.outer(w, w) * (shapes.T @ np.abs(device.mass) @ shapes)
    eta = np.abs(modes.shapes.T @ device.mass @ x)
    changed = 2 * device.ratio * FORMED * EPS * float(eta @ (rounded / np.add.outer(w, w)) @ eta)
    lost = found.speed**2 / 2 * (2 * float(missed @ np.abs(held)) + changed)
    return (MARGIN * float(abs(found.power - power)) + lost) / found.power + 4 * EPS


def relative(device: Device, missed: Values, found: Complex) -> float:
    """The largest error against the largest amplitude, both as lengths."""
    largest = float(np.max(np.abs(found) * device.weight))
    return float(np.max(missed * device.weight)) / largest if largest else 0.0
