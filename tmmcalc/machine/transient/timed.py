"""The records that the transient stage leaves, apart from the code that makes them."""

from __future__ import annotations

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.machine.timescales import TimeScales
from tmmcalc.machine.transient.results import End, Event
from tmmcalc.machine.verdicts import Verdict


@record
class TimedMotion:
    """One motion in time: what `results.Transient` holds, but for the drive; S times, N masses from the motor on."""

    name: str
    masses: tuple[str, ...]  # (N,) names
    ratios: tuple[float, ...]  # (N,) speed of each mass over the speed of the crank while no shaft is twisted
    t: Values  # (S,) [s]
    theta: Values  # (N, S) [rad]
    omega: Values  # (N, S) [rad/s]
    alpha: Values  # (N, S) [rad/s^2]
    shaft_moment: Values  # (N - 1, S) [N*m]
    rigid_moment: tuple[float, ...]  # (N - 1,) its largest size if all shafts were rigid [N*m]; () if they are
    motor_moment: Values  # (S,) on the shaft of the first mass [N*m]
    rated_moment: float | None  # of the motor there [N*m]; None: not known
    load_moment: Values  # (S,) on the crank, positive drives [N*m]
    load_factor: Values  # (S,)
    kinetic: Values  # (S,) [J]
    elastic: Values  # (S,) [J]
    motor_work: Values  # (S,) [J]
    load_work: Values  # (S,) [J]
    brake_work: Values  # (S,) [J]
    shaft_loss: Values  # (S,) [J]
    largest_moment: Values  # (2, N) of largest size and its time: of the shafts, last of the motor [N*m], [s]
    turning: Values  # (3, P) time, angle, speed of the crank at the local extremes of its speed
    step_error: Values | None  # (S,) estimated in the step to t (Merson)
    events: tuple[Event, ...]
    end: End
    verdicts: tuple[Verdict, ...]
    method: str
    reason: str
    scales: TimeScales | None
    rigid: tuple[int, ...]
    imbalance: float  # of the energy [-]
    error: float  # estimated relative error of the speeds [-]
    extremes_error: float  # the same of the largest moments
    counters: dict[str, int]


@record
class TimedMotions:
    """Result of the transient stage: one motion a scenario."""

    motions: tuple[TimedMotion, ...]
