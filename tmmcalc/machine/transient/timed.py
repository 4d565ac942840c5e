"""The records that the transient stage leaves, apart from the code that makes them."""

from __future__ import annotations

import math

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.timescales import TimeScales
from tmmcalc.machine.transient.results import End, Event
from tmmcalc.machine.verdicts import Verdict

TURN = 2 * math.pi


@record
class TimedMotion:
    """One motion in time: what `results.Transient` holds, but for the drive; S times, N masses from the motor on."""

    name: str
    masses: tuple[str, ...]  # (N,) names
    ratios: tuple[float, ...]  # (N,) speed of each mass over the speed of the crank while no shaft is twisted
    t: Values = quantity("t[s]", "time")  # (S,)
    theta: Values  # (N, S) [rad]
    omega: Values  # (N, S) [rad/s]
    alpha: Values  # (N, S) [rad/s^2]
    shaft_moment: Values  # (N - 1, S) [N*m]
    rigid_moment: tuple[float, ...]  # (N - 1,) its largest size if all shafts were rigid [N*m]; () if they are
    motor_moment: Values = quantity("M_motor[N*m]", "moment of the motor on the shaft of the first mass")  # (S,)
    rated_moment: float | None = quantity("M_motor_rated[N*m]", "rated moment of the motor")  # None: not known
    load_moment: Values = quantity("M_load[N*m]", "moment of the load on the crank; positive drives")  # (S,)
    load_factor: Values = quantity("load_factor[-]", "factor of the load", symbol="U")  # (S,)
    kinetic: Values = quantity("T[J]", "kinetic energy")  # (S,)
    elastic: Values = quantity("V[J]", "elastic energy")  # (S,)
    motor_work: Values  # (S,) [J]
    load_work: Values  # (S,) [J]
    brake_work: Values  # (S,) [J]
    shaft_loss: Values  # (S,) [J]
    largest_moment: Values  # (2, N) of largest size and its time: of the shafts, last of the motor [N*m], [s]
    turning: Values  # (3, P) time, angle, speed of the crank at the local extremes of its speed
    step_error: Values | None  # (S,) largest error of angle, speed, moment estimated in the step to t (Merson)
    events: tuple[Event, ...]
    end: End = quantity("end", "what ended the motion")
    verdicts: tuple[Verdict, ...]
    method: str = quantity("method", "method that ran")
    reason: str = quantity("method_reason", "why that method ran")
    scales: TimeScales | None
    rigid: tuple[int, ...]
    imbalance: float  # of the energy [-]
    error: float  # estimated relative error of the speeds [-]
    extremes_error: float  # the same of the largest moments
    counters: dict[str, int] = quantity("counters", "steps, rejected ones, evaluations")

    @derived("step_error[-]", "error of angle, speed, moment estimated in the step to t; 0 of methods without one")
    def own_error(self) -> Values:
        """As Merson prints it (S,)."""
        return self.step_error if self.step_error is not None else 0.0 * self.t

    @derived("end_time[s]", "time of the end")
    def end_time(self) -> float:
        """Since the beginning."""
        return float(self.t[-1])

    @derived("end_angle[deg]", "angle of the crank at the end")
    def end_angle(self) -> float:
        """With its whole turns."""
        return math.degrees(float(self.theta[-1, -1]))

    @derived("end_omega[rad/s]", "speed of the crank at the end")
    def end_speed(self) -> float:
        """Negative backwards."""
        return float(self.omega[-1, -1])

    @derived("turns", "turns of the crank")
    def turns(self) -> float:
        """From the beginning to the end."""
        return float(self.theta[-1, -1] - self.theta[-1, 0]) / TURN

    @derived("omega_begin[rad/s]", "speed of the crank at the beginning")
    def begin_speed(self) -> float:
        """Negative backwards."""
        return float(self.omega[-1, 0])

    @derived("M_motor_largest[N*m]", "moment of the motor of the largest magnitude, with its sign")
    def largest_motor(self) -> float:
        """Between the rows too."""
        return float(self.largest_moment[0, -1])

    @derived("M_motor_largest_at_t[s]", "time of the largest moment of the motor")
    def largest_motor_at(self) -> float:
        """Between the rows too."""
        return float(self.largest_moment[1, -1])

    @derived("energy_begin[J]", "kinetic and elastic energy at the beginning")
    def begin_energy(self) -> float:
        """Of all masses and shafts."""
        return float(self.kinetic[0] + self.elastic[0])

    @derived("energy_end[J]", "kinetic and elastic energy at the end")
    def end_energy(self) -> float:
        """Of all masses and shafts."""
        return float(self.kinetic[-1] + self.elastic[-1])


@record
class TimedMotions:
    """Result of the transient stage: one motion a scenario."""

    motions: tuple[TimedMotion, ...]
