"""Reduction of a characteristic to another shaft: M(omega) = u M_motor(u omega), less the losses of the gearing.

u = omega_motor/omega is the gear ratio, positive. Losses take from a driving moment and help a braking one: the
efficiency multiplies the first and divides the second.
"""

from __future__ import annotations

from typing import NamedTuple

from tmmcalc.core.errors import UsageError
from tmmcalc.machine.motors.characteristics import (
    Characteristic,
    ConstantMoment,
    Kloss,
    N,
    Parabolic,
    Straight,
    require_positive,
)
from tmmcalc.machine.motors.direct_current import Series


class Reduced(NamedTuple):
    """A characteristic seen through a gearing with losses."""

    base: Characteristic  # on the motor shaft
    ratio: float  # u [-]
    mean: float  # of the factors of a driving moment, u eta, and of a braking one, u/eta [-]
    half: float  # half their difference, driving less braking [-]
    synchronous: float | None  # [rad/s], as all speeds on the new shaft
    nominal: float | None
    critical: float | None
    least: float | None
    most: float | None
    name: str

    def moment(self, omega: N) -> N:
        """Moment [N*m]."""
        m = self.base.moment(self.ratio * omega)
        return self.mean * m + self.half * abs(m)

    def slope(self, omega: N) -> N:
        """Derivative [N*m*s/rad]; at no load that of the braking side."""
        x = self.ratio * omega
        braking = self.base.moment(x) <= 0
        return self.base.slope(x) * (self.ratio * (self.mean + self.half * (1 - 2 * braking)))


def reduced(characteristic: Characteristic, ratio: float, efficiency: float = 1.0) -> Characteristic:
    """The characteristic on the shaft that the motor turns ``ratio`` times as fast (textbook 3.54).

    ``efficiency`` of the gearing [-]. Without losses a closed form stays one. Raises `UsageError` unless the ratio is
    positive and 0 < efficiency <= 1.

    >>> from tmmcalc.machine.motors.characteristics import straight
    >>> reduced(straight(10.0, 100.0, 105.0), 20.0).moment(5.0)
    200.0
    >>> reduced(straight(10.0, 100.0, 105.0), 20.0, 0.9).moment(5.0)
    180.0
    """
    require_positive(ratio, "gear ratio")
    if not 0 < efficiency <= 1:
        raise UsageError(
            f"the efficiency of the gearing is {efficiency:g}; it lies above 0 and is at most 1",
            where="motor characteristic",
            value=efficiency,
            limit=1.0,
        )
    if efficiency == 1:
        closed = _closed(characteristic, ratio)
        if closed is not None:
            return closed
    driving, braking = ratio * efficiency, ratio / efficiency
    return Reduced(
        characteristic,
        ratio,
        (driving + braking) / 2,
        (driving - braking) / 2,
        _slower(characteristic.synchronous, ratio),
        _slower(characteristic.nominal, ratio),
        _slower(characteristic.critical, ratio),
        _slower(characteristic.least, ratio),
        _slower(characteristic.most, ratio),
        characteristic.name,
    )


def points_of(motor: Characteristic) -> tuple[float, ...]:
    """Speeds [rad/s] of the points between which a characteristic is smooth; none of a closed form."""
    if isinstance(motor, Reduced):
        return tuple(speed / motor.ratio for speed in points_of(motor.base))
    points: tuple[float, ...] = getattr(motor, "speeds", ())
    return points


def pole_of(motor: Characteristic) -> float | None:
    """Speed at which a characteristic has no bounds [rad/s]; None of one that is bounded everywhere."""
    if isinstance(motor, Reduced):
        return _slower(pole_of(motor.base), motor.ratio)
    return motor.pole if isinstance(motor, Series) else None


def _closed(motor: Characteristic, u: float) -> Characteristic | None:
    """The same form with other constants; None for a characteristic that is not one of the closed forms."""
    match motor:
        case Parabolic(a, b, synchronous, nominal, critical, name):
            return Parabolic(a * u, b * u**3, synchronous / u, nominal / u, _slower(critical, u), name)
        case Straight(stiffness, synchronous, nominal, critical, least, most, name):
            inner = _slower(nominal, u), _slower(critical, u)
            return Straight(stiffness * u * u, synchronous / u, *inner, _slower(least, u), _slower(most, u), name)
        case Kloss(scale, square, synchronous, critical, nominal, name):
            return Kloss(scale, square / (u * u), synchronous / u, critical / u, _slower(nominal, u), name)
        case Series(scale=scale, rate=rate, nominal=nominal):
            return motor._replace(scale=scale * u, rate=rate * u, nominal=_slower(nominal, u))
        case ConstantMoment(value=value, nominal=nominal):
            return ConstantMoment(value * u, _slower(nominal, u))
    return None


def _slower(speed: float | None, ratio: float) -> float | None:
    return None if speed is None else speed / ratio
