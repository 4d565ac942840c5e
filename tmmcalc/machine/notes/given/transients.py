"""What is given of motions in time: how each begins and ends, what is switched and when."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.machine.motors.model import RPM, Motor
from tmmcalc.machine.notes.motors import driven
from tmmcalc.machine.tables.names import transient_names
from tmmcalc.machine.tables.transients import BrakeTable, BrakingTable, LoadStepTable, TransientTable
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Datum
from tmmcalc.report.telling import Of, owned


def of_transients(order: Order) -> Iterator[Datum]:
    """All motions in time; a load that acts as it is given and a motor that is on throughout are not told of."""
    tables, found = order.spec.transients, driven(order) if "power" in order.results else None
    for table, name in zip(tables, transient_names([each.name for each in tables]), strict=True):
        of = owned(tr("motion “{name}”", name=name))
        yield from _beginning(table, of)
        if found is not None:
            yield from _motor(table, found[1], of)
        yield from _load(table, of)
        if table.brake is not None:
            yield from _brake(table.brake, of)
        if table.targets:
            rpm = tuple(speed * RPM for speed in table.targets)
            yield Datum(of(tr("speeds of the input link whose first passage is asked for")), (), rpm, "rpm")
        yield from _end(table, of)


def _beginning(table: TransientTable, of: Of) -> Iterator[Datum]:
    """The speed and the angle at which it begins."""
    if table.begin == "steady":
        yield Datum(of(tr("beginning")), text=tr("in the steady motion, position 0"))
        return
    yield Datum(of(tr("speed of the input link at the beginning")), (), (table.start_speed * RPM,), "rpm")
    if table.start_angle:
        said = of(tr("angle of the input link at the beginning"))
        yield Datum(said, (), (math.degrees(table.start_angle),), "deg")


def _motor(table: TransientTable, motor: Motor, of: Of) -> Iterator[Datum]:
    """When the motor is on, and how it is connected if it brakes."""
    if table.motor == "off":
        yield Datum(of(tr_name("motor")), text=tr("switched off"))
    intervals = table.motor_on or ()
    for k, (on, off) in enumerate(intervals, 1):
        said = tr("interval {number} in which the motor is on, from and to", number=k)
        yield Datum(of(said if len(intervals) > 1 else tr("motor on from, and to")), (), (on, off), "s")
    if table.braking is not None:
        yield from _braking(table.braking, motor, of)


def _braking(table: BrakingTable, motor: Motor, of: Of) -> Iterator[Datum]:
    """The circuit of a direct-current motor that brakes."""
    kinds = {
        "regenerative": tr("it brakes and feeds a source"),
        "dynamic": tr("it brakes, its armature closed on a resistor"),
        "plugging": tr("it brakes, its armature turned round; at rest it is switched off"),
    }
    yield Datum(of(tr_name("motor")), text=kinds[table.kind])
    yield Datum(of(tr("resistance added to the armature circuit")), ("R_a",), (table.resistance,), "Ohm")
    if table.kind == "regenerative" and (voltage := table.voltage or motor.voltage):
        yield Datum(of(tr("voltage that the armature is connected to")), ("V",), (voltage,), "V")
    if table.field is not None:
        said = tr("current of the field, from a source of its own, in parts of the rated one")
        yield Datum(of(said), ("j_f",), (table.field,))
    elif motor.kind == "series":
        said = tr("it carries the current of the armature, turned round against it")
        yield Datum(of(tr("field of the motor")), text=said)


def _load(table: TransientTable, of: Of) -> Iterator[Datum]:
    """What part of the loads acts, from the beginning and after each step."""
    if table.load == 1 and not table.load_steps:
        return
    yield Datum(of(tr("part of the loads that acts at the beginning")), (), (table.load,))
    for k, step in enumerate(table.load_steps, 1):
        yield from _step(step, k, of)


def _step(step: LoadStepTable, k: int, of: Of) -> Iterator[Datum]:
    """A step of the load and what it waits for."""
    yield Datum(of(tr("part of the loads after change {number}", number=k)), (), (step.factor,))
    if step.time is not None:
        yield Datum(of(tr("time of change {number}", number=k)), (), (step.time,), "s")
    if step.speed is not None:
        said = tr("speed of the input link above which change {number} comes", number=k)
        yield Datum(of(said), (), (step.speed * RPM,), "rpm")
    if step.quiet:
        waited = tr("a part of the cycle without load")
        yield Datum(of(tr("what change {number} waits for", number=k)), text=waited)


def _brake(table: BrakeTable, of: Of) -> Iterator[Datum]:
    """A brake, its mass and its times."""
    if table.moment or not table.viscous:
        yield Datum(of(tr("moment of the brake, against the motion")), ("M_b",), (table.moment,), "N*m")
    if table.viscous:
        said = tr("part of the moment of the brake in proportion to the speed")
        yield Datum(of(said), (), (table.viscous,), "N*m*s/rad")
    if table.mass is not None:
        yield Datum(of(tr("number of the mass that the brake acts on, the rotor 1")), (), (float(table.mass + 1),))
    if table.start:
        yield Datum(of(tr("time from which the brake acts")), (), (table.start,), "s")
    if table.end is not None:
        yield Datum(of(tr("time until which the brake acts")), (), (table.end,), "s")


def _end(table: TransientTable, of: Of) -> Iterator[Datum]:
    """What ends it; at rest a load may turn it back."""
    if table.duration is not None:
        yield Datum(of(tr("longest time")), (), (table.duration,), "s")
    if table.end_speed is not None:
        said = of(tr("speed of the input link at which it ends"))
        yield Datum(said, (), (table.end_speed * RPM,), "rpm")
    if table.end_angle is not None:
        said = of(tr("angle that the input link turns by until it ends"))
        yield Datum(said, (), (math.degrees(table.end_angle),), "deg")
    if table.duration is None and table.end_speed is None and table.end_angle is None:
        yield Datum(of(tr("end")), text=tr("when it repeats itself from cycle to cycle, or stands still"))
    if table.standstill == "pass":
        yield Datum(of(tr("loads at rest")), text=tr("they may turn the input link back"))
