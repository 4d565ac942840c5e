"""A dyad of the chain, read once from the mechanism: how it is placed and moves its links."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage import solvers
from tmmcalc.linkage.dyads import KINDS
from tmmcalc.linkage.dyads.base import Dyad, Element, Elements, Motions, Mount, Rates, Sites, Slides, element
from tmmcalc.linkage.model import Joint, Mechanism
from tmmcalc.linkage.structure import Group

_STILL = Rates(*(np.zeros(()) for _ in range(4)))


class Step(NamedTuple):
    """One dyad of the chain; ``group`` names it in messages."""

    group: Group
    variant: int  # sign as the spec gives it; 1 for the kinds with one assembly
    dyad: Dyad
    port1: Element
    port2: Element
    mount: Mount

    def ports(self, motions: Motions) -> tuple[Any, Any]:
        """States of the two ports on the links solved before."""
        kind = self.group.kind
        return self.port1.port(kind[0], motions), self.port2.port(kind[2], motions)

    def advance(
        self, motions: Motions, slides: Slides, x: Real, order: int, method: solvers.Method
    ) -> tuple[tuple[Any, Any], Any]:
        """Place the dyad and add the motions of its links; its ports, and its placement."""
        ports = self.ports(motions)
        placed = self.dyad.place(*ports)
        rates = self.dyad.rates(*ports, placed, method) if order else _STILL
        sites = Sites(self.group.links, (self.port1.link, self.port2.link), *ports)
        self.mount.move(sites, motions, slides, placed, rates)
        return ports, placed

    def regularity(self, placed: Any) -> Real:
        """Distance (n,) from a dead point: 1 the best, 0 singular."""
        return self.dyad.regularity(placed)


def build(mechanism: Mechanism, group: Group, variant: int) -> Step:
    """Read the constants of this dyad from the mechanism."""
    a, b = group.links
    inner, first, second = (mechanism.joint(name) for name in (*group.inner, *group.outer))
    elements = Elements(
        port1=element(first, _other(first, a)),
        port2=element(second, _other(second, b)),
        outer_a=element(first, a),
        outer_b=element(second, b),
        inner_a=element(inner, a),
        inner_b=element(inner, b),
    )
    dyad, mount = KINDS[group.kind].read(elements, group, variant)
    return Step(group, variant, dyad, elements.port1, elements.port2, mount)


def _other(joint: Joint, link: int) -> int:
    return joint.links[1 - joint.links.index(link)]
