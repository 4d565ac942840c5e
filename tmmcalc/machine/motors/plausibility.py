"""Whether the data of a motor agree with each other, and where its curve meets both axes.

The characteristic of a direct-current motor, and one by points, need not pass through the rated point of the name
plate. Where it does not, one of the data is wrong, or the motor is not the one that is meant.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from tmmcalc.core.notes import Note, held
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.motors.model import RPM, CharacteristicKind, Motor, characteristic

if TYPE_CHECKING:
    from tmmcalc.machine.motors.characteristics import Characteristic

PLACE = "the data of the motor contradict each other"
FAR = 0.05  # relative difference of two statements of one datum that is more than rounding and friction
DIRECT = ("shunt", "series")  # kinds of direct-current motors
OF_DATA = ("shunt", "series", "table")  # characteristics that need not pass through the rated point


@record
class Curve:
    """Ends of a direct-current motor's characteristic, on its own shaft."""

    no_load: float | None  # speed where the moment is zero [rad/s]; None: unloaded it runs away
    stall: float = quantity("M_stall[N*m]", "moment of the motor at standstill")

    @derived("n_no_load[rpm]", "speed at which the motor gives no moment")
    def no_load_rpm(self) -> float | None:
        """In revolutions per minute; None: unloaded it runs away."""
        return None if self.no_load is None else self.no_load * RPM


def curve_of(motor: Motor, kind: CharacteristicKind) -> Curve | None:
    """Both ends of the characteristic of a direct-current motor; None for other motors.

    >>> curve_of(Motor("m", 5e3, 145.0, kind="shunt", voltage=220.0, resistance=0.5, constant=1.375), "shunt")
    Curve(no_load=160.0, stall=605.0)
    """
    if motor.kind not in DIRECT:
        return None
    line = characteristic(motor, kind)
    return Curve(line.synchronous, line.moment(0.0))


def contradictions(motor: Motor, kind: CharacteristicKind) -> tuple[Note, ...]:
    """What in the data of the motor contradicts the rest by more than five per cent, with the numbers."""
    if kind not in OF_DATA:
        return ()
    return (*_at_rated_point(motor, characteristic(motor, kind)), *_of_circuit(motor, kind))


def _at_rated_point(motor: Motor, line: Characteristic) -> Iterator[Note]:
    idle, rated = line.synchronous, motor.nominal_moment
    if idle is not None and idle <= motor.speed:
        text = (
            "its characteristic has no load at {value:.6g} rpm, not above the rated {limit:.6g} rpm: "
            "at the rated speed it gives nothing"
        )
        yield held("warning", text, idle, motor.speed, "rad/s", shown="rpm", name="no-load speed", place=PLACE)
        return
    given = line.moment(motor.speed)
    if abs(given - rated) > FAR * rated:
        text = (
            "at the rated speed its characteristic gives {value:.5g} N*m, the rated power asks for {limit:.5g} N*m "
            "({off:+.3g} %)"
        )
        off = 100 * (given / rated - 1)
        yield held("warning", text, given, rated, "N*m", name="moment at the rated speed", place=PLACE, off=off)


def _of_circuit(motor: Motor, kind: CharacteristicKind) -> Iterator[Note]:
    """Data that the armature circuit makes superfluous, and that do not fit it."""
    if kind == "shunt" and motor.voltage and motor.constant and motor.synchronous:
        idle = motor.voltage / motor.constant
        if abs(motor.synchronous - idle) > FAR * idle:
            text = "U/k gives no load at {value:.6g} rpm, and not at the {limit:.6g} rpm given"
            numbers = idle, motor.synchronous, "rad/s"
            yield held("warning", text, *numbers, shown="rpm", name="no-load speed", place=PLACE)
    if kind == "series" and motor.voltage and motor.resistance and motor.efficiency:
        from tmmcalc.machine.motors.direct_current import voltage_drop

        drop = voltage_drop(motor.voltage, motor.resistance, motor.power)
        if drop > 1 - motor.efficiency + FAR:
            text = (
                "its windings lose {value:.3g} % of the rated input, more than all the losses that the efficiency "
                "{efficiency:g} leaves"
            )
            numbers = 100 * drop, 100 * (1 - motor.efficiency), "%"
            yield held("warning", text, *numbers, name="loss of the windings", place=PLACE, efficiency=motor.efficiency)
