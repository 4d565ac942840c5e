"""Velocity and acceleration polygons of one position: named vertices and the vectors between them.

The polygons of the grapho-analytical method (textbook 2.7), taken from the analytic values. A vertex is the tip
of the absolute velocity or acceleration of a point, drawn from the pole; points of the frame lie in the pole.

    v_B = v_A + v_BA                        two points of one link, (2.31)
    a_B = a_A + a_BA^n + a_BA^t             vertex n_k between the parts, k the link, (2.32), (2.33)
    v_An = v_Ak + v_n-k                     slider n on guide k, coinciding points A_n and A_k, (2.34)
    a_An = a_Ak + a_n-k + a^K               vertex k between the parts, a^K = 2 omega_k x v_n-k, (2.35)

Where they are asked for, the special point ``W3_2_4`` of a group of class III or IV has the vertex ``w3_2_4``.
Point ``D`` has the vertex ``d``. The pin ``A`` of slider 2 on the moving guide 3 has two: ``a2``, and ``a3`` for
the point of link 3 that coincides with it. A name that is taken keeps its capital letter.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import isnan

import numpy as np

from tmmcalc.linkage.chain import Configuration, chain_of
from tmmcalc.linkage.instant import LinkState, Place, in_time, turning_links
from tmmcalc.linkage.model import FRAME, Mechanism
from tmmcalc.linkage.pins import Pin, find_pins
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.special import Special, meeting, special_points
from tmmcalc.linkage.turning import slider_pin, turnings
from tmmcalc.linkage.vectors import Polygon, PolygonOverAll, Vector, VectorPolygons


def polygons(mechanism: Mechanism, result: Kinematics, position: int, *, special: bool = False) -> VectorPolygons:
    """The polygons of the position with this index, at the speed and acceleration of the result.

    Derivatives are the exact ones of the chain, whatever the method
    of the result. With ``special`` those of groups of class III and IV have their special points, each seen from the
    pole and from the pins of its legs. Raises `IndexError` for an index that the result does not have.
    """
    configuration = chain_of(mechanism, result).evaluate(np.atleast_1d(result.x[position]))
    plan = _planned(mechanism, result, configuration, 0)
    if special:
        for point in special_points(mechanism, result.structure):
            place = complex(meeting(configuration, point).r[0])
            if not isnan(place.real):
                plan.add_special(point, place)
    return plan.at(position)


def polygons_of_all(mechanism: Mechanism, result: Kinematics) -> tuple[PolygonOverAll, PolygonOverAll, tuple[str, ...]]:
    """The polygons of velocities and of accelerations over all positions, and the points in their poles."""
    configuration = chain_of(mechanism, result).evaluate(result.x)
    return _planned(mechanism, result, configuration, None).over_all()


def _planned(mechanism: Mechanism, result: Kinematics, configuration: Configuration, row: int | None) -> _Plan:
    """Both polygons at one of the positions; None: at all of them, with arrays (n,) for the numbers."""
    states = {k: in_time(motion, result, row) for k, motion in configuration.motions.items()}
    plan = _Plan(mechanism, result, states)
    plan.name_vertices()
    plan.add_turning()
    plan.add_sliding()
    plan.add_rest()
    return plan


class _Plan:
    """The two polygons while they grow."""

    def __init__(self, mechanism: Mechanism, result: Kinematics, states: dict[int, LinkState]) -> None:
        self.mechanism = mechanism
        self.result = result
        self.states = states
        self.pins = find_pins(mechanism)
        self.turning = turning_links(mechanism)
        self.sliding = [j for j in mechanism.joints if j.kind == "prismatic" and FRAME not in j.links]
        self.names: dict[Pin, str] = {}
        self.points: dict[str, str] = {}  # vertex -> the point whose motion it shows: B, of slider 2 at its pin A2
        self.guides: dict[str, tuple[Pin, str]] = {}  # joint -> the slider's pin, the vertex of the guide's point
        self.velocity: dict[str, Place] = {"p": 0j}
        self.acceleration: dict[str, Place] = {"pi": 0j}
        self.v_vectors: list[Vector] = []
        self.a_vectors: list[Vector] = []

    def name_vertices(self) -> None:
        """One vertex for every pin and point that moves, one more for the guide's point of a moving slider."""
        taken = {"p", "pi", *(f"n{link.id}" for link in self.mechanism.links), *self._coriolis_names()}
        for joint in self.sliding:
            pin = slider_pin(joint, self.pins)
            if pin not in self.names:
                name = f"{pin.name}{joint.links[0]}"
                self._add(pin, _free(name.lower(), taken), joint.links[0], name)
            vertex = _free(f"{pin.name.lower()}{joint.links[1]}", taken)
            self.guides[joint.name] = (pin, vertex)
            self.points[vertex] = f"{pin.name}{joint.links[1]}"
            guide = self.states[joint.links[1]]
            self.velocity[vertex], self.acceleration[vertex] = guide.point(guide.own(self._place(pin)))
        for pin in self.pins:
            if pin not in self.names and not pin.fixed:
                self._add(pin, _free(pin.name.lower(), taken, pin.name), next(iter(pin.at)), pin.name)

    def _coriolis_names(self) -> list[str]:
        turning = [j for j in self.sliding if j.links[1] in self.turning]
        return ["k"] if len(turning) == 1 else [f"k{j.links[0]}" for j in turning]

    def _place(self, pin: Pin) -> Place:
        link, p = next(iter(pin.at.items()))
        state = self.states[link]
        return state.r + state.arm(p)

    def _add(self, pin: Pin, vertex: str, link: int, name: str) -> None:
        self.names[pin], self.points[vertex] = vertex, name
        self.velocity[vertex], self.acceleration[vertex] = self.states[link].point(pin.at[link])

    def add_turning(self) -> None:
        """The parts of links that turn; that of the crank, which is at constant speed normal alone, if it has two."""
        crank = self.result.structure.input_link if self.result.turns else None
        for each in turnings(self.mechanism, self.result.structure, self.pins):
            if each.link == crank and not self.result.acceleration:
                continue
            if each.joint:
                pin, vertex = self.guides[each.joint]
                self._turn(each.link, each.base, vertex, self.states[each.link].own(self._place(pin)))
            else:
                self._turn(each.link, each.base, self.names[each.head], each.head.at[each.link])

    def _turn(self, link: int, base: Pin, head: str, p: Place) -> None:
        """Normal and tangential part of the acceleration of point p of a link about its attachment point."""
        state = self.states[link]
        tail, pole = self._vertex(base, "p"), self._vertex(base, "pi")
        arm = state.arm(p) - state.arm(base.at[link])
        self.acceleration[f"n{link}"] = self.acceleration[pole] - state.omega**2 * arm
        seen = self.points[head], self.points.get(tail, base.name)
        if not base.fixed:
            self.v_vectors.append(Vector(tail, head, "relative", link, *seen))
        self.a_vectors.append(Vector(pole, f"n{link}", "normal", link, *seen))
        self.a_vectors.append(Vector(f"n{link}", head, "tangential", link, *seen))

    def _vertex(self, pin: Pin, pole: str) -> str:
        return pole if pin.fixed else self.names[pin]

    def add_sliding(self) -> None:
        """Relative velocity; relative and Coriolis acceleration, the latter with its head in the slider's vertex."""
        coriolis = iter(self._coriolis_names())
        for joint in self.sliding:
            slider, guide = joint.links
            pin, tail = self.guides[joint.name]
            head = self.names[pin]
            seen = self.points[head], self.points[tail]
            self.v_vectors.append(Vector(tail, head, "sliding", slider, *seen))
            if guide not in self.turning:
                self.a_vectors.append(Vector(tail, head, "sliding", slider, *seen))
                continue
            k = next(coriolis)
            relative = self.velocity[head] - self.velocity[tail]
            self.acceleration[k] = self.acceleration[head] - 2j * self.states[guide].omega * relative
            self.a_vectors.append(Vector(tail, k, "sliding", slider, *seen))
            self.a_vectors.append(Vector(k, head, "coriolis", slider, *seen))

    def add_rest(self) -> None:
        """Other points of a link hang on its base: the lines of similarity; then the rays from the poles."""
        for link in sorted(self.turning & self.states.keys()):
            for tail, head in self._similar(link):
                for vectors in (self.v_vectors, self.a_vectors):
                    if not any({v.tail, v.head} == {tail, head} for v in vectors):
                        vectors.append(Vector(tail, head, "relative", link, self.points[head], self.points[tail]))
        points = [(vertex, next(iter(pin.at))) for pin, vertex in self.names.items()]
        points += [(vertex, self.mechanism.joint(name).links[1]) for name, (_, vertex) in self.guides.items()]
        for vertex, link in points:
            self.v_vectors.append(Vector("p", vertex, "absolute", link, self.points[vertex]))
            self.a_vectors.append(Vector("pi", vertex, "absolute", link, self.points[vertex]))

    def add_special(self, point: Special, place: complex) -> None:
        """The point of a basic link at this place, from the pole and from the pins of both legs."""
        state, vertex = self.states[point.link], point.name.lower()
        self.velocity[vertex], self.acceleration[vertex] = state.point(state.own(place))
        pins = (pin for leg in point.legs for pin in self.pins if leg.near.name in pin.joints)
        tails = [self.names[pin] for pin in pins if pin in self.names]
        for pole, vectors in (("p", self.v_vectors), ("pi", self.a_vectors)):
            vectors.append(Vector(pole, vertex, "special", point.link, point.name))
            vectors += [Vector(tail, vertex, "special", point.link, point.name, self.points[tail]) for tail in tails]

    def _similar(self, link: int) -> Iterator[tuple[str, str]]:
        """Pairs of vertices of a floating link, from its first pin to every other point."""
        own = [pin for pin in self.pins if link in pin.at]
        if any(pin.fixed for pin in own):
            return
        own.sort(key=lambda pin: not pin.joints)
        vertices = [self.names[pin] for pin in own]
        vertices += [v for name, (_, v) in self.guides.items() if self.mechanism.joint(name).links[1] == link]
        for head in vertices[1:]:
            yield vertices[0], head

    def at(self, position: int) -> VectorPolygons:
        """The plan that has numbers, as that of its position."""
        links = sorted(self.turning & self.states.keys())
        return VectorPolygons(
            position,
            Polygon("p", {name: complex(z) for name, z in self.velocity.items()}, tuple(self.v_vectors)),
            Polygon("pi", {name: complex(z) for name, z in self.acceleration.items()}, tuple(self.a_vectors)),
            self._fixed(),
            {link: float(self.states[link].omega) for link in links},
            {link: float(self.states[link].eps) for link in links},
        )

    def over_all(self) -> tuple[PolygonOverAll, PolygonOverAll, tuple[str, ...]]:
        """The plan that has arrays; what is the same at all positions, as the poles, has them too."""
        velocity, acceleration = (
            {name: np.broadcast_to(z, len(self.result.x)) for name, z in tips.items()}
            for tips in (self.velocity, self.acceleration)
        )
        return (
            PolygonOverAll("p", velocity, tuple(self.v_vectors)),
            PolygonOverAll("pi", acceleration, tuple(self.a_vectors)),
            self._fixed(),
        )

    def _fixed(self) -> tuple[str, ...]:
        """The points in the poles."""
        return tuple(pin.name.lower() for pin in self.pins if pin.fixed and pin.joints)


def _free(name: str, taken: set[str], otherwise: str = "") -> str:
    """The name, or its other form, or that with primes; and note it as taken."""
    chosen = name if name not in taken else otherwise or name
    while chosen in taken:
        chosen += "'"
    taken.add(chosen)
    return chosen
