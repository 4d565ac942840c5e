"""Torsion of the rod, held by the drive at its upper end: b tan b = rho l (i_y^2 + i_z^2)/J_p, w = b/l sqrt(G I_p/...).

G I_p th_aa = rho (i_y^2 + i_z^2) th'',   th(0) = 0,   G I_p th_a(l) = -J_p th''(l)
"""

from __future__ import annotations

from math import pi, sqrt

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.vibration.pendulum.task import PendulumTask


def torsion_frequencies(task: PendulumTask, count: int) -> Values:
    """The lowest natural frequencies [rad/s] of torsion; of a rod without inertia the one of the disc; maybe none."""
    rod, polar, section = task.rod, task.disc.polar, section_inertia(task)
    if rod.torsion is None or (section == 0 and polar == 0):
        return np.empty(0)
    if section == 0:
        return np.array([sqrt(rod.torsion / (rod.length * polar))])
    return torsion_roots(task, count) * sqrt(rod.torsion / section) / rod.length


def section_inertia(task: PendulumTask) -> float:
    """Polar moment of inertia of a metre of the rod [kg*m]."""
    rod = task.rod
    return rod.density * (rod.radius[0] ** 2 + rod.radius[1] ** 2)


def torsion_roots(task: PendulumTask, count: int) -> Values:
    """The lowest roots b (count,) of the frequency equation, of a rod that has inertia."""
    ends = pi * np.arange(count)
    if task.disc.polar == 0:
        return ends + pi / 2
    ratio = section_inertia(task) * task.rod.length / task.disc.polar

    def open_(b: Values, _: np.ndarray) -> Values:
        found: Values = b * np.sin(b) - ratio * np.cos(b)
        return found

    return bracketed(open_, ends, ends + pi / 2)
