"""Stiffnesses of the device from its rods and flat springs.

Rod, clamped at both ends:      c = 12 E I/l_c^3, I = pi d^4/64
Flat spring, clamped at both ends, whose inner end stands l2 from the axis about which the gripper tilts: it is pushed
by l2 theta and turned by -theta, the other pair is twisted:

    c1 = 12 E I/l1^3, I = b h^3/12,   c_t = 2 a l2 + 2 d + 2 d1 + m2 g l
    a = 12 E I (l1/2 + l2)/l1^3,   d = E I (4 l1 + 6 l2)/l1^2,   d1 = G J_t/l1,   J_t = alpha_t b h^3
"""

from __future__ import annotations

from math import pi

import numpy as np

from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.vibration.vibrator.task import Flats, Gripper, Rods, VibratorTask

TERMS = 8  # of the series of the section's torsion; the next is below rounding even in a square
ODD_FIFTHS = 1.0045237627951396  # 1 + 1/3^5 + 1/5^5 + ... = 31/32 zeta(5)


@record
class Stiffness:
    """Stiffnesses of the springs, and of the coordinates as their potential energy has them."""

    rod: float = quantity("c_rod[N/m]", "stiffness across one rod", symbol="c")
    vertical: float = quantity("c1[N/m]", "vertical stiffness of one flat spring", symbol="c_1")
    tilt: float = quantity("ct[N*m/rad]", "stiffness of the flat springs against a tilt", symbol="c_t")
    # parts of the stiffness against a tilt; None: it is given
    push: float | None = quantity("a[N/rad]", "force of a bent spring over the tilt")
    bend: float | None = quantity("d[N*m/rad]", "moment at a bent spring's inner end over the tilt")
    twist: float | None = quantity("d1[N*m/rad]", "moment of a twisted spring over the tilt", symbol="d_1")
    weight: float | None = quantity("m2gl[N*m/rad]", "moment of the weight over the tilt", symbol="m_2 g l")
    plate: float = quantity("c2[N*m/rad]", "stiffness of the plate about the exciter's hinge", symbol="c_2")


def stiffness_of(task: VibratorTask) -> Stiffness:
    """All stiffnesses, given or from the sizes of rods and springs."""
    parts = tilt_parts(task.flats, task.gripper, task.gravity) if task.flats.tilt is None else None
    push, bend, twist, weight = parts or (None, None, None, None)
    if parts is None:
        tilt = task.flats.tilt or 0.0
    else:
        tilt = 2 * parts[0] * task.flats.offset + 2 * parts[1] + 2 * parts[2] + parts[3]
    return Stiffness(rod(task.rods), vertical(task.flats), tilt, push, bend, twist, weight, task.plate)


def rod(rods: Rods) -> float:
    """Stiffness c [N/m] of a rod across itself.

    >>> round(rod(Rods(0.07, diameter=0.003, length=0.08)), 5)
    19197.00257
    """
    if rods.stiffness is not None:
        return rods.stiffness
    return 12 * rods.young * pi * rods.diameter**4 / 64 / rods.length**3


def vertical(flats: Flats) -> float:
    """Stiffness c1 [N/m] of a flat spring across itself."""
    if flats.vertical is not None:
        return flats.vertical
    return float(12 * flats.young * flats.width * flats.thickness**3 / 12 / flats.length**3)


def tilt_parts(flats: Flats, gripper: Gripper, gravity: float) -> tuple[float, float, float, float]:
    """a [N/rad], d, d1 and m2 g l [N*m/rad]: what the flat springs and the weight do against a tilt."""
    bending = flats.young * flats.width * flats.thickness**3 / 12
    outer, inner = flats.length, flats.offset
    push = 12 * bending * (outer / 2 + inner) / outer**3
    bend = bending * (4 * outer + 6 * inner) / outer**2
    alpha = torsion_coefficient(flats.width, flats.thickness) if flats.torsion is None else flats.torsion
    twist = flats.shear * alpha * flats.width * flats.thickness**3 / outer
    return push, bend, twist, gripper.mass * gravity * gripper.drop


def torsion_coefficient(width: float, thickness: float) -> float:
    """alpha_t in J_t = alpha_t b h^3 of a rectangle b x h (Saint-Venant's series), whichever side is longer.

    >>> round(torsion_coefficient(0.01, 0.01), 6), round(torsion_coefficient(0.1, 0.001), 6)
    (0.140577, 0.331233)
    """
    long, short = max(width, thickness), min(width, thickness)
    n = 2.0 * np.arange(TERMS) + 1
    decay = np.exp(-n * pi * long / short)  # tanh x = 1 - 2 e^-2x/(1 + e^-2x): the ones are summed in closed form
    series = ODD_FIFTHS - float(np.sum(2 * decay / (1 + decay) / n**5))
    found = (1 - 192 / pi**5 * short / long * series) / 3
    return found * (short / thickness) ** 3 * (long / width)
