"""Which stages a scene wants: None, or the reason why it leaves the stage out.

Nothing heavy is imported here, because plans ask about every stage.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from tmmcalc.pipeline.spared import pairs_of_train

if TYPE_CHECKING:
    from tmmcalc.cams.tables.cam import CamTable
    from tmmcalc.project import Spec

TURN = 2 * math.pi
SLIDES = "the input is a driven slider: its motion is no cycle"


def _asked(table: str, lacking: str, header: str = "") -> Callable[[Spec], str | None]:
    """What is wanted where the spec has its table; ``lacking`` is the sense of a spec without it."""
    reason = f"no {header or f'[{table}]'}: {lacking}"
    return lambda spec: None if getattr(spec, table) else reason


synthesis = _asked("synthesis", "no linkage is to be found")
train = _asked("train", "no tooth numbers are asked for")
gearing = _asked("gearing", "no train is written out")
cam_law = cam_synthesis = cam_profile = cam_pressure = _asked("cam", "no cam is asked for")
indexing = _asked("indexing", "no indexing drive is asked for")
manipulator = _asked("manipulator", "no arm is asked for")
vibrator = _asked("vibrator", "no vibratory device is asked for")
pendulum = _asked("pendulum", "no pendulum-rotor is asked for")
contact = _asked("contact", "no bodies are pressed together")
reliability = _asked("reliability", "no life is asked for")
tie_down = _asked("tie_down", "no load is tied down")
falling_ball = _asked("falling_ball", "no ball falls")
bearing = _asked("bearing", "no bearing is asked for")
feasibility = _asked("constraints", "nothing is to be kept", "[[constraints]]")


def structure(spec: Spec) -> str | None:
    """Groups are those of a mechanism."""
    return None if spec.mechanism is not None else "no [mechanism]"


kinematics = structure  # what moves is a mechanism


def forces(spec: Spec) -> str | None:
    """Nothing acts on a linkage without loads, masses and springs."""
    if spec.mechanism is None:
        return structure(spec)
    if _masses(spec) or spec.loads or spec.springs:
        return None
    return "no loads, masses or springs: nothing acts on the links"


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


def balance(spec: Spec) -> str | None:
    """What shakes is a linkage with masses, an engine, a rotor."""
    if spec.engine is not None or spec.rotor is not None or shakes(spec):
        return None
    if spec.mechanism is None:
        return "no [engine], no [rotor] and no [mechanism]"
    return "no masses: nothing shakes the foundation" if not _masses(spec) else _acyclic(spec)


def strength(spec: Spec) -> str | None:
    """Modules are those of tooth sets under a torque."""
    return train(spec) or ("no [strength]: no torque and no materials" if spec.strength is None else None)


criteria = strength  # trains are compared by their sizes, which strength gives


def pair(spec: Spec) -> str | None:
    """Pairs are written out, or those of a train that is chosen."""
    if spec.pair is None:
        return "no [pair]: no pair of gears is asked for"
    return criteria(spec) if pairs_of_train(spec) else None


profile = pair  # every pair has profiles


def blocking(spec: Spec) -> str | None:
    """The contour is that of two external wheels."""
    reason = pair(spec)
    if reason is None and not pairs_of_train(spec) and "external" not in _kinds(spec):
        return "no external pair: a ring or a rack has no blocking contour"
    return reason


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
