"""Random mechanisms that assemble by construction.

The plane comes first: the places of all joints are drawn at the start, dyad by dyad, with transmission
angles well away from zero; every link then gets axes of its own at a random place and angle, and the metric
is read off in them. So moving guides, offsets, ternary links, turned axes and guides on either side of a
prismatic joint all occur, and the start configuration is known exactly.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from tmmcalc.linkage.model import FRAME, Assembly, Grid, Input, Joint, Link, Mechanism, Output

KINDS = ("RRR", "RRP", "RPR", "PRP", "RPP")


@dataclass(frozen=True)
class RandomMechanism:
    """A mechanism with the configuration that it was built from, at ``mechanism.input.start``."""

    mechanism: Mechanism
    start: dict[int, tuple[complex, float]]  # link -> place of its origin, angle of its axes
    kinds: tuple[str, ...]  # kinds of the dyads in the order of attachment
    pairs: tuple[tuple[int, int], ...]  # their link numbers


def build(
    rng: np.random.Generator,
    kinds: Sequence[str] | None = None,
    *,
    prismatic_input: bool | None = None,
    span: float = np.radians(5.0),
    positions: int = 11,
) -> RandomMechanism:
    """Draw a crank (or a driven slider) and dyads of the given kinds, by default one to four of any kind.

    ``span`` is the input's travel from the start, in rad or in lengths of about the mechanism's size.
    """
    if kinds is None:
        kinds = rng.choice(KINDS, size=rng.integers(1, 5)).tolist()
    if prismatic_input is None:
        prismatic_input = bool(rng.random() < 0.25)
    plane = _Plane(rng)
    driver = plane.driven_slider() if prismatic_input else plane.crank()
    pairs = tuple(plane.dyad(kind) for kind in kinds)
    for link in plane.axes:
        if link != FRAME:
            plane.mark(f"P{link}", link, plane.nearby(plane.centre[link], 0.3, 0.8))
    return RandomMechanism(
        plane.mechanism(driver, span, positions),
        {link: axes for link, axes in plane.axes.items() if link != FRAME},
        tuple(kinds),
        pairs,
    )


def scenes(most: int = 4) -> SearchStrategy[RandomMechanism]:
    """Strategy of random mechanisms; shrinks towards fewer dyads and simpler kinds."""
    return st.builds(
        lambda seed, kinds: build(np.random.default_rng(seed), kinds),
        st.integers(0, 2**32 - 1),
        st.lists(st.sampled_from(KINDS), min_size=1, max_size=most),
    )


@dataclass
class _Plane:
    """The drawing at the start: axes of the links, joints and marked points, all in the fixed axes."""

    rng: np.random.Generator
    axes: dict[int, tuple[complex, float]] = field(default_factory=lambda: {FRAME: (0j, 0.0)})
    centre: dict[int, complex] = field(default_factory=lambda: {FRAME: 0j})
    points: dict[int, dict[str, complex]] = field(default_factory=lambda: {FRAME: {}})
    joints: list[Joint] = field(default_factory=list)
    sketch: dict[str, complex] = field(default_factory=dict)
    coordinate: float = 0.0

    def crank(self) -> str:
        """A crank about O with its pin A."""
        pivot = self.nearby(0j, 0.0, 0.3)
        crank = self.link(pivot)
        self.mark("A", crank, self.nearby(pivot, 0.3, 0.5))
        self.pin("O", FRAME, crank, pivot)
        self.coordinate = self.axes[crank][1]
        return "O"

    def driven_slider(self) -> str:
        """A slider on the frame, driven along its guide; its pin is A."""
        place = self.nearby(0j, 0.0, 0.3)
        slider = self.link(place)
        self.mark("A", slider, self.nearby(place, 0.0, 0.4))
        self.coordinate = self.slide("D1", FRAME, slider, place, self.angle())
        return "D1"

    def dyad(self, kind: str) -> tuple[int, int]:
        """Attach a dyad to two links of the source chain, the first of them moving."""
        moving = [link for link in self.axes if link != FRAME]
        one = int(self.rng.choice(moving[-3:]))
        two = int(self.rng.choice([link for link in self.axes if link != one]))
        if self.rng.random() < 0.5:
            one, two = two, one
        inner = self.nearby((self.centre[one] + self.centre[two]) / 2, 0.5, 1.5)
        pair = self.link(inner), self.link(inner)
        getattr(self, f"_{kind.lower()}")(one, two, *pair, inner)
        return pair

    def _rrr(self, one: int, two: int, a: int, b: int, inner: complex) -> None:
        direction = self.angle()
        first = inner + self.length() * np.exp(1j * direction)
        second = inner + self.length() * np.exp(1j * (direction + self.transmission()))
        self.pin(self.fresh(), one, a, first)
        self.pin(self.fresh(), a, b, inner)
        self.pin(self.fresh(), b, two, second)

    def _rrp(self, one: int, two: int, a: int, b: int, inner: complex) -> None:
        direction = self.angle()
        self.pin(self.fresh(), one, a, inner + self.length() * np.exp(1j * direction))
        self.pin(self.fresh(), a, b, inner)
        self.slide(self.fresh(), two, b, self.nearby(inner, 0, 0.4), direction + self.steep())

    def _rpr(self, one: int, two: int, a: int, b: int, inner: complex) -> None:
        direction = self.angle()
        first = inner + 0.6 * self.length() * np.exp(1j * direction)
        second = inner - 0.6 * self.length() * np.exp(1j * direction)
        self.pin(self.fresh(), one, a, first)
        self.slide(self.fresh(), a, b, self.nearby(first, 0, 0.4), direction + self.rng.uniform(-0.6, 0.6))
        self.pin(self.fresh(), b, two, second)

    def _prp(self, one: int, two: int, a: int, b: int, inner: complex) -> None:
        direction = self.angle()
        self.slide(self.fresh(), one, a, self.nearby(inner, 0, 0.4), direction)
        self.pin(self.fresh(), a, b, inner)
        self.slide(self.fresh(), b, two, self.nearby(inner, 0, 0.4), direction + self.transmission())

    def _rpp(self, one: int, two: int, a: int, b: int, inner: complex) -> None:
        direction = self.angle()
        pivot = self.nearby(inner, 0.2, 0.8)
        self.pin(self.fresh(), one, a, pivot)
        self.slide(self.fresh(), a, b, self.nearby(pivot, 0, 0.4), direction)
        self.slide(self.fresh(), b, two, self.nearby(inner, 0, 0.4), direction + self.transmission())

    def link(self, centre: complex) -> int:
        """A new link with axes of its own, at a random place and angle near the centre."""
        number = len(self.axes)
        self.axes[number] = (self.nearby(centre, 0, 0.7), self.angle())
        self.centre[number] = centre
        self.points[number] = {}
        return number

    def mark(self, name: str, link: int, place: complex) -> None:
        """Name a point of a link."""
        self.points[link][name] = self.own(link, place)
        if link != FRAME:
            self.sketch[name] = place

    def pin(self, name: str, one: int, two: int, place: complex) -> None:
        """A revolute joint here, its links in either order."""
        if self.rng.random() < 0.5:
            one, two = two, one
        self.mark(name, one, place)
        self.mark(name, two, place)
        self.joints.append(Joint(name, "revolute", (one, two), (self.own(one, place), self.own(two, place))))

    def slide(self, name: str, one: int, two: int, through: complex, angle: float) -> float:
        """A prismatic joint along the line through this place, the guide on either link; its coordinate."""
        slider, guide = (one, two) if self.rng.random() < 0.5 else (two, one)
        along = np.exp(1j * angle)
        s = float(self.rng.uniform(0.3, 1.5) * self.rng.choice([-1, 1]))
        ends = (self.own(slider, through), self.own(guide, through - s * along))
        directions = tuple(complex(along * np.exp(-1j * self.axes[link][1])) for link in (slider, guide))
        self.joints.append(Joint(name, "prismatic", (slider, guide), ends, (directions[0], directions[1])))
        return s

    def own(self, link: int, place: complex) -> complex:
        """A place of the plane in the axes of the link."""
        origin, angle = self.axes[link]
        return complex((place - origin) * np.exp(-1j * angle))

    def fresh(self) -> str:
        return f"J{len(self.joints)}"

    def angle(self) -> float:
        return float(self.rng.uniform(-np.pi, np.pi))

    def length(self) -> float:
        return float(self.rng.uniform(0.8, 2.0))

    def transmission(self) -> float:
        """An angle between 45 and 135 degrees, to either side."""
        return float(self.rng.uniform(0.25, 0.75) * np.pi * self.rng.choice([-1, 1]))

    def steep(self) -> float:
        """Angle of a guide with its rod: at most 45 degrees, either way along."""
        return float(self.rng.uniform(-0.25, 0.25) * np.pi + np.pi * self.rng.integers(0, 2))

    def nearby(self, centre: complex, least: float, most: float) -> complex:
        return complex(centre + self.rng.uniform(least, most) * np.exp(1j * self.angle()))

    def mechanism(self, driver: str, span: float, positions: int) -> Mechanism:
        links = [Link(number, self.points[number]) for number in self.axes]
        return Mechanism(
            links[0],
            tuple(links[1:]),
            tuple(self.joints),
            Input(driver, float(self.rng.uniform(0.5, 5)), float(self.rng.uniform(-2, 2)), self.coordinate),
            (Output(point=f"P{links[-1].id}", direction=self.angle()),),
            Grid(positions=positions, span=span),
            Assembly(sketch=dict(self.sketch)),
        )
