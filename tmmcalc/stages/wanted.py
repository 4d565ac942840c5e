"""Which stages a scene wants: None, or the reason why it leaves the stage out.

Nothing heavy is imported here, because plans ask about every stage.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from tmmcalc.stages.spared import pairs_of_train

if TYPE_CHECKING:
    from tmmcalc.spec import Spec
    from tmmcalc.spec.cam import CamTable

TURN = 2 * math.pi
SLIDES = "the input is a driven slider: its motion is no cycle"


def synthesis(spec: Spec) -> str | None:
    """A linkage is to be found."""
    return None if spec.synthesis is not None else "no [synthesis]: no linkage is to be found"


def structure(spec: Spec) -> str | None:
    """Groups are those of a mechanism."""
    return None if spec.mechanism is not None else "no [mechanism]"


def kinematics(spec: Spec) -> str | None:
    """What moves is a mechanism."""
    return structure(spec)


def forces(spec: Spec) -> str | None:
    """Nothing acts on a linkage without loads, masses and springs."""
    if spec.mechanism is None:
        return structure(spec)
    if _masses(spec) or spec.loads or spec.springs:
        return None
    return "no loads, masses or springs: nothing acts on the links"


def feasibility(spec: Spec) -> str | None:
    """Constraints are stated one by one."""
    return None if spec.constraints else "no [[constraints]]: nothing is to be kept"


def reduction(spec: Spec) -> str | None:
    """What does not act cannot be reduced; a torque diagram is reduced already."""
    return None if spec.torque is not None else forces(spec)


def power(spec: Spec) -> str | None:
    """Work over a cycle needs a cycle: a crank that turns fully."""
    return None if spec.torque is not None else _acyclic(spec) or forces(spec)


def flywheel(spec: Spec) -> str | None:
    """A flywheel is asked for by the unevenness that it has to keep."""
    if _slides(spec):
        return SLIDES
    if spec.flywheel is None:
        return "no [flywheel]: no unevenness to keep"
    if spec.flywheel.delta is None:
        return "[flywheel] has no delta: no unevenness to keep"
    return power(spec)


def motion(spec: Spec) -> str | None:
    """The speed varies where kinetic energy is stored and something acts; without a drive it is that of the input."""
    if _slides(spec):
        return SLIDES
    begun = any(transient.begin == "steady" for transient in spec.transients)
    if spec.motor is None and spec.motion is None and spec.flywheel is None and not begun:
        return "no [motor]: the speed is constant"
    shaft = spec.torque is not None and spec.torque.inertia
    wheel = spec.flywheel is not None and (spec.flywheel.inertia or spec.flywheel.delta)
    further = spec.motion is not None and spec.motion.inertia
    if not (_masses(spec) or shaft or wheel or further or _rotor(spec) or criteria(spec) is None):
        return "no masses and no constant inertia: nothing stores kinetic energy"
    return power(spec)


def transient(spec: Spec) -> str | None:
    """Motions in time are asked for one by one."""
    return "no [[transients]]: no motion in time is asked for" if not spec.transients else power(spec)


def unsteady(spec: Spec) -> str | None:
    """A motion from rest to rest is asked for, and a mechanism makes it."""
    return structure(spec) or ("no [unsteady]: no motion from rest to rest is asked for" if not spec.unsteady else None)


def manipulator(spec: Spec) -> str | None:
    """An arm that is asked for."""
    return "no [manipulator]: no arm is asked for" if spec.manipulator is None else None


def balance(spec: Spec) -> str | None:
    """What shakes is a linkage with masses, an engine, a rotor."""
    if spec.engine is not None or spec.rotor is not None or shakes(spec):
        return None
    if spec.mechanism is None:
        return "no [engine], no [rotor] and no [mechanism]"
    return "no masses: nothing shakes the foundation" if not _masses(spec) else _acyclic(spec)


def train(spec: Spec) -> str | None:
    """Tooth numbers are those of a train that is asked for."""
    return "no [train]: no tooth numbers are asked for" if spec.train is None else None


def strength(spec: Spec) -> str | None:
    """Modules are those of tooth sets under a torque."""
    return train(spec) or ("no [strength]: no torque and no materials" if spec.strength is None else None)


def criteria(spec: Spec) -> str | None:
    """Trains are compared by their sizes, which strength gives."""
    return strength(spec)


def pair(spec: Spec) -> str | None:
    """Pairs are written out, or those of a train that is chosen."""
    if spec.pair is None:
        return "no [pair]: no pair of gears is asked for"
    return criteria(spec) if pairs_of_train(spec) else None


def blocking(spec: Spec) -> str | None:
    """The contour is that of two external wheels."""
    reason = pair(spec)
    if reason is None and not pairs_of_train(spec) and "external" not in _kinds(spec):
        return "no external pair: a ring or a rack has no blocking contour"
    return reason


def profile(spec: Spec) -> str | None:
    """Every pair has profiles."""
    return pair(spec)


def cam_law(spec: Spec) -> str | None:
    """A law is that of a cam."""
    return "no [cam]: no cam is asked for" if spec.cam is None else None


def cam_synthesis(spec: Spec) -> str | None:
    """Every cam has its sizes."""
    return cam_law(spec)


def cam_profile(spec: Spec) -> str | None:
    """Every cam has a profile."""
    return cam_law(spec)


def cam_pressure(spec: Spec) -> str | None:
    """Every follower has a pressure angle, if only that of a flat face."""
    return cam_law(spec)


def cam_forces(spec: Spec) -> str | None:
    """What acts is known from the loads and the speed."""
    if spec.cam is None or spec.cam.loads is None:
        return cam_law(spec) or "no [cam.loads]: nothing is known of masses and forces"
    return _cam_speed(spec, spec.cam)


def _cam_speed(spec: Spec, cam: CamTable) -> str | None:
    """A speed of the cam's own, or of the shaft that it turns with."""
    turns = spec.torque is not None or (spec.mechanism is not None and not _slides(spec))
    return None if cam.speed is not None or turns else "[cam] has no speed: inertia forces are not known"


def cam_strength(spec: Spec) -> str | None:
    """Requirements are judged by the forces."""
    lacking = "no [cam.requirements]: neither materials nor sizes to judge"
    return cam_forces(spec) or (lacking if spec.cam is None or spec.cam.requirements is None else None)


def cam_optimum(spec: Spec) -> str | None:
    """An optimum is asked for, of a follower in a guide."""
    if spec.cam is not None and spec.cam.follower == "oscillating":
        return "there is no optimal design of a rocker: the method is that of a follower in a guide"
    lacking = "no [cam.optimum]: no optimum is asked for"
    return cam_forces(spec) or (lacking if spec.cam is None or spec.cam.optimum is None else None)


def cam_elastic(spec: Spec) -> str | None:
    """Only an elastic train vibrates, with the mass of the loads or one of its own."""
    if spec.cam is None or spec.cam.elastic is None:
        return cam_law(spec) or "no [cam.elastic]: the follower is rigid"
    return _cam_speed(spec, spec.cam)


def indexing(spec: Spec) -> str | None:
    """An indexing drive is asked for by its own table."""
    return "no [indexing]: no indexing drive is asked for" if spec.indexing is None else None


def gearing(spec: Spec) -> str | None:
    """Speeds and powers are those of a train that is written out."""
    return "no [gearing]: no train is written out" if spec.gearing is None else None


def vibrator(spec: Spec) -> str | None:
    """Springs and modes are those of a vibratory device."""
    return "no [vibrator]: no vibratory device is asked for" if spec.vibrator is None else None


def pendulum(spec: Spec) -> str | None:
    """Whirl is that of a pendulum-rotor."""
    return "no [pendulum]: no pendulum-rotor is asked for" if spec.pendulum is None else None


def contact(spec: Spec) -> str | None:
    """Asked for by its own table."""
    return "no [contact]: no bodies are pressed together" if spec.contact is None else None


def reliability(spec: Spec) -> str | None:
    """Asked for by its own table."""
    return "no [reliability]: no life is asked for" if spec.reliability is None else None


def tie_down(spec: Spec) -> str | None:
    """Asked for by its own table."""
    return "no [tie_down]: no load is tied down" if spec.tie_down is None else None


def falling_ball(spec: Spec) -> str | None:
    """Asked for by its own table."""
    return "no [falling_ball]: no ball falls" if spec.falling_ball is None else None


def bearing(spec: Spec) -> str | None:
    """Asked for by its own table."""
    return "no [bearing]: no bearing is asked for" if spec.bearing is None else None


def shakes(spec: Spec) -> bool:
    """Whether the spec has a linkage with masses whose crank turns fully."""
    return _masses(spec) and _acyclic(spec) is None


def _kinds(spec: Spec) -> set[str]:
    """Kinds of the pairs that are written out."""
    table = spec.pair
    if table is None:
        return set()
    general = table.kind or "external"
    return {mesh.kind or general for mesh in table.meshes} or {general}


def _rotor(spec: Spec) -> bool:
    """Whether the rotor of the motor stores energy; of a motor that is still to be chosen nobody knows."""
    motor = spec.motor
    return motor is not None and bool(motor.inertia or motor.flywheel_moment or motor.name not in (None, "choose"))


def _masses(spec: Spec) -> bool:
    return spec.mechanism is not None and any(link.mass or link.inertia for link in spec.mechanism.links)


def _slides(spec: Spec) -> bool:
    joints, driven = (spec.mechanism.joints, spec.mechanism.input.joint) if spec.mechanism is not None else ((), "")
    return any(joint.name == driven and joint.kind == "prismatic" for joint in joints)


def _acyclic(spec: Spec) -> str | None:
    if spec.mechanism is None:
        return structure(spec)
    if _slides(spec):
        return SLIDES
    span = spec.mechanism.grid.span
    if span is not None and abs(span - TURN) > 1e-9:
        return "grid.span is not a full turn: the motion is no cycle"
    return None
