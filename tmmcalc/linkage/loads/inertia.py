"""Loads of inertia of a body: -m a_S at its centre of mass and -J_S eps (textbook 3.1)."""

from __future__ import annotations

from typing import NamedTuple

from tmmcalc.core.plane import LinkMotion, Plane, Point, Real
from tmmcalc.linkage.loading import Body


class InertiaLoad(NamedTuple):
    """Force [N] at the centre of mass and couple [N*m], (n,) each."""

    force: Plane
    couple: Real
    at: Point  # state of the centre of mass


def inertia_load(body: Body, motion: LinkMotion, speed: float, acceleration: float) -> InertiaLoad:
    """The load of a body whose link moves so, at the input's speed and acceleration; in the precision of the motion."""
    at, w2 = motion.point(body.center), speed * speed
    a: Plane = at.a * w2 + at.v * acceleration
    return InertiaLoad(-body.mass * a, -body.inertia * (motion.eps * w2 + motion.omega * acceleration), at)
