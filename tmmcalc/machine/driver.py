"""What drives the input shaft, and the constant inertia that goes round with it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.machine.motors.characteristics import Characteristic
    from tmmcalc.machine.motors.model import CharacteristicKind, Motor

UNDRIVEN = "none"  # name of the characteristic of no motor


@record
class Driver:
    """A motor as the input shaft feels it."""

    characteristic: Characteristic  # reduced to the input shaft
    time_constant: float  # tau_e [s]
    ratio: float = 1.0  # of the gears: speed of the motor over that of the input
    efficiency: float = 1.0  # of the gears


@record
class ConstantInertia:
    """Parts of the constant inertia, all reduced to the input shaft [kg*m^2]."""

    rotor: float = quantity("J_rotor[kg*m^2]", "inertia of the motor's rotor", default=0.0)
    gears: float = quantity("J_gears[kg*m^2]", "inertia of the gears", default=0.0)
    further: float = quantity("J_further[kg*m^2]", "further constant inertia", default=0.0)
    flywheel: float = quantity("J_flywheel[kg*m^2]", "inertia of the flywheel", default=0.0)
    train: str = quantity("gear_train", "gear train whose inertia that of the gears is; empty: as given", default="")

    open: str = quantity("open_pair", "open pair that is in that of the gears; empty: none", default="")

    @derived("J_c[kg*m^2]", "constant inertia")
    def total(self) -> float:
        """The sum of the parts."""
        return self.rotor + self.gears + self.further + self.flywheel


def driver_of(
    motor: Motor, kind: CharacteristicKind, ratio: float, efficiency: float = 1.0, time_constant: float = 0.0
) -> Driver:
    """A motor behind gears of the given ratio (motor speed over input speed) and efficiency."""
    from tmmcalc.machine.motors.gearing import reduced
    from tmmcalc.machine.motors.model import characteristic

    return Driver(reduced(characteristic(motor, kind), ratio, efficiency), time_constant, ratio, efficiency)
