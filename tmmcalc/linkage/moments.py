"""The equations of equilibrium of every link, with their terms (textbook 3.2.3).

Moments are taken about the inner hinge of a dyad, where its inner reaction has none and R^T of the outer pin is left;
of a dyad with an inner prismatic pair about the link's own outer pin, or else about its slider's point; of the input
link and of links of other groups about their first joint.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from math import degrees

import numpy as np

from tmmcalc.core.plane import Plane, Real, cross
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.wrench import seat_of
from tmmcalc.linkage.freebody import FreeBody, link_bodies, solved
from tmmcalc.linkage.model import Joint, Mechanism
from tmmcalc.linkage.structure import Structure

NOTHING = 1e-14  # of the largest force or couple: less is not told


@record
class EquilibriumTerm:
    """What acts on a link, and its moment about the point that the moments of the link are taken about."""

    link: int = quantity("link", "the link that it acts on")
    name: str = quantity("name", "the force or couple in letter and index")
    kind: str = quantity("kind", "load, weight, inertia, spring, damper, reaction, friction or drive")
    joint: str = quantity("joint", "of a reaction or friction: the joint")
    force: float | None = quantity("force[N]", "size of the force")  # None: a couple
    direction: float | None = quantity("direction[deg]", "direction of the force from x")
    arm: float | None = quantity("arm[m]", "arm of the force, positive if it turns counter-clockwise")
    moment: float = quantity("moment[N*m]", "its moment, counter-clockwise")
    x: float | None = quantity("x[m]", "x of a point of its line")
    y: float | None = quantity("y[m]", "y of a point of its line")
    force_x: float | None = quantity("force_x[N]", "force along x")
    force_y: float | None = quantity("force_y[N]", "force along y")


@record
class LinkEquilibrium:
    """A link in equilibrium: the joint that moments are taken about, the terms, and what is left of their sums."""

    link: int
    about: str
    terms: tuple[EquilibriumTerm, ...]
    force_left: float = quantity("force_left[N]", "size of the sum of the forces on the link")
    moment_left: float = quantity("moment_left[N*m]", "sum of the moments on the link")


def equilibria(statics: Statics, theta: Real, side: Real) -> list[tuple[LinkEquilibrium, ...]]:
    """Every moving link at theta (n,); where friction jumps ``side`` (n,) -1 is the limit before, +1 after."""
    found = solved(statics, theta, side)
    chain = statics.scene.chain
    joints = {link.id: moments_about(chain.mechanism, chain.structure, link.id) for link in chain.mechanism.links}
    poles = {
        k: np.broadcast_to(seat_of(joint, found.place.configuration).r, theta.shape) for k, joint in joints.items()
    }
    return [tuple(_equilibria(link_bodies(found, row), joints, poles, row)) for row in range(len(theta))]


def _equilibria(
    bodies: tuple[FreeBody, ...], joints: dict[int, Joint], poles: dict[int, Plane], row: int
) -> Iterator[LinkEquilibrium]:
    force = max((abs(f.value) for body in bodies for f in body.forces), default=0.0)
    couple = max((abs(c.value) for body in bodies for c in body.couples), default=0.0)
    for body in bodies:
        (link,) = body.links
        terms = tuple(_terms(body, complex(poles[link][row]), NOTHING * force, NOTHING * couple))
        left = abs(body.vertices[-1])
        yield LinkEquilibrium(link, joints[link].name, terms, left, sum(term.moment for term in terms))


def moments_about(mechanism: Mechanism, structure: Structure, link: int) -> Joint:
    """The joint that the moments of a link are taken about."""
    own = [joint for joint in mechanism.joints if link in joint.links]
    group = next((group for group in structure.groups if link in group.links), None)
    if group is None:
        return mechanism.joint(mechanism.input.joint)
    if not group.kind:
        return own[0]
    inner = mechanism.joint(group.inner[0])
    outer = mechanism.joint(group.outer[group.links.index(link)])
    return outer if inner.kind == "prismatic" and outer.kind == "revolute" else inner


def _terms(body: FreeBody, pole: complex, least: float, least_couple: float) -> Iterator[EquilibriumTerm]:
    (link,) = body.links
    for f in body.forces:
        size = abs(f.value)
        if size > least:
            moment = float(cross(f.at - pole, f.value))
            name, direction = f"{f.letter}{f.index}", degrees(cmath.phase(f.value))
            at = (f.at.real, f.at.imag, f.value.real, f.value.imag)
            yield EquilibriumTerm(link, name, f.kind, f.joint, size, direction, moment / size, moment, *at)
    for c in body.couples:
        if abs(c.value) > least_couple:
            yield EquilibriumTerm(
                link, f"{c.letter}{c.index}", c.kind, c.joint, None, None, None, c.value, *4 * (None,)
            )
