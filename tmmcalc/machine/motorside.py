"""A steady regime at the shaft of the motor: what the motor gives through its gears, and how that warms it.

The losses of the gears add to a driving moment and take from a braking one: M_motor = M_d/(u eta) where M_d drives,
M_d eta/u where it brakes. A motor warms with the mean square of its moment over the time.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.core.numerics.panels import Values
    from tmmcalc.machine.driver import Driver
    from tmmcalc.machine.regime import Regime


@record
class MotorSide:
    """The steady regime at the shaft of the motor."""

    ratio: float  # u, speed of the motor over that of the input
    efficiency: float  # of the gears
    mean_power: float = quantity("P_motor_mean[W]", "mean power of the motor")
    rms_moment: float = quantity("M_motor_rms[N*m]", "root mean square of the motor's moment over the time")
    largest: float = quantity("M_motor_max[N*m]", "largest moment of the motor")
    rated_moment: float | None  # at the rated speed by its characteristic [N*m]; None: not known

    @derived("M_motor_rms/M_N", "rms moment of the motor over its rated moment")
    def heating(self) -> float | None:
        """Above 1 the motor overheats; None: not known."""
        return self.rms_moment / self.rated_moment if self.rated_moment else None


def motor_side(regime: Regime, driver: Driver) -> MotorSide:
    """The regime of a motor as its own shaft feels it."""
    u, eta, on = driver.ratio, driver.efficiency, regime.panels

    def through_gears(driving: Values) -> Values:
        return driving / u * np.where(driving > 0, 1 / eta, eta)

    moment, largest = through_gears(regime.driving), np.array(regime.driving_extremes[1][0])
    work, heat = on.total(np.stack((moment * u, moment * moment / regime.omega)))
    nominal = driver.characteristic.nominal
    return MotorSide(
        ratio=u,
        efficiency=eta,
        mean_power=float(work) / regime.cycle_time,
        rms_moment=float(heat / regime.cycle_time) ** 0.5,
        largest=float(through_gears(largest)),
        rated_moment=None if nominal is None else float(driver.characteristic.moment(nominal)) / (u * eta),
    )
