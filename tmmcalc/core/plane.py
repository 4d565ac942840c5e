"""Plane vectors as complex numbers, and the states that links hand to each other.

A vector (x, y) is x + iy; turning it by +90 degrees is multiplication by i. All states hold a value and
its first and second derivative with respect to one common variable: the input coordinate (transfer
functions) or time - the formulas are the same. Arrays have the shape (n,), one entry a position;
constants of the frame are 0-d arrays and broadcast.
"""

from __future__ import annotations

from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

# double precision, or extended where the rounding error is measured
Real = NDArray[np.floating[Any]]
Plane = NDArray[np.complexfloating[Any, Any]]
PLANE = {np.dtype(real): np.dtype(plane) for real, plane in ((float, complex), (np.longdouble, np.clongdouble))}


class Parts(NamedTuple):
    """A plane vector of which only the two parts are asked for; each real (n,)."""

    real: Real | float
    imag: Real


def cross(a: Plane | Parts | complex, b: Plane | Parts | complex) -> Real:
    """Scalar cross product a x b = a_x b_y - a_y b_x."""
    return a.real * b.imag - a.imag * b.real  # type: ignore[return-value]  # scalars count as 0-d arrays


def square(a: Plane) -> Real:
    """Squared length |a|^2, without the root and the overflow guard of ``abs``."""
    return a.real * a.real + a.imag * a.imag


def vector(x: Real | float, y: Real) -> Plane:
    """The vectors x + iy (n,), put together without a product; of the shape of y, to which x is broadcast."""
    found: Plane = np.empty(y.shape, PLANE[y.dtype])
    found.real = x
    found.imag = y
    return found


class Point(NamedTuple):
    """A moving point: position, first and second derivative; each complex (n,) [m, m/.., m/..^2]."""

    r: Plane
    v: Plane
    a: Plane


class Guide(NamedTuple):
    """A line fixed in a moving link: the state of a point on it, its unit direction, its rotation.

    ``r, v, a, e`` complex (n,); ``omega, eps`` real (n,): first and second derivative of the angle of e.
    """

    r: Plane
    v: Plane
    a: Plane
    e: Plane
    omega: Real
    eps: Real

    @classmethod
    def along(cls, point: Point, gamma: float | Real, omega: float | Real = 0.0, eps: float | Real = 0.0) -> Guide:
        """The line through a moving point at the angle gamma [rad] that turns with omega and eps."""
        return cls(*point, np.exp(1j * np.asarray(gamma)), np.asarray(omega), np.asarray(eps))

    @property
    def turns(self) -> bool:
        """Whether its direction turns; else it stands, or slides."""
        return bool(self.omega.ndim or self.omega or self.eps)

    def transport(self, offset: Plane) -> tuple[Plane, Plane]:
        """First and second derivative of the point that the guide carries along at ``offset`` [m] from its own."""
        if not self.turns:
            return self.v, self.a
        return self.v + 1j * self.omega * offset, self.a + (1j * self.eps - self.omega**2) * offset


class LinkMotion(NamedTuple):
    """The motion of a rigid link: that of its base point, and of the unit vector u along its own x axis.

    ``base`` is the base point in the link's axes [m]; ``u1 = i omega u`` and ``u2 = (i eps - omega^2) u``
    are the derivatives of u, so that a point p of the link moves with ``v + u1 (p - base)``.
    """

    base: complex
    r: Plane
    v: Plane
    a: Plane
    u: Plane
    u1: Plane
    u2: Plane
    omega: Real
    eps: Real

    def point(self, p: complex) -> Point:
        """State of the point p [m] given in the link's own axes (textbook (2.22), (2.58), (2.59))."""
        d = p - self.base
        if d == 0:
            return Point(self.r, self.v, self.a)
        if not (self.v.ndim or self.v or self.a):  # it turns about a pin of the frame
            return Point(self.r + d * self.u, d * self.u1, d * self.u2)
        return Point(self.r + d * self.u, self.v + d * self.u1, self.a + d * self.u2)

    def guide(self, p: complex, direction: complex) -> Guide:
        """State of the line through p [m] along ``direction`` (unit), both in the link's own axes."""
        e = self.u if direction == 1 else self.u * direction
        return Guide(*self.point(p), e, self.omega, self.eps)


def rotated(base: complex, at: Point, u: Plane, omega: Real, eps: Real) -> LinkMotion:
    """Motion of a link whose base point moves as ``at`` and whose x axis is u, turning with omega, eps."""
    return LinkMotion(base, *at, u, vector(0, omega) * u, vector(-omega * omega, eps) * u, omega, eps)


@cache
def frame() -> LinkMotion:
    """Motion of the frame: rest."""
    zero, one, still = np.zeros((), np.complex128), np.ones((), np.complex128), np.zeros(())
    for constant in (zero, one, still):
        constant.flags.writeable = False
    return LinkMotion(0j, zero, zero, zero, one, zero, zero, still, still)
