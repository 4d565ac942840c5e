"""Zhukovsky's lever of one position: the balancing moment from velocities and given forces alone (textbook 3.2.8).

The plan of velocities is turned by 90 degrees, here clockwise, and every given force F is applied at the end of the
turned velocity -i v of its point. Its moment about the pole is its power:

    (-i v) x F = Re(conj(v) F)                        sum of F h + F_bal h_bal = 0

A couple M on a link is a pair of forces M/l at two points of the link a distance l apart, on the vertices of these
points. Ideal reactions do no work together and stay away; friction of the pairs is given, as the force analysis found
it. Velocities are those of the plans.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from math import degrees

import numpy as np

from tmmcalc.core.plane import cross
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.freebody import Acting, Couple, FreeBody, link_bodies
from tmmcalc.linkage.instant import LinkState, in_time
from tmmcalc.linkage.pins import Pin, find_pins
from tmmcalc.linkage.results import Kinematics

UNGIVEN = ("reaction", "drive")  # what is not applied to the lever
LEAST = 1e-12  # of an end of a vector from an axis [mm]: nearer is on it
NOTHING = 1e-14  # of the largest force or couple: less is not told


@record
class LeverForce:
    """A force on the lever, at the end of a turned velocity; ``mu`` is the scale of the plan [(m/s)/mm]."""

    name: str = quantity("name", "the force or couple in letter and index")
    kind: str = quantity("kind", "load, weight, inertia, spring, damper or friction")
    link: int = quantity("link", "the link that it acts on")
    point: str = quantity("point", "of a couple's pair of forces: the point of the link that has this one")
    force: float = quantity("force[N]", "size of the force")
    direction: float = quantity("direction[deg]", "direction of the force from x")
    x: float = quantity("x[mm]", "x of the end of the turned velocity from the pole")
    y: float = quantity("y[mm]", "y of the end of the turned velocity from the pole")
    arm: float = quantity("arm[mm]", "arm of the force about the pole, positive if it turns counter-clockwise")
    moment: float = quantity("moment[N*mm]", "moment of the force about the pole")


@record
class Lever:
    """The lever of a position: its forces, and the drive that balances it beside that of the force analysis."""

    forces: tuple[LeverForce, ...]
    balancing: tuple[LeverForce, ...]  # those of the drive as the force analysis found it
    mu: float = quantity("mu_v[m/s/mm]", "scale of the plan of velocities", symbol=r"\mu_v")
    moment: float = quantity("moment_sum[N*mm]", "sum of the moments about the pole")
    drive: float  # that balances it [N*m or N]
    kinetostatic: float  # of the force analysis

    @property
    def difference(self) -> float:
        """Drive of the lever less that of the force analysis."""
        return self.drive - self.kinetostatic


def lever(statics: Statics, kinematics: Kinematics, theta: float, side: float, mu: float) -> Lever:
    """The lever at theta to the scale ``mu`` [(m/s)/mm]; where friction jumps ``side`` -1 is the limit before."""
    scene, states = statics.scene, _states(statics, kinematics, theta)
    pins = find_pins(scene.chain.mechanism)
    bodies = link_bodies(statics, theta, side)
    applied = [each for body in bodies for each in _applied(body, states, pins)]
    driving = [each for body in bodies for each in _driving(body, states, pins)]
    largest = max((abs(force) for *_, force, _ in applied), default=0.0)
    forces = tuple(_on_plan(*each, mu) for each in applied if abs(each[3]) > NOTHING * largest)
    balancing = tuple(_on_plan(*each, mu) for each in driving if abs(each[3]) > NOTHING * largest)
    power = sum(cross(-1j * velocity, force) for *_, force, velocity in applied)
    place = scene.place(np.array([theta]), side)
    drive = float(np.ravel(statics.solve(place, side).drive)[0])
    return Lever(forces, balancing, mu, float(power) / mu, -float(power) / kinematics.speed, drive)


def fastest(statics: Statics, kinematics: Kinematics, theta: float) -> float:
    """The largest velocity of a pin or named point at theta [m/s]."""
    states = _states(statics, kinematics, theta)
    pins = find_pins(statics.scene.chain.mechanism)
    return max((abs(states[k].point(p)[0]) for pin in pins for k, p in pin.at.items()), default=0.0)


def _states(statics: Statics, kinematics: Kinematics, theta: float) -> dict[int, LinkState]:
    scene = statics.scene
    motions = scene.chain.evaluate(scene.travel.x(np.array([theta]))).motions
    return {k: in_time(motion, kinematics) for k, motion in motions.items()}


Applied = tuple[Acting | Couple, int, str, complex, complex]  # what, its link, the point of a pair, force, velocity


def _applied(body: FreeBody, states: dict[int, LinkState], pins: tuple[Pin, ...]) -> Iterator[Applied]:
    """The given forces of a link with the velocities of their points, each couple as two."""
    return (each for each in _acting(body, states, pins) if each[0].kind not in UNGIVEN)


def _driving(body: FreeBody, states: dict[int, LinkState], pins: tuple[Pin, ...]) -> Iterator[Applied]:
    """What the drive does to a link, in the same way: its moment is a pair of forces as well."""
    return (each for each in _acting(body, states, pins) if each[0].kind == "drive")


def _acting(body: FreeBody, states: dict[int, LinkState], pins: tuple[Pin, ...]) -> Iterator[Applied]:
    """All that acts on a link with the velocities of the points, each couple as two forces."""
    (link,) = body.links
    state = states[link]
    for force in body.forces:
        yield force, link, "", force.value, _velocity(state, force.at)
    for couple in body.couples:
        if couple.value:
            (tail, a), (head, b) = _points(link, state, pins)
            pair = 1j * couple.value / (b - a).conjugate()  # M/l along the left normal of the line
            yield couple, link, head, pair, _velocity(state, b)
            yield couple, link, tail, -pair, _velocity(state, a)


def _velocity(state: LinkState, place: complex) -> complex:
    return state.point(state.own(place))[0]


def _points(link: int, state: LinkState, pins: tuple[Pin, ...]) -> tuple[tuple[str, complex], tuple[str, complex]]:
    """Two points of a link with their names: its pins that are the furthest apart, or one and a point 1 m from it."""
    own = [(pin.name, state.r + state.arm(pin.at[link])) for pin in pins if link in pin.at]
    first = own[0] if own else ("0", state.r)
    other = max(own, key=lambda each: abs(each[1] - first[1]), default=first)
    apart = abs(other[1] - first[1]) > 0
    return first, other if apart else (f"1 m from {first[0]}", first[1] + state.u)


def _on_plan(what: Acting | Couple, link: int, point: str, force: complex, velocity: complex, mu: float) -> LeverForce:
    tip = complex(*(part if abs(part) > LEAST else 0.0 for part in (velocity.imag / mu, -velocity.real / mu)))
    arm = float(cross(tip, force / abs(force)))
    name = f"{what.letter}{what.index}"
    direction = degrees(cmath.phase(force))
    return LeverForce(name, what.kind, link, point, abs(force), direction, tip.real, tip.imag, arm, abs(force) * arm)
