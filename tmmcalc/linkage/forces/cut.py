"""A dyad cut out of the mechanism: its joints as posts that give reactions, and all else that acts on it."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from tmmcalc.linkage.forces.dyad import FRICTIONLESS, Balance, Friction, Reactions
from tmmcalc.linkage.forces.wrench import NOTHING, Wrench
from tmmcalc.linkage.loading import Pair
from tmmcalc.linkage.model import Joint, Mechanism
from tmmcalc.linkage.plane import Real
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
    """A dyad with its three joints: outer of a, inner, outer of b; reactions act on a, a, b."""

    group: Group
    posts: tuple[Post, Post, Post]

    @property
    def rubbing(self) -> list[int]:
        """Which of the three joints have friction."""
        return [k for k, post in enumerate(self.posts) if post.coefficient > 0]


def post_of(joint: Joint, receiver: int, pairs: dict[str, Pair]) -> Post:
    """The joint with the friction of its pair."""
    giver = joint.links[1 - joint.links.index(receiver)]
    pair = pairs.get(joint.name)
    if pair is None:
        return Post(joint, receiver, giver, 0.0, None)
    coefficient = pair.friction * (pair.radius if joint.kind == "revolute" else 1.0)
    return Post(joint, receiver, giver, coefficient, pair.length / 2 if pair.length else None)


def plan_of(mechanism: Mechanism, group: Group, pairs: dict[str, Pair]) -> Plan:
    """The plan of a dyad."""
    a, b = group.links
    outer_a, inner, outer_b = (mechanism.joint(name) for name in (group.outer[0], group.inner[0], group.outer[1]))
    return Plan(group, (post_of(outer_a, a, pairs), post_of(inner, a, pairs), post_of(outer_b, b, pairs)))


class Cut(NamedTuple):
    """A dyad in place with the wrenches on its links, each about the inner joint's point (n,)."""

    plan: Plan
    balance: Balance
    loads: tuple[Wrench, Wrench]
    c: dict[int, Real]  # of every rubbing joint: coefficient times the sense of the receiver's motion in it, (n,)

    def solve(self, n: int) -> tuple[Reactions, Friction, Solution | None]:
        """Reactions at n positions, the friction in them, and how it came out; None where nothing rubs."""
        inner = self.balance.inner(*self.loads)
        if not self.c:
            return self.balance.outer(*self.loads, inner), FRICTIONLESS, None
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
        return self.balance.outer(load_a, load_b, inner, friction), friction, solution

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
