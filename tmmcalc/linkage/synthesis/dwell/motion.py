"""Motion of the six-bars at dwell scale: unknowns theta, angle of A -> C, and S of the output, zero at dwell.

Two closures, of bars CB and DE: g1 = (|C - B|^2 - l_CB^2)/2, g2 = (|D - E|^2 - l_DE^2)/2. All formulas broadcast:
linkages (m,) with angles of the crank (m,), or one linkage (1,) with angles (n,). Derivatives are per radian of it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.synthesis.dwell.linkages import Flags, Linkages

LIMIT = 0.1  # of a step of Newton's method [rad, parts of l_OB]
ITERATIONS = 12
LAST = 1e-9  # a step of Newton's method as small as this leaves an error of its square


class Pose(NamedTuple):
    """Places of the pins, and the gradient of the two closures by theta and S."""

    a: Plane
    c: Plane
    d: Plane
    b: Plane
    e: Plane
    slope: tuple[Plane, Plane]  # of B and E by S
    gap: tuple[Real, Real]  # g1, g2
    j11: Real
    j12: Real
    j21: Real
    j22: Real

    @property
    def determinant(self) -> Real:
        """Determinant of the gradient: zero in a singular position."""
        return self.j11 * self.j22 - self.j12 * self.j21

    def solve(self, p: Real, q: Real) -> tuple[Real, Real]:
        """Solution of the 2x2 system with the right side (p, q)."""
        det = self.determinant
        det = np.where(det == 0, np.finfo(float).tiny, det)
        return (p * self.j22 - self.j12 * q) / det, (self.j11 * q - p * self.j21) / det


class Unknowns(NamedTuple):
    """Unknowns with their first and second derivatives by the angle of the crank."""

    theta: Real
    s: Real
    dtheta: Real
    ds: Real
    ddtheta: Real
    dds: Real


def dot(p: Plane, q: Plane) -> Real:
    """Scalar product."""
    return np.asarray(p.real * q.real + p.imag * q.imag)


def pose(linkages: Linkages, phi: Real, theta: Real, s: Real) -> Pose:
    """The linkages at angles of the crank [rad] and unknowns."""
    a = linkages.crank * np.exp(1j * phi)
    w = np.exp(1j * theta)
    ca, da = w * linkages.coupler, w * linkages.d
    c, d = a + ca, a + da
    if linkages.rocks:
        turn = np.exp(1j * s)
        fb, fe = turn * (1 - linkages.output), turn * (linkages.e - linkages.output)
        b, e, slope = linkages.output + fb, linkages.output + fe, (1j * fb, 1j * fe)
    else:
        b, e, slope = 1 + s * linkages.output, linkages.e + s * linkages.output, (linkages.output, linkages.output)
    p, q = c - b, d - e
    gap = (dot(p, p) - linkages.bar**2) / 2, (dot(q, q) - linkages.rod**2) / 2
    return Pose(a, c, d, b, e, slope, gap, dot(p, 1j * ca), -dot(p, slope[0]), dot(q, 1j * da), -dot(q, slope[1]))


def closed(linkages: Linkages, phi: Real, theta: Real, s: Real) -> tuple[Real, Real, Flags]:
    """Unknowns by Newton's method from a guess, and where it converged."""
    for _ in range(ITERATIONS):
        at = pose(linkages, phi, theta, s)
        dtheta, ds = at.solve(*at.gap)
        theta, s = theta - np.clip(dtheta, -LIMIT, LIMIT), s - np.clip(ds, -LIMIT, LIMIT)
        done = (np.abs(dtheta) < LAST) & (np.abs(ds) < LAST)
        if done.all():
            break
    return theta, s, done


def rates(linkages: Linkages, phi: Real, theta: Real, s: Real) -> tuple[Unknowns, Real]:
    """First and second derivatives at a closed place, and the determinant there."""
    at = pose(linkages, phi, theta, s)
    p, q = at.c - at.b, at.d - at.e
    va = 1j * at.a
    dtheta, ds = at.solve(-dot(p, va), -dot(q, va))
    ca, da = at.c - at.a, at.d - at.a
    bend = [1j * slope * ds**2 if linkages.rocks else 0 for slope in at.slope]
    gaps = [va + 1j * arm * dtheta - slope * ds for arm, slope in zip((ca, da), at.slope, strict=True)]
    right = [
        -(dot(gap, gap) + dot(bar, -at.a - arm * dtheta**2 - curve))
        for gap, bar, arm, curve in zip(gaps, (p, q), (ca, da), bend, strict=True)
    ]
    ddtheta, dds = at.solve(right[0], right[1])
    return Unknowns(theta, s, dtheta, ds, ddtheta, dds), at.determinant


def foretold(state: Unknowns, step: Real | float) -> tuple[Real, Real]:
    """Unknowns a step of the crank further, to the second order."""
    theta = state.theta + step * (state.dtheta + step * state.ddtheta / 2)
    return theta, state.s + step * (state.ds + step * state.dds / 2)
