r"""Moment of a motor as a function of speed: the contract, and the closed forms of induction motors.

A positive moment drives. Above its no-load speed a motor brakes: the moment is negative. Every form is plain
arithmetic, so that it takes a float as fast as Python can and an array as it stands.

                    K
    M  _ _ _ _ _ .-'-.        K  break-down point, ``critical``
       start -'       \       H  rated point, ``nominal``
                       H       C  synchronous (no-load) speed, ``synchronous``
    0 ------------------C----> omega

The parabola and the straight line replace the working branch HC alone, the form of Kloss the whole curve.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple, Protocol, TypeVar

from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.core.numerics.panels import Values

N = TypeVar("N", float, "Values")

WHERE = "motor characteristic"


class Characteristic(Protocol):
    """Moment over the speed of one shaft, the motor's own or another to which it is reduced.

    ``moment(omega)`` [N*m] and ``slope(omega)`` = dM/domega [N*m*s/rad] take a float or an array.
    """

    @property
    def name(self) -> str:
        """Kind of the characteristic."""

    @property
    def synchronous(self) -> float | None:
        """No-load speed [rad/s]; None: there is none."""

    @property
    def nominal(self) -> float | None:
        """Rated speed [rad/s]; None: unknown."""

    @property
    def critical(self) -> float | None:
        """Speed of the break-down moment [rad/s]; None: there is none, or it is unknown."""

    @property
    def least(self) -> float | None:
        """Lowest speed at which the formula holds [rad/s]; None: at all."""

    @property
    def most(self) -> float | None:
        """Highest speed at which the formula holds [rad/s]; None: at all."""

    def moment(self, omega: N) -> N:
        """Moment [N*m] at ``omega`` [rad/s]."""

    def slope(self, omega: N) -> N:
        """Derivative dM/domega [N*m*s/rad] at ``omega`` [rad/s]."""


class Parabolic(NamedTuple):
    """M = A - B omega^2 on the working branch (textbook 3.55)."""

    a: float  # A [N*m]
    b: float  # B [N*m*s^2/rad^2]
    synchronous: float  # [rad/s]
    nominal: float  # [rad/s]
    critical: float | None = None  # of the motor itself [rad/s]; the parabola has none
    name: str = "parabolic"

    @property
    def least(self) -> float:
        """The rated speed: below it the parabola leaves the curve."""
        return self.nominal

    @property
    def most(self) -> float:
        """The synchronous speed."""
        return self.synchronous

    def moment(self, omega: N) -> N:
        """Moment [N*m]."""
        return self.a - self.b * omega * omega

    def slope(self, omega: N) -> N:
        """Derivative [N*m*s/rad]."""
        return -2.0 * self.b * omega


class Straight(NamedTuple):
    """M = b (omega_c - omega): the working branch as a line, and the whole of a direct-current motor's shunt curve."""

    stiffness: float  # b [N*m*s/rad]
    synchronous: float  # omega_c [rad/s]
    nominal: float | None = None  # [rad/s]
    critical: float | None = None  # of the motor itself [rad/s]; the line has none
    least: float | None = None
    most: float | None = None
    name: str = "linear"

    def moment(self, omega: N) -> N:
        """Moment [N*m]."""
        return self.stiffness * (self.synchronous - omega)

    def slope(self, omega: N) -> N:
        """Derivative [N*m*s/rad]."""
        return 0.0 * omega - self.stiffness


class Kloss(NamedTuple):
    """M = 2 M_K s s_K / (s^2 + s_K^2), s = 1 - omega/omega_c (textbook 3.68), at every speed and slip.

    Written in d = omega_c - omega: M = 2 M_K w d / (d^2 + w^2) with w = s_K |omega_c|.
    """

    scale: float  # 2 M_K w [N*m*rad/s]
    square: float  # w^2 [rad^2/s^2]
    synchronous: float  # omega_c [rad/s]
    critical: float  # omega_K = omega_c - w [rad/s]
    nominal: float | None = None  # [rad/s]
    name: str = "kloss"

    @property
    def least(self) -> None:
        """No limit: the form holds against the field (s > 1) too."""
        return

    @property
    def most(self) -> None:
        """No limit: beyond the synchronous speed (s < 0) the machine is a generator."""
        return

    @property
    def peak(self) -> float:
        """Break-down moment M_K [N*m]."""
        return self.scale / (2 * math.sqrt(self.square))

    def moment(self, omega: N) -> N:
        """Moment [N*m]."""
        d = self.synchronous - omega
        return self.scale * d / (d * d + self.square)

    def slope(self, omega: N) -> N:
        """Derivative [N*m*s/rad]."""
        d = self.synchronous - omega
        d2 = d * d
        sum2 = d2 + self.square
        return self.scale * (d2 - self.square) / (sum2 * sum2)


class ConstantMoment(NamedTuple):
    """The same moment at every speed; 0 is a motor switched off, a negative one a brake."""

    value: float  # [N*m]
    nominal: float | None = None  # [rad/s]
    synchronous: None = None
    critical: None = None
    least: None = None
    most: None = None
    name: str = "constant"

    def moment(self, omega: N) -> N:
        """Moment [N*m]."""
        return 0.0 * omega + self.value

    def slope(self, omega: N) -> N:
        """Derivative: 0."""
        return 0.0 * omega


def parabolic(moment: float, nominal: float, synchronous: float, critical: float | None = None) -> Parabolic:
    """Parabola through the rated point and the synchronous speed (textbook 3.56).

    ``moment`` M_N [N*m] at ``nominal`` omega_N, 0 at ``synchronous`` omega_c [rad/s]. Raises `UsageError` unless
    0 < omega_N < omega_c.

    >>> round(parabolic(110.0, 10.0, 10.71428571).b, 6)
    7.434483
    """
    _ordered(nominal, synchronous)
    b = moment / ((synchronous - nominal) * (synchronous + nominal))
    return Parabolic(b * synchronous * synchronous, b, synchronous, nominal, critical)


def straight(moment: float, nominal: float, synchronous: float, critical: float | None = None) -> Straight:
    """Straight line through the rated point and the synchronous speed; it holds as far beyond the one as before it.

    Arguments and errors as of `parabolic`.

    >>> straight(110.0, 10.0, 10.5).moment(10.25)
    55.0
    """
    _ordered(nominal, synchronous)
    b = moment / (synchronous - nominal)
    return Straight(b, synchronous, nominal, critical, nominal, 2 * synchronous - nominal)


def kloss(peak: float, critical_slip: float, synchronous: float, nominal: float | None = None) -> Kloss:
    """Form of Kloss from its break-down point (textbook 3.68).

    ``peak`` M_K [N*m], ``critical_slip`` s_K [-], ``synchronous`` omega_c and, for reference, ``nominal`` [rad/s].
    Raises `UsageError` unless s_K and omega_c are positive.

    >>> round(kloss(242.0, 0.2773, 10.714).moment(0.0), 3)
    124.63
    """
    require_positive(critical_slip, "critical slip s_K")
    require_positive(synchronous, "synchronous speed")
    width = critical_slip * synchronous
    return Kloss(2 * peak * width, width * width, synchronous, synchronous - width, nominal)


def require_positive(value: float, what: str) -> None:
    """Raise `UsageError` unless ``value`` is positive and finite."""
    if not 0 < value < math.inf:
        raise UsageError(f"the {what} is {value:g}; it is positive", where=WHERE, value=value, limit=0.0)


def _ordered(nominal: float, synchronous: float) -> None:
    require_positive(nominal, "rated speed")
    if not nominal < synchronous < math.inf:
        raise UsageError(
            f"the rated speed {nominal:.6g} rad/s is not below the synchronous speed {synchronous:.6g} rad/s",
            where=WHERE,
            value=nominal,
            limit=synchronous,
            remedy="a motor slips under load: give the speed of its name plate",
        )
