"""Direct-current motors: the moment over speed from the equation of the armature circuit.

U = I R + E with E = k omega (shunt or independent field) or E = c I omega/(1 + b I/I_N) (series field; with b = 0 the
flux is proportional to the current); the moment E I/omega is electromagnetic, friction is not taken off.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.machine.motors.characteristics import WHERE, N, Straight, require_positive

ENDLESS = 1e12  # current over the rated one that stands for one without limit


class Series(NamedTuple):
    """A machine whose field carries the current of its armature, by its current j in parts of the rated one.

        v (1 + b j) = r j (1 + b j) + e kappa omega j,   M = e m j^2/(1 + b j)

    with the flux j/(1 + b j) of iron that saturates (Froehlich), proportional to the current for b = 0: then
    M = m v^2/(r + kappa omega)^2, which has a pole at the speed -r/kappa. The field turned round against the armature,
    e = -1, it brakes. A machine that drives has no no-load speed: unloaded it runs away.
    """

    scale: float  # m = M_N (1 + b) [N*m]
    rate: float  # kappa, by which the EMF follows the speed [s/rad]
    drop: float  # r, the voltage lost in the circuit at the rated current over the rated voltage [-]
    bend: float = 0.0  # b [-]
    way: float = 1.0  # e: 1 drives, -1 brakes
    voltage: float = 1.0  # v, that of the source over the rated one: 1, or 0 without a source
    nominal: float | None = None  # [rad/s]
    synchronous: None = None
    critical: None = None
    name: str = "series"

    @property
    def least(self) -> float | None:
        """Standstill, where the flux is proportional to the current: below it a driven machine has its pole."""
        return 0.0 if self.way > 0 and not self.bend else None

    @property
    def most(self) -> float | None:
        """The pole of a braking machine whose flux is proportional to the current."""
        return self.pole if self.way < 0 else None

    @property
    def pole(self) -> float | None:
        """Speed -e r/kappa from which on nothing limits the current, if the flux is proportional to it [rad/s]."""
        return None if self.bend else -self.way * self.drop / self.rate

    def moment(self, omega: N) -> N:
        """Moment [N*m]."""
        j = self.current(omega)
        return self.way * self.scale * j * j / (1.0 + self.bend * j) + 0.0  # no moment has no sign

    def slope(self, omega: N) -> N:
        """Derivative [N*m*s/rad]."""
        j, b = self.current(omega), self.bend
        p = self._linear(omega)
        root = (p * p + 4.0 * self.drop * b * self.voltage) ** 0.5
        flux = 1.0 + b * j
        return -self.scale * self.rate * j * j * (2.0 + b * j) / (flux * flux * (root + 1e-300))

    def current(self, omega: N) -> N:
        """The current over the rated one [-]: the root of r b j^2 + p j = v with p = r + e kappa omega - v b."""
        p = self._linear(omega)
        if isinstance(p, (float, int)):
            return self._above(p) if p > 0 else self._below(p)
        found: N = np.where(p > 0, self._above(np.where(p > 0, p, 1.0)), self._below(np.where(p > 0, 0.0, p)))
        return found

    def _linear(self, omega: N) -> N:
        return self.drop - self.voltage * self.bend + self.way * self.rate * omega

    def _above(self, p: N) -> N:
        """The root where p is positive, without a difference of what is nearly equal."""
        v = self.voltage
        return 2.0 * v / (p + (p * p + 4.0 * self.drop * self.bend * v) ** 0.5)

    def _below(self, p: N) -> N:
        """The root where p is not positive; where nothing saturates, beyond the pole, only trial steps come."""
        if not self.bend:
            return 0.0 * p + self.voltage * ENDLESS
        b = self.bend
        return ((p * p + 4.0 * self.drop * b * self.voltage) ** 0.5 - p) / (2.0 * self.drop * b)


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


def series(moment: float, nominal: float, drop: float, saturation: float = 0.0) -> Series:
    """Direct-current motor with series field through its rated point, of ``moment`` M_N at ``nominal`` omega_N.

    ``drop`` = I_N R/U [-], the part of the voltage lost in the windings at the rated point; where copper losses
    prevail it is 1 - efficiency. ``saturation`` [-] is the part of the flux that the iron lacks at the rated current.
    Without it M = M_N ((omega_N + a)/(omega + a))^2 with a = omega_N drop/(1 - drop). Raises `UsageError` unless
    0 < drop < 1 and 0 <= saturation < 1.

    >>> round(series(40.0, 100.0, 0.2).moment(0.0), 9)
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
    if not 0 <= saturation < 1:
        text = f"the saturation of a series motor takes {saturation:g} of its flux; it is at least 0, and below 1"
        raise UsageError(text, where=WHERE, value=saturation, limit=1.0)
    bend = saturation / (1 - saturation)
    return Series(moment * (1 + bend), (1 - drop) * (1 + bend) / nominal, drop, bend, nominal=nominal)


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
