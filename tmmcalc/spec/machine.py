"""From the tables of a spec to the plain values that the machine stages read: motor, gears, flywheel, motion."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from tmmcalc.machine.model import FlywheelTask, Gears, MotionTask, MotorChoice
from tmmcalc.machine.motors.catalogue import find, load_catalogue
from tmmcalc.machine.motors.model import CharacteristicKind, Motor, gd2

if TYPE_CHECKING:
    from .motor import MotorTable
    from .root import Spec

CHOOSE = "choose"
_USUAL: dict[str, CharacteristicKind] = {"induction": "parabolic", "shunt": "shunt", "series": "series"}
_SAME = ("kind", "power", "speed", "overload", "start", "inertia", "time_constant", "efficiency", "voltage")
_OWN = ("resistance", "constant")


def to_motor(spec: Spec) -> MotorChoice | None:
    """The motor of the spec, None if it has none; raises `UsageError` or `SpecError` for what a catalogue has not."""
    table = spec.motor
    if table is None:
        return None
    if table.name == CHOOSE:
        own = load_catalogue(table.catalogue) if table.catalogue is not None else ()
        lag = table.time_constant or 0.0
        return MotorChoice(None, table.characteristic or "parabolic", lag, own, table.synchronous_speed)
    motor = _motor(table)
    return MotorChoice(motor, table.characteristic or _USUAL[motor.kind], motor.time_constant)


def _motor(table: MotorTable) -> Motor:
    """The motor by its name with the data beside it, or by its data alone."""
    given = _data(table)
    if table.name is not None and table.power is None:
        found = find(table.name, load_catalogue(table.catalogue) if table.catalogue is not None else None)
        return replace(found, **given)
    return Motor(name=table.name or "motor", **given)


def _data(table: MotorTable) -> dict[str, Any]:
    """The data that the table gives, under the names of `Motor`."""
    data = {name: value for name in (*_SAME, *_OWN) if (value := getattr(table, name)) is not None}
    synchronous = table.synchronous_speed if table.synchronous_speed is not None else table.no_load_speed
    if synchronous is not None:
        data["synchronous"] = synchronous
    if table.flywheel_moment is not None:
        data["inertia"] = gd2(table.flywheel_moment)
    if table.table is not None:
        data["points"] = tuple(zip(table.table.speed, table.table.moment, strict=True))
        data["interpolation"] = table.table.interpolation
    return data


def to_gears(spec: Spec) -> Gears:
    """The gears; without a table a ratio that follows from the speeds."""
    table = spec.transmission
    return Gears(table.ratio, table.efficiency, table.inertia) if table is not None else Gears()


def to_flywheel(spec: Spec) -> FlywheelTask | None:
    """The flywheel that the spec asks for or has, None if it says nothing of one."""
    table = spec.flywheel
    if table is None:
        return None
    return FlywheelTask(
        delta=table.delta,
        inertia=table.inertia or 0.0,
        shaft="other" if table.ratio is not None else table.shaft or "input",
        ratio=table.ratio,
        diameter=table.diameter,
        width=table.width,
        thickness=table.thickness,
        material=table.material,
        density=table.density,
        speed_limit=table.speed_limit,
    )


def to_motion(spec: Spec) -> MotionTask:
    """How the motion is found: by the motor if there is one, unless the spec says otherwise."""
    table = spec.motion
    if table is None:
        return MotionTask(spec.motor is None)
    positional = spec.motor is None if table.drive is None else table.drive == "positional"
    return MotionTask(positional, table.inertia, table.speed)
