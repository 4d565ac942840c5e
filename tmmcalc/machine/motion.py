"""The steady motion of a machine: the regime, the idle run beside it, the recurrence of the textbook."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Literal

import numpy as np

from tmmcalc.core.errors import AccuracyError, NoSolutionError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.driver import ConstantInertia, Driver
from tmmcalc.machine.motorside import MotorSide, motor_side
from tmmcalc.machine.offspeed import INPUT, off_speed
from tmmcalc.machine.regime import Regime
from tmmcalc.machine.textbook import Textbook, Turn
from tmmcalc.machine.timescales import TimeScales
from tmmcalc.machine.verdicts import Verdict, verdicts

if TYPE_CHECKING:
    from tmmcalc.machine.recurrence import Nodes


@record
class Motion:
    """Result of the motion stage over n positions; moments, inertias and speeds are those of the input shaft."""

    labels: tuple[str, ...]  # (n,)
    phi: Values  # (n,) input coordinate counted from position 0 [rad]
    theta: Values  # (n,) the same along the motion
    kind: Literal["motor", "positional", "none"] = quantity("drive", "what drives the machine")
    characteristic: str = quantity(  # of positional forces "constant moment", of no drive "none"
        "characteristic", "name of the motor's characteristic"
    )
    inertia: ConstantInertia
    regime: Regime
    idle: Regime | None  # without technological loads; None where there is none
    omega: Values = quantity("omega[rad/s]", "angular speed of the input, positive")  # (n,)
    eps: Values = quantity("eps[rad/s^2]", "angular acceleration of the input")  # (n,)
    time: Values = quantity("t[s]", "time since position 0")  # (n,)
    driving: Values = quantity("M_d[N*m]", "moment of the drive")  # (n,)
    load: Values = quantity("M_load[N*m]", "reduced moment of everything else at that speed")  # (n,)
    omega_idle: Values | None = quantity("omega_idle[rad/s]", "angular speed without technological loads")  # (n,)
    textbook: Textbook | None
    verdicts: tuple[Verdict, ...]
    balancing: float = quantity(
        "M_balancing[N*m]", "moment that closes the work of a diagram before anything drives", default=0.0
    )
    motor: MotorSide | None = None  # the regime at the shaft of the motor; None without one
    scales: TimeScales | None = None  # time constants over the cycle; None: nothing depends on the speed of a motor

    @derived("omega_textbook[rad/s]", "speed by the recurrence", source="(3.57)")
    def omega_textbook(self) -> Values | None:
        """At the positions (n,); None where the recurrence is not done."""
        return self.textbook.regime.omega if self.textbook is not None else None


def solve_motion(
    cycle: Cycle,
    idle: Cycle | None,
    inertia: ConstantInertia,
    driver: Driver | None,
    speed: float,
    positions: tuple[tuple[str, ...], Values, Values],
    key: str = INPUT,
    *,
    undriven: bool = False,
    tolerance: float = 0.0,
) -> Motion:
    """The steady motion; ``driver`` None: a constant driving moment at the mean ``speed`` [rad/s], or none at all.

    ``idle`` is the cycle without technological loads; ``positions`` are labels, phi and theta (n,); ``key`` is where
    the spec gives the speed of the cycle; ``undriven``: the loads alone set the speed. ``tolerance``: relative
    error asked of a motor's regime, 0 near rounding. Raises `NoSolutionError` where
    the machine stalls, runs away, its energy does not last for a cycle, or no speed balances its loads.
    """
    sense = math.copysign(1.0, positions[1][-1])
    if undriven:
        from tmmcalc.machine.selfregulation import self_regulated

        regime, quiet = self_regulated(cycle, inertia.total, sense=sense), None
    else:
        regime = _regime(cycle, inertia, driver, speed, sense, tolerance)
        quiet = _idle(idle, inertia, driver, speed, tolerance)
    return motion_of(cycle, regime, quiet, inertia, driver, positions, key, undriven=undriven)


def motion_of(
    cycle: Cycle,
    regime: Regime,
    quiet: Regime | None,
    inertia: ConstantInertia,
    driver: Driver | None,
    positions: tuple[tuple[str, ...], Values, Values],
    key: str = INPUT,
    *,
    undriven: bool = False,
) -> Motion:
    """The result from the regime and that without technological loads, ``quiet``."""
    labels, phi, theta = positions
    sense = math.copysign(1.0, phi[-1])
    at = np.clip(theta, 0.0, cycle.period)
    omega, eps, driving = regime.panels.at(np.stack((regime.omega, regime.acceleration, regime.driving)), at)
    load = cycle.panels.at(np.stack((cycle.moment, cycle.viscous, cycle.quadratic)), at)
    return Motion(
        labels=labels,
        phi=phi,
        theta=theta,
        kind="none" if undriven else "positional" if driver is None else "motor",
        characteristic=_called(driver, undriven),
        inertia=inertia,
        regime=regime,
        idle=quiet,
        omega=omega,
        eps=eps,
        time=regime.time_at(at),
        driving=driving,
        load=load[0] + load[1] * omega + load[2] * omega**2,
        omega_idle=quiet.omega_at(at) if quiet is not None else None,
        textbook=_textbook(cycle, inertia, driver, theta, omega),
        verdicts=_verdicts(cycle, regime, driver, sense, key, undriven),
        balancing=cycle.balancing,
        motor=motor_side(regime, driver) if driver is not None else None,
        scales=_scales(cycle, regime, driver) if driver is not None else None,
    )


def _scales(cycle: Cycle, regime: Regime, driver: Driver) -> TimeScales | None:
    from tmmcalc.machine.regimescales import regime_scales

    return regime_scales(cycle, regime, driver)


def _called(driver: Driver | None, undriven: bool) -> str:
    """The name of what drives."""
    if driver is not None:
        return driver.characteristic.name
    return "none" if undriven else "constant moment"


def _verdicts(
    cycle: Cycle, regime: Regime, driver: Driver | None, sense: float, key: str, undriven: bool
) -> tuple[Verdict, ...]:
    """What there is to say of the regime, warnings first."""
    found: tuple[Verdict, ...] = ()
    if driver is not None or undriven:
        found = verdicts(regime, driver.characteristic if driver is not None else None, sense)
    off = off_speed(regime.mean, cycle.speed, driver.ratio if driver is not None else None, sense, key)
    if off is None:
        return found
    return tuple(sorted((off, *found), key=lambda verdict: verdict.severity == "note"))


def _regime(
    cycle: Cycle, inertia: ConstantInertia, driver: Driver | None, speed: float, sense: float, tolerance: float
) -> Regime:
    if driver is None:
        from tmmcalc.machine.positional import positional

        return positional(cycle, inertia.total, speed, sense=sense)
    from tmmcalc.machine.steady import driven

    lag = driver.time_constant
    return driven(cycle, inertia.total, driver.characteristic, time_constant=lag, sense=sense, tolerance=tolerance)


def _idle(
    idle: Cycle | None, inertia: ConstantInertia, driver: Driver | None, speed: float, tolerance: float
) -> Regime | None:
    """The idle run, if the machine has one: it is shown beside the loaded one and decides nothing."""
    if idle is None:
        return None
    try:
        return _regime(idle, inertia, driver, speed, 1.0, tolerance)
    except (NoSolutionError, AccuracyError):
        return None


def _textbook(
    cycle: Cycle, inertia: ConstantInertia, driver: Driver | None, theta: Values, omega: Values
) -> Textbook | None:
    """The recurrence of the course, for a parabola on an equal grid."""
    n = len(theta) - 1
    parabola = _parabola(driver)
    if parabola is None or np.ptp(np.diff(theta)) > 1e-9 * cycle.period / n:
        return None
    from tmmcalc.machine import recurrence

    a, b, rated = parabola
    nodes = recurrence.on_nodes(cycle, inertia.total, a, b, n)
    try:
        regime = recurrence.periodic(nodes)
    except (NoSolutionError, AccuracyError):
        return None
    error = float(np.max(np.abs(regime.omega - omega)) / np.mean(omega))
    return Textbook(a, b, regime, _turns(nodes, rated), error)


def _turns(nodes: Nodes, rated: float) -> tuple[Turn, ...]:
    """The iteration turn by turn; none where it does not settle."""
    from tmmcalc.machine.recurrence import turns

    try:
        return turns(nodes, rated)
    except AccuracyError:
        return ()


def _parabola(driver: Driver | None) -> tuple[float, float, float] | None:
    """A, B and the rated speed of a parabola on the input shaft; of gears with losses that of the driving motor."""
    if driver is None or driver.time_constant:
        return None
    from tmmcalc.machine.motors.characteristics import Parabolic
    from tmmcalc.machine.motors.gearing import Reduced

    motor = driver.characteristic
    if isinstance(motor, Parabolic):
        return motor.a, motor.b, motor.nominal
    if isinstance(motor, Reduced) and isinstance(motor.base, Parabolic) and motor.nominal is not None:
        factor = motor.mean + motor.half
        return factor * motor.base.a, factor * motor.ratio**2 * motor.base.b, motor.nominal
    return None
