"""Direct-current motors: the moment over speed from the equation of the armature circuit.

U = I R + E with E = k omega (shunt or independent field) or E = c I omega (series field, flux proportional to the
current); the moment E I/omega is electromagnetic, friction is not taken off.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from tmmcalc.core.errors import UsageError
from tmmcalc.machine.motors.characteristics import WHERE, N, Straight, require_positive


class Series(NamedTuple):
    """M = C / (omega + a)^2: a direct-current motor with series field, its flux proportional to the current.

    U = I (R + c omega) and M = c I^2 give C = U^2/c and a = R/c. There is no no-load speed: an unloaded motor runs
    away. Below the speed 0 the form has a pole at -a.
    """

    scale: float  # C [N*m*rad^2/s^2]
    shift: float  # a [rad/s]
    nominal: float | None = None  # [rad/s]
    synchronous: None = None
    critical: None = None
    least: float = 0.0
    most: None = None
    name: str = "series"

    def moment(self, omega: N) -> N:
        """Moment [N*m]."""
        d = omega + self.shift
        return self.scale / (d * d)

    def slope(self, omega: N) -> N:
        """Derivative [N*m*s/rad]."""
        d = omega + self.shift
        return -2.0 * self.scale / (d * d * d)


def shunt(voltage: float, resistance: float, constant: float, nominal: float | None = None) -> Straight:
    """Direct-current motor with shunt or independent field: M = k (U - k omega)/R.

    ``voltage`` U [V], armature ``resistance`` R [ohm], ``constant`` k [V*s/rad = N*m/A]. Raises `UsageError` if
    one is not positive.

    >>> shunt(220.0, 0.5, 1.375).synchronous
    160.0
    """
    require_positive(voltage, "voltage U")
    require_positive(resistance, "armature resistance R")
    require_positive(constant, "motor constant k")
    return Straight(constant * constant / resistance, voltage / constant, nominal, name="shunt")


def series(moment: float, nominal: float, drop: float) -> Series:
    """Direct-current motor with series field through its rated point: M = M_N ((omega_N + a)/(omega + a))^2.

    ``drop`` = I_N R/U [-], the part of the voltage lost in the windings at the rated point, gives a = R/c =
    omega_N drop/(1 - drop); where copper losses prevail it is 1 - efficiency. Raises `UsageError` unless
    0 < drop < 1.

    >>> series(40.0, 100.0, 0.2).moment(0.0)
    1000.0
    """
    require_positive(nominal, "rated speed")
    if not 0 < drop < 1:
        raise UsageError(
            f"the voltage drop of a series motor is {drop:g} of the voltage; it lies between 0 and 1",
            where=WHERE,
            value=drop,
            limit=1.0,
            remedy="give the efficiency at the rated point, or voltage and resistance",
        )
    shift = nominal * drop / (1 - drop)
    return Series(moment * (nominal + shift) ** 2, shift, nominal)


def voltage_drop(voltage: float, resistance: float, power: float) -> float:
    """Part I R/U [-] of the voltage lost in the windings where a motor gives ``power`` = (U - I R) I [W].

    ``voltage`` U [V], ``resistance`` R [ohm]. Raises `UsageError` if so much power cannot pass the resistance.

    >>> round(voltage_drop(100.0, 1.0, 1600.0), 12)
    0.2
    """
    require_positive(voltage, "voltage U")
    require_positive(resistance, "resistance R")
    share = 4 * resistance * power / (voltage * voltage)
    if share > 1:
        most = voltage * voltage / (4 * resistance)
        raise UsageError(
            f"{power:g} W cannot pass {resistance:g} ohm at {voltage:g} V; the most is U^2/(4 R) = {most:.6g} W",
            where=WHERE,
            value=power,
            limit=most,
            remedy="check voltage and resistance",
        )
    return share / (2 * (1 + math.sqrt(1 - share)))
