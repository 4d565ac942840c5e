"""Electric braking of a direct-current machine with shunt or independent field: lines through the second quadrant.

The armature circuit with an added resistance R_a and the voltage V of what it is connected to gives

    M = k (V - k omega)/(R + R_a)

    regenerative   V > 0 below k omega: the machine feeds the source; down to V/k, where the moment ends
    dynamic        V = 0: the armature on a resistor; the moment falls with the speed to nothing
    plugging       V = -U: the armature turned round; it still brakes at rest, and would turn the machine back

so that a rotor of the inertia J alone falls towards V/k with the time constant J (R + R_a)/k^2.
"""

from __future__ import annotations

from typing import Literal

from tmmcalc.core.records import record
from tmmcalc.machine.motors.characteristics import Straight
from tmmcalc.machine.motors.model import Motor

BrakingKind = Literal["regenerative", "dynamic", "plugging"]


@record
class Braking:
    """How the armature is connected while the machine brakes."""

    kind: BrakingKind
    resistance: float = 0.0  # R_a, added to the armature circuit [ohm]
    voltage: float | None = None  # V of the source in regenerative braking [V]; None: that of the motor


def braking(motor: Motor, how: Braking) -> Straight:
    """The characteristic on the shaft of a ``motor`` that brakes.

    Raises `UsageError` where voltage, resistance or constant of the motor is not known.

    >>> motor = Motor("shunt", 2e3, 150.0, kind="shunt", voltage=220.0, resistance=0.5, constant=1.4)
    >>> line = braking(motor, Braking("dynamic", resistance=0.9))
    >>> round(line.moment(100.0), 9), line.moment(0.0)
    (-140.0, 0.0)
    """
    own, k = motor.known("voltage"), motor.known("constant")
    source = own if how.voltage is None else how.voltage
    voltage = {"regenerative": source, "dynamic": 0.0, "plugging": -own}[how.kind]
    return Straight(k * k / (motor.known("resistance") + how.resistance), voltage / k, name=how.kind)
