"""The records that the manipulator stage leaves."""

from __future__ import annotations

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.core.timelaw import TimeLaw
from tmmcalc.core.timerows import TimedExtreme
from tmmcalc.linkage.results import Grade
from tmmcalc.manipulators.task import Arm


@record
class PieceFacts:
    """A piece of the path: a line, or an arc where it has a radius."""

    start: tuple[float, ...] = quantity("start[m]", "beginning of the piece")
    end: tuple[float, ...] = quantity("end[m]", "end of the piece")
    length: float = quantity("length[m]", "length of the piece")
    begin: float = quantity("begin[s]", "time at which the gripper comes to the piece")
    centre: tuple[float, ...] | None = quantity("centre[m]", "centre of the arc")
    radius: float | None = quantity("R[m]", "radius of the arc")
    theta: float | None = quantity(
        "theta_1[rad]", "angle of the beginning of the arc, from the axis x or, in space, the chord"
    )
    theta_end: float | None = quantity("theta_2[rad]", "angle of the end of the arc, continuous from theta_1")
    sense: int | None = quantity("q", "sense of the arc: +1 where theta grows")


@record
class LegFacts:
    """A part of the path from rest to rest."""

    begin: float  # [s]
    law: TimeLaw  # of the way along it
    speed_limit: float | None = quantity(
        "v_arc[m/s]", "speed that the curvature allows under the limits of the accelerations"
    )
    pieces: tuple[PieceFacts, ...]


@record
class SingularPlace:
    """Where the joints lose a degree of freedom, or come near to it: a local minimum over the time."""

    # "r" and "l_3": the distance from base or shoulder [m]; "elbow": the sine of the angle of the arms
    what: str = quantity("what", "what is small at the singular place")
    t: float = quantity("t[s]", "time of the singular place")
    value: float = quantity("value[{unit}]", "how small it is")
    relative: float = quantity("relative", "how small it is against the size of the motion; 0: singular")

    @property
    def unit(self) -> str:
        """Of a distance, or that of the sine: none."""
        return "" if self.what == "elbow" else "m"


@record
class LimitExcess:
    """A joint beyond its range."""

    joint: str = quantity("joint", "joint coordinate")
    angular: bool
    limit: float = quantity("limit[{unit}]", "limit of the joint coordinate")  # [rad or m]
    value: float = quantity("value[{unit}]", "the farthest beyond the limit")
    t: float = quantity("t[s]", "time of the farthest")
    first: float = quantity("first[s]", "time at which the limit is passed first")

    @property
    def unit(self) -> str:
        """Of a joint that turns, or that slides."""
        return "rad" if self.angular else "m"

    @derived("excess[{unit}]", "how far the joint is beyond its limit")
    def excess(self) -> float:
        """Above zero [rad or m]."""
        return abs(self.value - self.limit)


@record
class Contact:
    """What crosses an obstacle: intervals of time, of no length where it is only touched."""

    obstacle: str
    what: str  # "path", "straight line" from start to end (in parts of its length), "arm"
    intervals: tuple[tuple[float, float], ...] = quantity(
        "{obstacle}_{part}[{unit}]", "when {part} crosses the obstacle; of a straight line, in parts of its length"
    )

    @property
    def unit(self) -> str:
        """Of the time; a straight line has none."""
        return "" if self.what == "straight line" else "s"


@record
class Manipulator:
    """The motion of a manipulator at n instants; gripper states (3, D, n), joint states (3, J, n).

    A jump of an acceleration inside the motion has two rows: 4- is the limit before one at row 4. The first and the
    last row are the limits inside the motion.
    """

    arm: Arm
    inverse: bool  # the gripper's path is given; otherwise the joints' motion
    duration: float = quantity("T[s]", "duration of the motion")
    labels: tuple[str, ...]  # (n,)
    t: Values = quantity("t[s]", "time")  # (n,)
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
