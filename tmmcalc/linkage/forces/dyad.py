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

from tmmcalc.errors import SingularityError
from tmmcalc.linkage.forces.wrench import NOTHING, Pivot, Seat, Slideway, Wrench
from tmmcalc.linkage.plane import Plane, Real, cross

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
UNITS = (Friction(np.ones(()), _NONE, _NONE), Friction(_NONE, np.ones(()), _NONE), Friction(_NONE, _NONE, np.ones(())))


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
        a, b = _row(self.a, self.inner), _row(self.b, self.inner)
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
    """What an outer joint says of the inner wrench (F, M) on its own link: Re(conj(arm) F) - lever M = value."""

    arm: Plane
    lever: float
    turns: bool  # a revolute joint

    def value(self, d: Plane, load: Wrench, friction: Real) -> Real:
        """The value under a load about the inner joint's point, ``d`` the vector from there to the outer joint."""
        if self.turns:
            return friction + load.moment - cross(d, load.force)
        return -(friction + _dot(self.arm, load.force))

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

    def reactions(self, load_a: Wrench, load_b: Wrench, friction: Friction = FRICTIONLESS) -> Reactions:
        """Reactions under wrenches on a and b, each about the inner joint's point (n,)."""
        dyad, f = self.dyad, friction.inner
        to_a, to_b = dyad.a.r - dyad.inner.r, dyad.b.r - dyad.inner.r
        value_a = self.a.value(to_a, load_a, friction.outer_a)
        value_b = -self.b.value(to_b, load_b, friction.outer_b)  # the inner wrench acts on b reversed
        own = NOTHING
        if f.ndim or f:
            own = Wrench(NOTHING.force, f) if isinstance(dyad.inner, Pivot) else Wrench(f * dyad.inner.e, _NONE)
            value_a = value_a - self.a.of(own)
            value_b = value_b - self.b.of(own)
        inner = Wrench(
            value_a * self.by_a.force + value_b * self.by_b.force + own.force,
            value_a * self.by_a.moment + value_b * self.by_b.moment + own.moment,
        )
        return Reactions(
            _outer(dyad.a, load_a.plus(inner).reversed(), to_a, friction.outer_a),
            inner,
            _outer(dyad.b, inner.plus(load_b.reversed()), to_b, friction.outer_b),
        )


def _outer(seat: Seat, wrench: Wrench, d: Plane, friction: Real) -> Wrench:
    """The reaction of an outer joint about its own point; that of a pin has no moment but friction."""
    return Wrench(wrench.force, friction) if isinstance(seat, Pivot) else wrench.about(d)


def _row(outer: Seat, inner: Seat) -> Row:
    if isinstance(outer, Slideway):
        return Row(outer.e, 0.0, False)
    return Row(1j * (outer.r - inner.r), 1.0, True)


def _dot(a: Plane, b: Plane) -> Real:
    return (np.conj(a) * b).real
