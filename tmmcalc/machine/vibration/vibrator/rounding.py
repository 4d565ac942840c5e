"""What rounding leaves of steady amplitudes: of the equations as they stand by residual, of their coefficients by size.

A residual in extended precision, over the dynamic stiffness, is the error against the matrices as they are; these are
sums of few products, each with some roundings, which the dynamic stiffness passes on likewise.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.machine.vibration.vibrator.modes import FORMED
from tmmcalc.numerics.extended import EPS, MARGIN
from tmmcalc.numerics.panels import Values

Complex = NDArray[np.complexfloating[Any, Any]]


class Device(NamedTuple):
    """M, C and B (7, 7), the excitation over w^2 (7,), and what makes lengths of the coordinates (7,)."""

    mass: Values
    stiffness: Values
    damping: Values
    force: Complex
    weight: Values


def amplitude_errors(device: Device, omega: Values, found: Complex) -> tuple[Values, Values]:
    """Errors of amplitudes (m, 7) at speeds (m,): of every coordinate (m, 7), and relative of the power (m,)."""
    w = omega.astype(np.longdouble)[:, None, None]
    dynamic = device.stiffness - w**2 * device.mass + 1j * w * device.damping
    load = w[..., 0] ** 2 * device.force
    open_ = (load - np.einsum("mij,mj->mi", dynamic, found)).astype(complex)
    inverse = np.linalg.inv(dynamic.astype(complex))
    at = omega[:, None, None]
    sizes = at**2 * np.abs(device.mass) + np.abs(device.stiffness) + at * np.abs(device.damping)
    terms = np.einsum("mij,mj->mi", sizes, np.abs(found)) + np.abs(load).astype(float)
    missed = MARGIN * np.abs(np.einsum("mij,mj->mi", inverse, open_))
    missed += FORMED * EPS * np.einsum("mij,mj->mi", np.abs(inverse), terms) + EPS * np.abs(found)
    held = found @ device.damping.T
    power = np.sum((found.conj() * held).real, axis=1)
    lost = 2 * np.sum(missed * np.abs(held), axis=1)
    return missed, np.divide(lost, power, out=np.zeros_like(power), where=power > 0) + 4 * EPS


def relative(device: Device, missed: Values, found: Complex) -> float:
    """The largest error against the largest amplitude, both as lengths."""
    largest = float(np.max(np.abs(found) * device.weight))
    return float(np.max(missed * device.weight)) / largest if largest else 0.0
