"""The steady motion of a machine: the regime, the idle run beside it, the methods of the textbook."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import AccuracyError, NoSolutionError
from tmmcalc.core.numerics.panels import Panels, Values
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.driver import ConstantInertia, Driver
from tmmcalc.machine.motorside import MotorSide, motor_side
from tmmcalc.machine.nodes import LEVEL, NEAR, at_speed, both_sides, on_edges
from tmmcalc.machine.offspeed import INPUT, off_speed
from tmmcalc.machine.regime import Regime
from tmmcalc.machine.textbook import EnergyMotion, Textbook, Turn
from tmmcalc.machine.timescales import TimeScales
from tmmcalc.machine.verdicts import Verdict, verdicts

if TYPE_CHECKING:
    from tmmcalc.machine.flywheel.placement import Wheel
    from tmmcalc.machine.model import FlywheelTask
    from tmmcalc.machine.recurrence import Nodes
    from tmmcalc.machine.reduction.results import Reduction


class Positions(NamedTuple):
    """The positions of a machine, and what acts in them: where that jumps it tells which side of the jump is meant."""

    labels: tuple[str, ...]  # (n,)
    phi: Values  # (n,) input coordinate counted from position 0 [rad]
    theta: Values  # (n,) the same along the motion
    moment: Values | None = None  # (n,) reduced moment along the motion at the mean speed [N*m]; None: just after

    @classmethod
    def of(cls, reduction: Reduction) -> Positions:
        """Those of a reduction."""
        sense = math.copysign(1.0, reduction.phi[-1])
        theta = np.abs(reduction.phi - reduction.phi[0])
        return cls(reduction.labels, reduction.phi, theta, sense * reduction.total)


class Existing(NamedTuple):
    """A flywheel that is there, of which a size is given."""

    task: FlywheelTask
    ratio: float  # speed of its shaft over that of the input shaft


@record
class Motion:
    """Result of the motion stage over n positions; moments, inertias and speeds are those of the input shaft."""

    labels: tuple[str, ...]  # (n,)
    phi: Values  # (n,) input coordinate counted from position 0 [rad]
    theta: Values  # (n,) the same along the motion
    early: NDArray[np.bool_]  # (n,) where what acts is the limit just before a jump
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
    by_energy: EnergyMotion | None = None  # by the textbook without a motor; None: with one, or it is not done

    @derived("omega_textbook[rad/s]", "speed by the recurrence, without a motor by the energy", source="(3.57), (3.48)")
    def omega_textbook(self) -> Values | None:
        """At the positions (n,); None where neither is done."""
        if self.by_energy is not None:
            return self.by_energy.omega
        return self.textbook.regime.omega if self.textbook is not None else None

    @derived("omega_textbook_error", "largest difference of its speeds from the exact regime, against the mean speed")
    def textbook_error(self) -> float | None:
        """Of the recurrence, or of the energy."""
        nodal = self.omega_textbook
        return None if nodal is None else float(np.max(np.abs(nodal - self.omega)) / np.mean(self.omega))


def solve_motion(
    cycle: Cycle,
    idle: Cycle | None,
    inertia: ConstantInertia,
    driver: Driver | None,
    speed: float,
    positions: Positions,
    key: str = INPUT,
    undriven: bool = False,
    there: Existing | None = None,
    *,
    tolerance: float = 0.0,
) -> Motion:
    """The steady motion; ``driver`` None: a constant driving moment at the mean ``speed`` [rad/s], or none at all.

    ``idle`` is the cycle without technological loads; ``key`` is where the spec gives the speed of the cycle;
    ``undriven``: the loads alone set the speed; ``there``: the flywheel that the ``inertia`` has. ``tolerance``:
    relative error asked of a motor's regime, 0 near rounding. Raises `NoSolutionError` where the machine stalls, runs
    away, its energy does not last for a cycle, or no speed balances its loads.
    """
    sense = math.copysign(1.0, positions.phi[-1])
    settled = _by_drive(driver, speed, undriven, tolerance)
    regime = settled(cycle, inertia.total, sense=sense)
    quiet = None if undriven or idle is None else _quiet(partial(settled, idle, inertia.total))
    return motion_of(cycle, regime, quiet, inertia, driver, positions, key, undriven, there)


def motion_of(
    cycle: Cycle,
    regime: Regime,
    quiet: Regime | None,
    inertia: ConstantInertia,
    driver: Driver | None,
    positions: Positions,
    key: str = INPUT,
    undriven: bool = False,
    there: Existing | None = None,
) -> Motion:
    """The result from the regime and that without technological loads, ``quiet``."""
    labels, phi, theta, _ = positions
    sense = math.copysign(1.0, phi[-1])
    at, early = _placed(cycle, theta), _early(cycle, theta, positions.moment)
    moving = np.stack((regime.omega, regime.acceleration, regime.driving))
    omega, eps, driving = sided(cycle, regime.panels, moving, theta, early)
    wheel = existing(there, inertia.flywheel, regime.omega_max)
    load = sided(cycle, cycle.panels, np.stack((cycle.moment, cycle.viscous, cycle.quadratic)), theta, early)
    return Motion(
        labels=labels,
        phi=phi,
        theta=theta,
        early=early,
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
        textbook=_textbook(cycle, inertia, driver, theta),
        verdicts=(
            *(() if wheel is None else wheel.verdicts),
            *_verdicts(cycle, regime, driver, sense, key, undriven),
        ),
        balancing=cycle.balancing,
        motor=motor_side(regime, driver) if driver is not None else None,
        scales=_scales(cycle, regime, driver) if driver is not None else None,
        by_energy=_by_energy(cycle, regime, inertia, theta) if driver is None and not undriven else None,
    )


def existing(there: Existing | None, inertia: float, fastest: float) -> Wheel | None:
    """The flywheel that is there, if a size of it is given: its rim follows from its ``inertia`` at the input shaft.

    ``fastest`` is the largest speed of that shaft [rad/s].
    """
    if there is None:
        return None
    from tmmcalc.machine.flywheel.placement import wheels

    return wheels(there.task, inertia, fastest, there.ratio, None)[0]


def _placed(cycle: Cycle, theta: Values) -> Values:
    """Angles (n,) within the cycle."""
    return on_edges(cycle.panels.edges, np.clip(theta, 0.0, cycle.period), NEAR * cycle.period)


def _early(cycle: Cycle, theta: Values, moment: Values | None) -> NDArray[np.bool_]:
    """In which positions (n,) the ``moment`` that acts there is that just before a jump."""
    if moment is None:
        return np.zeros(len(theta), bool)
    whole = at_speed(cycle, cycle.speed)
    after, before = both_sides(cycle, whole, _placed(cycle, theta))
    apart = LEVEL * float(np.max(np.abs(whole)))
    return np.asarray(np.abs(before - moment) < np.abs(after - moment) - apart)


def sided(cycle: Cycle, panels: Panels, values: Values, theta: Values, early: NDArray[np.bool_]) -> Values:
    """Functions (..., K, N) on panels at angles (n,) of a cycle, where ``early`` (n,) the limits just before."""
    at = _placed(cycle, theta)
    return np.where(early, panels.at(values, at, before=True), panels.at(values, at))


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


def _by_drive(driver: Driver | None, speed: float, undriven: bool, tolerance: float) -> Callable[..., Regime]:
    """The function ``(cycle, constant inertia, sense=1)`` that finds the regime, by what drives the machine."""
    if undriven:
        from tmmcalc.machine.selfregulation import self_regulated

        return self_regulated
    if driver is None:
        from tmmcalc.machine.positional import positional

        return partial(positional, speed=speed)
    from tmmcalc.machine.steady import driven

    motor, lag = driver.characteristic, driver.time_constant
    return partial(driven, characteristic=motor, time_constant=lag, tolerance=tolerance)


def _quiet(idle: Callable[[], Regime]) -> Regime | None:
    """The idle run, if there is a regime of it: it is shown beside the loaded one and decides nothing."""
    try:
        return idle()
    except (NoSolutionError, AccuracyError):
        return None


def _steps(cycle: Cycle, theta: Values) -> int | None:
    """Number of the steps of the positions; None where they are not equal."""
    n = len(theta) - 1
    return n if n > 1 and np.ptp(np.diff(theta)) <= 1e-9 * cycle.period / n else None


def _by_energy(cycle: Cycle, regime: Regime, inertia: ConstantInertia, theta: Values) -> EnergyMotion | None:
    """The motion without a motor as the textbook finds it, on an equal grid."""
    n = _steps(cycle, theta)
    if n is None:
        return None
    from tmmcalc.machine.byenergy import by_energy

    try:
        return by_energy(cycle, inertia.total, regime.mean, n)
    except NoSolutionError:
        return None


def _textbook(cycle: Cycle, inertia: ConstantInertia, driver: Driver | None, theta: Values) -> Textbook | None:
    """The recurrence of the course, for a parabola on an equal grid."""
    n = _steps(cycle, theta)
    parabola = _parabola(driver)
    if parabola is None or n is None:
        return None
    from tmmcalc.machine import recurrence

    a, b, rated = parabola
    nodes = recurrence.on_nodes(cycle, inertia.total, a, b, n)
    try:
        regime = recurrence.periodic(nodes)
    except (NoSolutionError, AccuracyError):
        return None
    return Textbook(a, b, regime, _turns(nodes, rated))


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
