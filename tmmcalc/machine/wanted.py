"""Which stages of the machine room a scene wants, and which results they read, where the spec gives none.

Nothing heavy is imported here, because plans ask about every stage.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.gears.wanted import TRAIN, ratio_of_drive
from tmmcalc.gears.wanted import strength as unchosen
from tmmcalc.linkage.wanted import SLIDES, acyclic, forces, has_masses, slides

if TYPE_CHECKING:
    from tmmcalc.machine.room import MachineTables

NO_REGIME = "a constant moment drives: no regime under a motor is integrated"


def reduction(spec: MachineTables) -> str | None:
    """What does not act cannot be reduced; a torque diagram is reduced already."""
    return None if spec.torque is not None else forces(spec)


def power(spec: MachineTables) -> str | None:
    """Work over a cycle needs a cycle: a crank that turns fully."""
    return None if spec.torque is not None else acyclic(spec) or forces(spec)


def read_by_power(spec: MachineTables) -> tuple[str, ...]:
    """Ratio, efficiency and inertia of the drive line are given, or else those of the train."""
    table = spec.transmission
    given = table is not None and table.efficiency is not None and table.inertia is not None
    train = () if given and _ratio_given(spec) else TRAIN
    return (*train, "drive") if ratio_of_drive(spec) and _to_choose(spec) and not _ratio_given(spec) else train


def drive(spec: MachineTables) -> str | None:
    """Speeds of motor and crank give a ratio to a train that has none."""
    if spec.train is None:
        return "no [train]: it is given no ratio"
    return None if ratio_of_drive(spec) else "the ratio of the train is given"


def read_by_drive(spec: MachineTables) -> tuple[str, ...]:
    """What loads the machine matters to a motor that is chosen."""
    return ("reduction",) if _to_choose(spec) and not _ratio_given(spec) else ()


def _to_choose(spec: MachineTables) -> bool:
    """Whether a motor is to be chosen."""
    return spec.motor is not None and spec.motor.name == "choose"


def flywheel(spec: MachineTables) -> str | None:
    """A flywheel is asked for by the unevenness that it has to keep."""
    if slides(spec):
        return SLIDES
    if spec.flywheel is None:
        return "no [flywheel]: no unevenness to keep"
    if spec.flywheel.delta is None:
        return "[flywheel] has no delta: no unevenness to keep"
    return power(spec)


def motion(spec: MachineTables) -> str | None:
    """The speed varies where kinetic energy is stored and something acts; without a drive it is that of the input."""
    if slides(spec):
        return SLIDES
    begun = any(transient.begin == "steady" for transient in spec.transients)
    if spec.motor is None and spec.motion is None and spec.flywheel is None and not begun:
        return "no [motor]: the speed is constant"
    shaft = spec.torque is not None and (spec.torque.inertia or spec.torque.reduced_inertia is not None)
    wheel = spec.flywheel is not None and (spec.flywheel.inertia or spec.flywheel.delta)
    further = spec.motion is not None and spec.motion.inertia
    if not (has_masses(spec) or shaft or wheel or further or _rotor(spec) or unchosen(spec) is None):
        return "no masses and no constant inertia: nothing stores kinetic energy"
    return power(spec)


def read_by_motion(spec: MachineTables) -> tuple[str, ...]:
    """A flywheel that is there need not be sized."""
    there = spec.flywheel is not None and bool(spec.flywheel.inertia)
    return () if there else ("flywheel",)


def transient(spec: MachineTables) -> str | None:
    """Motions in time are asked for one by one."""
    return "no [[transients]]: no motion in time is asked for" if not spec.transients else power(spec)


def balance(spec: MachineTables) -> str | None:
    """What shakes is a linkage with masses, an engine, a rotor."""
    if spec.engine is not None or spec.rotor is not None or shakes(spec):
        return None
    if spec.mechanism is None:
        return "no [engine], no [rotor] and no [mechanism]"
    return "no masses: nothing shakes the foundation" if not has_masses(spec) else acyclic(spec)


def shakes(spec: MachineTables) -> bool:
    """Whether the spec has a linkage with masses whose crank turns fully."""
    return has_masses(spec) and acyclic(spec) is None


def _rotor(spec: MachineTables) -> bool:
    """Whether the rotor of the motor stores energy; of a motor that is still to be chosen nobody knows."""
    motor = spec.motor
    return motor is not None and bool(motor.inertia or motor.flywheel_moment or motor.name not in (None, "choose"))


def _ratio_given(spec: MachineTables) -> bool:
    """Whether the ratio of the gears is given, by itself or as that of the shafts."""
    return bool(spec.shafts) or (spec.transmission is not None and spec.transmission.ratio is not None)


def constant_moment(spec: MachineTables) -> bool:
    """Whether no motor drives the steady motion, and not the loads alone."""
    from tmmcalc.machine.tables.tasks.machine import to_motion

    task = to_motion(spec)
    return (task.positional or spec.motor is None) and not task.undriven


def curved(spec: MachineTables) -> tuple[str, ...]:
    """The package of monotone cubics, where they run through the points of the motor."""
    curve = spec.motor.table if spec.motor is not None else None
    return ("scipy.interpolate",) if curve is not None and curve.interpolation == "pchip" else ()
