"""Reactions of a group of any class: the equations of equilibrium of all its links at once.

A group of n links and 3n/2 pairs has 3n equations for the two components of each reaction: a force in a revolute pair;
in a prismatic one a normal force and a couple. Where the drive acts inside the group, its force is one unknown more
and there is half a pair less. Moments are taken about a pole and divided by the group's reach, to be forces as well.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Real, cross
from tmmcalc.linkage.forces.dyad import GroupReactions
from tmmcalc.linkage.forces.wrench import Plan, Post, Seat, Slideway, Wrench

if TYPE_CHECKING:
    from tmmcalc.linkage.forces.friction import Rubbing, Solution

_NONE, _ONE = np.zeros(()), np.ones(())


class GroupEquilibrium(NamedTuple):
    """A group in place: where its joints stand, the wrenches on its links about the pole, the friction in its pairs."""

    plan: Plan
    seats: tuple[Seat, ...]
    loads: dict[int, Wrench]
    c: dict[int, Real]  # of every rubbing joint: coefficient times the sense of the receiver's motion in it, (n,)
    pole: complex

    def solve(self, shape: tuple[int, ...]) -> GroupReactions:
        """Reactions at (n,) positions, or (C, n) in cases of load, with the friction in them."""
        bare, responses = self._solved(shape)
        if not self.c:
            return self._held(bare, (_NONE,) * len(self.seats), None)
        from tmmcalc.linkage.forces.friction import solve  # only what rubs needs it

        solution = solve(self._rubbing(bare, responses), shape)
        return self._with(bare, responses, solution.values)._replace(solution=solution)

    def under(self, values: Real) -> GroupReactions:
        """Reactions under friction values (k, n) of the joints that rub."""
        return self._with(*self._solved(values.shape[1:]), values)

    def _with(self, bare: Real, responses: Real, values: Real) -> GroupReactions:
        """Reactions under friction values (k, n), from those without friction and those to a unit of each."""
        friction = [_NONE] * len(self.seats)
        for k, value in zip(self.c, values, strict=True):
            friction[k] = value
        return self._held(bare + np.einsum("kc...,k...->c...", responses, values), tuple(friction), None)

    def _rubbing(self, bare: Real, responses: Real) -> list[Rubbing]:
        """The pairs that rub."""
        from tmmcalc.linkage.forces.friction import Rubbing

        of_unit = [self._held(part, (_NONE,) * len(self.seats), None).reactions for part in responses]
        base = self._held(bare, (_NONE,) * len(self.seats), None).reactions
        return [
            Rubbing(self.seats[k], c, base[k], tuple(r[k] for r in of_unit), self.plan.posts[k].half)
            for k, c in self.c.items()
        ]

    def _solved(self, shape: tuple[int, ...]) -> tuple[Real, Real]:
        """Components of the reactions (3 L, n) under the loads; (k, 3 L, n) under a unit of friction in each pair."""
        table = _Table(self, shape)
        for k, seat in enumerate(self.seats):
            for column, (force, couple) in enumerate(_units(seat), 2 * k):
                table.write(table.matrix[..., column], k, force, couple)
        if self.plan.driven is not None:
            table.write(table.matrix[..., -1], self.plan.driven, self._drive_direction(), _NONE)
        for column, k in enumerate(self.c, 1):
            seat = self.seats[k]
            force, couple = (seat.e, _NONE) if isinstance(seat, Slideway) else (_NONE + 0j, _ONE)
            table.write(table.sides[..., column], k, -force, -couple)
        found = np.linalg.solve(table.matrix, table.sides)
        return np.ascontiguousarray(np.moveaxis(found[..., 0], -1, 0)), np.ascontiguousarray(
            np.moveaxis(found[..., 1:], (-1, -2), (0, 1))
        )

    def _drive_direction(self) -> Plane:
        """Direction (n,) of the drive's force on the receiver of its joint, which pushes the slider ahead."""
        k = self.plan.driven or 0
        seat, post = self.seats[k], self.plan.posts[k]
        assert isinstance(seat, Slideway)
        return seat.e if post.receiver == post.joint.links[0] else -seat.e

    def _held(self, components: Real, friction: tuple[Real, ...], solution: Solution | None) -> GroupReactions:
        """Wrenches about each joint's own point from components (3 L, n)."""
        reactions = []
        for k, (seat, own) in enumerate(zip(self.seats, friction, strict=True)):
            first, second = components[2 * k], components[2 * k + 1]
            if isinstance(seat, Slideway):
                reactions.append(Wrench((1j * first + own) * seat.e, second))
            else:
                reactions.append(Wrench(first + 1j * second, own))
        drive = None if self.plan.driven is None else components[-1]
        return GroupReactions(tuple(reactions), friction, solution, drive)


class _Table:
    """The equations of equilibrium: three rows a link, one column an unknown, and the right sides."""

    def __init__(self, group: GroupEquilibrium, shape: tuple[int, ...]) -> None:
        links = group.plan.group.links
        self.group, self.rows = group, {link: 3 * i for i, link in enumerate(links)}
        self.reach = float(max(np.max(np.abs(seat.r - group.pole)) for seat in group.seats)) or 1.0
        self.matrix = np.zeros((shape[-1], 3 * len(links), 3 * len(links)))
        self.sides = np.zeros((*shape, 3 * len(links), 1 + len(group.c)))
        for link, row in self.rows.items():
            load = group.loads[link]
            self._add(self.sides[..., 0], row, -1.0, load.force, load.moment)

    def write(self, column: Real, k: int, force: Plane, couple: Real) -> None:
        """What joint k does with this force at its point and this couple, to its receiver and back to its giver."""
        post: Post = self.group.plan.posts[k]
        moment = cross(self.group.seats[k].r - self.group.pole, force) + couple
        for link, sign in ((post.receiver, 1.0), (post.giver, -1.0)):
            if link in self.rows:
                self._add(column, self.rows[link], sign, force, moment)

    def _add(self, column: Real, row: int, sign: float, force: Plane, moment: Real) -> None:
        column[..., row] += sign * force.real
        column[..., row + 1] += sign * force.imag
        column[..., row + 2] += sign * moment / self.reach


def _units(seat: Seat) -> tuple[tuple[Plane, Real], tuple[Plane, Real]]:
    """The two components of a reaction: forces along x and y, or a normal force and a couple."""
    if isinstance(seat, Slideway):
        return (1j * seat.e, _NONE), (_NONE + 0j, _ONE)
    return (_ONE + 0j, _NONE), (_ONE * 1j, _NONE)
