"""The input link: reaction of the frame and what the drive must apply (textbook 3.14-3.16).

Coupling: a moment. Gear: the mesh force at the pitch point, inclined by the mesh angle, whose radial part pushes an
external wheel away from its mate whichever flank works. Driven slider: a force along the guide.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from tmmcalc.linkage.forces.friction import Rubbing, Solution, solve
from tmmcalc.linkage.forces.wrench import NOTHING, Slideway, Wrench
from tmmcalc.linkage.loading import Coupling, GearDrive
from tmmcalc.linkage.plane import Plane, Real

PASSES = 60


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
    moment = -load.moment
    if np.any(c):
        moment, stuck = _with_bearing(load, drive, c)
    else:
        stuck = np.zeros(np.shape(moment), bool)
    mesh = mesh_force(drive, moment)
    force = -(load.force + mesh)
    friction = -c * np.abs(force)
    n = np.size(moment)
    none = np.zeros(n, bool)
    limit = np.where(stuck, 0.0, 1.0)
    solution = Solution(np.zeros((1, n)), np.broadcast_to(stuck, n), limit, none, 1)
    return Driven(moment, mesh, Wrench(force, friction), friction, solution)


def _with_bearing(load: Wrench, gear: GearDrive, c: Real) -> tuple[Real, np.ndarray]:
    """The moment that also overcomes the bearing under the mesh force: M = M_0 + c |R(M)|, and where there is none."""
    ideal, slope = -load.moment, np.zeros(np.shape(load.moment))
    moment = ideal
    for _ in range(PASSES):
        force = -(load.force + mesh_force(gear, moment))
        size = np.abs(force)
        sense = np.where(moment >= 0, 1.0, -1.0)
        step = -sense * mesh_force(gear, sense)
        slope = c * (np.conj(force) * step).real / np.where(size > 0, size, 1.0)
        change = (ideal + c * size - moment) / (1 - slope)
        moment = moment + change
        if np.all(np.abs(change) <= 1e-14 * np.max(np.abs(moment), initial=1e-300)):
            break
    return moment, slope >= 1


def slider(load: Wrench, seat: Slideway, sense: float, c: Real, half: float | None) -> Driven:
    """A driven slider under a wrench about its point of the line; ``sense`` is +1 if its coordinate grows along e.

    ``c`` (n,) is the friction coefficient times the sense of the link's motion along e.
    """
    e = seat.e
    normal = 1j * e
    held = -(np.conj(normal) * load.force).real * normal
    frame = Wrench(held, -load.moment)
    pair = Rubbing(seat, c, frame, (NOTHING,), half)
    solution = solve([pair], np.size(load.moment)) if np.any(c) else None
    friction = solution.values[0] if solution else np.zeros(np.shape(load.moment))
    frame = Wrench(held + friction * e, frame.moment)
    force = -((np.conj(e) * load.force).real + friction)
    return Driven(sense * force, None, frame, friction, solution)
