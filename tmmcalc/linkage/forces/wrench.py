"""Forces with their moment, and the joints of a group at which reactions act."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Real, cross
from tmmcalc.linkage.chain import Configuration
from tmmcalc.linkage.loading import Pair
from tmmcalc.linkage.model import Joint, Mechanism
from tmmcalc.linkage.structure import Group


class Wrench(NamedTuple):
    """A force (n,) [N] and its moment (n,) [N*m] about a point that the context names."""

    force: Plane
    moment: Real

    def about(self, d: Plane) -> Wrench:
        """The same wrench about the point at the vector ``d`` from the old one."""
        return Wrench(self.force, self.moment - cross(d, self.force))

    def plus(self, other: Wrench) -> Wrench:
        """Sum of two wrenches about the same point."""
        return Wrench(self.force + other.force, self.moment + other.moment)

    def minus(self, other: Wrench) -> Wrench:
        """Difference of two wrenches about the same point."""
        return Wrench(self.force - other.force, self.moment - other.moment)

    def times(self, factor: Real | float) -> Wrench:
        """The wrench as many times."""
        return Wrench(self.force * factor, self.moment * factor)

    def reversed(self) -> Wrench:
        """The opposite wrench."""
        return Wrench(-self.force, -self.moment)


NOTHING = Wrench(np.zeros((), np.complex128), np.zeros(()))


class Pivot(NamedTuple):
    """A revolute joint in place: the pin (n,) [m]."""

    r: Plane


class Slideway(NamedTuple):
    """A prismatic joint in place: the slider's point (n,) [m] and the unit direction of the line (n,)."""

    r: Plane
    e: Plane


Seat = Pivot | Slideway


class Post(NamedTuple):
    """A joint as one of its links feels it: the link that takes the reaction, the one that gives it, its friction."""

    joint: Joint
    receiver: int
    giver: int
    coefficient: float  # f of a prismatic pair, f r of a revolute one
    half: float | None  # half length of a slider [m]

    @property
    def sign(self) -> float:
        """+1 if the receiver is the higher-numbered link, whose motion and reaction are told."""
        return 1.0 if self.receiver > self.giver else -1.0


class Plan(NamedTuple):
    """A group with its joints; of a dyad they are the outer one of a, the inner one, the outer one of b."""

    group: Group
    posts: tuple[Post, ...]
    driven: int | None = None  # the joint of the drive, if it acts inside the group


def post_of(joint: Joint, receiver: int, pairs: dict[str, Pair]) -> Post:
    """The joint with the friction of its pair."""
    giver = joint.other(receiver)
    pair = pairs.get(joint.name)
    if pair is None:
        return Post(joint, receiver, giver, 0.0, None)
    coefficient = pair.friction * (pair.radius if joint.kind == "revolute" else 1.0)
    return Post(joint, receiver, giver, coefficient, pair.length / 2 if pair.length else None)


def plan_of(mechanism: Mechanism, group: Group, pairs: dict[str, Pair]) -> Plan:
    """The plan of a group: reactions act on a, a, b of a dyad, on the links of another group.

    Inner ones of another group act on the link that the joint names first.
    """
    if not group.kind:
        joints = [mechanism.joint(name) for name in (*group.outer, *group.inner)]
        receivers = [next(k for k in joint.links if k in group.links) for joint in joints]
        posts = tuple(post_of(joint, k, pairs) for joint, k in zip(joints, receivers, strict=True))
        names = [joint.name for joint in joints]
        return Plan(group, posts, names.index(group.drive) if group.drive else None)
    a, b = group.links
    outer_a, inner, outer_b = (mechanism.joint(name) for name in (group.outer[0], group.inner[0], group.outer[1]))
    return Plan(group, (post_of(outer_a, a, pairs), post_of(inner, a, pairs), post_of(outer_b, b, pairs)))


def seat_of(joint: Joint, configuration: Configuration) -> Seat:
    """Where a joint stands; reactions of a prismatic one are taken at the slider's point of its line."""
    motion = configuration.motions[joint.links[0]]
    r = motion.point(joint.points[0]).r
    return Pivot(r) if joint.kind == "revolute" else Slideway(r, motion.u * joint.directions[0])


def sliding(joint: Joint, configuration: Configuration) -> tuple[Real, Real]:
    """Relative motion in a joint per unit of input speed, and its derivative: rate and rate2, each (n,).

    Revolute: angular, of the higher-numbered link against the lower-numbered one [rad/rad]. Prismatic: of the
    higher-numbered link along the line [m/rad].
    """
    low, high = sorted(joint.links)
    if joint.kind == "revolute":
        a, b = configuration.motions[low], configuration.motions[high]
        return b.omega - a.omega, b.eps - a.eps
    slide = configuration.slides[joint.name]
    sign = 1.0 if joint.links[0] == high else -1.0
    return sign * slide.ds, sign * slide.dds
