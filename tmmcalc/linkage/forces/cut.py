"""A dyad cut out of the mechanism: its joints as posts that give reactions, and all else that acts on it."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from tmmcalc.core.plane import Real
from tmmcalc.linkage.forces.dyad import FRICTIONLESS, Balance, Dyad, Friction, Reactions
from tmmcalc.linkage.forces.wrench import NOTHING, Wrench
from tmmcalc.linkage.loading import Pair
from tmmcalc.linkage.model import Joint, Mechanism
from tmmcalc.linkage.structure import Group

if TYPE_CHECKING:
    from tmmcalc.linkage.forces.friction import Solution


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
    giver = joint.links[1 - joint.links.index(receiver)]
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


class Held(NamedTuple):
    """What holds a group: reactions on the receivers about each joint's own point, and the friction in them."""

    reactions: Reactions | tuple[Wrench, ...]
    friction: Friction | tuple[Real, ...]
    solution: Solution | None  # None where nothing rubs
    drive: Real | None  # force (n,) of the drive on its slider along the line, if it acts inside the group


class Cut(NamedTuple):
    """A dyad in place with the wrenches on its links, each about the inner joint's point (n,)."""

    plan: Plan
    balance: Balance
    loads: tuple[Wrench, Wrench]
    c: dict[int, Real]  # of every rubbing joint: coefficient times the sense of the receiver's motion in it, (n,)

    @property
    def seats(self) -> Dyad:
        """Where its joints stand."""
        return self.balance.dyad

    def solve(self, n: int) -> Held:
        """Reactions at n positions with the friction in them."""
        inner = self.balance.inner(*self.loads)
        if not self.c:
            return Held(self.balance.outer(*self.loads, inner), FRICTIONLESS, None, None)
        from tmmcalc.linkage.forces.friction import Rubbing, solve  # only what rubs needs it

        responses = [self.balance.response(k) for k in self.c]
        load_a, load_b = self.loads
        base = (load_a.plus(inner).reversed() if 0 in self.c else NOTHING, inner, inner.minus(load_b))
        pairs = [
            Rubbing(
                self.balance.dyad[k],
                c,
                self._about(k, base[k]),
                tuple(self._about(k, r.reversed() if k == 0 else r) for r in responses),
                self.plan.posts[k].half,
            )
            for k, c in self.c.items()
        ]
        solution = solve(pairs, n)
        for response, value in zip(responses, solution.values, strict=True):
            inner = inner.plus(response.times(value))
        friction = self.given(solution.values)
        return Held(self.balance.outer(load_a, load_b, inner, friction), friction, solution, None)

    def under(self, values: Real) -> Held:
        """Reactions under friction values (k, n) of the joints that rub."""
        friction = self.given(values)
        return Held(self.balance.reactions(*self.loads, friction), friction, None, None)

    def _about(self, k: int, wrench: Wrench) -> Wrench:
        """A wrench about the inner joint's point, about that of joint ``k`` if its moment counts there."""
        if k == 1 or self.plan.posts[k].half is None:
            return wrench
        return wrench.about(self.balance.dyad[k].r - self.balance.dyad.inner.r)

    def given(self, values: Real) -> Friction:
        """Friction in the three joints from the values (k, n) of those that rub."""
        three = list(FRICTIONLESS)
        for k, value in zip(self.c, values, strict=True):
            three[k] = value
        return Friction(*three)
