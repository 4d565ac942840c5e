"""An independent force analysis: Newton's and Euler's equations of all links at once, in real time.

Positions and their derivatives come from the closure equations (``reference``), loads are written out here once more
from their physical definition, and per position one system of 3 n equations gives both unknown components of every
pair and the drive. Nothing is known of groups. Friction is a given number per pair; `law` says what it should be.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from reference import Motion, Placements, Reference, solve

from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.loading import GearDrive, Load, Loading, Pair, Spring
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.polynomial import Polynomial
from tmmcalc.linkage.loadlaws.quadratic import Quadratic
from tmmcalc.linkage.loadlaws.viscous import Viscous
from tmmcalc.linkage.model import FRAME, Joint, Mechanism
from tmmcalc.linkage.results import Kinematics

Array = NDArray[np.float64]
Plane = NDArray[np.complex128]
Given = list[tuple[int, Plane, Plane, Array]]  # link, force, place, moment


@dataclass(frozen=True)
class Place:
    """Place, velocity and acceleration of a point in time, each (n,)."""

    r: Plane
    v: Plane
    a: Plane


@dataclass(frozen=True)
class Motions:
    """The motion of all links in time, from the closure equations."""

    mechanism: Mechanism
    reference: Reference
    speed: float
    acceleration: float

    def angle(self, link: int) -> tuple[Array, Array, Array]:
        """Angle of the link's axes, angular velocity and acceleration."""
        if link == FRAME:
            return (np.zeros_like(self.reference.coordinate),) * 3
        return self.in_time(self.reference.angles[link])

    def in_time(self, motion: Motion) -> tuple[Array, Array, Array]:
        w, e = self.speed, self.acceleration
        return motion.value, motion.first * w, motion.second * w**2 + motion.first * e

    def point(self, link: int, p: complex) -> Place:
        """A point given in the link's own axes."""
        turned, w, e = self.angle(link)
        arm = p * np.exp(1j * turned)
        origin = (np.zeros_like(arm),) * 3
        if link != FRAME:
            origin = self.in_time(self.reference.points[link, "origin"])
        return Place(origin[0] + arm, origin[1] + 1j * w * arm, origin[2] + (1j * e - w**2) * arm)

    def carried(self, link: int, r: Plane) -> Plane:
        """Velocity of the point of the link that stands at r (n,) now."""
        base = self.point(link, 0j)
        return base.v + 1j * self.angle(link)[1] * (r - base.r)

    def line(self, joint: Joint) -> tuple[Plane, Plane]:
        """The slider's point of a prismatic joint and its direction."""
        slider = joint.links[0]
        return self.point(slider, joint.points[0]).r, joint.directions[0] * np.exp(1j * self.angle(slider)[0])

    def sliding(self, joint: Joint) -> tuple[Array, Array]:
        """Velocity and acceleration of the higher-numbered link against the other: in the pair, in time."""
        low, high = sorted(joint.links)
        if joint.kind == "revolute":
            (_, w1, e1), (_, w2, e2) = self.angle(low), self.angle(high)
            return w2 - w1, e2 - e1
        _, v, a = self.in_time(self.reference.slides[joint.name])
        return (v, a) if joint.links[0] == high else (-v, -a)

    def sense(self, joint: Joint, side: Array) -> Array:
        """Sense of that motion; at rest the one to come (``side`` +1) or gone by (-1), of a pair that never moves 0."""
        velocity, acceleration = self.sliding(joint)
        scale = np.max(np.abs(velocity))
        if scale < 1e-12 * abs(self.speed):
            return np.zeros_like(velocity)
        return np.sign(np.where(np.abs(velocity) < 1e-7 * scale, side * acceleration, velocity))


def placements(mechanism: Mechanism, kinematics: Kinematics) -> Placements:
    """Where the links stand at the first position, to start the independent solver from."""
    chain = chain_of(mechanism, kinematics)
    placed = chain.evaluate(kinematics.x[:1]).motions
    return {
        link.id: (complex(np.ravel(placed[link.id].point(0j).r)[0]), float(np.angle(np.ravel(placed[link.id].u)[0])))
        for link in mechanism.links
    }


def motions(mechanism: Mechanism, start: Placements, x: Array) -> Motions:
    """Follow a mechanism from its placement at ``x[0]``."""
    links = tuple(replace(link, points={**link.points, "origin": 0j}) for link in mechanism.links)
    marked = replace(mechanism, links=links)
    return Motions(mechanism, solve(marked, start, x), mechanism.input.speed, mechanism.input.acceleration)


Values = Mapping[str, Callable[[Array], Array]]  # of loads by name, against theta, where the law is not read here


def given_loads(at: Motions, loading: Loading, theta: Array, values: Values | None = None) -> Given:
    """All loads, those of inertia included."""
    n, found = len(theta), []
    for body in loading.bodies:
        place = at.point(body.link, body.center)
        found.append(
            (body.link, body.mass * (loading.gravity - place.a), place.r, -body.inertia * at.angle(body.link)[2])
        )
    for load in loading.loads:
        found += _load(at, load, theta, (values or {}).get(load.name))
    for spring in loading.springs:
        found += _spring(at, spring, n)
    return [entry for entry in found if entry[0] != FRAME]


def _load(at: Motions, load: Load, theta: Array, values: Callable[[Array], Array] | None) -> Given:
    n = len(theta)
    zero, none = np.zeros(n), np.zeros(n, complex)
    if load.kind == "moment":
        rate = at.angle(load.link)[1] - at.angle(load.against)[1]
        size = load.factor * _size(load, theta, rate, values)
        return [(load.link, none, none, size), (load.against, none, none, -size)]
    place = at.point(load.link, load.point)
    direction = load.direction * np.exp(1j * at.angle(load.follows)[0])
    rate = dot(direction, place.v - at.carried(load.against, place.r))
    force = load.factor * _size(load, theta, rate, values) * direction
    return [(load.link, force, place.r, zero), (load.against, -force, place.r, zero)]


def _size(load: Load, theta: Array, rate: Array, values: Callable[[Array], Array] | None) -> Array:
    law = load.law
    if values is not None:
        return values(theta)
    if isinstance(law, Constant):
        return np.full(len(theta), law.value)
    if isinstance(law, Polynomial):
        return np.polynomial.polynomial.polyval(theta, law.coefficients)
    if isinstance(law, Viscous):
        return -law.coefficient * rate
    assert isinstance(law, Quadratic)
    return -law.coefficient * rate * np.abs(rate)


def _spring(at: Motions, spring: Spring, n: int) -> Given:
    (a, b), zero, none = spring.links, np.zeros(n), np.zeros(n, complex)
    if spring.kind == "torsion":
        (angle_a, w_a, _), (angle_b, w_b, _) = at.angle(a), at.angle(b)
        wound = angle_b - angle_a - spring.free
        turns = np.round((wound.min() + wound.max()) / 2 / (2 * np.pi))  # the short way, at the middle of the swing
        moment = spring.stiffness * (wound - 2 * np.pi * turns) + spring.damping * (w_b - w_a)
        return [(a, none, none, moment), (b, none, none, -moment)]
    one, other = (at.point(link, p) for link, p in zip(spring.links, spring.points, strict=True))
    d = other.r - one.r
    rate = dot(d, other.v - one.v) / np.abs(d)
    pull = (spring.stiffness * (np.abs(d) - spring.free) + spring.damping * rate) * d / np.abs(d)
    return [(a, pull, one.r, zero), (b, -pull, other.r, zero)]


@dataclass(frozen=True)
class Solved:
    """Reactions (J, n) of the lower-numbered link on the higher-numbered one, about the pin or the slider's point."""

    reaction: Plane
    couple: Array
    drive: Array
    mesh: Plane


def newton_euler(
    at: Motions, given: Given, friction: Mapping[str, Array], gear: GearDrive | None = None, flank: Array | None = None
) -> Solved:
    """Solve 3 n equations a position; ``flank`` (n,) is the sign of the gear's moment, which sets its radial force."""
    mechanism, n = at.mechanism, len(at.reference.coordinate)
    row = {link.id: 3 * k for k, link in enumerate(mechanism.links)}
    size = 3 * len(mechanism.links)
    matrix, right = np.zeros((n, size, size)), np.zeros((n, size))

    def act(link: int, column: int, force: Plane, r: Plane, moment: Array | float = 0.0) -> None:
        if link != FRAME:
            k = row[link]
            matrix[:, k, column] += force.real
            matrix[:, k + 1, column] += force.imag
            matrix[:, k + 2, column] += (np.conj(r) * force).imag + moment

    def push(link: int, force: Plane, r: Plane, moment: Array | float = 0.0) -> None:
        if link != FRAME:
            k = row[link]
            right[:, k] -= force.real
            right[:, k + 1] -= force.imag
            right[:, k + 2] -= (np.conj(r) * force).imag + moment

    for link, force, r, moment in given:
        push(link, force, r, moment)
    one = np.ones(n, complex)
    for j, joint in enumerate(mechanism.joints):
        low, high = sorted(joint.links)
        value = friction.get(joint.name, np.zeros(n))
        for link, sign in ((high, 1.0), (low, -1.0)):
            if joint.kind == "revolute":
                r = at.point(joint.links[0], joint.points[0]).r
                act(link, 2 * j, sign * one, r)
                act(link, 2 * j + 1, sign * 1j * one, r)
                push(link, 0 * one, r, sign * value)
            else:
                r, e = at.line(joint)
                act(link, 2 * j, sign * 1j * e, r)
                act(link, 2 * j + 1, 0 * e, r, sign)
                push(link, sign * value * e, r)
    mesh = _drive(at, act, size - 1, gear, flank)
    solution = np.linalg.solve(matrix, right[..., None])[..., 0]
    return _read(at, solution, friction, mesh)


def _drive(at: Motions, act: Callable[..., None], column: int, gear: GearDrive | None, flank: Array | None) -> Plane:
    """The unknown drive on the input link, of a driven length on both; the mesh force (n,) of a unit moment."""
    joint = at.mechanism.joint(at.mechanism.input.joint)
    link, n = max(joint.links), len(at.reference.coordinate)
    none = np.zeros(n, complex)
    if joint.kind == "prismatic":
        r, e = at.line(joint)
        for driven, sense in zip(joint.links, (1.0, -1.0), strict=True):  # the guide takes what the slider is given
            act(driven, column, sense * e, r)
        return none
    if gear is None:
        act(link, column, none, none, 1.0)
        return none
    assert flank is not None
    centre = at.point(FRAME, joint.points[joint.links.index(FRAME)]).r
    to_mate = np.exp(1j * gear.pinion)
    away = 1.0 if gear.internal else -1.0
    unit = (1j * to_mate + away * flank * np.tan(gear.mesh_angle) * to_mate) / gear.radius * np.ones(n)
    act(link, column, unit, centre + gear.radius * to_mate)
    return unit


def _read(at: Motions, solution: Array, friction: Mapping[str, Array], mesh: Plane) -> Solved:
    joints, n = at.mechanism.joints, len(solution)
    reaction, couple = np.zeros((len(joints), n), complex), np.zeros((len(joints), n))
    for j, joint in enumerate(joints):
        first, second = solution[:, 2 * j], solution[:, 2 * j + 1]
        value = friction.get(joint.name, np.zeros(n))
        if joint.kind == "revolute":
            reaction[j], couple[j] = first + 1j * second, value
        else:
            _, e = at.line(joint)
            reaction[j], couple[j] = first * 1j * e + value * e, second
    return Solved(reaction, couple, solution[:, -1], mesh * solution[:, -1])


def law(at: Motions, pairs: tuple[Pair, ...], reaction: Plane, couple: Array, side: Array) -> dict[str, Array]:
    """What friction must be under these reactions: against the sliding; at rest, against that to come or gone by."""
    found = {}
    for pair in pairs:
        j = [joint.name for joint in at.mechanism.joints].index(pair.joint)
        joint = at.mechanism.joints[j]
        sense = at.sense(joint, side)
        if joint.kind == "revolute":
            found[pair.joint] = -pair.friction * pair.radius * np.abs(reaction[j]) * sense
            continue
        _, e = at.line(joint)
        size = np.abs(dot(1j * e, reaction[j]))
        if pair.length is not None:
            size = np.maximum(size, 2 * np.abs(couple[j]) / pair.length)
        found[pair.joint] = -pair.friction * size * sense
    return found


def dot(a: Plane, b: Plane) -> Array:
    return (np.conj(a) * b).real
