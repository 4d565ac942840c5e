"""From the tables of a spec to the plain values that the machine stages read.

A torque diagram, motor, gears and shafts, flywheel, motion and motions in time; for balancing see ``balancing``.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from tmmcalc.machine.model import (
    DriveShaft,
    FlywheelTask,
    Gears,
    InertiaPoints,
    MotionTask,
    MotorChoice,
    TorqueFormula,
    TorqueHarmonics,
    TorquePoints,
    TorqueTask,
    TransientTask,
    TrialTask,
)
from tmmcalc.machine.tables.names import shaft_names, transient_names

if TYPE_CHECKING:
    from tmmcalc.machine.motors.braking import Braking
    from tmmcalc.machine.motors.model import CharacteristicKind, Motor
    from tmmcalc.machine.room import MachineTables
    from tmmcalc.machine.tables.motor import MotorTable
    from tmmcalc.machine.tables.torque import TorqueTable
    from tmmcalc.machine.tables.transients import BrakeTable, BrakingTable, TransientTable
    from tmmcalc.machine.transient.scenario import Brake, Scenario

CHOOSE = "choose"
_USUAL: dict[str, CharacteristicKind] = {"induction": "parabolic", "shunt": "shunt", "series": "series"}
_SAME = ("kind", "power", "speed", "overload", "start", "inertia", "efficiency", "voltage")
_OWN = ("resistance", "constant", "saturation", "field_resistance")


def to_motor(spec: MachineTables) -> MotorChoice | None:
    """The motor of the spec, None if it has none; raises `UsageError` or `SpecError` for what a catalogue has not."""
    table = spec.motor
    if table is None:
        return None
    from tmmcalc.machine.motors.catalogue import load_catalogue
    from tmmcalc.machine.motors.model import with_lag

    if table.name == CHOOSE:
        own = load_catalogue(table.catalogue) if table.catalogue is not None else ()
        return MotorChoice(
            None, table.characteristic or "parabolic", _lag(table), own, table.synchronous_speed, table.reserve or 0.0
        )
    motor = with_lag(_motor(table), _lag(table))
    return MotorChoice(motor, table.characteristic or _USUAL[motor.kind], motor.time_constant)


def _motor(table: MotorTable) -> Motor:
    """The motor by its name with the data beside it, or by its data alone."""
    from tmmcalc.machine.motors.catalogue import find, load_catalogue
    from tmmcalc.machine.motors.model import Motor

    given = _data(table)
    if table.name is not None and table.power is None:
        found = find(table.name, load_catalogue(table.catalogue) if table.catalogue is not None else None)
        return replace(found, **given)
    return Motor(name=table.name or "motor", **given)


def _lag(table: MotorTable) -> float | None:
    """The time constant; None: by the formula."""
    return None if table.time_constant == "auto" else table.time_constant or 0.0


def _data(table: MotorTable) -> dict[str, Any]:
    """The data that the table gives, under the names of `Motor`."""
    data = {name: value for name in (*_SAME, *_OWN) if (value := getattr(table, name)) is not None}
    synchronous = table.synchronous_speed if table.synchronous_speed is not None else table.no_load_speed
    if synchronous is not None:
        data["synchronous"] = synchronous
    if table.flywheel_moment is not None:
        from tmmcalc.machine.motors.model import gd2

        data["inertia"] = gd2(table.flywheel_moment)
    if table.table is not None:
        data["points"] = tuple(zip(table.table.speed or (), table.table.moment or (), strict=True))
        data["interpolation"] = table.table.interpolation
    return data


def to_gears(spec: MachineTables) -> Gears:
    """What is given of the gears; their ratio by itself, or as that of the shafts together.

    Those of [transmission] end at the pinion of an open pair, the shafts at the crank.
    """
    from tmmcalc.gears.tables.tasks.open_pair import to_open_pair

    table, on_crank = spec.transmission, to_open_pair(spec)
    u = 1.0 if on_crank is None else on_crank.ratio
    product = math.prod(shaft.ratio for shaft in spec.shafts) if spec.shafts else None
    if table is None:
        return Gears(product, open=on_crank)
    ratio = table.ratio * u if table.ratio else product
    return Gears(ratio, table.efficiency, None if table.inertia is None else table.inertia * u**2, on_crank)


def to_trial(spec: MachineTables) -> TrialTask | None:
    """What the motor that is chosen is tried by; None: none is chosen.

    A start is a motion in time from standstill with the motor on; its load never drives the crank backwards.
    """
    if spec.motor is None or spec.motor.name != CHOOSE:
        return None
    starts = tuple(
        task._replace(scenario=replace(task.scenario, standstill="stop"))
        for task in to_scenarios(spec)
        if not task.steady and not task.scenario.speed and task.scenario.motor
    )
    return TrialTask(to_motion(spec), to_flywheel(spec), starts, to_shafts(spec))


def to_shafts(spec: MachineTables) -> tuple[DriveShaft, ...]:
    """The elastic drive from the motor to the crank; empty if the spec has none, and the drive is rigid."""
    from tmmcalc.machine.transient.model import Shaft

    return tuple(
        DriveShaft(
            name=name,
            shaft=Shaft(
                stiffness=math.inf if table.stiffness is None else table.stiffness,
                damping=table.damping,
                ratio=table.ratio,
                behind_gear=table.behind_gear,
            ),
            inertia=table.inertia or 0.0,
        )
        for table, name in zip(spec.shafts, shaft_names([table.name for table in spec.shafts]), strict=True)
    )


def to_flywheel(spec: MachineTables) -> FlywheelTask | None:
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


def to_motion(spec: MachineTables) -> MotionTask:
    """How the motion is found: by the motor if there is one, unless the spec says otherwise."""
    table = spec.motion
    if table is None:
        return MotionTask(spec.motor is None)
    positional = spec.motor is None if table.drive is None else table.drive != "motor"
    return MotionTask(positional, table.inertia, table.speed, table.drive == "none")


def speed_key(spec: MachineTables) -> str:
    """Where the spec gives the mean speed of the input."""
    return "mechanism.input.speed" if spec.torque is None else "torque.speed"


def to_torque(spec: MachineTables) -> TorqueTask | None:
    """The torque diagram of the spec, None if it has none."""
    table = spec.torque
    if table is None:
        return None
    return TorqueTask(
        name=table.name,
        speed=table.speed,
        period=table.period,
        law=_torque_law(table),
        delays=_delays(table),
        inertia=table.inertia,
        reduced=_reduced_inertia(table),
        balanced=table.balanced,
    )


def _torque_law(table: TorqueTable) -> TorqueFormula | TorqueHarmonics | TorquePoints:
    """The one law of a diagram."""
    from tmmcalc.machine.tables.torque import with_powers

    if table.formula is not None:
        return TorqueFormula(with_powers(table.formula), tuple(table.constants.items()))
    if table.harmonics is not None:
        terms = tuple((term.order, term.cos, term.sin) for term in table.harmonics.terms)
        return TorqueHarmonics(table.harmonics.constant, terms)
    if table.pieces is not None:
        theta, moment = zip(*table.pieces, strict=True)
        return TorquePoints(theta, moment)
    assert table.table is not None
    curve = table.table
    moments = tuple(curve.moment or ())
    return TorquePoints(_angles(curve.theta, len(moments), table.period), moments, curve.interpolation)


def _reduced_inertia(table: TorqueTable) -> InertiaPoints | None:
    """The reduced inertia that varies with the angle."""
    curve = table.reduced_inertia
    if curve is None:
        return None
    values, period = tuple(curve.inertia or ()), curve.period or table.period
    return InertiaPoints(_angles(curve.theta, len(values), period), values, period, curve.interpolation)


def _angles(given: list[float] | None, count: int, period: float) -> tuple[float, ...]:
    """The angles of a table, by default equal steps of its period [rad]."""
    return tuple(i * period / count for i in range(count)) if given is None else tuple(given)


def _delays(table: TorqueTable) -> tuple[float, ...]:
    if table.count is None:
        return tuple(table.delays or ())
    from tmmcalc.machine.diagram import even_delays

    return even_delays(table.count, table.period)


def to_scenarios(spec: MachineTables) -> tuple[TransientTask, ...]:
    """The motions in time of the spec; speeds and angles are those of the crank, along its motion."""
    from tmmcalc.machine.transient.methods import Method

    return tuple(
        TransientTask(
            _scenario(table, name),
            Method(table.method, table.step, table.tolerance),
            table.begin == "steady",
            _braking(table.braking),
        )
        for table, name in zip(spec.transients, transient_names([t.name for t in spec.transients]), strict=True)
    )


def _scenario(table: TransientTable, name: str) -> Scenario:
    from tmmcalc.machine.transient.scenario import LONGEST, LoadStep, Scenario

    steps = (LoadStep(step.factor, step.time, step.speed, step.quiet) for step in table.load_steps)
    return Scenario(
        name=name,
        duration=table.duration or LONGEST,
        speed=table.start_speed,
        angle=table.start_angle,
        settled=table.begin == "steady",
        motor=_motor_times(table),
        load=(LoadStep(table.load), *steps),
        brake=_brake(table.brake),
        standstill=table.standstill,
        targets=tuple(table.targets),
        end_speed=table.end_speed,
        end_angle=table.end_angle,
        until_steady=table.duration is None,
    )


def _motor_times(table: TransientTable) -> tuple[tuple[float, float], ...]:
    if table.motor_on is not None:
        return tuple((on, off) for on, off in table.motor_on)
    return ((0.0, math.inf),) if table.motor != "off" else ()


def _braking(table: BrakingTable | None) -> Braking | None:
    if table is None:
        return None
    from tmmcalc.machine.motors.braking import Braking

    return Braking(table.kind, table.resistance, table.voltage, table.field)


def _brake(table: BrakeTable | None) -> Brake | None:
    from tmmcalc.machine.transient.scenario import Brake

    if table is None:
        return None
    mass = -1 if table.mass is None else table.mass
    return Brake(table.moment, table.viscous, mass, table.start, math.inf if table.end is None else table.end)
