"""The records that the manipulator stage leaves."""

from __future__ import annotations

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.records import record
from tmmcalc.core.timelaw import TimeLaw
from tmmcalc.core.timerows import TimedExtreme
from tmmcalc.linkage.results import Grade
from tmmcalc.manipulators.task import Arm


@record
class PieceFacts:
    """A piece of the path: a line, or an arc where it has a radius."""

    start: tuple[float, ...]  # [m]
    end: tuple[float, ...]
    length: float  # [m]
    begin: float  # [s] when the gripper comes to it
    centre: tuple[float, ...] | None  # [m]
    radius: float | None  # [m]
    theta: float | None  # θ_1: of an arc the angle of its start, from the axis x or, in space, the chord [rad]
    theta_end: float | None  # θ_2, continuous from θ_1 [rad]
    sense: int | None  # q: +1 where θ grows


@record
class LegFacts:
    """A part of the path from rest to rest."""

    begin: float  # [s]
    law: TimeLaw  # of the way along it
    speed_limit: float | None  # what its curvature allows under the limits of the accelerations [m/s]
    pieces: tuple[PieceFacts, ...]


@record
class SingularPlace:
    """Where the joints lose a degree of freedom, or come near to it: a local minimum over the time."""

    what: str  # "r" and "l_3": the distance from base or shoulder [m]; "elbow": the sine of the angle of the arms
    t: float  # [s]
    value: float  # [m] or [-]
    relative: float  # against the size of the motion [-]; 0 at the singular place itself


@record
class LimitExcess:
    """A joint beyond its range."""

    joint: str
    angular: bool
    limit: float  # [rad or m]
    value: float  # the farthest beyond it
    t: float  # when [s]
    first: float  # when it is passed first [s]

    @property
    def excess(self) -> float:
        """By how much [rad or m], above zero."""
        return abs(self.value - self.limit)


@record
class Contact:
    """What crosses an obstacle: intervals of time, of no length where it is only touched."""

    obstacle: str
    what: str  # "path", "straight line" from start to end (in parts of its length), "arm"
    intervals: tuple[tuple[float, float], ...]  # [s]; of the straight line [-]


@record
class Manipulator:
    """The motion of a manipulator at n instants; gripper states (3, D, n), joint states (3, J, n).

    A jump of an acceleration inside the motion has two rows: 4- is the limit before one at row 4. The first and the
    last row are the limits inside the motion.
    """

    arm: Arm
    inverse: bool  # the gripper's path is given; otherwise the joints' motion
    duration: float  # T [s]
    labels: tuple[str, ...]  # (n,)
    t: Values  # (n,) [s]
    side: Indices  # (n,) -1: the limit from before, +1: from after
    way: Values  # (3, n) s [m], v, a along the path; zeros in the direct problem
    phase: Indices  # (n,) 1 acceleration, 2 uniform motion, 3 deceleration; 0 in the direct problem
    gripper: Values  # (3, D, n) [m], [m/s], [m/s^2]
    joints: tuple[str, ...]  # (J,)
    angular: tuple[bool, ...]  # (J,) whether the joint is an angle
    q: Values  # (3, J, n) joint coordinates [rad or m] and their derivatives; angles are continuous
    elbow: Values | None  # (D, n) the elbow of an angular arm [m]
    elbow_angle: Values | None  # (3, n) from its upper arm to its forearm [rad] with derivatives; continuous
    legs: tuple[LegFacts, ...]  # of the path; none in the direct problem
    laws: tuple[TimeLaw, ...]  # of the joints, in the direct problem by laws
    extremes: tuple[TimedExtreme, ...]
    singular: tuple[SingularPlace, ...]
    excesses: tuple[LimitExcess, ...]
    contacts: tuple[Contact, ...]
    grades: tuple[Grade, ...]
    residual: float | None  # of direct(inverse) against the gripper, relative; None at a singular place
    error: dict[str, float]  # estimates, relative, of columns by their names (`rounding`)
    counters: dict[str, int]
