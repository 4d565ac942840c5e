"""All forces at points of the turn, for one follower with its guide and spring."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.formulas import (
    Mask,
    cam_torque,
    contact_force,
    driving_torque,
    friction_ratio,
    guide_forces,
    inclination,
    protrusion,
    resultant,
)
from tmmcalc.cams.forces.results import GuideFound
from tmmcalc.cams.forces.turn import Points
from tmmcalc.cams.laws.law import Number, Values
from tmmcalc.cams.task import CamTask, Loads
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.records import record


@record
class Carried:
    """What is the same all over the turn."""

    follower: Follower
    highest: float  # largest dS of the turn
    inertia: float  # m2 omega^2 or J2 omega^2
    stiffness: Number
    preload: Number
    friction: float  # f of the guide
    pivot: float  # mu of a rocker, f r/l2
    guide: GuideFound | None
    gap: float
    arm: float  # 1, of a rocker l2

    @property
    def rubs(self) -> bool:
        """Whether there is friction at all."""
        return bool(self.friction or self.pivot)


def carried(task: CamTask, follower: Follower, loads: Loads, stiffness: Number, preload: Number) -> Carried:
    """The follower with its guide; raises `UsageError` and `NoSolutionError` for a guide that there is not."""
    turns = follower.kind == "oscillating"
    return Carried(
        follower,
        task.program.highest,
        loads.mass * loads.speed**2,
        stiffness,
        preload,
        0.0 if turns else loads.friction,
        loads.pivot_friction * loads.pivot_radius / follower.rocker if turns else 0.0,
        None if turns else guide_of(task, follower, loads.friction),
        task.guide.gap,
        follower.rocker if turns else 1.0,
    )


def guide_of(task: CamTask, follower: Follower, friction: float) -> GuideFound | None:
    """H1, H2 and l of the guide; None if it is not given and nothing rubs (5.85).

    Raises `UsageError` where friction needs it, `NoSolutionError` where it has no length.
    """
    guide, roller = task.guide, 0.0 if follower.kind == "flat" else follower.roller
    lower = follower.start + task.program.highest + roller + guide.gap
    if guide.top is not None:
        length = guide.top - lower
        if length <= 0:
            raise NoSolutionError(
                f"the guide has no length: its upper edge H2 = {1e3 * guide.top:.6g} mm is not above the lower one, "
                f"H1 = {1e3 * lower:.6g} mm",
                where="cam_forces, guide",
                value=guide.top,
                limit=lower,
                remedy="a larger top in [cam.guide], a smaller start_distance or roller_radius",
            )
        return GuideFound(lower, guide.top, length)
    if guide.length is not None:
        return GuideFound(lower, lower + guide.length, guide.length)
    if friction:
        raise UsageError(
            "friction in the guide needs its length",
            where="cam_forces, guide",
            remedy="give top or length in [cam.guide]",
        )
    return None


class State(NamedTuple):
    """Forces at m points, each (m,)."""

    load: Values  # P_c or M_c
    sine: Values
    cosine: Values
    protrusion: Values  # q
    ratio: Values  # mu
    contact: Values  # R
    works: Mask  # it does not jam
    lower: Values  # N1, canonical; 0 without a guide
    upper: Values  # N2
    torque: Values  # -T, without friction
    driving: Values  # with friction
    rubbed: Values  # what friction takes, per radian


def state(of: Carried, at: Points) -> State:
    """All forces at points."""
    motion, follower = at.motion, of.follower
    load = resultant(motion, of.inertia, of.stiffness, of.preload, at.force, at.acceleration)
    sine, cosine = inclination(follower, motion)
    roller = 0.0 if follower.kind == "flat" else follower.roller
    q = protrusion(motion, of.highest, roller, of.gap)
    length = of.guide.length if of.guide else 0.0
    ratio = np.full(len(load), of.pivot)
    if follower.kind != "oscillating":
        ratio, _ = friction_ratio(follower, motion, sine, q, length, of.friction)
    contact, works = contact_force(load, cosine, ratio, at.sense, of.arm)
    lower, upper = guide_forces(follower, motion, contact, sine, q, length)
    driving = cam_torque(contact, cosine, motion, of.arm)
    rubbed = of.arm * ratio * np.abs(contact * motion[1])
    return State(
        load, sine, cosine, q, ratio, contact, works, lower, upper, driving_torque(load, motion), driving, rubbed
    )


def pivot_force(follower: Follower, motion: Values, contact: Values, sine: Values, cosine: Values) -> Values:
    """Force of the frame on the rocker in its pivot (2, n) [N], in the user's axes with OX from O to the pivot.

    The rocker's mass is balanced about the pivot, spring and technological force are moments: what is left is -R n,
    with n turned from the velocity by theta towards the rocker's end.
    """
    psi, side = follower.start + motion[0], follower.assembly * follower.sense
    outward = -np.cos(psi) + 1j * side * np.sin(psi)
    velocity = np.sin(psi) + 1j * side * np.cos(psi)
    force = -contact * (cosine * velocity + sine * outward)
    return np.stack((force.real, force.imag))
