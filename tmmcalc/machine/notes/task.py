"""What is given of a machine: its motor, the gears to it, the unevenness of its speed, its flywheel."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from tmmcalc.machine.flywheel.results import Flywheel
from tmmcalc.machine.flywheel.rim import DEFAULT
from tmmcalc.machine.motors.model import RPM
from tmmcalc.machine.notes.motors import called, driven, motor_data
from tmmcalc.machine.power import Power
from tmmcalc.machine.tables.tasks.balance import to_engine, to_rotor
from tmmcalc.machine.tables.tasks.machine import to_motion
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Datum


def blocks(order: Order) -> Iterator[Block]:
    """The data, without those that the program has found."""
    spec, power = order.spec, order.results.get("power")
    if power is not None and power.duty is not None and not power.duty.chosen:
        yield from _motor(power, given_ratio=spec.transmission is not None and spec.transmission.ratio is not None)
    if spec.motion is not None and spec.motion.inertia:
        said = tr("further constant moment of inertia of the input link")
        yield Datum(said, ("J_e",), (spec.motion.inertia,), "kg*m^2")
    yield from _turning(order)
    if {"motion", "flywheel", "transient"} & set(order.results):
        yield Datum(tr("drive of the machine"), text=_drive(order))
    flywheel = spec.flywheel
    if flywheel is None:
        return
    words: Mapping[str, tuple[float | None, str, str]] = {
        "delta_0": (flywheel.delta, "", tr("allowed coefficient of speed fluctuation")),
        "J_f": (flywheel.inertia, "kg*m^2", tr("moment of inertia of the flywheel")),
        "D": (flywheel.diameter, "m", tr("mean diameter of the rim")),
        "b": (flywheel.width, "m", tr("width of the rim")),
    }
    for key, (value, unit, meaning) in words.items():
        if value is not None:
            yield Datum(meaning, (key,), (value,), unit)
    if flywheel.shaft == "motor":
        yield Datum(tr("shaft of the flywheel"), text=tr("that of the motor"))
    if flywheel.ratio is not None:
        yield Datum(tr("speed of the flywheel over the speed of the input link"), ("u_M",), (flywheel.ratio,))
    if "flywheel" in order.results:
        yield from _rim(order.results["flywheel"], proportioned=flywheel.width is None and flywheel.thickness is None)


def _drive(order: Order) -> str:
    """What drives the machine, by which its motion and its flywheel are found."""
    found = driven(order)
    if found is None:
        free = to_motion(order.spec).undriven
        return tr("nothing but the loads") if free else tr("constant driving moment")
    return called(found[0].characteristic)


def _rim(found: Flywheel, *, proportioned: bool) -> Iterator[Datum]:
    """What is taken for a rim that is designed, beyond its sizes."""
    rim = found.wheels[0].rim if found.addition > 0 else None
    if rim is None:
        return
    yield Datum(tr("what the rim is made of"), text=tr_name(rim.material.name))
    yield Datum(tr("density"), ("rho",), (rim.material.density,), "kg/m^3")
    yield Datum(tr("share of the rim in the moment of inertia"), ("c_J",), (DEFAULT.rim_inertia,))
    yield Datum(tr("share of the rim in the mass"), ("c_m",), (DEFAULT.rim_mass,))
    if proportioned:
        yield Datum(tr("ratio of width and thickness"), ("c_b",), (DEFAULT.width_to_thickness,))


def _turning(order: Order) -> Iterator[Datum]:
    """A rotor and an engine, without masses and cylinders, which have tables in their chapter."""
    rotor, engine = to_rotor(order.spec), to_engine(order.spec)
    if rotor is not None:
        made = rotor.rotor
        yield Datum(tr("mass of the rotor"), ("m",), (made.mass,), "kg")
        yield Datum(tr("place of the centre of mass along the axis"), ("z_S",), (made.center,), "m")
        yield Datum(tr("places of the bearings along the axis"), ("z_A", "z_B"), made.bearings, "m")
        yield Datum(tr("places of the planes of correction along the axis"), ("z_I", "z_II"), rotor.planes, "m")
        yield Datum(tr("highest service speed"), ("n",), (made.speed * RPM,), "rpm")
        if rotor.radius is not None:
            yield Datum(tr("radius of the correction weights"), ("r_k",), (rotor.radius,), "m")
        if rotor.grade is not None:
            yield Datum(tr("grade of balance quality"), ("G",), (rotor.grade,), "mm/s")
    if engine is not None:
        yield Datum(tr("number of cylinders"), ("n_c",), (float(len(engine.cylinders)),))
        yield Datum(tr("number of strokes of the cycle"), (), (), text=str(engine.strokes))
        if engine.firing_order is not None:
            yield Datum(tr("firing order"), text="–".join(map(str, engine.firing_order)))
        yield Datum(tr("speed of the shaft"), ("n",), (engine.speed * RPM,), "rpm")


def _motor(power: Power, *, given_ratio: bool) -> Iterator[Datum]:
    """The plate of the motor."""
    assert power.duty is not None
    left_out = {"eta_u"} if given_ratio else {"eta_u", "u"}
    known = motor_data(power.duty.motor, power)
    if power.duty.motor.inertia:
        known["J_R"] = Given(power.duty.motor.inertia, "kg*m^2", tr("moment of inertia of the rotor"))
    for key, given in known.items():
        if key not in left_out and isinstance(given.value, float) and given.value:
            yield Datum(given.meaning, (key,), (given.value,), given.unit)
