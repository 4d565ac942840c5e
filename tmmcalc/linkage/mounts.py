"""How the links of each kind of dyad move once the dyad is placed.

A mount holds the constants that tie the axes of the two links to the vectors of the dyad. The sliding
coordinate of a prismatic joint is measured from the guide link's point to the slider's; a ``sign`` is -1 where the
group's own link carries the guide.
"""

from __future__ import annotations

from typing import Any, NamedTuple, Protocol

from tmmcalc.core.plane import Guide, LinkMotion, Plane, Point, Real, rotated

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


class Sites(NamedTuple):
    """Where a dyad stands at the moment: its links a and b, the source links, the states of the ports."""

    links: tuple[int, ...]
    sources: tuple[int, int]
    port1: Any
    port2: Any


class Mount(Protocol):
    """The constants of one kind, and the motions they give."""

    def move(self, at: Sites, motions: Motions, slides: Slides, placed: Any, rates: Rates) -> None:
        """Add the motions of the group's links, and its sliding coordinates."""


def carried(guide: LinkMotion, turn: complex, base: complex, at: Point) -> LinkMotion:
    """Motion of a link that keeps the constant turn (unit) to the guide's link."""
    turned = (guide.u, guide.u1, guide.u2) if turn == 1 else (guide.u * turn, guide.u1 * turn, guide.u2 * turn)
    return LinkMotion(base, *at, *turned, guide.omega, guide.eps)


def slid(guide: Guide, s: Real, rate: Real, rate2: Real) -> Point:
    """State of the point at the coordinate s on a moving guide line (Coriolis term included)."""
    x = s * guide.e
    v = guide.v + 1j * guide.omega * x + rate * guide.e
    turning = (1j * guide.eps - guide.omega**2) * x + (rate2 + 2j * guide.omega * rate) * guide.e
    return Point(guide.r + x, v, guide.a + turning)


def _signed(sign: int, s: Real, rate: Real, rate2: Real) -> Slide:
    return Slide(s, rate, rate2) if sign > 0 else Slide(-s, -rate, -rate2)


class RRRMount(NamedTuple):
    """RRR: both links turn about their outer pins."""

    pin_a: complex  # outer joint of a, in the axes of a
    pin_b: complex
    vector_a: complex  # outer to inner joint, in the axes of a
    vector_b: complex

    def move(self, at: Sites, motions: Motions, slides: Slides, placed: Any, rates: Rates) -> None:
        """Base points are the outer pins."""
        a, b = at.links
        motions[a] = rotated(self.pin_a, at.port1, placed.a / self.vector_a, rates.x, rates.xx)
        motions[b] = rotated(self.pin_b, at.port2, placed.b / self.vector_b, rates.y, rates.yy)


class RRPMount(NamedTuple):
    """RRP: rod a turns about its outer pin, slider b follows the guide; its base point is the inner pin."""

    pin_a: complex
    vector_a: complex
    inner_a: complex
    inner_b: complex
    turn: complex  # axes of b against the axes of the source link, unit
    shift: float  # from the slider's line point to the inner pin, along the guide [m]
    outer: str
    sign: int

    def move(self, at: Sites, motions: Motions, slides: Slides, placed: Any, rates: Rates) -> None:
        """The rod carries the inner pin, the pin carries the slider."""
        a, b = at.links
        motions[a] = rotated(self.pin_a, at.port1, placed.a / self.vector_a, rates.x, rates.xx)
        pin = motions[a].point(self.inner_a)
        motions[b] = carried(motions[at.sources[1]], self.turn, self.inner_b, pin)
        slides[self.outer] = _signed(self.sign, placed.s - self.shift, rates.y, rates.yy)


class RPRMount(NamedTuple):
    """RPR: both links turn alike, each about its own outer pin."""

    pin_a: complex
    pin_b: complex
    axis_b: complex  # direction of the line in the axes of b, unit
    turn: complex  # axes of a against the axes of b, unit
    shift: float
    inner: str
    sign: int

    def move(self, at: Sites, motions: Motions, slides: Slides, placed: Any, rates: Rates) -> None:
        """Link b carries the direction, link a keeps a constant turn to it."""
        a, b = at.links
        u = placed.e if self.axis_b == 1 else placed.e / self.axis_b
        motions[b] = rotated(self.pin_b, at.port2, u, rates.x, rates.xx)
        motions[a] = carried(motions[b], self.turn, self.pin_a, at.port1)
        slides[self.inner] = _signed(self.sign, placed.s - self.shift, rates.y, rates.yy)


class PRPMount(NamedTuple):
    """PRP: two sliders, each turning with its own guide; the base point of both is the inner pin."""

    inner_a: complex
    inner_b: complex
    turn_a: complex
    turn_b: complex
    shift_a: float
    shift_b: float
    outer: tuple[str, str]
    signs: tuple[int, int]

    def move(self, at: Sites, motions: Motions, slides: Slides, placed: Any, rates: Rates) -> None:
        """The inner pin slides on the first guide."""
        a, b = at.links
        on_guide = Guide(*_offset(at.port1, placed.offset1 - placed.s1 * placed.e1), *at.port1[3:])
        pin = slid(on_guide, placed.s1, rates.x, rates.xx)
        motions[a] = carried(motions[at.sources[0]], self.turn_a, self.inner_a, pin)
        motions[b] = carried(motions[at.sources[1]], self.turn_b, self.inner_b, pin)
        slides[self.outer[0]] = _signed(self.signs[0], placed.s1 - self.shift_a, rates.x, rates.xx)
        slides[self.outer[1]] = _signed(self.signs[1], placed.s2 - self.shift_b, rates.y, rates.yy)


def _offset(guide: Guide, x: Plane) -> Point:
    """State of the point of the guide's link at the vector x from its reference point."""
    return Point(
        guide.r + x,
        guide.v + 1j * guide.omega * x,
        guide.a + (1j * guide.eps - guide.omega**2) * x,
    )


class RPPMount(NamedTuple):
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

    def move(self, at: Sites, motions: Motions, slides: Slides, placed: Any, rates: Rates) -> None:
        """The base point of a is its pin, that of b its point on the guide."""
        a, b = at.links
        guide = motions[at.sources[1]]
        s1 = placed.s1 - self.shift_b
        motions[a] = carried(guide, self.turn_a, self.pin_a, at.port1)
        motions[b] = carried(guide, self.turn_b, self.line_b, slid(at.port2, s1, rates.x, rates.xx))
        slides[self.outer] = _signed(self.signs[1], s1, rates.x, rates.xx)
        slides[self.inner] = _signed(self.signs[0], placed.s2 - self.shift_a, rates.y, rates.yy)
