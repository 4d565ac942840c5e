"""Reduced inertia of a linkage and its exact derivative (textbook 3.39-3.41), and the static lumping of rods."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.plane import Real, square
from tmmcalc.linkage.chain import Configuration
from tmmcalc.linkage.loading import Body, Loading
from tmmcalc.linkage.model import FRAME, Mechanism


def reduced_inertia(bodies: Sequence[Body], configuration: Configuration, n: int) -> tuple[Real, Real]:
    """J = sum m |S'|^2 + J_S w'^2 and dJ/dx = 2 sum m S'.S'' + J_S w' w'', each (n,), against the input coordinate."""
    inertia, slope = np.zeros(n), np.zeros(n)
    for body in bodies:
        motion = configuration.motions[body.link]
        if body.mass:
            at = motion.point(body.center)
            inertia = inertia + body.mass * square(at.v)
            slope = slope + 2 * body.mass * (np.conj(at.v) * at.a).real
        if body.inertia:
            inertia = inertia + body.inertia * motion.omega**2
            slope = slope + 2 * body.inertia * motion.omega * motion.eps
    return inertia, slope


def slope_size(bodies: Sequence[Body], configuration: Configuration, n: int) -> Real:
    """Sum of the magnitudes of all that makes dJ/dx (n,)."""
    size = np.zeros(n)
    for body in bodies:
        motion = configuration.motions[body.link]
        at = motion.point(body.center)
        size = size + 2 * body.mass * np.abs(at.v) * np.abs(at.a)
        size = size + 2 * body.inertia * np.abs(motion.omega * motion.eps)
    return size


def rods_of(mechanism: Mechanism, loading: Loading) -> tuple[int, ...]:
    """Links with mass that hang on two pins, neither of them in the frame: connecting rods."""
    heavy = {body.link for body in loading.bodies if body.mass > 0}
    rods = []
    for link in mechanism.links:
        joints = [joint for joint in mechanism.joints if link.id in joint.links]
        pins = all(joint.kind == "revolute" and FRAME not in joint.links for joint in joints)
        if link.id in heavy and len(joints) == 2 and pins:
            rods.append(link.id)
    return tuple(rods)


def lumped(mechanism: Mechanism, loading: Loading, rods: tuple[int, ...]) -> tuple[Body, ...]:
    """The bodies with the mass of every rod placed in its two pins: m_A = m l_BS/l, m_B = m l_AS/l (3.42).

    Mass and centre of mass along the rod are kept, the moment of inertia is not (textbook 3.3.3.2).
    """
    bodies: list[Body] = []
    for body in loading.bodies:
        bodies += _in_pins(mechanism, body) if body.link in rods else [body]
    return tuple(bodies)


def _in_pins(mechanism: Mechanism, body: Body) -> list[Body]:
    joints = [joint for joint in mechanism.joints if body.link in joint.links]
    a, b = (joint.points[joint.links.index(body.link)] for joint in joints)
    share = ((body.center - a) * (b - a).conjugate()).real / abs(b - a) ** 2  # of the mass that goes to b
    return [Body(body.link, body.mass * (1 - share), 0.0, a), Body(body.link, body.mass * share, 0.0, b)]
