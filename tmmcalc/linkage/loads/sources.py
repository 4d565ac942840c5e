"""Sources of load: each gives, at any configuration, forces and moments on links.

A source of order 0 depends on the position alone; one of order 1 or 2 is multiplied by the input speed omega or by
omega |omega|, so that one evaluation holds for every speed. Against a velocity v = v' omega the viscous force
-c v is -c v' of order 1, the quadratic one -c v' |v'| of order 2.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.plane import LinkMotion, Plane, Point, Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Configuration
from tmmcalc.linkage.loading import Body, Load, Loading, Spring
from tmmcalc.linkage.loadlaws.resistance import Resistance
from tmmcalc.linkage.model import FRAME
from tmmcalc.linkage.survey import Survey

FULL = 1e-3  # a swing that comes so near to a whole turn [rad] goes round


class Place(NamedTuple):
    """Some positions of the mechanism: theta along the motion (n,) and the configuration there.

    Where something jumps ``side`` (n,) tells which limit is meant: -1 that before, +1 that after.
    """

    theta: Real
    configuration: Configuration
    side: Real | float = 1.0


class Action(NamedTuple):
    """A force at a point of a link and a moment on it: the force (n,) [N], state of the point, moment (n,) [N*m]."""

    link: int
    force: Plane
    at: Point  # its velocity is the transfer function
    moment: Real

    @property
    def pure(self) -> bool:
        """Whether it is a moment alone."""
        return self.force is _NO_FORCE

    def power(self, configuration: Configuration) -> Real:
        """Power (n,) per unit of input speed: the reduced moment of this action (textbook 3.34)."""
        turning = self.moment * configuration.motions[self.link].omega if self.moment is not _ZERO else _ZERO
        return turning if self.pure else turning + (np.conj(self.force) * self.at.v).real


class Source(NamedTuple):
    """One cause of load: its name, its kind for sums and tables, its order in the speed, its actions."""

    name: str
    kind: str  # "load", "weight", "spring", "damper"
    order: int
    actions: Callable[[Place], list[Action]]

    def factor(self, speed: float) -> float:
        """What the actions are multiplied by at this input speed."""
        return speed * abs(speed) if self.order == 2 else speed**self.order


_ZERO = np.zeros(())
_NO_FORCE = np.zeros((), np.complex128)


def weights(loading: Loading) -> list[Source]:
    """The weights of all links as one source; none without gravity or mass."""
    heavy = [body for body in loading.bodies if body.mass > 0]
    if loading.gravity == 0 or not heavy:
        return []

    def actions(place: Place) -> list[Action]:
        motions = place.configuration.motions
        return [
            Action(b.link, np.asarray(b.mass * loading.gravity, np.complex128), motions[b.link].point(b.center), _ZERO)
            for b in heavy
        ]

    return [Source("weight", "weight", 0, actions)]


class InertiaLoad(NamedTuple):
    """Force [N] at the centre of mass and couple [N*m], (n,) each."""

    force: Plane
    couple: Real
    at: Point  # state of the centre of mass


def inertia_load(body: Body, motion: LinkMotion, speed: float, acceleration: float) -> InertiaLoad:
    """The inertia (3.1) of a body whose link moves so, at the input's speed and acceleration; in its precision."""
    at, w2 = motion.point(body.center), speed * speed
    a: Plane = at.a * w2 + at.v * acceleration
    return InertiaLoad(-body.mass * a, -body.inertia * (motion.eps * w2 + motion.omega * acceleration), at)


def inertia(bodies: tuple[Body, ...], speed: float, acceleration: float) -> Source:
    """Loads of inertia -m a_S and -J_S eps (3.1) at the input's speed and acceleration."""

    def actions(place: Place) -> list[Action]:
        result = []
        for body in bodies:
            force, couple, at = inertia_load(body, place.configuration.motions[body.link], speed, acceleration)
            result.append(Action(body.link, force, at, couple if body.inertia else _ZERO))
        return result

    return Source("inertia", "inertia", 0, actions)


def technological(load: Load, value: Callable[[Place], Real]) -> Source:
    """A load whose value [N or N*m] depends on the position, with its opposite on the link it pushes against."""

    def actions(place: Place) -> list[Action]:
        size = value(place)
        if load.kind == "moment":
            return _opposite(place, (load.link, load.against), size)
        return _forces(load, place, size * _direction(load, place))

    return Source(load.name, "load", 0, actions)


def resisting(load: Load) -> Source:
    """A resistance: against the velocity of its point along its direction, or of its link."""
    law = load.law
    assert isinstance(law, Resistance)

    def against(rate: Real) -> Real:
        return law.against(load.factor, rate)

    def actions(place: Place) -> list[Action]:
        motions = place.configuration.motions
        if load.kind == "moment":
            size = against(motions[load.link].omega - motions[load.against].omega)
            return _opposite(place, (load.link, load.against), size)
        direction = _direction(load, place)
        at = motions[load.link].point(load.point)
        other = same_place(motions[load.against], at)
        return _forces(load, place, against((np.conj(direction) * (at.v - other.v)).real) * direction)

    return Source(load.name, "load", law.order, actions)


def _direction(load: Load, place: Place) -> Plane:
    return load.direction * place.configuration.motions[load.follows].u


def _forces(load: Load, place: Place, force: Plane) -> list[Action]:
    """The force on the load's link and its opposite, in the same line, on the other."""
    at = place.configuration.motions[load.link].point(load.point)
    actions = [Action(load.link, force, at, _ZERO)]
    if load.against != FRAME:
        other = same_place(place.configuration.motions[load.against], at)
        actions.append(Action(load.against, -force, other, _ZERO))
    return actions


def same_place(other: LinkMotion, at: Point) -> Point:
    """State of the point of another link that stands where this point stands."""
    d = (at.r - other.r) / other.u
    return Point(at.r, other.v + d * other.u1, other.a + d * other.u2)


def springs(spring: Spring, dense: Survey) -> list[Source]:
    """The elastic and the damping part of a spring; raises `NoSolutionError` for one that is wound up turn by turn."""
    parts = []
    if spring.stiffness:
        elastic = _linear(spring, 0) if spring.kind == "linear" else _torsion(spring, *_winding(spring, dense))
        parts.append(Source(spring.name, "spring", 0, elastic))
    if spring.damping:
        damping = _linear(spring, 1) if spring.kind == "linear" else _torsion_damper(spring)
        parts.append(Source(spring.name, "damper", 1, damping))
    return parts


def _linear(spring: Spring, order: int) -> Callable[[Place], list[Action]]:
    (a, b), (p, q) = spring.links, spring.points

    def actions(place: Place) -> list[Action]:
        motions = place.configuration.motions
        one, other = motions[a].point(p), motions[b].point(q)
        d = other.r - one.r
        length = np.abs(d)
        if np.any(length == 0):
            raise NoSolutionError(
                "the ends of the spring meet, which leaves its direction open",
                where=f"{spring.name}, theta {float(np.broadcast_to(place.theta, d.shape)[length == 0][0]):.6g}",
                remedy="fasten it at other points",
            )
        e = d / length
        pull = spring.stiffness * (length - spring.free) if order == 0 else _stretching(e, one, other) * spring.damping
        pair = [(a, pull * e, one), (b, -pull * e, other)]
        return [Action(k, force, at, _ZERO) for k, force, at in pair if k != FRAME]

    return actions


def _stretching(e: Plane, one: Point, other: Point) -> Real:
    """Rate of the length, per unit of input speed."""
    return (np.conj(e) * (other.v - one.v)).real


def _winding(spring: Spring, dense: Survey) -> tuple[float, float]:
    """Angle between the links at the middle of their swing, and how far the spring is wound there, the short way."""
    one, other = (dense.angle(k) if k != FRAME else np.zeros(len(dense.x)) for k in spring.links)
    low, high = float(np.min(other - one)), float(np.max(other - one))
    if high - low > TURN - FULL:
        a, b = spring.links
        raise NoSolutionError(
            f"links {a} and {b} turn by {math.degrees(high - low):.4g} deg against each other, which winds the spring "
            "up without end",
            where=spring.name,
            value=high - low,
            limit=TURN,
            remedy="fasten a torsion spring between links that swing",
        )
    middle = (low + high) / 2
    return middle, math.remainder(middle - spring.free, TURN)


def _torsion(spring: Spring, middle: float, wound: float) -> Callable[[Place], list[Action]]:
    a, b = spring.links
    back = np.exp(-1j * middle)

    def actions(place: Place) -> list[Action]:
        motions = place.configuration.motions
        moment = spring.stiffness * (wound + np.angle(motions[b].u / motions[a].u * back))
        return _opposite(place, spring.links, moment)

    return actions


def _torsion_damper(spring: Spring) -> Callable[[Place], list[Action]]:
    a, b = spring.links

    def actions(place: Place) -> list[Action]:
        motions = place.configuration.motions
        return _opposite(place, spring.links, spring.damping * (motions[b].omega - motions[a].omega))

    return actions


def _opposite(place: Place, links: tuple[int, int], moment: Real) -> list[Action]:
    """A moment on the first link and its opposite on the second."""
    still = place.configuration.motions[FRAME].point(0j)
    return [Action(k, _NO_FORCE, still, m) for k, m in zip(links, (moment, -moment), strict=True) if k != FRAME]
