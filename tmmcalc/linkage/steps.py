"""How each kind of dyad hangs on the chain: its ports from solved links, its links from its placement.

A step reads the constants of a group once from the mechanism: where its outer joints sit on links of
the source chain (ports), and how the axes of its own links stand to the vectors of the dyad. The sliding
coordinate of a prismatic joint is measured from the guide link's point to the slider's; ``sign`` is -1
where the group's link carries the guide and the source link (or link b) the slider.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.linkage.dyads import PRP, RPP, RPR, RRP, RRR, Dyad
from tmmcalc.linkage.model import Joint, Mechanism
from tmmcalc.linkage.plane import Guide, LinkMotion, Plane, Point, Real, rotated
from tmmcalc.linkage.structure import Group

Motions = dict[int, LinkMotion]


class Slide(NamedTuple):
    """Coordinate of a prismatic joint and its first and second derivative; each real (n,) [m, ...]."""

    s: Real
    ds: Real
    dds: Real


Slides = dict[str, Slide]


class Rates(NamedTuple):
    """Rates x, y of a dyad and their derivatives; zero for positions only."""

    x: Real
    y: Real
    xx: Real
    yy: Real


class Seat(NamedTuple):
    """A joint as seen from one link: the link, and the joint's point and direction in its axes."""

    link: int
    point: complex
    direction: complex
    slider: bool  # this link is the slider of a prismatic joint


def seat(joint: Joint, link: int) -> Seat:
    """The joint's constants in the axes of this link."""
    side = joint.links.index(link)
    return Seat(link, joint.points[side], joint.directions[side], side == 0)


def _other(joint: Joint, link: int) -> int:
    return joint.links[1 - joint.links.index(link)]


@dataclass(frozen=True)
class Step:
    """One dyad of the chain. Subclasses say how its links move; ``group`` names it in messages."""

    group: Group
    variant: int  # sign as the spec gives it; 1 for the kinds with one assembly
    dyad: Dyad
    port1: Seat
    port2: Seat

    def ports(self, motions: Motions) -> tuple[Any, Any]:
        """States of the two ports on the links solved before."""
        return (
            _port(self.group.kind[0], self.port1, motions),
            _port(self.group.kind[2], self.port2, motions),
        )

    def move(self, motions: Motions, slides: Slides, ports: tuple[Any, Any], placed: Any, rates: Rates) -> None:
        """Add the motions of the group's links, and its sliding coordinates."""
        raise NotImplementedError


def _port(letter: str, at: Seat, motions: Motions) -> Point | Guide:
    motion = motions[at.link]
    return motion.point(at.point) if letter == "R" else motion.guide(at.point, at.direction)


def _carried(guide: LinkMotion, turn: complex, base: complex, at: Point) -> LinkMotion:
    """Motion of a link that keeps the constant turn (unit) to the guide's link."""
    turned = (guide.u, guide.u1, guide.u2) if turn == 1 else (guide.u * turn, guide.u1 * turn, guide.u2 * turn)
    return LinkMotion(base, *at, *turned, guide.omega, guide.eps)


def _slid(guide: Guide, s: Real, rate: Real, rate2: Real) -> Point:
    """State of the point at the coordinate s on a moving guide line (Coriolis term included)."""
    x = s * guide.e
    v = guide.v + 1j * guide.omega * x + rate * guide.e
    turning = (1j * guide.eps - guide.omega**2) * x + (rate2 + 2j * guide.omega * rate) * guide.e
    return Point(guide.r + x, v, guide.a + turning)


def _signed(sign: int, s: Real, rate: Real, rate2: Real) -> Slide:
    return Slide(s, rate, rate2) if sign > 0 else Slide(-s, -rate, -rate2)


@dataclass(frozen=True)
class RRRStep(Step):
    """RRR: both links turn about their outer pins."""

    pin_a: complex  # outer joint of a, in the axes of a
    pin_b: complex
    vector_a: complex  # outer to inner joint, in the axes of a
    vector_b: complex

    def move(self, motions: Motions, slides: Slides, ports: tuple[Any, Any], placed: Any, rates: Rates) -> None:
        """Base points are the outer pins."""
        a, b = self.group.links
        motions[a] = rotated(self.pin_a, ports[0], placed.a / self.vector_a, rates.x, rates.xx)
        motions[b] = rotated(self.pin_b, ports[1], placed.b / self.vector_b, rates.y, rates.yy)


@dataclass(frozen=True)
class RRPStep(Step):
    """RRP: rod a turns about its outer pin, slider b follows the guide; its base point is the inner pin."""

    pin_a: complex
    vector_a: complex
    inner_a: complex
    inner_b: complex
    turn: complex  # axes of b against the axes of the source link, unit
    shift: float  # from the slider's line point to the inner pin, along the guide [m]
    outer: str
    sign: int

    def move(self, motions: Motions, slides: Slides, ports: tuple[Any, Any], placed: Any, rates: Rates) -> None:
        """The rod carries the inner pin, the pin carries the slider."""
        a, b = self.group.links
        motions[a] = rotated(self.pin_a, ports[0], placed.a / self.vector_a, rates.x, rates.xx)
        pin = motions[a].point(self.inner_a)
        motions[b] = _carried(motions[self.port2.link], self.turn, self.inner_b, pin)
        slides[self.outer] = _signed(self.sign, placed.s - self.shift, rates.y, rates.yy)


@dataclass(frozen=True)
class RPRStep(Step):
    """RPR: both links turn alike, each about its own outer pin."""

    pin_a: complex
    pin_b: complex
    axis_b: complex  # direction of the line in the axes of b, unit
    turn: complex  # axes of a against the axes of b, unit
    shift: float
    inner: str
    sign: int

    def move(self, motions: Motions, slides: Slides, ports: tuple[Any, Any], placed: Any, rates: Rates) -> None:
        """Link b carries the direction, link a keeps a constant turn to it."""
        a, b = self.group.links
        u = placed.e if self.axis_b == 1 else placed.e / self.axis_b
        motions[b] = rotated(self.pin_b, ports[1], u, rates.x, rates.xx)
        motions[a] = _carried(motions[b], self.turn, self.pin_a, ports[0])
        slides[self.inner] = _signed(self.sign, placed.s - self.shift, rates.y, rates.yy)


@dataclass(frozen=True)
class PRPStep(Step):
    """PRP: two sliders, each turning with its own guide; the base point of both is the inner pin."""

    inner_a: complex
    inner_b: complex
    turn_a: complex
    turn_b: complex
    shift_a: float
    shift_b: float
    outer: tuple[str, str]
    signs: tuple[int, int]

    def move(self, motions: Motions, slides: Slides, ports: tuple[Any, Any], placed: Any, rates: Rates) -> None:
        """The inner pin slides on the first guide."""
        a, b = self.group.links
        on_guide = Guide(*_offset(ports[0], placed.offset1 - placed.s1 * placed.e1), *ports[0][3:])
        pin = _slid(on_guide, placed.s1, rates.x, rates.xx)
        motions[a] = _carried(motions[self.port1.link], self.turn_a, self.inner_a, pin)
        motions[b] = _carried(motions[self.port2.link], self.turn_b, self.inner_b, pin)
        slides[self.outer[0]] = _signed(self.signs[0], placed.s1 - self.shift_a, rates.x, rates.xx)
        slides[self.outer[1]] = _signed(self.signs[1], placed.s2 - self.shift_b, rates.y, rates.yy)


def _offset(guide: Guide, x: Plane) -> Point:
    """State of the point of the guide's link at the vector x from its reference point."""
    return Point(
        guide.r + x,
        guide.v + 1j * guide.omega * x,
        guide.a + (1j * guide.eps - guide.omega**2) * x,
    )


@dataclass(frozen=True)
class RPPStep(Step):
    """RPP: both links keep a constant turn to the guide's link; b slides on it, a is pinned."""

    pin_a: complex
    line_b: complex  # point of b's outer line, in the axes of b
    turn_a: complex
    turn_b: complex
    shift_a: float
    shift_b: float
    inner: str
    outer: str
    signs: tuple[int, int]  # of the inner and of the outer joint

    def move(self, motions: Motions, slides: Slides, ports: tuple[Any, Any], placed: Any, rates: Rates) -> None:
        """The base point of a is its pin, that of b its point on the guide."""
        a, b = self.group.links
        guide = motions[self.port2.link]
        s1 = placed.s1 - self.shift_b
        motions[a] = _carried(guide, self.turn_a, self.pin_a, ports[0])
        motions[b] = _carried(guide, self.turn_b, self.line_b, _slid(ports[1], s1, rates.x, rates.xx))
        slides[self.outer] = _signed(self.signs[1], s1, rates.x, rates.xx)
        slides[self.inner] = _signed(self.signs[0], placed.s2 - self.shift_a, rates.y, rates.yy)


def build(mechanism: Mechanism, group: Group, variant: int) -> Step:
    """Read the constants of this dyad from the mechanism."""
    return _BUILDERS[group.kind](mechanism, group, variant)


class _Sides(NamedTuple):
    """The joints of a dyad as seen from its own links and from the source chain."""

    port1: Seat
    port2: Seat
    outer_a: Seat
    outer_b: Seat
    inner_a: Seat
    inner_b: Seat


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


def _sign(own: Seat) -> int:
    return 1 if own.slider else -1


def _along(line: Seat, point: complex) -> complex:
    """The vector from the line's point to this point of the same link, in axes of the line."""
    return np.conj(line.direction) * (point - line.point)


def _rrr(mechanism: Mechanism, group: Group, variant: int) -> Step:
    s = _sides(mechanism, group)
    vector_a, vector_b = s.inner_a.point - s.outer_a.point, s.inner_b.point - s.outer_b.point
    dyad = RRR(abs(vector_a), abs(vector_b), variant)
    return RRRStep(group, variant, dyad, s.port1, s.port2, s.outer_a.point, s.outer_b.point, vector_a, vector_b)


def _rrp(mechanism: Mechanism, group: Group, variant: int) -> Step:
    s = _sides(mechanism, group)
    vector = s.inner_a.point - s.outer_a.point
    pin = _along(s.outer_b, s.inner_b.point)
    return RRPStep(
        group,
        variant,
        RRP(abs(vector), pin.imag, variant),
        s.port1,
        s.port2,
        s.outer_a.point,
        vector,
        s.inner_a.point,
        s.inner_b.point,
        s.port2.direction / s.outer_b.direction,
        pin.real,
        group.outer[1],
        _sign(s.outer_b),
    )


def _rpr(mechanism: Mechanism, group: Group, variant: int) -> Step:
    """The book measures s from the pivot of the guide link; variant +1 puts the slider's pivot ahead of it."""
    s = _sides(mechanism, group)
    shift = _along(s.inner_a, s.outer_a.point) - _along(s.inner_b, s.outer_b.point)
    sign = _sign(s.inner_a)
    return RPRStep(
        group,
        variant,
        RPR(shift.imag, variant * sign),
        s.port1,
        s.port2,
        s.outer_a.point,
        s.outer_b.point,
        s.inner_b.direction,
        s.inner_b.direction / s.inner_a.direction,
        shift.real,
        group.inner[0],
        sign,
    )


def _prp(mechanism: Mechanism, group: Group, variant: int) -> Step:
    s = _sides(mechanism, group)
    pin_a, pin_b = _along(s.outer_a, s.inner_a.point), _along(s.outer_b, s.inner_b.point)
    return PRPStep(
        group,
        variant,
        PRP(pin_a.imag, pin_b.imag),
        s.port1,
        s.port2,
        s.inner_a.point,
        s.inner_b.point,
        s.port1.direction / s.outer_a.direction,
        s.port2.direction / s.outer_b.direction,
        pin_a.real,
        pin_b.real,
        (group.outer[0], group.outer[1]),
        (_sign(s.outer_a), _sign(s.outer_b)),
    )


def _rpp(mechanism: Mechanism, group: Group, variant: int) -> Step:
    s = _sides(mechanism, group)
    turn_b = s.port2.direction / s.outer_b.direction
    d = s.inner_b.direction / s.outer_b.direction
    line = _along(s.outer_b, s.inner_b.point)
    pin = _along(s.inner_a, s.outer_a.point)
    return RPPStep(
        group,
        variant,
        RPP(d, line.imag, pin.imag),
        s.port1,
        s.port2,
        s.outer_a.point,
        s.outer_b.point,
        s.port2.direction * d / s.inner_a.direction,
        turn_b,
        pin.real,
        line.real,
        group.inner[0],
        group.outer[1],
        (_sign(s.inner_a), _sign(s.outer_b)),
    )


_BUILDERS = {"RRR": _rrr, "RRP": _rrp, "RPR": _rpr, "PRP": _prp, "RPP": _rpp}
