"""The records that a transient motion leaves."""

from __future__ import annotations

from typing import Literal

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.machine.timescales import TimeScales
from tmmcalc.machine.transient.model import Drive
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.verdicts import Verdict

End = Literal["time", "speed", "angle", "standstill", "stall", "steady", "runaway"]


@record
class Event:
    """Something that happened: its exact time, and the crank there."""

    # "load", "motor on", "motor off", "brake on", "brake off", "target", "overload", "pull-out", ...
    kind: str = quantity("kind", "kind of the event")
    time: float = quantity("t[s]", "time of the event")
    angle: float = quantity("angle[rad]", "angle of the crank")
    speed: float = quantity("omega[rad/s]", "angular velocity of the crank")
    message: str = quantity("message", "what happened", header="event")


@record
class Transient:
    """A transient motion at S times: every accepted step, and the instants that were asked for.

    Masses and shafts are listed from the motor to the crank, each on its own shaft. Where the moment jumps the row
    holds its value after the jump.
    """

    drive: Drive
    scenario: Scenario
    t: Values  # (S,) [s]
    theta: Values  # (N, S) angles of the masses [rad]
    omega: Values  # (N, S) speeds [rad/s]
    alpha: Values  # (N, S) accelerations [rad/s^2]
    shaft_moment: Values  # (N - 1, S) moments of the shafts, positive towards the crank [N*m]
    motor_moment: Values  # (S,) on the shaft of the first mass [N*m]
    load_moment: Values  # (S,) on the crank, positive drives [N*m]
    load_factor: Values  # (S,)
    kinetic: Values  # (S,) energy [J]
    elastic: Values  # (S,) energy of the shafts [J]
    motor_work: Values  # (S,) since t = 0 [J]
    load_work: Values  # (S,)
    brake_work: Values  # (S,) not positive
    shaft_loss: Values  # (S,) work of the shafts' damping, not positive
    largest_moment: Values  # (2, N) of largest size and its time: of the shafts, last of the motor [N*m], [s]
    turning: Values  # (3, P) time, angle and speed of the crank where its speed is locally largest or smallest
    step_error: Values | None  # (S,) largest error of angle, speed, moment estimated in the step to t (Merson)
    events: tuple[Event, ...]  # in the order of time
    end: End  # what ended the run
    verdicts: tuple[Verdict, ...]
    method: str  # the method that ran
    reason: str  # why
    scales: TimeScales | None  # time constants over the duration; None: nothing changes within it
    rigid: tuple[int, ...]  # shafts that were taken as rigid
    imbalance: float  # largest |energy - initial energy - works| over the largest energy turned over [-]
    error: float  # estimated relative error of the speeds [-]
    extremes_error: float  # the same of the largest moments
    counters: dict[str, int]  # steps, rejected, evaluations, pieces
