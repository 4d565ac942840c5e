"""The closure of an Assur group of any class, as vector equations of its independent loops.

Links joined by prismatic joints turn together; every such class of links has one unit vector U = exp(i theta), known if
the class hangs on a guide of the source chain. Along a tree of joints that starts in the source chain, the origin
of every link is a sum of constant multiples of these vectors; each joint outside the tree closes a loop:

    F = G + sum_c A_c U_c + sum_j D_j s_j e_j = 0        one complex equation a loop

G is known from the source chain, s_j and e_j are the coordinates and directions of the prismatic joints. A group of n
links and 3n/2 pairs has n/2 loops and n real unknowns, theta and s. Where the drive acts inside the group, its
coordinate is given: then there are n - 1 unknowns in (n - 1)/2 loops.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple, TypeVar

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.linkage.dyads.base import Motions
from tmmcalc.linkage.model import Joint, Mechanism
from tmmcalc.linkage.structure import Group

K = TypeVar("K", int, str)
V = TypeVar("V", int, complex)


class Turning(NamedTuple):
    """A direction that turns with a class, or with a link of the source chain: ``turn`` (unit) times its vector."""

    known: bool  # of a link of the source chain
    of: int  # number of the class, or of the link
    turn: complex


class Grown(NamedTuple):
    """A link of the group, and the joint of the tree through which it hangs on ``parent``."""

    link: int
    joint: Joint
    parent: int


class Rail(NamedTuple):
    """A prismatic joint of the group: its name, its direction, whether the drive gives its coordinate."""

    joint: str
    along: Turning
    driven: bool


class Equations(NamedTuple):
    """The constants of the loops of one group: L loops, C classes, S prismatic joints, K source links."""

    group: Group
    turnings: dict[int, Turning]  # of the x axis of every link of the group
    tree: tuple[Grown, ...]  # in the order in which the links hang on each other
    rails: tuple[Rail, ...]
    sources: tuple[int, ...]
    origins: Plane  # (L, K) how often the origin of a source link is counted
    axes: Plane  # (L, K) multiples of the unit vectors of source links
    classes: Plane  # (L, C) A
    slides: Plane  # (L, S) D

    @property
    def free(self) -> list[int]:
        """Which prismatic joints have an unknown coordinate."""
        return [j for j, rail in enumerate(self.rails) if not rail.driven]

    @property
    def unknowns(self) -> int:
        """Number N of unknowns: the angles of the classes, then the free coordinates."""
        return self.classes.shape[1] + len(self.free)

    def given(self, motions: Motions) -> tuple[Plane, Plane, Plane]:
        """G and its two derivatives, each (L, n) or (L, 1), from the motions of the source chain."""
        found = [motions[k] for k in self.sources]
        position = self._sum([(m.r - m.u * m.base, m.u) for m in found])
        velocity = self._sum([(m.v - m.u1 * m.base, m.u1) for m in found])
        return position, velocity, self._sum([(m.a - m.u2 * m.base, m.u2) for m in found])

    def _sum(self, states: list[tuple[Plane, Plane]]) -> Plane:
        flat = np.array(np.broadcast_arrays(*(np.atleast_1d(part) for state in states for part in state)))
        return np.asarray(self.origins @ flat[::2] + self.axes @ flat[1::2])


def equations_of(mechanism: Mechanism, group: Group) -> Equations:
    """Read the constants of a group from the mechanism."""
    joints = [mechanism.joint(name) for name in (*group.inner, *group.outer)]
    turnings, count = _turnings(group, joints)
    tree, closing = _tree(group, joints)
    rails = tuple(
        Rail(j.name, _turned(turnings, j.links[1], j.directions[1]), j.name == mechanism.input.joint)
        for j in joints
        if j.kind == "prismatic"
    )
    sums = _Origins(turnings)
    for grown in tree:
        sums.grow(grown)
    loops = [sums.gap(joint) for joint in closing]
    sources = tuple(sorted({k for loop in loops for part in loop[:2] for k in part}))
    names = [rail.joint for rail in rails]
    return Equations(
        group,
        turnings,
        tuple(tree),
        rails,
        sources,
        _table([loop.origins for loop in loops], sources),
        _table([loop.axes for loop in loops], sources),
        _table([loop.classes for loop in loops], range(count)),
        _table([loop.slides for loop in loops], names),
    )


def _table(rows: Sequence[Mapping[K, complex]], keys: Sequence[K]) -> Plane:
    """Multiples (L, keys) of the loops."""
    table = np.array([[row.get(key, 0j) for key in keys] for row in rows]).reshape(len(rows), len(keys))
    return table.astype(np.result_type(table, np.complex128), copy=False)


def _turnings(group: Group, joints: list[Joint]) -> tuple[dict[int, Turning], int]:
    """How the x axis of every link of the group stands, and the number of classes whose angle is unknown."""
    rigid = {k: [j for j in joints if j.kind == "prismatic" and k in j.links] for k in group.links}
    held = [k for k in group.links if any(set(j.links) - set(group.links) for j in rigid[k])]
    found: dict[int, Turning] = {}
    count = 0
    for first in (*held, *group.links):
        if first in found:
            continue
        outer = next((j for j in rigid[first] if set(j.links) - set(group.links)), None)
        if outer is None:
            found[first], count = Turning(False, count, 1 + 0j), count + 1
        else:
            source = next(k for k in outer.links if k != first)
            found[first] = Turning(True, source, _between(outer, source))
        waiting = [first]
        while waiting:
            k = waiting.pop()
            for joint in rigid[k]:
                other = next(q for q in joint.links if q != k)
                if other in group.links and other not in found:
                    found[other] = found[k]._replace(turn=found[k].turn * _between(joint, k))
                    waiting.append(other)
    return found, count


def _between(joint: Joint, known: int) -> complex:
    """The x axis of the other link of a joint against that of ``known``, as a prismatic joint holds them."""
    own = joint.links.index(known)
    return joint.directions[own] / joint.directions[1 - own]


def _turned(turnings: dict[int, Turning], link: int, direction: complex) -> Turning:
    """A direction fixed in a link."""
    own = turnings.get(link, Turning(True, link, 1 + 0j))
    return own._replace(turn=own.turn * direction)


def _tree(group: Group, joints: list[Joint]) -> tuple[list[Grown], list[Joint]]:
    """Joints through which the links hang on the source chain, those nearest to it first; and the others."""
    left, waiting = list(joints), list(group.links)
    tree: list[Grown] = []
    while waiting:
        ready = [(j, k) for j in left for k in j.links if k in waiting and not (set(j.links) - {k}) & set(waiting)]
        for joint, link in ready:
            if link in waiting:
                tree.append(Grown(link, joint, next(k for k in joint.links if k != link)))
                waiting.remove(link)
                left.remove(joint)
    return tree, left


class _Sum(NamedTuple):
    """A vector as multiples of origins and axes of source links, of vectors of classes, of slides s e."""

    origins: dict[int, int]
    axes: dict[int, complex]
    classes: dict[int, complex]
    slides: dict[str, int]

    def plus(self, other: _Sum, sign: int = 1) -> _Sum:
        """This vector and ``sign`` times another one."""
        return _Sum(
            _added(self.origins, other.origins, sign),
            _added(self.axes, other.axes, sign),
            _added(self.classes, other.classes, sign),
            _added(self.slides, other.slides, sign),
        )


def _added(a: dict[K, V], b: dict[K, V], sign: int) -> dict[K, V]:
    """The sum of two tables of multiples."""
    return {key: a.get(key, 0) + sign * b.get(key, 0) for key in {**a, **b}}


class _Origins:
    """The origins of links as sums, grown along the tree."""

    def __init__(self, turnings: dict[int, Turning]) -> None:
        self.turnings = turnings
        self.grown: dict[int, _Sum] = {}

    def origin(self, link: int) -> _Sum:
        """The origin of a link."""
        return self.grown.get(link, _Sum({link: 1}, {}, {}, {}))

    def arm(self, link: int, point: complex) -> _Sum:
        """The vector from the origin of a link to a point in its axes."""
        turning = _turned(self.turnings, link, point)
        one = {turning.of: turning.turn}
        return _Sum({}, one, {}, {}) if turning.known else _Sum({}, {}, one, {})

    def seat(self, joint: Joint, side: int) -> _Sum:
        """The point of a joint on one of its links; of a guide, at the slider's coordinate."""
        link = joint.links[side]
        point = self.origin(link).plus(self.arm(link, joint.points[side]))
        slides = joint.kind == "prismatic" and side == 1
        return point.plus(_Sum({}, {}, {}, {joint.name: 1})) if slides else point

    def grow(self, grown: Grown) -> None:
        """Place a link whose parent is placed."""
        side = grown.joint.links.index(grown.link)
        own = self.arm(grown.link, grown.joint.points[side])
        if grown.joint.kind == "prismatic" and side == 1:
            own = own.plus(_Sum({}, {}, {}, {grown.joint.name: 1}))
        self.grown[grown.link] = self.seat(grown.joint, 1 - side).plus(own, -1)

    def gap(self, joint: Joint) -> _Sum:
        """What must vanish for a joint outside the tree to be closed."""
        return self.seat(joint, 0).plus(self.seat(joint, 1), -1)
