"""The records that a transient motion leaves."""

from __future__ import annotations

from typing import Literal

from tmmcalc.errors import UsageError
from tmmcalc.machine.transient.model import Drive
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.verdicts import Verdict
from tmmcalc.numerics.panels import Values
from tmmcalc.records import record

MethodName = Literal["auto", "merson", "rk4", "RK45", "DOP853", "LSODA", "Radau", "BDF"]
METHODS = ("auto", "merson", "rk4", "RK45", "DOP853", "LSODA", "Radau", "BDF")
End = Literal["time", "speed", "angle", "standstill", "stall"]


@record
class Method:
    """How the motion is integrated.

    ``auto`` picks by stiffness. ``merson`` takes fixed steps if a ``step`` [s] is given, and controls them otherwise;
    ``rk4`` needs a step; the methods of scipy control theirs. The ``tolerance`` of one step is relative to the
    largest speed, moment and energy of the drive, and to one radian.
    """

    name: MethodName = "auto"
    step: float | None = None
    tolerance: float = 1e-10
    budget: int = 200_000  # evaluations of the equations after which the run is given up

    def __post_init__(self) -> None:
        """Refuse what is not a method."""
        if self.name not in METHODS:
            raise UsageError(
                f"there is no method {self.name!r}",
                where="transient motion",
                remedy="methods: " + ", ".join(METHODS),
            )
        if (self.name == "rk4") > (self.step is not None) or (self.step is not None and not self.step > 0):
            raise UsageError(
                f"{self.name} with the step {self.step}",
                where="transient motion",
                value=self.step,
                remedy="give a positive step [s]; textbook 0.01 to 0.04 s",
            )
        if self.step is not None and self.name not in ("merson", "rk4"):
            raise UsageError(
                f"{self.name} controls its steps itself, it takes no step of {self.step:g} s",
                where="transient motion",
                value=self.step,
                remedy="leave the step out, or take merson or rk4",
            )
        if not 1e-13 <= self.tolerance <= 1e-2:
            raise UsageError(
                f"the tolerance is {self.tolerance:g}",
                where="transient motion",
                value=self.tolerance,
                remedy="between 1e-13 and 1e-2; 1e-10 is the default",
            )


@record
class Event:
    """Something that happened: its exact time, and the crank there."""

    kind: str  # "load", "motor on", "motor off", "brake on", "brake off", "target", "overload", "pull-out", ...
    time: float  # [s]
    angle: float  # of the crank [rad]
    speed: float  # of the crank [rad/s]
    message: str


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
    step_error: Values | None  # (S,) largest error of angle, speed, moment estimated in the step to t (Merson)
    events: tuple[Event, ...]  # in the order of time
    end: End  # what ended the run
    verdicts: tuple[Verdict, ...]
    method: str  # the method that ran
    reason: str  # why
    rigid: tuple[int, ...]  # shafts that were taken as rigid
    imbalance: float  # largest |energy - initial energy - works| over the largest energy turned over [-]
    error: float  # estimated relative error of the speeds [-]
    counters: dict[str, int]  # steps, rejected, evaluations, pieces
