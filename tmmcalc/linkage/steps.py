"""How each kind of dyad hangs on the chain: read once from the mechanism.

A step knows where its outer joints sit on links of the source chain (the ports), the metric of the dyad, and
the mount that ties the axes of its own links to the dyad's vectors.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.plane import Guide, Point, Real
from tmmcalc.linkage import solvers
from tmmcalc.linkage.dyads import PRP, RPP, RPR, RRP, RRR, Dyad
from tmmcalc.linkage.dyads.rpr import RPRPlaced
from tmmcalc.linkage.model import Joint, Mechanism
from tmmcalc.linkage.mounts import (
    Motions,
    Mount,
    PRPMount,
    Rates,
    RPPMount,
    RPRMount,
    RRPMount,
    RRRMount,
    Sites,
    Slides,
)
from tmmcalc.linkage.structure import Group


class Seat(NamedTuple):
    """A joint as seen from one link: the link, and the joint's point and direction in its axes."""

    link: int
    point: complex
    direction: complex
    slider: bool  # this link is the slider of a prismatic joint

    def port(self, letter: str, motions: Motions) -> Point | Guide:
        """State of the outer joint on a solved link: a point for R, a guide for P."""
        motion = motions[self.link]
        return motion.point(self.point) if letter == "R" else motion.guide(self.point, self.direction)

    @property
    def sign(self) -> int:
        """+1 if the coordinate of the joint grows with this link's own advance along the line."""
        return 1 if self.slider else -1

    def along(self, point: complex) -> complex:
        """The vector from the line's point to this point of the same link, in axes of the line."""
        return self.direction.conjugate() * (point - self.point)


def seat(joint: Joint, link: int) -> Seat:
    """The joint's constants in the axes of this link."""
    side = joint.links.index(link)
    return Seat(link, joint.points[side], joint.directions[side], side == 0)


class Step(NamedTuple):
    """One dyad of the chain; ``group`` names it in messages."""

    group: Group
    variant: int  # sign as the spec gives it; 1 for the kinds with one assembly
    dyad: Dyad
    port1: Seat
    port2: Seat
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
        sites = Sites(self.group.links, (self.port1.link, self.port2.link), *ports)
        self.mount.move(sites, motions, slides, placed, rates(self.dyad, ports, placed, method) if order else _STILL)
        return ports, placed

    def regularity(self, placed: Any) -> Real:
        """Distance (n,) from a dead point: 1 the best, 0 singular."""
        reach = float(np.max(np.abs(placed.q))) if isinstance(placed, RPRPlaced) else 0.0
        return self.dyad.regularity(placed, reach)


_STILL = Rates(*(np.zeros(()) for _ in range(4)))


def rates(dyad: Dyad, ports: tuple[Any, Any], placed: Any, method: solvers.Method) -> Rates:
    """Stages 2 and 3 of a dyad: its two rates and their derivatives."""
    solve = method(*dyad.columns(placed))
    x, y = solve(dyad.velocity(*ports, placed))
    return Rates(x, y, *solve(dyad.acceleration(*ports, placed, x, y)))


class _Sides(NamedTuple):
    """The joints of a dyad as seen from its own links and from the source chain."""

    port1: Seat
    port2: Seat
    outer_a: Seat
    outer_b: Seat
    inner_a: Seat
    inner_b: Seat


def build(mechanism: Mechanism, group: Group, variant: int) -> Step:
    """Read the constants of this dyad from the mechanism."""
    sides = _sides(mechanism, group)
    dyad, mount = _BUILDERS[group.kind](sides, group, variant)
    return Step(group, variant, dyad, sides.port1, sides.port2, mount)


def _sides(mechanism: Mechanism, group: Group) -> _Sides:
    a, b = group.links
    inner, first, second = (mechanism.joint(name) for name in (*group.inner, *group.outer))
    return _Sides(
        seat(first, _other(first, a)),
        seat(second, _other(second, b)),
        seat(first, a),
        seat(second, b),
        seat(inner, a),
        seat(inner, b),
    )


def _other(joint: Joint, link: int) -> int:
    return joint.links[1 - joint.links.index(link)]


def _rrr(s: _Sides, group: Group, variant: int) -> tuple[Dyad, Mount]:
    vector_a, vector_b = s.inner_a.point - s.outer_a.point, s.inner_b.point - s.outer_b.point
    mount = RRRMount(s.outer_a.point, s.outer_b.point, vector_a, vector_b)
    return RRR(abs(vector_a), abs(vector_b), variant), mount


def _rrp(s: _Sides, group: Group, variant: int) -> tuple[Dyad, Mount]:
    vector = s.inner_a.point - s.outer_a.point
    pin = s.outer_b.along(s.inner_b.point)
    mount = RRPMount(
        pin_a=s.outer_a.point,
        vector_a=vector,
        inner_a=s.inner_a.point,
        inner_b=s.inner_b.point,
        turn=s.port2.direction / s.outer_b.direction,
        shift=pin.real,
        outer=group.outer[1],
        sign=s.outer_b.sign,
    )
    return RRP(abs(vector), pin.imag, variant), mount


def _rpr(s: _Sides, group: Group, variant: int) -> tuple[Dyad, Mount]:
    """Variant +1 puts the slider's pivot ahead of the guide link's, whichever of the two is link a."""
    shift = s.inner_a.along(s.outer_a.point) - s.inner_b.along(s.outer_b.point)
    mount = RPRMount(
        pin_a=s.outer_a.point,
        pin_b=s.outer_b.point,
        axis_b=s.inner_b.direction,
        turn=s.inner_b.direction / s.inner_a.direction,
        shift=shift.real,
        inner=group.inner[0],
        sign=s.inner_a.sign,
    )
    return RPR(shift.imag, variant * s.inner_a.sign), mount


def _prp(s: _Sides, group: Group, variant: int) -> tuple[Dyad, Mount]:
    pin_a, pin_b = s.outer_a.along(s.inner_a.point), s.outer_b.along(s.inner_b.point)
    mount = PRPMount(
        inner_a=s.inner_a.point,
        inner_b=s.inner_b.point,
        turn_a=s.port1.direction / s.outer_a.direction,
        turn_b=s.port2.direction / s.outer_b.direction,
        shift_a=pin_a.real,
        shift_b=pin_b.real,
        outer=(group.outer[0], group.outer[1]),
        signs=(s.outer_a.sign, s.outer_b.sign),
    )
    return PRP(pin_a.imag, pin_b.imag), mount


def _rpp(s: _Sides, group: Group, variant: int) -> tuple[Dyad, Mount]:
    d = s.inner_b.direction / s.outer_b.direction
    line, pin = s.outer_b.along(s.inner_b.point), s.inner_a.along(s.outer_a.point)
    mount = RPPMount(
        pin_a=s.outer_a.point,
        line_b=s.outer_b.point,
        turn_a=s.port2.direction * d / s.inner_a.direction,
        turn_b=s.port2.direction / s.outer_b.direction,
        shift_a=pin.real,
        shift_b=line.real,
        inner=group.inner[0],
        outer=group.outer[1],
        signs=(s.inner_a.sign, s.outer_b.sign),
    )
    return RPP(d, line.imag, pin.imag), mount


_BUILDERS = {"RRR": _rrr, "RRP": _rrp, "RPR": _rpr, "PRP": _prp, "RPP": _rpp}
