"""A dyad cut out of the mechanism: its joints as posts that give reactions, and all else that acts on it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.linkage.forces.dyad import FRICTIONLESS, UNITS, Balance, Friction
from tmmcalc.linkage.forces.friction import Rubbing, Solution, solve
from tmmcalc.linkage.forces.wrench import NOTHING, Wrench
from tmmcalc.linkage.loading import Pair
from tmmcalc.linkage.model import Joint, Mechanism
from tmmcalc.linkage.plane import Real
from tmmcalc.linkage.structure import Group


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

    def friction(self, n: int) -> tuple[Friction, Solution | None]:
        """Friction in the three joints at n positions, and how it came out; None where nothing rubs."""
        if not self.c:
            return FRICTIONLESS, None
        base = self.balance.reactions(*self.loads)
        units = [self.balance.reactions(NOTHING, NOTHING, UNITS[k]) for k in self.c]
        pairs = [
            Rubbing(self.balance.dyad[k], c, base[k], tuple(unit[k] for unit in units), self.plan.posts[k].half)
            for k, c in self.c.items()
        ]
        solution = solve(pairs, n)
        return self.given(solution.values), solution

    def given(self, values: Real) -> Friction:
        """Friction in the three joints from the values (k, n) of those that rub."""
        three = [np.zeros(())] * 3
        for k, value in zip(self.c, values, strict=True):
            three[k] = value
        return Friction(*three)
