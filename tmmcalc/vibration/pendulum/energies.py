"""Mass, gyroscopic and stiffness matrices of the pendulum-rotor from its kinetic and potential energy.

    T = 1/2 int rho (v'^2 + i^2 v_a'^2) da + 1/2 (m v'^2 + J v_a'^2) at the lower end, the same for w
    P = 1/2 int (E I v_aa^2 + N v_a^2) da + 1/2 k v_a(0)^2,   N(a) = g (rho (l - a) + m)
    spin: Omega int rho (i_y^2 + i_z^2) v_a w_a' da + Omega J_p v_a w_a' at the lower end

N stands for the weight: the rod does not stretch, so a slope lifts what hangs below it. With z = v + i w

    M z'' - i Omega G z' + K z = -b (acceleration of the joint)
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.vibration.pendulum.basis import Basis, gauss, sample
from tmmcalc.vibration.pendulum.task import PendulumTask


@record
class Matrices:
    """The matrices of one plane, or of both of an axisymmetric rotor."""

    stiffness: Values  # K (n, n)
    mass: Values  # M
    spin: Values  # G
    load: Values  # b (n,): a uniform acceleration
    tip: Values  # (n,) displacement of the lower end
    slope: Values  # (n,) slope there


def matrices(task: PendulumTask, basis: Basis, plane: int, gravity: float | None = None) -> Matrices:
    """K, M, G of plane 0 (v) or 1 (w) in the functions of the basis; ``gravity`` [m/s^2] in place of the task's."""
    rod, disc, l = task.rod, task.disc, task.rod.length
    g = task.gravity if gravity is None else gravity
    points, weights = gauss(basis)
    at = sample(basis, points)
    ends = sample(basis, np.array([0.0, 1.0]))
    hung, tip, slope = ends.slope[:, 0] / l, ends.value[:, 1], ends.slope[:, 1] / l
    tension = g * (rod.density * l * (1 - points) + disc.mass)
    slopes = _gram(at.slope, weights) / l
    bending = rod.bending[plane] / l**3 * _gram(at.curvature, weights)
    pivot = (task.pivot or 0.0) * np.outer(hung, hung)
    radii = rod.radius[0] ** 2 + rod.radius[1] ** 2
    inertia = np.outer(slope, slope)
    return Matrices(
        stiffness=bending + _gram(at.slope, weights * tension) / l + pivot,
        mass=rod.density * l * _gram(at.value, weights)
        + rod.density * rod.radius[plane] ** 2 * slopes
        + disc.mass * np.outer(tip, tip)
        + disc.diametral[plane] * inertia,
        spin=rod.density * radii * slopes + disc.polar * inertia,
        load=rod.density * l * at.value @ weights + disc.mass * tip,
        tip=tip,
        slope=slope,
    )


def _gram(rows: Values, weights: Values) -> Values:
    found: Values = (rows * weights) @ rows.T
    return (found + found.T) / 2
