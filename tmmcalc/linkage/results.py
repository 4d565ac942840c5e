"""The records that the kinematics stage leaves, apart from the code that makes them.

A run that loads a stored result needs these alone.
"""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.notes import Note, Phrase
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.structure import Structure

MethodName = Literal["closed", "projection", "differences", "splitting"]
METHODS = ("closed", "projection", "differences", "splitting")


@record
class Method:
    """How velocities and accelerations are found.

    ``closed``: elimination by cross products (default). ``projection``: the vector equations projected on
    two axes and solved as 2x2 systems. ``differences``: central differences of positions with ``step`` [rad or
    m] (by default 1.5 degrees, or 1/240 of a slider's range), of positions rounded to ``decimals`` of the crank
    length if given (textbook (2.62), (2.63)). ``splitting``: positions, too, of higher groups by removing a binary link
    and trying the angle of another one, so that the rest is dyads.
    """

    name: MethodName = quantity("method", "method of velocities and accelerations", default="closed")
    step: float | None = None
    decimals: int | None = None

    def __post_init__(self) -> None:
        """Refuse what is not a method."""
        if self.name not in METHODS:
            known = ", ".join(METHODS)
            raise UsageError(f"there is no method {self.name!r}", where="kinematics", remedy=f"methods: {known}")


@record
class Limit:
    """An end of an assembly interval: the input coordinate [rad or m], and what stops it there."""

    x: float
    group: str
    reason: str


@record
class Interval:
    """An interval of the input coordinate [rad or m]; an end without a limit is open as far as the links reach."""

    low: float
    high: float
    limits: tuple[Limit, ...] = ()

    @property
    def slack(self) -> float:
        """What rounding may put a coordinate beyond the ends."""
        return 1e-9 * (self.high - self.low)

    def shift(self, x: float, turn: float | None) -> float:
        """Whole turns that bring x into the interval; 0 where it is wider than a turn, for its turns differ."""
        if turn is None or self.high - self.low > turn + self.slack:
            return 0.0
        return -turn * math.floor((x - self.low + self.slack) / turn)

    def holds(self, low: float, high: float, turn: float | None) -> bool:
        """Whether [low, high] lies inside, counted modulo ``turn`` if there is one."""
        shift = self.shift(low, turn)
        return self.low - self.slack <= low + shift and high + shift <= self.high + self.slack


@record
class Branch:
    """One assembly of a group of class III or higher, followed along the input from where it was chosen.

    The unknowns of its loops stand at m places with equal steps of a parameter t from 0 to 1, in which they are smooth
    up to the limits: x = low + (high - low) t, with t^2 from a limit at ``low``, and alike at ``high``.
    """

    group: str
    at: float  # input coordinate where it was chosen [rad or m]
    low: float
    high: float
    limits: tuple[Limit, ...]
    turn: float | None  # of the crank [rad], modulo which a branch of one turn or less is meant; None: a slider
    period: float | None  # after which it comes back [rad]; None: it does not
    q: Real  # (N, m) unknowns: angles [rad], then coordinates of prismatic joints [m]
    dq: Real  # (N, m) their derivative by t


@record
class Domain:
    """All intervals where the mechanism assembles, within one turn of the crank or the reach of a slider."""

    intervals: tuple[Interval, ...]
    full: bool = quantity("assembles_everywhere", "the crank turns fully, or the slider has no limit")


@record
class DeadCentre:
    """A reversal of the output: input coordinate [rad or m] and output coordinate [m or rad] there."""

    x: float
    value: float


@record
class Extreme:
    """An extreme value and the input coordinate [rad or m] where it stands."""

    value: float
    x: float


@record
class OutputSummary:
    """What section 17 of a course project asks of an output link.

    ``dead_centres`` start with the one before the working stroke and follow the motion. ``working_angle``,
    ``idle_angle`` and ``time_ratio`` are None unless there are exactly two. ``velocity`` and ``acceleration`` hold the
    smallest and the largest.
    """

    name: str
    angular: bool
    dead_centres: tuple[DeadCentre, ...] = quantity(
        "dead_centres_{output}[{per}]", "input coordinates where output {output} turns back"
    )
    stroke: float | None = quantity(
        "stroke_{output}[{unit}]",
        "largest distance between dead centres of {output}, its longest stroke if it goes round",
    )
    working_angle: float | None = quantity(
        "working_{output}[rad]", "angle of the crank over the working stroke of {output}"
    )
    idle_angle: float | None = quantity("idle_{output}[rad]", "angle of the crank over the idle stroke of {output}")
    time_ratio: float | None = quantity("K_{output}", "ratio of the times of the strokes of {output}", symbol="K")
    velocity: tuple[Extreme, Extreme] = quantity("vS_{output}[{unit}/s]", "velocity of output {output}")
    acceleration: tuple[Extreme, Extreme] = quantity("aS_{output}[{unit}/s^2]", "acceleration of output {output}")


@record
class GroupQuality:
    """Transmission and regularity of one group over the analysed range."""

    group: str
    transmission: float | None = quantity(  # None: a higher group, which has none
        "transmission_min_{group}[rad]", "smallest transmission angle of {group}"
    )
    transmission_at: float | None  # input coordinate there [rad or m]; None: the same everywhere
    regularity: float  # smallest regularity [-]
    regularity_at: float | None
    weak: tuple[Extreme, ...]  # every local minimum of the transmission angle below 30 degrees
    singular: tuple[Extreme, ...]  # every local minimum of the regularity below 0.05

    @derived("pressure_max_{group}[rad]", "largest pressure angle of {group}")
    def pressure(self) -> float | None:
        """Largest pressure angle [rad]."""
        return None if self.transmission is None else math.pi / 2 - self.transmission

    @derived("amplification_max_{group}", "largest factor by which {group} amplifies errors and velocities")
    def amplification(self) -> float:
        """Largest factor by which the group amplifies errors and velocities [-]."""
        return 1 / self.regularity


@record
class Grade:
    """Something worth knowing about the result: ``note`` or ``warning``, where, and the numbers."""

    severity: Literal["note", "warning"]
    where: Phrase | str
    message: Phrase | str
    value: float | None = None  # that it is about, and the limit that it is held against
    limit: float | None = None
    unit: str | None = None  # of both
    name: str = ""  # of the quantity

    def __str__(self) -> str:
        return Note(self.severity, self.message, self.where, self.value, self.limit, self.unit, self.name)


@record
class LastDigit:
    """What a unit in the last place of every length, direction and input coordinate does to the motion, at most [-].

    Relative to the largest value of each kind, as errors are; 1 where no digit is left.
    """

    position: float = quantity("position", "relative change of positions by the last digit of the data")
    velocity: float = quantity("velocity", "relative change of velocities by the last digit of the data")
    acceleration: float = quantity("acceleration", "relative change of accelerations by the last digit of the data")


@record
class ErrorEstimate:
    """Estimated largest error over all positions, relative to the largest value of each kind [-].

    The kinds are points with prismatic joints, and links, whose angles are told against one radian. The data are taken
    as exact: ``last_digit`` is what their own rounding may do beside it; None where the transmission keeps it as small
    as rounding, and in variants that are solved together.
    """

    position: float = quantity("position", "relative error of positions")
    velocity: float = quantity("velocity", "relative error of velocities")
    acceleration: float = quantity("acceleration", "relative error of accelerations")
    reference: str
    last_digit: LastDigit | None = quantity(
        "last_digit", "what a unit in the last place of the data changes", default=None
    )


@record
class Trace:
    """Stacked motion at n input coordinates. Derivatives are per unit of the input coordinate."""

    point_names: tuple[str, ...]
    r: Plane  # (P, n) positions [m]
    dr: Plane  # (P, n)
    ddr: Plane  # (P, n)
    link_ids: tuple[int, ...]
    angle: Real  # (L, n) [rad]
    dangle: Real  # (L, n)
    ddangle: Real  # (L, n)
    joint_names: tuple[str, ...]
    s: Real  # (J, n) coordinates of the prismatic joints [m]
    ds: Real  # (J, n)
    dds: Real  # (J, n)


@record
class Terms:
    """How much of two terms the equations of accelerations have, of the whole: less is a mistake made on purpose."""

    coriolis: float = 1.0  # of 2 omega x v along the guides that turn
    normal: float = 1.0  # of omega^2 r about the base points of the links, the input link apart


@record
class Kinematics:
    """Result of the kinematics stage for n positions and O outputs.

    Derivatives ``d...``, ``dd...`` are transfer functions, per unit of the input coordinate.
    """

    structure: Structure
    variants: dict[str, int] = quantity(  # by group name
        "variants", "the sign of a dyad, the number of an assembly of a higher group"
    )
    branches: dict[str, Branch]  # by group name, of groups of class III and higher
    input_joint: str
    turns: bool  # crank (True) or driven slider
    speed: float = quantity("speed[{unit}/s]", "speed of the input")
    acceleration: float = quantity("acceleration[{unit}/s^2]", "acceleration of the input")
    crank_length: float | None = quantity(  # None for a driven slider
        "l_1[m]", "length of the crank, the unit of dimensionless results"
    )
    frame_points: dict[str, tuple[float, float]] = quantity("frame_points[m]", "coordinates x, y of the fixed points")
    labels: tuple[str, ...]  # (n,) position labels
    phi: Real  # (n,) input coordinate counted from position 0 [rad or m]
    x: Real = quantity("{input}[{unit}]", "input coordinate")  # (n,)
    trace: Trace  # points, links, prismatic joints at x
    outputs: tuple[str, ...]  # (O,)
    angular: tuple[bool, ...]  # (O,) whether the output is an angle
    s: Real  # (O, n) displacement from position 0 [m or rad]
    ds: Real  # (O, n)
    dds: Real  # (O, n)
    domain: Domain = quantity("assembles_for[{unit}]", "intervals of the input coordinate where it assembles")
    summaries: tuple[OutputSummary, ...]
    qualities: tuple[GroupQuality, ...]
    grades: tuple[Grade, ...]
    method: Method
    error: ErrorEstimate = quantity("error", "estimated errors")
    counters: dict[str, int]
    terms: Terms | None = None  # None: whole

    def in_time(self, rate: np.ndarray, rate2: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Velocity and acceleration from first and second transfer function: v = S' w, a = S'' w^2 + S' eps."""
        steady = rate2 * self.speed**2
        return rate * self.speed, steady + rate * self.acceleration if self.acceleration else steady
