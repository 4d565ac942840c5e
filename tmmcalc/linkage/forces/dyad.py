"""Reactions of one dyad from the wrenches on its two links: a 2x2 system for every kind.

          A (outer)        B (inner)        C (outer)
    source --o------ a ------o------ b ------o-- source

The unknown is what b does to a in the inner joint B: a force (revolute), or a normal force and a couple (prismatic).
Each outer joint cannot take one thing: a revolute pair no moment about its pin, a prismatic pair no force along
its line - except friction, which is given. That is one equation a link:

    revolute  A:  (r_A - r_B) x F - M = known        prismatic A:  e_A . F = known

Textbook (3.3)-(3.13), (3.18)-(3.26). Friction values are what the joint does to the link named first: of A and B on
link a, of C on link b; along the line [N] or about the pin [N*m].
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import SingularityError
from tmmcalc.core.plane import Plane, Real, cross
from tmmcalc.linkage.forces.wrench import NOTHING, Pivot, Seat, Slideway, Wrench

SINGULAR = 1e-9  # determinant, against the product of the arms, at which a dyad transmits no force


class Reactions(NamedTuple):
    """Wrenches about each joint's own point: A and B on link a, C on link b."""

    outer_a: Wrench
    inner: Wrench
    outer_b: Wrench


class Friction(NamedTuple):
    """Given friction in the three joints of a dyad: a force along the line [N] or a moment about the pin [N*m]."""

    outer_a: Real
    inner: Real
    outer_b: Real


_NONE = np.zeros(())
FRICTIONLESS = Friction(_NONE, _NONE, _NONE)


class Dyad(NamedTuple):
    """The three joints of a dyad in place."""

    a: Seat  # outer joint of link a
    inner: Seat
    b: Seat  # outer joint of link b

    def solve(self, load_a: Wrench, load_b: Wrench, friction: Friction = FRICTIONLESS) -> Reactions:
        """Reactions under wrenches on a and b, each about the inner joint's point (n,).

        Raises `SingularityError` at a dead point: the determinant is that of the velocities of the dyad.
        """
        balance = self.balance()
        balance.check()
        return balance.reactions(load_a, load_b, friction)

    def balance(self) -> Balance:
        """The equations of both links, solved once for all loads."""
        a, b = _row(self.a, self.inner, 1.0), _row(self.b, self.inner, -1.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            if isinstance(self.inner, Pivot):
                determinant = cross(a.arm, b.arm)
                by_a, by_b = Wrench(-1j * b.arm / determinant, _NONE), Wrench(1j * a.arm / determinant, _NONE)
            else:
                n = 1j * self.inner.e
                across_a, across_b = _dot(a.arm, n), _dot(b.arm, n)
                determinant = across_b * a.lever - across_a * b.lever
                by_a = Wrench(-b.lever / determinant * n, -across_b / determinant)
                by_b = Wrench(a.lever / determinant * n, across_a / determinant)
        return Balance(self, a, b, by_a, by_b, determinant)


class Row(NamedTuple):
    """What an outer joint says of the inner wrench (F, M): Re(conj(arm) F) - lever M = value.

    ``side`` is the sign with which the inner wrench acts on its link: +1 on a, -1 on b.
    """

    arm: Plane
    lever: float
    turns: bool  # a revolute joint
    side: float

    def value(self, d: Plane, load: Wrench) -> Real:
        """The value under a load about the inner joint's point, ``d`` the vector from there to the outer joint."""
        value = load.moment - cross(d, load.force) if self.turns else -_dot(self.arm, load.force)
        return value if self.side > 0 else -value

    @property
    def of_friction(self) -> float:
        """The value of a unit of friction in the outer joint."""
        return self.side if self.turns else -self.side

    def of(self, inner: Wrench) -> Real:
        """The left side for an inner wrench."""
        return _dot(self.arm, inner.force) - self.lever * inner.moment


class Balance(NamedTuple):
    """The two equations of a dyad with their inverse: the inner wrench of a unit value in each."""

    dyad: Dyad
    a: Row
    b: Row
    by_a: Wrench
    by_b: Wrench
    determinant: Real

    def check(self) -> None:
        """Raise `SingularityError` where the dyad is at a dead point."""
        size = np.abs(self.a.arm) * np.abs(self.b.arm)
        if not isinstance(self.dyad.inner, Pivot):
            size = self.a.lever * np.abs(self.b.arm) + self.b.lever * np.abs(self.a.arm)
        sine = np.abs(self.determinant) / np.where(size > 0, size, 1.0)
        if np.any(sine <= SINGULAR):
            raise SingularityError(
                f"a dead point: reactions grow without bound (row {int(np.argmin(sine))})",
                where="forces, dyad",
                value=float(np.min(sine)),
                limit=SINGULAR,
                remedy="keep its links away from that position",
            )

    def inner(self, load_a: Wrench, load_b: Wrench) -> Wrench:
        """The inner wrench on link a without friction, loads about the inner joint's point (n,)."""
        value_a = self.a.value(self.dyad.a.r - self.dyad.inner.r, load_a)
        value_b = self.b.value(self.dyad.b.r - self.dyad.inner.r, load_b)
        return self.by_a.times(value_a).plus(self.by_b.times(value_b))

    def response(self, k: int) -> Wrench:
        """The inner wrench that a unit of friction in joint ``k`` alone makes: 0 outer of a, 1 inner, 2 outer of b."""
        if k == 0:
            return self.by_a.times(self.a.of_friction)
        if k == 2:
            return self.by_b.times(self.b.of_friction)
        inner = self.dyad.inner
        own = Wrench(NOTHING.force, np.ones(())) if isinstance(inner, Pivot) else Wrench(inner.e, _NONE)
        return own.plus(self.by_a.times(-self.a.of(own))).plus(self.by_b.times(-self.b.of(own)))

    def outer(self, load_a: Wrench, load_b: Wrench, inner: Wrench, friction: Friction = FRICTIONLESS) -> Reactions:
        """All reactions once the inner wrench is known: each link is in equilibrium."""
        dyad = self.dyad
        on_a, on_b = load_a.plus(inner).reversed(), inner.minus(load_b)
        return Reactions(
            _outer(dyad.a, on_a, dyad.inner.r, friction.outer_a),
            inner,
            _outer(dyad.b, on_b, dyad.inner.r, friction.outer_b),
        )

    def reactions(self, load_a: Wrench, load_b: Wrench, friction: Friction = FRICTIONLESS) -> Reactions:
        """Reactions under wrenches on a and b, each about the inner joint's point (n,)."""
        inner = self.inner(load_a, load_b)
        for k, value in enumerate(friction):
            if value is not _NONE:
                inner = inner.plus(self.response(k).times(value))
        return self.outer(load_a, load_b, inner, friction)


def _outer(seat: Seat, wrench: Wrench, point: Plane, friction: Real) -> Wrench:
    """The reaction of an outer joint about its own point; that of a pin has no moment but friction."""
    return Wrench(wrench.force, friction) if isinstance(seat, Pivot) else wrench.about(seat.r - point)


def _row(outer: Seat, inner: Seat, side: float) -> Row:
    if isinstance(outer, Slideway):
        return Row(outer.e, 0.0, False, side)
    return Row(1j * (outer.r - inner.r), 1.0, True, side)


def _dot(a: Plane, b: Plane) -> Real:
    return (np.conj(a) * b).real
