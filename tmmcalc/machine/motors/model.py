"""A motor by its rated data, and the characteristics that they define.

All speeds and moments are those of the motor shaft; `gearing.reduced` carries a characteristic to the input shaft.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Literal

from tmmcalc.core.errors import UsageError
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.machine.motors.characteristics import Characteristic

Interpolation = Literal["linear", "pchip"]
MotorKind = Literal["induction", "shunt", "series"]
CharacteristicKind = Literal["parabolic", "linear", "kloss", "shunt", "series", "constant", "table"]
MOTOR_KINDS = ("induction", "shunt", "series")
RPM = 30 / math.pi  # to a rad/s


@record
class Motor:
    """Rated data of a motor; None: not known."""

    name: str = quantity("motor", "name of the motor")
    power: float = quantity("P_N[W]", "rated power")
    speed: float  # omega_N [rad/s]
    synchronous: float | None = None  # omega_c, of a shunt motor its no-load speed [rad/s]
    overload: float | None = quantity("K", "overload ratio M_K/M_N", default=None)
    inertia: float | None = quantity("J_R[kg*m^2]", "inertia of the rotor", default=None)
    start: float | None = quantity("M_start/M_N", "moment at standstill over the rated one", default=None)
    time_constant: float = quantity(  # 0: the characteristic is followed at once
        "tau_e[s]", "electromagnetic time constant", default=0.0
    )
    kind: MotorKind = quantity("motor_kind", "kind of the motor", default="induction")
    voltage: float | None = quantity("U[V]", "voltage of a direct-current motor", default=None)
    resistance: float | None = quantity("R[ohm]", "resistance of the armature circuit", default=None)
    constant: float | None = quantity("k[V*s/rad]", "constant of a shunt motor", default=None)
    saturation: float = quantity(
        "saturation", "part of the flux that the iron of a series motor lacks at the rated current", default=0.0
    )
    field_resistance: float = 0.0  # of a series motor: part of ``resistance`` that is its field winding [ohm]
    efficiency: float | None = quantity("eta_motor", "efficiency of the motor at its rated point", default=None)
    points: tuple[tuple[float, float], ...] = ()  # measured characteristic: omega [rad/s], M [N*m]
    interpolation: Interpolation = "pchip"  # between the points
    source: str = quantity("motor_source", "where the data of the motor are from", default="")

    def __post_init__(self) -> None:
        """Refuse data that no motor has."""
        if self.kind not in MOTOR_KINDS:
            self._refuse(f"there is no motor of kind {self.kind!r}", remedy=f"kinds: {', '.join(MOTOR_KINDS)}")
        for what in ("power", "speed", "synchronous", "start", "voltage", "resistance", "constant", "efficiency"):
            value = getattr(self, what)
            if value is not None and not 0 < value < math.inf:
                self._refuse(f"the {what} is {value:g}; it is positive", value, 0.0)
        for what in ("inertia", "time_constant", "saturation", "field_resistance"):
            value = getattr(self, what)
            if value is not None and not 0 <= value < math.inf:
                self._refuse(f"the {what} is {value:g}; it is not negative", value, 0.0)
        if self.overload is not None and not 1 < self.overload < math.inf:
            message = f"the overload ratio K = M_K/M_N is {self.overload:g}; it is above 1"
            self._refuse(message, self.overload, 1.0, "give the ratio of the break-down moment to the rated one")
        if not self.saturation < 1:
            self._refuse(f"the saturation is {self.saturation:g}; it is below 1", self.saturation, 1.0)
        if self.efficiency is not None and not self.efficiency < 1:
            self._refuse(f"the efficiency is {self.efficiency:g}; it is below 1", self.efficiency, 1.0)
        if self.synchronous is not None and not self.speed < self.synchronous:
            message = f"rated at {_rpm(self.speed)} rpm, not below the synchronous {_rpm(self.synchronous)} rpm"
            self._refuse(message, self.speed, self.synchronous, "a motor slips under load: see its name plate")

    def _refuse(self, message: str, value: float | None = None, limit: float | None = None, remedy: str = "") -> None:
        raise UsageError(message, where=f"motor {self.name}", value=value, limit=limit, remedy=remedy)

    @derived("M_N[N*m]", "rated moment P_N/omega_N")
    def nominal_moment(self) -> float:
        """On the shaft of the motor."""
        return self.power / self.speed

    @derived("n_N[rpm]", "rated speed")
    def rated_rpm(self) -> float:
        """omega_N in revolutions per minute."""
        return self.speed * RPM

    @derived("n_sync[rpm]", "synchronous speed, of a shunt motor its no-load speed")
    def synchronous_rpm(self) -> float | None:
        """omega_c in revolutions per minute; None: not known."""
        return None if self.synchronous is None else self.synchronous * RPM

    @property
    def nominal_slip(self) -> float:
        """Rated slip s_N = 1 - omega_N/omega_c [-]; raises `UsageError` if the synchronous speed is not known."""
        synchronous = self.known("synchronous")
        return (synchronous - self.speed) / synchronous

    @property
    def critical_slip(self) -> float:
        """Critical slip s_K [-] (textbook 3.67); raises `UsageError` if omega_c or K is not known."""
        return critical_slip(self.known("overload"), self.nominal_slip)

    @property
    def break_down(self) -> float | None:
        """Speed of the break-down moment omega_K [rad/s]; None if omega_c or K is not known."""
        if self.synchronous is None or self.overload is None:
            return None
        return self.synchronous * (1 - self.critical_slip)

    def known(self, what: str) -> float:
        """The datum called ``what``; raises `UsageError` if it is not known."""
        value: float | None = getattr(self, what)
        if value is None:
            raise UsageError(f"the {_NAMES[what]} is not given", where=f"motor {self.name}", remedy=f"add {what}")
        return value


_NAMES = {
    "synchronous": "synchronous (no-load) speed",
    "overload": "overload ratio K = M_K/M_N",
    "voltage": "voltage U",
    "resistance": "armature resistance R",
    "constant": "motor constant k",
    "efficiency": "efficiency",
}


def characteristic(motor: Motor, kind: CharacteristicKind) -> Characteristic:
    """The characteristic of a motor on its own shaft.

    "parabolic" and "linear" ask for the synchronous speed, "kloss" for the overload ratio too; "shunt" for voltage,
    resistance and constant or else the no-load speed; "series" for the efficiency or else voltage and resistance;
    "table" for points; "constant" holds the rated moment. Raises `UsageError` where data are missing, or the kind is
    that of another motor.

    >>> motor = Motor("AO-2-21-4", 1100.0, 146.6, 157.08, 2.2)
    >>> round(characteristic(motor, "kloss").moment(146.6), 4) == round(motor.nominal_moment, 4)
    True
    """
    if kind not in _MAKERS:
        known = ", ".join(_MAKERS)
        raise UsageError(f"there is no characteristic {kind!r}", where=f"motor {motor.name}", remedy=f"kinds: {known}")
    kinds, make = _MAKERS[kind]
    if motor.kind not in kinds:
        fitting = ", ".join(known for known, (of, _) in _MAKERS.items() if motor.kind in of)
        raise UsageError(
            f"a motor of kind {motor.kind!r} has no characteristic {kind!r}",
            where=f"motor {motor.name}",
            remedy=f"its characteristics: {fitting}",
        )
    return make(motor)


def _parabolic(motor: Motor) -> Characteristic:
    from tmmcalc.machine.motors.characteristics import parabolic

    return parabolic(motor.nominal_moment, motor.speed, motor.known("synchronous"), motor.break_down)


def _linear(motor: Motor) -> Characteristic:
    from tmmcalc.machine.motors.characteristics import straight

    return straight(motor.nominal_moment, motor.speed, motor.known("synchronous"), motor.break_down)


def _kloss(motor: Motor) -> Characteristic:
    from tmmcalc.machine.motors.characteristics import kloss

    peak = motor.known("overload") * motor.nominal_moment
    return kloss(peak, motor.critical_slip, motor.known("synchronous"), motor.speed)


def _shunt(motor: Motor) -> Characteristic:
    from tmmcalc.machine.motors.characteristics import Straight, straight
    from tmmcalc.machine.motors.direct_current import shunt

    if motor.voltage is None and motor.resistance is None and motor.constant is None:
        line = straight(motor.nominal_moment, motor.speed, motor.known("synchronous"))
        return Straight(line.stiffness, line.synchronous, motor.speed, name="shunt")
    line = shunt(motor.known("voltage"), motor.known("resistance"), motor.known("constant"), motor.speed)
    if not motor.speed < line.synchronous:
        raise UsageError(
            f"rated at {_rpm(motor.speed)} rpm, not below the no-load speed U/k of {_rpm(line.synchronous)} rpm",
            where=f"motor {motor.name}",
            value=motor.speed,
            limit=line.synchronous,
            remedy="check voltage and constant",
        )
    return line


def _series(motor: Motor) -> Characteristic:
    from tmmcalc.machine.motors.direct_current import series, voltage_drop

    if motor.voltage is None and motor.resistance is None:
        drop = 1 - motor.known("efficiency")
    else:
        drop = voltage_drop(motor.known("voltage"), motor.known("resistance"), motor.power)
    return series(motor.nominal_moment, motor.speed, drop, motor.saturation)


def _constant(motor: Motor) -> Characteristic:
    from tmmcalc.machine.motors.characteristics import ConstantMoment

    return ConstantMoment(motor.nominal_moment, motor.speed)


def _table(motor: Motor) -> Characteristic:
    from tmmcalc.machine.motors.table import table

    return table(motor.points, motor.interpolation, motor.speed)


_MAKERS = {
    "parabolic": (("induction",), _parabolic),
    "linear": (("induction", "shunt"), _linear),
    "kloss": (("induction",), _kloss),
    "shunt": (("shunt",), _shunt),
    "series": (("series",), _series),
    "constant": (MOTOR_KINDS, _constant),
    "table": (MOTOR_KINDS, _table),
}


def critical_slip(overload: float, slip: float) -> float:
    """Critical slip s_K = s_N (K + sqrt(K^2 - 1)) [-] of the form of Kloss (textbook 3.67).

    ``overload`` K = M_K/M_N [-], ``slip`` s_N [-]. Raises `UsageError` unless K > 1 and 0 < s_N < 1.

    >>> round(critical_slip(2.2, 1 / 15), 4)
    0.2773
    """
    if not 1 < overload < math.inf:
        raise UsageError(f"the overload ratio is {overload:g}; it is above 1", where="motor", value=overload, limit=1.0)
    if not 0 < slip < 1:
        raise UsageError(f"the rated slip is {slip:g}; it lies between 0 and 1", where="motor", value=slip, limit=1.0)
    return slip * (overload + math.sqrt((overload - 1) * (overload + 1)))


def electromagnetic_time_constant(critical_slip: float, frequency: float = 50.0) -> float:
    """Time constant tau_e = 1/(2 pi f s_K) [s] with which an induction motor follows its characteristic.

    ``critical_slip`` s_K [-], ``frequency`` f of the mains [Hz].

    >>> round(electromagnetic_time_constant(0.2773), 4)
    0.0115
    """
    if not (critical_slip > 0 and frequency > 0):
        message = f"critical slip {critical_slip:g} and frequency {frequency:g} Hz; both are positive"
        raise UsageError(message, where="motor")
    return 1 / (2 * math.pi * frequency * critical_slip)


def with_lag(motor: Motor, time_constant: float | None) -> Motor:
    """The motor with this time constant [s], None: the one that follows from its critical slip at 50 Hz.

    Raises `UsageError` if that is asked of a motor whose synchronous speed or overload ratio is not known.
    """
    if time_constant is None:
        time_constant = electromagnetic_time_constant(motor.critical_slip)
    return replace(motor, time_constant=time_constant)


def gd2(value: float) -> float:
    """Moment of inertia J = GD^2/4 [kg*m^2] from the flywheel effect GD^2 of a catalogue [kgf*m^2].

    >>> gd2(0.112)
    0.028
    """
    return value / 4


def _rpm(omega: float) -> str:
    return f"{omega * 30 / math.pi:.6g}"
