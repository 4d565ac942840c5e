"""What a kind of dyad must provide.

A dyad is a two-link Assur group: an inner joint between its links a and b and one outer joint of each
with the chain that is already solved. One file a kind: RRR, RRP, RPR, PRP, RPP (the letters are the
outer joint of a, the inner joint, the outer joint of b; PRR and PPR are RRP and RPP with a and b
exchanged). A kind is a named tuple of its metric, with its ``variant`` where it has two assemblies, and

1. ``read(elements, group, variant)``: the dyad of a mechanism, and the mount that ties its links to it;
2. ``margin(port1, port2)``: a smooth function of the ports, negative exactly where the dyad does not
   assemble [-];
3. ``place(port1, port2)``: stage 1, positions, for the chosen variant;
4. ``rates(port1, port2, placed, method)``: stages 2 and 3, from one plane vector equation c1 x + c2 y = w each;
5. ``regularity(placed)``: |sin| of the angle between the columns, 0 at a dead point;
6. ``limit``, ``gap``, ``dead_point``: in words, what holds the links at a limit position, by how much they miss
   each other, what makes a dead point;
7. ``alone()``: its mount without a mechanism.

Ports are `Point` for an outer revolute and `Guide` for an outer prismatic joint. A mount holds the constants that tie
the axes of the two links to the vectors of the dyad. The sliding coordinate of a prismatic joint is measured from the
guide link's point to the slider's; a ``sign`` is -1 where the group's own link carries the guide.
"""

from __future__ import annotations

from typing import Any, NamedTuple, Protocol

from tmmcalc.core.errors import StructureError
from tmmcalc.core.plane import Guide, LinkMotion, Point, Real
from tmmcalc.linkage.model import Joint
from tmmcalc.linkage.solvers import Method
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


class Sites(NamedTuple):
    """Where a dyad stands at the moment: its links a and b, the source links, the states of the ports."""

    links: tuple[int, ...]
    sources: tuple[int, int]
    port1: Any
    port2: Any


class Element(NamedTuple):
    """A pairing element, a joint as one link has it: the link, the joint's point and direction in its axes."""

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


def element(joint: Joint, link: int) -> Element:
    """The joint's constants in the axes of this link."""
    side = joint.links.index(link)
    return Element(link, joint.points[side], joint.directions[side], side == 0)


class Elements(NamedTuple):
    """The joints of a dyad as seen from the source chain (the ports) and from its own links."""

    port1: Element
    port2: Element
    outer_a: Element
    outer_b: Element
    inner_a: Element
    inner_b: Element


class Mount(Protocol):
    """The constants of one kind, and the motions they give."""

    def move(self, at: Sites, motions: Motions, slides: Slides, placed: Any, rates: Rates) -> None:
        """Add the motions of the group's links, and its sliding coordinates."""


class Dyad(Protocol):
    """One kind of dyad with its metric; ports and placements are those of the kind."""

    @classmethod
    def read(cls, elements: Elements, group: Group, variant: int) -> tuple[Dyad, Mount]:
        """The dyad of a mechanism with its mount; of a kind with one assembly the variant says nothing."""

    def margin(self, port1: Any, port2: Any) -> Real:
        """Smooth function, negative exactly where the links do not reach [-]; shape (n,)."""

    def place(self, port1: Any, port2: Any) -> Any:
        """Stage 1: the placement of both links for the chosen assembly variant."""

    def rates(self, port1: Any, port2: Any, placed: Any, method: Method) -> Rates:
        """Stages 2 and 3: the two rates and their derivatives."""

    def regularity(self, placed: Any) -> Real:
        """Distance from a dead point, 1 the best, 0 singular."""

    def limit(self, a: int | str, b: int | str, port1: Any, port2: Any) -> str:
        """What holds the links named a and b at a limit position; ports at that position."""

    def gap(self, a: int | str, b: int | str, port1: Any, port2: Any) -> str:
        """By how much the links named a and b miss each other; ports at one position."""

    def dead_point(self) -> str:
        """What makes a dead point."""

    def alone(self) -> tuple[Mount, complex | None]:
        """Its mount where the axes of the links stand along their vectors, and an inner pin in the axes of a.

        Slides are named by their letter's place.
        """


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


def signed(sign: int, s: Real, rate: Real, rate2: Real) -> Slide:
    """A coordinate that is counted along the line or against it."""
    return Slide(s, rate, rate2) if sign > 0 else Slide(-s, -rate, -rate2)


def length_of(vector: complex, link: int, group: Group) -> float:
    """Length [m] of a rod by the vector between its pins; raises `StructureError` for one of no length."""
    length = abs(vector)
    if length * length == 0:  # its square is what the positions are divided by
        raise StructureError(
            f"the two pins of link {link} in this group are at one place: the link is a rod of no length there",
            where=f"kinematics, group {group.name}",
            value=length,
            limit=0.0,
            remedy='give its points their distance, such as A = ["200 mm", 0]',
        )
    return length


def mm(length: float) -> str:
    """A length [m] as text."""
    return f"{length * 1000:.7g} mm"
