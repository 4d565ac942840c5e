"""Forces of a six-bar with massless links against a resistance of its output, positive where S would grow: -F u, or -M.

Bars 3 and 4 are two-force links, so the force of the crank on the coupler goes through A and the intersection of CB
and DE. That intersection may lie at infinity: the forces follow from two equations of equilibrium instead, which are
singular only where the linkage is.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Real, cross
from tmmcalc.linkage.synthesis.dwell.linkages import Linkages
from tmmcalc.linkage.synthesis.dwell.motion import dot, pose


class UnitForces(NamedTuple):
    """Forces for a resistance of 1 N, or 1 N*m of a rocker with lengths in parts of l_OB."""

    f3: Real  # compressive, in bar CB
    f4: Real  # compressive, in bar DE
    r12: Plane  # of the crank on the coupler
    normal: Real  # of the guide on the slider, along the left normal of u; 0 of a rocker
    couple: Real  # of the guide on the slider about B; 0 of a rocker
    delta: Real  # pressure angle [rad]: of R12 against u, or against the normal to AF
    moment: Real  # driving moment on the crank
    arms: tuple[Real, Real]  # h of the bars about A: of unit forces from link 5 to the coupler
    pulls: tuple[Real, Real]  # c of the same: along u, or their arms about F

    @property
    def r21(self) -> Real:
        """Size of the force between crank and coupler."""
        return np.abs(self.r12)


def unit_forces(linkages: Linkages, phi: Real, theta: Real, s: Real) -> UnitForces:
    """Forces at angles of the crank [rad] and closed unknowns."""
    at = pose(linkages, phi, theta, s)
    e3, e4 = (at.c - at.b) / linkages.bar, (at.d - at.e) / linkages.rod
    turn3, turn4 = cross(at.c - at.a, e3), cross(at.d - at.a, e4)
    if linkages.rocks:
        f = linkages.output
        load3, load4 = cross(at.b - f, e3), cross(at.e - f, e4)
    else:
        load3, load4 = dot(e3, linkages.output), dot(e4, linkages.output)
    across: Plane
    normal: Real
    couple: Real
    det = turn4 * load3 - turn3 * load4
    det = np.asarray(np.where(det == 0, np.finfo(float).tiny, det))
    f3, f4 = -turn4 / det, turn3 / det
    r12 = -(f3 * e3 + f4 * e4)
    if linkages.rocks:
        across = 1j * (at.a - linkages.output)
        normal, couple = 0 * f3, 0 * f3
    else:
        across = linkages.output
        normal, couple = -dot(r12, 1j * across), f4 * cross(at.e - at.b, e4)
    delta = np.arctan2(dot(r12, 1j * across), dot(r12, across))
    return UnitForces(f3, f4, r12, normal, couple, delta, cross(at.a, r12), (turn3, turn4), (load3, load4))
