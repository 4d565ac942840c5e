"""What is given of the drive: the plate of the motor, the gears, elastic shafts, what turns with the input link."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.machine.motors.model import RPM, Motor
from tmmcalc.machine.notes.motors import called, driven, losses, plate, points_of
from tmmcalc.machine.power import Power
from tmmcalc.machine.tables.motor import MotorTable
from tmmcalc.machine.tables.names import shaft_names
from tmmcalc.machine.tables.shafts import ShaftTable
from tmmcalc.machine.tables.tasks.machine import CHOOSE, to_motion
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Datum
from tmmcalc.report.telling import data_of

DRIVEN = {"motion", "flywheel", "transient"}  # stages that ask what drives the machine


def of_drive(order: Order) -> Iterator[Datum]:
    """The motor and what stands between it and the input link, then how the machine is driven."""
    spec, power = order.spec, order.results.get("power")
    if power is not None:
        if spec.motor is not None:
            yield from _motor(spec.motor, power)
        yield from _gears(order, power)
    for k, (table, name) in enumerate(zip(spec.shafts, shaft_names([each.name for each in spec.shafts]), strict=True)):
        yield from _shaft(table, name, k + 1)
    if spec.motion is not None and spec.motion.inertia:
        said = tr("further constant moment of inertia of the input link")
        yield Datum(said, ("J_e",), (spec.motion.inertia,), "kg*m^2")
    if spec.motion is not None and spec.motion.speed is not None and to_motion(spec).positional:
        yield Datum(tr("mean speed of the input link"), (), (spec.motion.speed * RPM,), "rpm")
    if DRIVEN & set(order.results):
        yield Datum(tr("drive of the machine"), text=_drive(order))
        yield from _whole_curve(order)


def _motor(table: MotorTable, power: Power) -> Iterator[Datum]:
    """The plate of a motor that is given; of one to choose what it has to keep."""
    if table.name == CHOOSE:
        yield Datum(tr_name("motor"), text=tr("the least of the catalogue that does"))
        if table.synchronous_speed is not None:
            said = tr("synchronous speed of the motor")
            yield Datum(said, ("n_c",), (table.synchronous_speed * RPM,), "rpm")
        if table.reserve:
            said = tr("part by which rated power and moment of the motor exceed mean power and rms moment")
            yield Datum(said, (), (table.reserve,))
        return
    if power.duty is None:
        return
    motor = power.duty.motor
    known = plate(motor)
    yield from data_of(known, known)
    if motor.start is not None:
        yield Datum(tr("starting moment of the motor over the rated one"), (), (motor.start,))
    if motor.field_resistance:
        said = tr("part of this resistance that is the field winding")
        yield Datum(said, ("R_f",), (motor.field_resistance,), "Ohm")
    if motor.inertia:
        yield Datum(tr("moment of inertia of the rotor"), ("J_R",), (motor.inertia,), "kg*m^2")
    yield from _lag(table, motor)
    yield from points_of(motor)


def _lag(table: MotorTable, motor: Motor) -> Iterator[Datum]:
    """The electromagnetic lag: its time constant, or that it is the one of the critical slip."""
    said = tr("electromagnetic time constant")
    if table.time_constant == "auto":
        yield Datum(said, ("tau_e",), text=tr("by the critical slip, at 50 Hz"))
    elif motor.time_constant:
        yield Datum(said, ("tau_e",), (motor.time_constant,), "s")


def _gears(order: Order, power: Power) -> Iterator[Datum]:
    """The gears as they are given, without an open pair on the crank, which is told by itself."""
    table = order.spec.transmission
    before = order.spec.open_pair is not None  # the pair, whose pinion these gears end at
    if table is None:
        if power.line.efficiency == 1.0 and not before:  # of a train too, unless the criteria give what it loses
            yield Datum(losses(power).meaning, ("eta_u",), (1.0,))
        return
    if table.ratio is not None:
        said = tr("speed ratio of the motor and the input shaft")
        of_pinion = tr("speed ratio of the motor and the pinion of the open pair")
        yield Datum(of_pinion if before else said, ("u_r" if before else "u",), (table.ratio,))
    if table.efficiency is not None:
        said = tr("efficiency of the gears between the motor and the open pair") if before else losses(power).meaning
        yield Datum(said, ("eta_r" if before else "eta_u",), (table.efficiency,))
    if table.inertia is not None:
        said = tr("moment of inertia of the gears, reduced to the input link")
        of_pinion = tr("moment of inertia of the gears, reduced to the pinion of the open pair")
        yield Datum(of_pinion if before else said, () if before else ("J_g",), (table.inertia,), "kg*m^2")


def _shaft(table: ShaftTable, name: str, k: int) -> Iterator[Datum]:
    """An elastic shaft behind mass k, the gear behind it, the mass behind both; each as it is on its own shaft."""
    if table.stiffness is None:
        yield Datum(tr("shaft “{name}”", name=name), text=tr("rigid"))
    else:
        yield Datum(tr("stiffness of shaft “{name}”", name=name), (f"c_{k}",), (table.stiffness,), "N*m/rad")
        yield Datum(tr("damping of shaft “{name}”", name=name), (f"d_{k}",), (table.damping,), "N*m*s/rad")
    said = tr("speed before shaft “{name}” over the speed behind it and its gear", name=name)
    yield Datum(said, (f"u_{{{k},{k + 1}}}",), (table.ratio,))
    if table.stiffness is not None and table.ratio != 1:
        before, behind = tr("before its gear"), tr("behind its gear")
        yield Datum(tr("where shaft “{name}” is elastic", name=name), text=behind if table.behind_gear else before)
    if table.inertia is not None:
        said = tr("moment of inertia of the mass behind shaft “{name}”", name=name)
        yield Datum(said, (f"J_{{d,{k + 1}}}",), (table.inertia,), "kg*m^2")


def _drive(order: Order) -> str:
    """What drives the machine, by which its motion and its flywheel are found."""
    found = driven(order)
    if found is None:
        free = to_motion(order.spec).undriven
        return tr("nothing but the loads") if free else tr("constant moment, with which the work of the cycle is zero")
    return called(found[0].characteristic)


def _whole_curve(order: Order) -> Iterator[Datum]:
    """That motions in time have the whole curve of a motor whose steady motion takes the working part alone."""
    found = driven(order)
    if found is None or "transient" not in order.results or found[1].overload is None:
        return
    if found[0].characteristic in ("parabolic", "linear"):
        yield Datum(tr("drive in motions in time"), text=tr("motor, its characteristic by the formula of Kloss"))
