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
    rod, polar = task.rod, task.disc.polar
    section = rod.density * (rod.radius[0] ** 2 + rod.radius[1] ** 2)
    if rod.torsion is None or (section == 0 and polar == 0):
        return np.empty(0)
    if section == 0:
        return np.array([sqrt(rod.torsion / (rod.length * polar))])
    speed = sqrt(rod.torsion / section)
    ends = pi * np.arange(count)
    if polar == 0:
        return (ends + pi / 2) * speed / rod.length
    ratio = section * rod.length / polar

    def open_(b: Values, _: np.ndarray) -> Values:
        found: Values = b * np.sin(b) - ratio * np.cos(b)
        return found

    return bracketed(open_, ends, ends + pi / 2) * speed / rod.length
