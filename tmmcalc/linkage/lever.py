"""Zhukovsky's lever: the balancing moment from velocities and given forces alone (textbook 3.2.8).

The plan of velocities is turned by 90 degrees, here clockwise, and every given force F is applied at the end of the
turned velocity -i v of its point. Its moment about the pole is its power:

    (-i v) x F = Re(conj(v) F)                        sum of F h + F_bal h_bal = 0

A couple M on a link is a pair of forces M/l at two points of the link a distance l apart, on the vertices of these
points. Ideal reactions do no work together and stay away; friction of the pairs is given, as the force analysis found
it. Velocities are those of the plans.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from math import degrees

import numpy as np

from tmmcalc.core.plane import LinkMotion, Real, cross
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.freebody import Acting, Couple, FreeBody, link_bodies, solved
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.pins import find_pins
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.numbers import round_scale

REACH = 100.0  # longest velocity of a pin on the lever [mm]
UNGIVEN = ("reaction", "drive")  # what is not applied to the lever
LEAST = 1e-12  # of an end of a vector from an axis [mm]: nearer is on it
LEAST_ARM = 1e-10  # [mm]: a shorter one is none
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


def working(forces: Sequence[LeverForce]) -> list[LeverForce]:
    """The forces of a lever without the pairs that stand for couples on links that do not turn."""
    turning = {(f.link, f.name, f.kind) for f in forces if f.point and abs(f.arm) > LEAST_ARM}
    return [f for f in forces if not f.point or (f.link, f.name, f.kind) in turning]


def levers(statics: Statics, kinematics: Kinematics, theta: Real, side: Real, mu: float) -> tuple[Lever, ...]:
    """The levers at theta (n,) to the scale ``mu`` [(m/s)/mm].

    Where friction jumps ``side`` (n,) -1 is the limit before, +1 after.
    """
    found = solved(statics, theta, side)
    mechanism, motions = statics.scene.chain.mechanism, found.place.configuration.motions
    links = {
        link.id: _Moving(motions[link.id], replaced_at(mechanism, link.id), kinematics.speed, theta.shape)
        for link in mechanism.links
    }
    drive = np.broadcast_to(found.state.drive, theta.shape)
    made = []
    for row in range(len(theta)):
        acting = [each for body in link_bodies(found, row) for each in _acting(body, links[body.links[0]], row)]
        applied = [each for each in acting if each[0].kind not in UNGIVEN]
        largest = max((abs(force) for *_, force, _ in applied), default=0.0)
        told = [each for each in acting if abs(each[3]) > NOTHING * largest]
        forces = tuple(_on_plan(*each, mu) for each in told if each[0].kind not in UNGIVEN)
        balancing = tuple(_on_plan(*each, mu) for each in told if each[0].kind == "drive")
        power = float(sum(cross(-1j * velocity, force) for *_, force, velocity in applied))
        made.append(Lever(forces, balancing, mu, power / mu, -power / kinematics.speed, float(drive[row])))
    return tuple(made)


def velocity_scale(statics: Statics, kinematics: Kinematics, theta: Real) -> float:
    """The round scale [(m/s)/mm] by which no velocity of a pin or named point at theta (n,) is longer than `REACH`."""
    motions = statics.scene.chain.evaluate(statics.scene.travel.x(theta)).motions
    pins = find_pins(statics.scene.chain.mechanism)
    rates = [np.max(np.abs(motions[k].point(p).v)) for pin in pins for k, p in pin.at.items()]
    return round_scale(float(max(rates)) * abs(kinematics.speed) / REACH)


End = tuple[str, complex]  # a point of a link by its name, in the axes of the link [m]


def replaced_at(mechanism: Mechanism, link: int) -> tuple[End, End]:
    """The two points of a link whose pair of forces stands for a couple on it, the first that of the tail.

    They are its pins that are the furthest apart, or one pin and a point 1 m from it.
    """
    own = [(pin.name, pin.at[link]) for pin in find_pins(mechanism) if link in pin.at]
    first = own[0] if own else ("0", 0j)
    other = max(own, key=lambda each: abs(each[1] - first[1]), default=first)
    return first, other if other[1] != first[1] else (f"{first[0]}+1m", first[1] + 1)


class _Moving:
    """A link at n positions: its place and velocity [m/s], those of the ends of what stands for couples."""

    def __init__(self, motion: LinkMotion, ends: tuple[End, ...], speed: float, shape: tuple[int, ...]) -> None:
        self.r, self.v, self.omega = (np.broadcast_to(z, shape).tolist() for z in (motion.r, motion.v, motion.omega))
        self.speed = speed
        self.ends = [(name, np.broadcast_to(motion.point(p).r, shape).tolist()) for name, p in ends]

    def velocity(self, at: complex, row: int) -> complex:
        """The velocity of the point of the link that stands at this place."""
        return (self.v[row] + 1j * self.omega[row] * (at - self.r[row])) * self.speed


Applied = tuple[Acting | Couple, int, str, complex, complex]  # what, its link, the point of a pair, force, velocity


def _acting(body: FreeBody, moving: _Moving, row: int) -> Iterator[Applied]:
    """All that acts on a link with the velocities of its points, each couple as two forces."""
    (link,) = body.links
    for force in body.forces:
        yield force, link, "", force.value, moving.velocity(force.at, row)
    for couple in body.couples:
        if couple.value:
            (tail, a), (head, b) = ((name, places[row]) for name, places in moving.ends)
            pair = 1j * couple.value / (b - a).conjugate()  # M/l along the left normal of the line
            yield couple, link, head, pair, moving.velocity(b, row)
            yield couple, link, tail, -pair, moving.velocity(a, row)


def _on_plan(what: Acting | Couple, link: int, point: str, force: complex, velocity: complex, mu: float) -> LeverForce:
    tip = complex(*(part if abs(part) > LEAST else 0.0 for part in (velocity.imag / mu, -velocity.real / mu)))
    arm = float(cross(tip, force / abs(force)))
    name = f"{what.letter}{what.index}"
    direction = degrees(cmath.phase(force))
    return LeverForce(name, what.kind, link, point, abs(force), direction, tip.real, tip.imag, arm, abs(force) * arm)
