"""What drives the input shaft, and the constant inertia that goes round with it."""

from __future__ import annotations

from tmmcalc.machine.motors.characteristics import Characteristic
from tmmcalc.machine.motors.gearing import reduced
from tmmcalc.machine.motors.model import CharacteristicKind, Motor, characteristic
from tmmcalc.records import record


@record
class Driver:
    """A motor as the input shaft feels it."""

    characteristic: Characteristic  # reduced to the input shaft
    time_constant: float  # tau_e [s]


@record
class ConstantInertia:
    """Parts of the constant inertia, all reduced to the input shaft [kg*m^2]."""

    rotor: float = 0.0
    gears: float = 0.0
    further: float = 0.0
    flywheel: float = 0.0

    @property
    def total(self) -> float:
        """Their sum [kg*m^2]."""
        return self.rotor + self.gears + self.further + self.flywheel


def driver_of(
    motor: Motor, kind: CharacteristicKind, ratio: float, efficiency: float = 1.0, time_constant: float = 0.0
) -> Driver:
    """A motor behind gears of the given ratio (motor speed over input speed) and efficiency."""
    return Driver(reduced(characteristic(motor, kind), ratio, efficiency), time_constant)
