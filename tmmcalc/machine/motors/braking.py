"""Electric braking of direct-current machines: lines and curves through the second quadrant.

A field that does not hang on the armature (shunt, independent, or that of a series machine on a source of its own)
gives with an added resistance R_a and the voltage V of what the armature is connected to

    M = k (V - k omega)/(R + R_a)

    regenerative   V > 0 below k omega: the machine feeds the source; down to V/k, where the moment ends
    dynamic        V = 0: the armature on a resistor; the moment falls with the speed to nothing
    plugging       V = -U: the armature turned round; it still brakes at rest, and would turn the machine back

so that a rotor of the inertia J alone falls towards V/k with the time constant J (R + R_a)/k^2.

The field of a series machine that carries the current of its armature, turned round against it, keeps its sense, and
its EMF drives the current:

    dynamic        I (R + R_a) = E: the machine excites itself, above the critical speed (R + R_a)/c alone, with
                   c = E/(I omega) at a small current; below it nothing brakes. Saturation alone limits the current
    plugging       I (R + R_a) = U + E: with a flux in proportion to the current M = -c U^2/(R + R_a - c omega)^2,
                   whose pole is that critical speed

It cannot feed a source: with its current its own field would fall to nothing before E comes up to the voltage.
"""

from __future__ import annotations

from typing import Literal

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.machine.motors.characteristics import Characteristic, Straight
from tmmcalc.machine.motors.direct_current import Series
from tmmcalc.machine.motors.model import Motor, characteristic

BrakingKind = Literal["regenerative", "dynamic", "plugging"]


@record
class Braking:
    """How the armature is connected while the machine brakes."""

    kind: BrakingKind
    resistance: float = 0.0  # R_a, added to the armature circuit [ohm]
    voltage: float | None = None  # V of the source in regenerative braking [V]; None: that of the motor
    field: float | None = None  # of a series motor: current of the field from a source of its own, over the rated one


def braking(motor: Motor, how: Braking) -> Characteristic:
    """The characteristic on the shaft of a ``motor`` that brakes.

    Raises `UsageError` where voltage, resistance or constant of the motor is not known, and where a series machine is
    to feed a source, or to excite itself with nothing that limits its current.

    >>> motor = Motor("shunt", 2e3, 150.0, kind="shunt", voltage=220.0, resistance=0.5, constant=1.4)
    >>> line = braking(motor, Braking("dynamic", resistance=0.9))
    >>> round(line.moment(100.0), 9), line.moment(0.0)
    (-140.0, 0.0)
    >>> motor = Motor("series", 4e3, 100.0, kind="series", voltage=220.0, resistance=1.0, saturation=0.3)
    >>> curve = braking(motor, Braking("dynamic", resistance=9.0))
    >>> round(curve.moment(100.0), 9), round(critical_speed(curve), 9), curve.moment(60.0)
    (-40.0, 70.0, 0.0)
    """
    if motor.kind == "series" and how.field is None:
        return _in_series(motor, how)
    own = motor.known("voltage")
    source = own if how.voltage is None else how.voltage
    voltage = {"regenerative": source, "dynamic": 0.0, "plugging": -own}[how.kind]
    k, resistance = independent(motor, how)
    return Straight(k * k / (resistance + how.resistance), voltage / k, name=how.kind)


def critical_speed(line: Characteristic) -> float | None:
    """Speed above which the machine of a braking ``line`` excites itself [rad/s]; None: its field is independent."""
    if not isinstance(line, Series) or line.way > 0:
        return None
    return line.drop / line.rate


def independent(motor: Motor, how: Braking) -> tuple[float, float]:
    """Constant k [V*s/rad] and resistance of the armature [ohm] while the field does not hang on its current."""
    if motor.kind != "series" or how.field is None:
        return motor.known("constant"), motor.known("resistance")
    own = _series(motor)
    flux = how.field / (1 + own.bend * how.field)
    return motor.known("voltage") * own.rate * flux, motor.known("resistance") - motor.field_resistance


def _in_series(motor: Motor, how: Braking) -> Series:
    """The machine with its field turned round against the armature."""
    own = _series(motor)
    if how.kind == "regenerative":
        raise UsageError(
            "a series motor cannot feed a source: its field falls with its own current, which ends before its EMF "
            "comes up to the voltage",
            where=f"motor {motor.name}",
            remedy="give its field a source of its own, or let it brake dynamically",
        )
    if how.kind == "dynamic" and not own.bend:
        raise UsageError(
            "a series motor whose flux is in proportion to its current has nothing that limits the current with which "
            "it excites itself",
            where=f"motor {motor.name}",
            remedy="give its saturation, or its field a source of its own",
        )
    drop = own.drop * (1 + how.resistance / motor.known("resistance"))
    return own._replace(drop=drop, way=-1.0, voltage=float(how.kind == "plugging"), nominal=None, name=how.kind)


def _series(motor: Motor) -> Series:
    """The machine as it drives, by its circuit."""
    motor.known("voltage")
    motor.known("resistance")
    found = characteristic(motor, "series")
    assert isinstance(found, Series)
    return found
