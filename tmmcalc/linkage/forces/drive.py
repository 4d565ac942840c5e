"""The input link: reaction of the frame and what the drive must apply (textbook 3.14-3.16).

Coupling: a moment. Gear: the mesh force at the pitch point, inclined by the mesh angle, whose radial part pushes an
external wheel away from its mate whichever flank works. Driven slider: a force along the guide.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Real, cross, square
from tmmcalc.linkage.forces.wrench import NOTHING, Slideway, Wrench
from tmmcalc.linkage.loading import Coupling, GearDrive

if TYPE_CHECKING:
    from tmmcalc.linkage.forces.friction import Solution


class Driven(NamedTuple):
    """What holds the input link: drive (n,) [N*m or N], mesh force (n,) [N], wrench of the frame about its joint."""

    drive: Real  # along the positive input coordinate
    mesh: Plane | None
    frame: Wrench
    friction: Real  # part of it: about the pin [N*m] or along the line [N]
    solution: Solution | None  # of the friction with the frame


def mesh_force(gear: GearDrive, moment: Real) -> Plane:
    """Force (n,) of the pinion on the crank's gear that makes the moment (n,) about its axis."""
    beta = np.exp(1j * gear.pinion)
    radial = math.tan(gear.mesh_angle) * (1.0 if gear.internal else -1.0)
    return (moment * 1j + np.abs(moment) * radial) * beta / gear.radius


def crank(load: Wrench, drive: Coupling | GearDrive, c: Real) -> Driven:
    """A crank under a wrench about its pivot; c (n,) is f r of the main bearing times the sense of rotation."""
    if isinstance(drive, Coupling):
        size = np.abs(load.force)
        friction = -c * size
        return Driven(-load.moment - friction, None, Wrench(-load.force, friction), friction, None)
    moment, solution = _with_bearing(load, drive, c) if np.any(c) else (-load.moment, None)
    mesh = mesh_force(drive, moment)
    force = -(load.force + mesh)
    friction = -c * np.abs(force)
    return Driven(moment, mesh, Wrench(force, friction), friction, solution)


def _with_bearing(load: Wrench, gear: GearDrive, c: Real) -> tuple[Real, Solution]:
    """The moment M = M_0 + c |R(M)| that also overcomes the bearing, and what part of its friction can be overcome.

    Along the motion M grows from M_0 with the friction. On either flank of the teeth R = -(L + M u), so M is a root of
    (M - M_0)^2 = c^2 |L + M u|^2; that path goes to infinity where the friction circle reaches the line of action, or
    folds back.
    """
    from tmmcalc.linkage.forces.friction import Solution  # only what rubs needs it

    sense, tau, shape = np.where(c < 0, -1.0, 1.0), np.asarray(c**2), np.shape(load.moment)
    ideal, own = -sense * load.moment, square(load.force)
    braking = ideal + np.sqrt(tau * own) <= 0
    u = np.where(braking, -mesh_force(gear, -sense), mesh_force(gear, sense))
    along, across, bare = (np.conj(load.force) * u).real, cross(load.force, u) ** 2, square(load.force + ideal * u)
    with np.errstate(divide="ignore", invalid="ignore"):
        end = np.where(ideal + along / square(u) > 0, 1 / square(u), bare / across)
        end = np.where((ideal < 0) & (own + ideal * along <= 0), ideal**2 / own, end)
        limit = np.where(braking | (tau < end), 1.0, np.sqrt(end / tau))
        a, h, q = 1 - tau * square(u), ideal + tau * along, ideal**2 - tau * own
        root = np.sqrt(np.maximum(tau * bare - tau**2 * across, 0.0))
        moment = np.where(limit < 1, ideal, np.where(h < 0, q / (h - root), (h + root) / a))
    return sense * moment, Solution(np.zeros((1, *shape)), limit < 1, limit, np.zeros(shape, bool), np.ones(shape), 1)


def slider(load: Wrench, seat: Slideway, sense: float, c: Real, half: float | None) -> Driven:
    """A driven slider under a wrench about its point of the line; ``sense`` is +1 if its coordinate grows along e.

    ``c`` (n,) is the friction coefficient times the sense of the link's motion along e.
    """
    e = seat.e
    normal = 1j * e
    held = -(np.conj(normal) * load.force).real * normal
    frame = Wrench(held, -load.moment)
    solution = _rubbing(seat, c, frame, half) if np.any(c) else None
    friction = solution.values[0] if solution else np.zeros(np.shape(load.moment))
    frame = Wrench(held + friction * e, frame.moment)
    force = -((np.conj(e) * load.force).real + friction)
    return Driven(sense * force, None, frame, friction, solution)


def _rubbing(seat: Slideway, c: Real, frame: Wrench, half: float | None) -> Solution:
    """Friction of a driven slider, whose normal force it does not change."""
    from tmmcalc.linkage.forces.friction import Rubbing, solve  # only what rubs needs it

    return solve([Rubbing(seat, c, frame, (NOTHING,), half)], np.shape(frame.moment))
