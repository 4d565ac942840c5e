"""What happens to the drive: its start, the switching of motor, brake and load, and what ends the run."""

from __future__ import annotations

import math
from typing import Literal

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record

LONGEST = 600.0  # a motion without a duration is given up here [s]
Standstill = Literal["stop", "pass"]


@record
class LoadStep:
    """A load factor U and the condition from which it holds; without one it holds from the start.

    Friction goes with the load in a straight line between its values without and with it: exact for the factors 0 and
    1, and else an approximation, because friction follows the sizes of the reactions and not the reactions.

    Several steps take effect one after the other: the second waits for its condition after the first has come.
    """

    factor: float  # U [-]; multiplies what the load adds to the idle cycle, or the whole moment if there is none
    time: float | None = None  # not before this time [s]
    speed: float | None = None  # when the speed of the crank first exceeds this one [rad/s]
    quiet: bool = False  # wait until the crank reaches a part of the cycle where the load is zero

    def __post_init__(self) -> None:
        """Refuse two conditions at once."""
        if self.time is not None and self.speed is not None:
            raise UsageError(
                f"a load step waits for the time {self.time:g} s and for the speed {self.speed:g} rad/s",
                where="transient motion",
                remedy="give one of them, or two steps",
            )


@record
class Brake:
    """A braking moment on one mass, in time or from the start: constant part against the motion, and viscous part."""

    moment: float = 0.0  # constant part [N*m], on the shaft of the mass; holds the mass at standstill
    viscous: float = 0.0  # proportional part [N*m*s/rad]
    mass: int = -1  # which mass of the drive, counted from the motor; -1: the crank
    start: float = 0.0  # [s]
    end: float = math.inf  # [s]

    def __post_init__(self) -> None:
        """Refuse a brake that drives."""
        if not (0 <= self.moment < math.inf and 0 <= self.viscous < math.inf):
            raise UsageError(
                f"a brake of {self.moment:g} N*m and {self.viscous:g} N*m*s/rad does not brake",
                where="transient motion",
                value=min(self.moment, self.viscous),
                limit=0.0,
                remedy="give both parts as numbers that are not negative",
            )


@record
class Scenario:
    """One transient motion of the drive from the time 0. Speeds and angles are those of the crank.

    ``standstill`` is what the load does to a crank at rest: "stop": it only resists, the crank is not driven backwards
    and the run ends when nothing will move it again; "pass": it may drive backwards (a weight), the run goes on.
    """

    name: str
    duration: float  # the run ends here at the latest [s]
    speed: float = 0.0  # initial speed [rad/s]
    angle: float = 0.0  # initial angle [rad], counted as in the cycle
    settled: bool = False  # start with the static motor moment and with shafts twisted as by rigid motion
    moment: float | None = None  # of the motor at the start, at the crank, if settled [N*m]; None: the static one
    motor: tuple[tuple[float, float], ...] = ((0.0, math.inf),)  # intervals of time when it is on [s]
    load: tuple[LoadStep, ...] = (LoadStep(1.0),)
    brake: Brake | None = None
    standstill: Standstill = "stop"
    targets: tuple[float, ...] = ()  # speeds whose first passage is noted [rad/s]
    end_speed: float | None = None  # the run ends when this speed is first reached [rad/s]
    end_angle: float | None = None  # the run ends when the crank has turned by this angle [rad]
    until_steady: bool = False  # the run ends when the motion repeats itself from cycle to cycle

    def __post_init__(self) -> None:
        """Refuse what cannot be run."""
        _require(0 < self.duration < math.inf, "duration", self.duration, "a positive number of seconds")
        _require(math.isfinite(self.angle), "angle", self.angle, "a number")
        least = 0.0 if self.standstill == "stop" else -math.inf
        _require(least <= self.speed < math.inf, "speed", self.speed, 'not negative, or standstill = "pass"')
        if self.end_angle is not None:
            _require(0 < self.end_angle < math.inf, "end_angle", self.end_angle, "a positive number")
        for begin, end in self.motor:
            _require(0 <= begin < end, "motor", begin, "intervals (begin, end) with 0 <= begin < end")
        if not self.load or self.load[0].time is not None or self.load[0].speed is not None:
            raise UsageError(
                "the first load step has a condition, so that there is no load factor at the start",
                where=f"scenario {self.name}",
                remedy="begin with LoadStep(factor) without a condition",
            )

    def motor_on(self, time: float) -> bool:
        """Whether the motor is on just after ``time``."""
        return any(begin <= time < end for begin, end in self.motor)

    def brake_on(self, time: float) -> bool:
        """Whether the brake acts just after ``time``."""
        return self.brake is not None and self.brake.start <= time < self.brake.end

    def times(self) -> tuple[float, ...]:
        """Ascending times, up to the duration, at which something is switched."""
        brake = (self.brake.start, self.brake.end) if self.brake else ()
        steps = (step.time for step in self.load if step.time is not None)
        switched = {time for interval in self.motor for time in interval} | {*brake, *steps}
        return (*sorted(time for time in switched if 0 < time < self.duration), self.duration)


def _require(holds: bool, field: str, value: float, rule: str) -> None:
    if not holds:
        raise UsageError(
            f"{field} is {value:g}", where="transient motion", value=value, remedy=f"{field} must be {rule}"
        )
