r"""Many six-bars of class IV at once: three-position synthesis in closed form, and the checks that need no motion.

                  C ------3------ B          movable: 1 crank OA, 2 coupler ACD, 3 bar CB, 4 bar DE,
                /   \            /           5 output with B and E: a slider along u, or a rocker about F
              2      \         5
            /    D ---4--- E -/              While 5 stands, OACB is a four-bar and D a point of its coupler: E is the
          A                                  centre of the circle through three places of D, so that 5 stands at the
        1/                                   same place three times and hardly moves between.
        O

Lengths are parts of l_OB: O = 0 and B = 1 at dwell. Arrays have the shape (m,), one entry a candidate. The theory is
that of O. I. Zinchenko, Bulletin of NTU KhPI 42 (2008), with its misprints mended.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Real, cross
from tmmcalc.linkage.synthesis.dwell.task import Lengths

COLLINEAR = 1e-9  # sine of the angle at the first of three points below which they lie on a line
Flags = np.ndarray


class Parameters(NamedTuple):
    """Parameters (m,) of the three-position synthesis: angles in rad, lengths in parts of l_OB."""

    phi12: Real
    phi13: Real
    psi0: Real
    psi12: Real
    psi13: Real
    bar: Real  # l_CB
    side: Real  # l_CD
    alpha: Real


class Linkages(NamedTuple):
    """Six-bars by their sizes and their place in position 1, each (m,)."""

    phi0: Real  # angle of the crank in position 1 [rad]
    crank: Real  # l_OA
    coupler: Real  # l_AC
    d: Plane  # D in the axes of the coupler: origin A, x along A -> C
    bar: Real  # l_CB
    rod: Real  # l_DE
    e: Plane  # E at dwell
    theta0: Real  # angle of A -> C in position 1 [rad]
    turns: Real  # (3, m) of the crank from position 1 to 1, 2 and 3 [rad]
    rocks: bool
    output: Plane  # direction u of the slider, or the pivot F of the rocker; 0 until it is chosen

    def rows(self, which: Flags) -> Linkages:
        """The linkages with these indices or flags."""
        parts = {name: part[..., which] for name, part in self._asdict().items() if name != "rocks"}
        return Linkages(rocks=self.rocks, **parts)


class Drawn(NamedTuple):
    """Linkages of a three-position synthesis, the places (3, m) of their pins, and what speaks against each."""

    linkages: Linkages
    a: Plane
    c: Plane
    dd: Plane  # D
    faults: dict[str, Flags]  # by reason


def circumcentre(p: Plane) -> tuple[Plane, Flags]:
    """Centre (m,) of the circle through three points (3, m), and whether they do not lie on a line.

    >>> centre, round_ = circumcentre(np.array([[1 + 0j], [1j], [-1 + 0j]]))
    >>> float(abs(centre[0]).round(9)), bool(round_[0])
    (0.0, True)
    """
    b, c = p[1] - p[0], p[2] - p[0]
    area = cross(b, c)
    lengths = np.abs(b) * np.abs(c)
    round_ = np.abs(area) > COLLINEAR * lengths
    twice = np.where(round_, 2 * area, 1.0)
    offset = 1j * (np.abs(c) ** 2 * b - np.abs(b) ** 2 * c) / twice
    return p[0] + np.where(round_, offset, 0), round_


def from_positions(given: Parameters) -> Drawn:
    """The linkages of which bar BC and crank stand in three given positions (m,); the output is not yet chosen."""
    turns = np.array([np.zeros_like(given.phi12), given.phi12, given.phi13])
    bars = np.array([np.zeros_like(given.psi12), given.psi12, given.psi13])
    c = 1 + given.bar * np.exp(1j * (given.psi0 + bars))
    a1, turned = circumcentre(np.exp(-1j * turns) * c)
    a = np.exp(1j * turns) * a1
    coupler = np.abs(c[0] - a1)
    linkages, dd, round_ = _closed(a, c, coupler, given.side, given.alpha, given.bar, turns)
    turned &= (coupler > COLLINEAR) & (np.abs(a1) > COLLINEAR)
    return Drawn(linkages, a, c, dd, _faults(linkages, a, c, dd, turned, round_))


def from_lengths(given: Lengths, dwell: float) -> Drawn:
    """The linkage of given lengths whose crank turns through ``dwell`` from phi0 on; NaN where OACB does not close."""
    turns = np.array([[0.0], [given.phi12], [dwell]])
    a = given.crank * np.exp(1j * (given.phi0 + turns))
    q = 1 - a
    along = (given.coupler**2 - given.bar**2 + np.abs(q) ** 2) / (2 * np.abs(q))
    with np.errstate(invalid="ignore"):
        across = np.sqrt(given.coupler**2 - along**2) * (1 if given.left else -1)
    c = a + q / np.abs(q) * (along + 1j * across)
    one = np.ones(1)
    linkages, dd, round_ = _closed(
        a, c, given.coupler * one, given.side * one, given.alpha * one, given.bar * one, turns
    )
    return Drawn(linkages, a, c, dd, _faults(linkages, a, c, dd, np.isfinite(c).all(axis=0), round_))


def _closed(
    a: Plane, c: Plane, coupler: Real, side: Real, alpha: Real, bar: Real, turns: Real
) -> tuple[Linkages, Plane, Flags]:
    """The linkages by the places (3, m) of A and C, the places of D, and whether they have a circle."""
    long = np.maximum(coupler, COLLINEAR)
    dd = c + side * np.exp(1j * alpha) * (a - c) / long
    e, round_ = circumcentre(dd)
    none = np.zeros_like(e)
    local = coupler - side * np.exp(1j * alpha)
    theta0, phi0 = np.angle(c[0] - a[0]), np.angle(a[0])
    rod = np.abs(dd[0] - e)
    return Linkages(phi0, np.abs(a[0]), coupler, local, bar, rod, e, theta0, turns, False, none), dd, round_


def _faults(linkages: Linkages, a: Plane, c: Plane, dd: Plane, turned: Flags, round_: Flags) -> dict[str, Flags]:
    """What speaks against each linkage (m,) before it moves: a linkage counts under the first reason that it meets."""
    first, second = np.sign(cross(c - a, 1 - a)), np.sign(cross(dd - c, linkages.e - c))
    faults = {
        "no circle through the three places of C": ~turned,
        "no circle through the three places of D": ~round_,
        "positions on different assemblies of O-A-C-B": ~np.all(first == first[:1], axis=0),
        "positions on different assemblies of C-D-E": ~np.all(second == second[:1], axis=0),
    }
    return only_first(faults)


def only_first(faults: dict[str, Flags]) -> dict[str, Flags]:
    """Every candidate under the first of its reasons alone."""
    seen = np.zeros(next(iter(faults.values())).shape, bool)
    found = {}
    for reason, flags in faults.items():
        found[reason] = flags & ~seen
        seen = seen | flags
    return found


def sliding(linkages: Linkages, n: Real, dwell: float, reverse: bool) -> Linkages:
    """With a slider that moves along the crank at the part n of the dwell; ``reverse`` (k = 1) turns S about."""
    u = np.exp(1j * (linkages.phi0 + n * dwell)) * (-1 if reverse else 1)
    return linkages._replace(rocks=False, output=u)


def rocking(linkages: Linkages, pivot: Plane) -> Linkages:
    """With a rocker about F (m,)."""
    return linkages._replace(rocks=True, output=np.broadcast_to(pivot, linkages.e.shape).astype(complex))


def pivot_of(linkages: Linkages, n: Real, dwell: float, swing: float, left: Flags) -> Plane:
    """F (m,) for a swing [rad] by l_OF = l_OA/sin(swing/2), across the crank at the part n of the dwell."""
    side = np.where(left, 1j, -1j)
    return side * linkages.crank / np.sin(swing / 2) * np.exp(1j * (linkages.phi0 + n * dwell))
