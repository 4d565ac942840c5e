"""The wheels of a train as a page turns them: members where they stand, which of their wheels mesh, and tooth in space.

A layout stands as its end view does (`tmmcalc.gears.pictures.placed`), a train that is written out mesh by mesh by
`tmmcalc.gears.network.places`. Teeth are thought ones, but as many as there are, and where they mesh: of two wheels
with their pitch point in the direction delta from the first one (of a ring: from both)

    s1 = (theta1 - delta) z1/2pi,  s2 = (delta + pi - theta2) z2/2pi  or  (theta2 - delta) z2/2pi,  s1 = s2 + 1/2 mod 1

with theta the direction of the middle of a tooth.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from tmmcalc.gears.chosen.motion import MODULE, Moving, modules_of
from tmmcalc.gears.network.model import FRAME, INTERNAL, Network
from tmmcalc.gears.network.places import places
from tmmcalc.gears.pictures.placed import placed
from tmmcalc.gears.scheme import CARRIER
from tmmcalc.gears.views.fitting import spread

ALIKE = 1e-9  # relative: lengths that are one


class Circle(NamedTuple):
    """A wheel of a member."""

    radius: float  # of the circle that rolls [m]
    ring: bool
    teeth: int


class Member(NamedTuple):
    """A member with its wheels, in all its places."""

    name: str
    axes: tuple[complex, ...]  # at the beginning [m]
    circles: tuple[Circle, ...]
    bearer: str
    tilted: bool = False

    @property
    def outer(self) -> float:
        """Radius of its largest wheel."""
        return max((circle.radius for circle in self.circles), default=0.0)


Place = tuple[str, int]  # a wheel: its member, its place among the circles of that
Placed = tuple[list[Member], list[tuple[Place, Place]]]  # members where they stand, the wheels that mesh


def members_of(found: Moving) -> Placed:
    """The members of a train where they stand, and which of their wheels mesh."""
    return _of_network(found) if found.chosen is None else _of_layout(found)


def _of_layout(found: Moving) -> Placed:
    chosen, network = found.chosen, found.task.network
    assert chosen is not None
    train = placed(chosen.sets, 0, np.array(modules_of(chosen)), rack=chosen.task.pressure_angle)
    circles: dict[str, list[Circle]] = {}
    known: dict[str, Place] = {}
    for wheel in train.wheels:
        name = wheel.name.rstrip("'")
        own = circles.setdefault(name, [])
        known[wheel.name] = name, len(own)
        own.append(Circle(wheel.pitch[0][0], wheel.internal, wheel.teeth))
    members = [Member(name, train.wheel(name).axes, tuple(own), network.bearer(name)) for name, own in circles.items()]
    if train.scheme.planetary:
        members.append(Member(CARRIER, (0j,), (), FRAME))
    return members, [(known[mesh.first], known[mesh.second]) for mesh in train.scheme.meshes]


def _of_network(found: Moving) -> Placed:
    network = found.task.network
    at = places(network, None, found.task.locked, MODULE)
    circles: dict[str, list[Circle]] = {name: [] for name in (*network.members, FRAME)}
    axes, meshes = dict(at.axes), list[tuple[Place, Place]]()
    for point in at.pitch:
        mesh = network.meshes[point.mesh]
        bevel = network.tilted(mesh.first) or network.tilted(mesh.second)
        pair = []
        for k, (name, teeth) in enumerate(((mesh.first, mesh.first_teeth), (mesh.second, mesh.second_teeth))):
            ring = mesh.sign == INTERNAL and not bevel and point.radii[k] > point.radii[1 - k]
            circle, own = Circle(point.radii[k], ring, teeth), circles[name]
            same = [j for j, each in enumerate(own) if _same(circle, each)]
            pair.append((name, same[0] if same else len(own)))
            own += [] if same else [circle]
        meshes += [] if bevel else [(pair[0], pair[1])]
        axes.setdefault(FRAME, axes.get(network.carriers[point.mesh], 0j))
    members = [
        Member(name, tuple(_copies(network, axes, name)), tuple(own), network.bearer(name), network.tilted(name))
        for name, own in circles.items()
        if name != FRAME or own
    ]
    return members, meshes


def _same(one: Circle, other: Circle) -> bool:
    alike = one.ring == other.ring and one.teeth == other.teeth
    return alike and math.isclose(one.radius, other.radius, rel_tol=ALIKE)


def _copies(network: Network, axes: dict[str, complex], name: str) -> Iterator[complex]:
    """Where all that are called so stand: planets around the axis of their carrier, as far as they fit in."""
    bearer, count = network.bearer(name), network.count(name)
    centre = axes[bearer] if bearer != FRAME else axes[name]
    turns = spread(network, axes, bearer, MODULE)
    if len(turns) > 1:  # of fewer than the most on the carrier some of its places, where these are as many times more
        turns = turns[:1] if len(turns) % count else turns[:: len(turns) // count]
    for turn in turns:
        yield centre + (axes[name] - centre) * complex(math.cos(2 * math.pi * turn), math.sin(2 * math.pi * turn))


def teeth_of(members: list[Member], meshes: list[tuple[Place, Place]]) -> dict[tuple[str, int, int], float]:
    """The direction of a tooth of every wheel [rad] at the beginning, by member, copy and place of the circle.

    Each wheel takes what the first mesh asks of it that reaches it; where planets do not fit in, others do not mesh.
    """
    named = {member.name: member for member in members}
    found: dict[tuple[str, int, int], float] = {}
    for member in members:
        for place in range(len(member.circles)):
            queue = [(member.name, 0, place)]
            if queue[0] in found:
                continue
            found[queue[0]] = math.pi / 2
            for own in queue:
                for mate, angle in _mates(named, meshes, own, found[own]):
                    if mate not in found:
                        found[mate] = angle
                        queue.append(mate)
    return found


def _mates(
    named: dict[str, Member], meshes: list[tuple[Place, Place]], own: tuple[str, int, int], angle: float
) -> Iterator[tuple[tuple[str, int, int], float]]:
    """Wheels in mesh with one whose tooth has a direction, and the directions of their teeth."""
    name, copy, place = own
    one = named[name]
    for pair in meshes:
        for near, far in (pair, pair[::-1]):
            if near != (name, place):
                continue
            other = named[far[0]]
            first, second = one.circles[place], other.circles[far[1]]
            copies = range(len(other.axes)) if len(one.axes) == 1 else [copy if len(other.axes) > 1 else 0]
            for k in copies:
                apart = other.axes[k] - one.axes[copy]
                # from a ring its mate lies towards the pitch point, from the mate of a ring away from it
                delta = float(np.angle(-apart if second.ring else apart))
                s = (angle - delta) * first.teeth / (2 * math.pi) + 0.5
                pitch = 2 * math.pi / second.teeth
                inside = first.ring or second.ring
                yield (far[0], k, far[1]), delta + s * pitch if inside else delta + math.pi - s * pitch
