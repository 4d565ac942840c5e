"""``[manipulator]``: an arm, the path of its gripper or the motion of its joints, limits, obstacles."""

from typing import Annotated, Literal

from pydantic import Field

from tmmcalc.spec.choices import Known, Whole
from tmmcalc.spec.identifiers import Words
from tmmcalc.spec.quantities import Distance, Length, Quantity, Size
from tmmcalc.spec.table import Table

_POSITIVE = {"at_least_zero": True, "nonzero": True}
ARMS = ("spherical", "cylindrical", "angular")
PATHS = ("arc", "line", "polyline")
ELBOWS = {"up": 1, "down": -1}
SIDES = {"left": 1, "right": -1}

ArmName = Annotated[Literal["spherical", "cylindrical", "angular"], Known("kind of arm", ARMS)]
ElbowName = Annotated[str, Known("place of the elbow", tuple(ELBOWS))]
PathName = Annotated[str, Known("kind of path", PATHS)]
Side = Annotated[str, Known("side of the arc's centre", tuple(SIDES))]
Place = Annotated[list[Length], Field(min_length=2, max_length=3)]
Corner = Annotated[list[Length], Field(min_length=2, max_length=2)]
Normal = Annotated[list[float], Field(min_length=3, max_length=3)]
Speed = Annotated[float, Quantity("speed", **_POSITIVE)]
Acceleration = Annotated[float, Quantity("acceleration", **_POSITIVE)]
Duration = Annotated[float, Quantity("time", **_POSITIVE)]
Instant = Annotated[float, Quantity("time", at_least_zero=True)]
Coordinate = Annotated[float, Quantity("length", "angle")]
JointSpeed = Annotated[float, Quantity("speed", "angular speed", **_POSITIVE)]
JointAcceleration = Annotated[float, Quantity("acceleration", "angular acceleration", **_POSITIVE)]
Pair = Annotated[list[Coordinate], Field(min_length=2, max_length=2)]
Steps = Annotated[int, Whole("a number of steps", 1, 1_000_000)]
ObstacleName = Annotated[str, Words("obstacle")]


class PathTable(Table):
    """The path of the gripper: points have two coordinates, or three with a turning base."""

    kind: PathName = Field(
        description='`"arc"`, by radius and side or through a point; `"line"`; `"polyline"`, through points.'
    )
    start: Place | None = Field(
        default=None, description='Start `[x, y]`, y upwards, or `[x, y, z]`, z upwards: `["1.2 m", "0.3 m"]`.'
    )
    end: Place | None = Field(default=None, description="End, with as many coordinates.")
    radius: Size | None = Field(
        default=None, description="Radius of an arc, at least half the distance of its ends; the shorter arc is taken."
    )
    side: Side | None = Field(
        default=None,
        description='Whether the centre of an arc is to the `"left"` (K = +1) or `"right"` (K = -1) of the line from '
        "start to end.",
    )
    via: Place | None = Field(
        default=None,
        description="Or a point that the arc goes through, in place of radius and side; "
        "then it may be longer than a half circle.",
    )
    normal: Normal | None = Field(
        default=None,
        description="Normal of the plane of an arc in space: left is normal x direction (default: `[0, 0, 1]`).",
    )
    points: list[Place] | None = Field(default=None, min_length=2, description="Points of a polyline.")
    corner_radius: Distance = Field(
        default=0.0,
        description="Radius of arcs that round the corners of a polyline; without it the gripper stops at each.",
    )


class JointTable(Table):
    """A joint that goes from rest to rest by the time-optimal law, or stays where it is."""

    start: Coordinate = Field(alias="from", description="Coordinate at the beginning.")
    end: Coordinate | None = Field(default=None, alias="to", description="Coordinate at the end (default: it stays).")
    speed: JointSpeed | None = Field(default=None, description="Largest speed.")
    acceleration: JointAcceleration | None = Field(default=None, description="Largest acceleration.")


class JointsTable(Table):
    """The direct problem: a law for each joint of the arm."""

    psi: JointTable | None = Field(default=None, description="Rotation of the base.")
    phi_2: JointTable | None = Field(
        default=None, description="Elevation of a spherical arm; direction of the upper arm of an angular one."
    )
    phi_3: JointTable | None = Field(default=None, description="Direction of the forearm, from elbow to gripper.")
    l_3: JointTable | None = Field(default=None, description="Extension of a spherical arm.")
    h: JointTable | None = Field(default=None, description="Height of a cylindrical arm over its shoulder.")
    r: JointTable | None = Field(default=None, description="Reach of a cylindrical arm.")
    together: bool = Field(
        default=True,
        description="Whether all joints take the time of the slowest; `false`: each is as quick as it can.",
    )


class MotionTable(Table):
    """The direct problem: coordinates of all joints at given times, smooth between, at rest at both ends."""

    t: list[Instant] = Field(min_length=2, description="Times, ascending.")
    psi: list[Coordinate] | None = Field(default=None, description="Rotation of the base.")
    phi_2: list[Coordinate] | None = Field(
        default=None, description="Elevation of a spherical arm; direction of the upper arm of an angular one."
    )
    phi_3: list[Coordinate] | None = Field(default=None, description="Direction of the forearm, from elbow to gripper.")
    l_3: list[Coordinate] | None = Field(default=None, description="Extension of a spherical arm.")
    h: list[Coordinate] | None = Field(default=None, description="Height of a cylindrical arm over its shoulder.")
    r: list[Coordinate] | None = Field(default=None, description="Reach of a cylindrical arm.")


class LimitsTable(Table):
    """Ranges [lowest, highest] of the joints."""

    psi: Pair | None = Field(default=None, description="Rotation of the base.")
    phi_2: Pair | None = Field(
        default=None,
        description="Elevation of a spherical arm; direction of the upper arm of an angular one: "
        '`["0 deg", "80 deg"]`.',
    )
    phi_3: Pair | None = Field(default=None, description="Direction of the forearm, from elbow to gripper.")
    elbow: Pair | None = Field(
        default=None,
        description="Angle from the upper arm to the forearm, phi_3 - phi_2, within half a turn of zero at the start.",
    )
    l_3: Pair | None = Field(default=None, description="Extension of a spherical arm.")
    h: Pair | None = Field(default=None, description="Height of a cylindrical arm over its shoulder.")
    r: Pair | None = Field(default=None, description="Reach of a cylindrical arm.")


class ObstacleTable(Table):
    """A polygon that path and arm must not cross; with a turning base a prism over a polygon of x, y."""

    name: ObstacleName | None = Field(
        default=None, description="Name of the obstacle (default: `obstacle`, `obstacle 2` ...)."
    )
    corners: list[Corner] | None = Field(
        default=None, min_length=3, description="Corners `[x, y]` of a polygon, in order."
    )
    box: Annotated[list[Corner], Field(min_length=2, max_length=2)] | None = Field(
        default=None, description="Or two opposite corners of a rectangle."
    )
    low: Length | None = Field(
        default=None, description="Lowest height of a prism over the polygon, with a turning base."
    )
    high: Length | None = Field(
        default=None, description="Highest height of a prism over the polygon, with a turning base."
    )


class ManipulatorTable(Table):
    """A manipulator: its arm in a vertical plane, with or without a turning base, and its motion."""

    arm: ArmName = Field(
        description='`"spherical"`: elevation `phi_2` and extension `l_3`; `"cylindrical"`: '
        'height `h` and reach `r`; `"angular"`: directions `phi_2` of the upper arm and `phi_3` of the '
        "forearm."
    )
    upper_arm: Size | None = Field(default=None, description="Angular arm: from shoulder to elbow.")
    forearm: Size | None = Field(default=None, description="Angular arm: from elbow to gripper.")
    elbow: ElbowName | None = Field(
        default=None,
        description='Angular arm along a path: `"up"`, to the left of the line from shoulder to gripper, or '
        '`"down"`, to the right of it; left is up where the gripper is in front (default: `"up"`).',
    )
    height: Length = Field(default=0.0, description="Height of the shoulder over the origin.")
    speed: Speed | None = Field(default=None, description="Along a path: largest speed of the gripper.")
    acceleration: Acceleration | None = Field(
        default=None, description="Along a path: largest tangential acceleration."
    )
    normal_acceleration: Acceleration | None = Field(
        default=None,
        description="Largest normal acceleration, a limit that the largest speed keeps on the sharpest arc between "
        "two stops.",
    )
    total_acceleration: Acceleration | None = Field(
        default=None,
        description="Largest acceleration of the gripper in all, a limit that the largest speed keeps on the "
        "sharpest arc between two stops.",
    )
    duration: Duration | None = Field(
        default=None,
        description="Duration of a path without stops, in place of the largest speed; "
        "the least speed that keeps it is taken.",
    )
    steps: Steps = Field(
        default=24, description="Rows of the table: equal steps of the time; the instants of the jumps are added."
    )
    path: PathTable | None = Field(default=None, description="Path of the gripper: the inverse problem.")
    joints: JointsTable | None = Field(default=None, description="Laws of the joints: the direct problem.")
    motion: MotionTable | None = Field(default=None, description="Table of the joints: the direct problem.")
    limits: LimitsTable = Field(default_factory=LimitsTable, description="Ranges of the joints.")
    obstacles: list[ObstacleTable] = Field(default=[], description="What path and arm must not cross.")
    check_arm: bool = Field(
        default=True,
        description="Whether the arm itself must keep clear of the obstacles; it is looked at in 1441 instants and "
        "at eight steps between any two jumps.",
    )
