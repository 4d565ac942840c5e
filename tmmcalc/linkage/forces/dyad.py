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

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Real, cross
from tmmcalc.linkage.forces.wrench import NOTHING, Pivot, Plan, Seat, Slideway, Wrench

if TYPE_CHECKING:
    from tmmcalc.linkage.forces.friction import Solution

Three = tuple[Wrench, Wrench, Wrench]  # about each joint's own point: A and B on link a, C on link b
_NONE = np.zeros(())


class GroupReactions(NamedTuple):
    """What holds a group: reactions on the receivers about each joint's own point, and the friction in them."""

    reactions: tuple[Wrench, ...]
    friction: tuple[Real, ...]
    solution: Solution | None  # None where nothing rubs
    drive: Real | None  # force (n,) of the drive on its slider along the line, if it acts inside the group


class Row(NamedTuple):
    """What an outer joint says of the inner wrench (F, M): Re(conj(arm) F) - lever M = value."""

    arm: Plane
    lever: float  # 1 of a revolute joint, 0 of a prismatic one
    value: Real
    friction: float  # the value of a unit of friction in the outer joint

    def of(self, inner: Wrench) -> Real:
        """The left side for an inner wrench."""
        return _dot(self.arm, inner.force) - self.lever * inner.moment


class DyadEquilibrium(NamedTuple):
    """A dyad in place with the wrenches on its links, each about the inner joint's point (n,)."""

    plan: Plan
    seats: tuple[Seat, Seat, Seat]  # of the joints A, B, C
    loads: tuple[Wrench, Wrench]  # on a and b
    c: dict[int, Real]  # of every rubbing joint: coefficient times the sense of the receiver's motion in it, (n,)

    def solve(self, shape: tuple[int, ...]) -> GroupReactions:
        """Reactions at (n,) positions, or (C, n) in cases of load, with the friction in them."""
        rows = self.rows()
        units = self.of_units(rows)
        inner = units[0].times(rows[0].value).plus(units[1].times(rows[1].value))
        if not self.c:
            return GroupReactions(self.outer(inner, (_NONE, _NONE, _NONE)), (_NONE, _NONE, _NONE), None, None)
        from tmmcalc.linkage.forces.friction import Rubbing, solve  # only what rubs needs it

        responses = [self.response(k, rows, units) for k in self.c]
        load_a, load_b = self.loads
        base = (load_a.plus(inner).reversed() if 0 in self.c else NOTHING, inner, inner.minus(load_b))
        pairs = [
            Rubbing(
                self.seats[k],
                c,
                self._about(k, base[k]),
                tuple(self._about(k, r.reversed() if k == 0 else r) for r in responses),
                self.plan.posts[k].half,
            )
            for k, c in self.c.items()
        ]
        solution = solve(pairs, shape)
        for response, value in zip(responses, solution.values, strict=True):
            inner = inner.plus(response.times(value))
        friction = self.in_joints(solution.values)
        return GroupReactions(self.outer(inner, friction), friction, solution, None)

    def under(self, values: Real) -> GroupReactions:
        """Reactions under friction values (k, n) of the joints that rub."""
        rows = self.rows()
        units = self.of_units(rows)
        inner = units[0].times(rows[0].value).plus(units[1].times(rows[1].value))
        for k, value in zip(self.c, values, strict=True):
            inner = inner.plus(self.response(k, rows, units).times(value))
        friction = self.in_joints(values)
        return GroupReactions(self.outer(inner, friction), friction, None, None)

    def rows(self) -> tuple[Row, Row]:
        """The equation of each link: moments about the pin of its outer joint, or forces along the line of it."""
        point, found = self.seats[1].r, []
        for seat, load, side in zip(self.seats[::2], self.loads, (1.0, -1.0), strict=True):
            if isinstance(seat, Slideway):
                arm, lever, value, friction = seat.e, 0.0, -_dot(seat.e, load.force), -side
            else:
                d = seat.r - point
                arm, lever, value, friction = 1j * d, 1.0, load.moment - cross(d, load.force), side
            found.append(Row(arm, lever, value if side > 0 else -value, friction))
        return found[0], found[1]

    def of_units(self, rows: tuple[Row, Row]) -> tuple[Wrench, Wrench]:
        """The inner wrench of a unit value in each equation; without bound at a dead point."""
        (a, b), inner = rows, self.seats[1]
        with np.errstate(divide="ignore", invalid="ignore"):
            if isinstance(inner, Pivot):
                determinant = cross(a.arm, b.arm)
                return Wrench(-1j * b.arm / determinant, _NONE), Wrench(1j * a.arm / determinant, _NONE)
            n = 1j * inner.e
            across_a, across_b = _dot(a.arm, n), _dot(b.arm, n)
            determinant = across_b * a.lever - across_a * b.lever
            return (
                Wrench(-b.lever / determinant * n, -across_b / determinant),
                Wrench(a.lever / determinant * n, across_a / determinant),
            )

    def response(self, k: int, rows: tuple[Row, Row], units: tuple[Wrench, Wrench]) -> Wrench:
        """The inner wrench that a unit of friction in joint ``k`` alone makes: 0 outer of a, 1 inner, 2 outer of b."""
        (a, b), (by_a, by_b) = rows, units
        if k == 0:
            return by_a.times(a.friction)
        if k == 2:
            return by_b.times(b.friction)
        inner = self.seats[1]
        own = Wrench(NOTHING.force, np.ones(())) if isinstance(inner, Pivot) else Wrench(inner.e, _NONE)
        return own.plus(by_a.times(-a.of(own))).plus(by_b.times(-b.of(own)))

    def outer(self, inner: Wrench, friction: tuple[Real, ...]) -> Three:
        """All reactions once the inner wrench is known: each link is in equilibrium.

        That of an outer pin has no moment about it but friction.
        """
        (load_a, load_b), (a, b, c) = self.loads, self.seats
        on_a, on_b = load_a.plus(inner).reversed(), inner.minus(load_b)
        return (
            Wrench(on_a.force, friction[0]) if isinstance(a, Pivot) else on_a.about(a.r - b.r),
            inner,
            Wrench(on_b.force, friction[2]) if isinstance(c, Pivot) else on_b.about(c.r - b.r),
        )

    def in_joints(self, values: Real) -> tuple[Real, Real, Real]:
        """Friction in the three joints from the values (k, n) of those that rub."""
        three = [_NONE, _NONE, _NONE]
        for k, value in zip(self.c, values, strict=True):
            three[k] = value
        return three[0], three[1], three[2]

    def _about(self, k: int, wrench: Wrench) -> Wrench:
        """A wrench about the inner joint's point, about that of joint ``k`` if its moment counts there."""
        if k == 1 or self.plan.posts[k].half is None:
            return wrench
        return wrench.about(self.seats[k].r - self.seats[1].r)


def _dot(a: Plane, b: Plane) -> Real:
    return (np.conj(a) * b).real
