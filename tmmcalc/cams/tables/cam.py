"""``[cam]``: a disk cam and its follower: the motion, the sizes that are given, what it carries."""

import math
from fractions import Fraction
from typing import Annotated, Literal

from pydantic import Field

from tmmcalc.cams.tables.cam_law import Law
from tmmcalc.cams.tables.cam_parts import (
    CamElasticTable,
    CamGuideTable,
    CamLimitsTable,
    CamLoadsTable,
    CamOptimumTable,
    CamRequirementsTable,
    CamSpringTable,
    Distance,
    Size,
)
from tmmcalc.spec.choices import Exact, Known, Whole, Within
from tmmcalc.spec.quantities import Quantity
from tmmcalc.spec.table import Table

FOLLOWERS = ("translating", "oscillating", "flat")
CLOSURES = ("force", "groove")
SHAFTS = ("crank", "motor")
MOST_TURNS = 12  # of the crank until a cam on a shaft of the machine repeats
_ANGLE = ("angle", "deg", math.pi / 180)
_POSITIVE = {"at_least_zero": True, "nonzero": True}

FollowerName = Annotated[Literal["translating", "oscillating", "flat"], Known("kind of follower", FOLLOWERS)]
Rotation = Annotated[str, Known("sense of rotation", ("clockwise", "counter-clockwise"))]
Closing = Annotated[Literal["force", "groove"], Known("way to keep the follower on the cam", CLOSURES)]
RockerTurn = Annotated[str, Known("sense of the rocker", ("with", "against"))]
Stroke = Annotated[float, Quantity("length", "angle", **_POSITIVE)]
Speed = Annotated[float, Quantity("angular speed", **_POSITIVE)]
PhaseAngle = Annotated[float, Quantity("angle", **_POSITIVE)]
Dwell = Annotated[float, Quantity("angle", at_least_zero=True)]
SwingAngle = Annotated[float, Within(*_ANGLE, 1e-3, 179.999)]
CrankAngle = Annotated[float, Within(*_ANGLE, 0, 360 * MOST_TURNS)]
Shaft = Annotated[str, Known("shaft of the machine", SHAFTS)]
Ratio = Annotated[Fraction, Exact("a ratio of speeds", "0.5", above=0)]
Offset = Annotated[float, Within("length", "mm", 1e-3, -1e5, 1e5, bare=2.0)]
Steps = Annotated[int, Whole("a number of steps", 2, 100_000)]
Step = Annotated[float, Within(*_ANGLE, 1e-3, 90)]


def closed_ratio(ratio: Fraction, gears: float) -> Fraction:
    """The ratio of a cam behind gears of a ratio, as the nearest quotient that closes in a few turns of the crank.

    >>> closed_ratio(Fraction(1, 3), 18.0)
    Fraction(6, 1)
    """
    return (ratio * Fraction(gears)).limit_denominator(MOST_TURNS)


class CamTable(Table):
    """A disk cam: its motion, the sizes that are given (the others are found), limits, loads, requirements."""

    follower: FollowerName = Field(
        description='`"translating"`: a roller on a stem; `"oscillating"`: a roller on a rocker; `"flat"`: '
        "a face across a stem."
    )
    rotation: Rotation | None = Field(
        default=None,
        description='Sense in which the cam turns: `"clockwise"` or `"counter-clockwise"` (default: that of the crank '
        "with which it turns; else clockwise).",
    )
    closure: Closing = Field(
        default="force",
        description='`"force"`: a spring or weight keeps the follower on the cam; `"groove"`: '
        "two walls guide the roller.",
    )
    stroke: Stroke = Field(description='Stroke of the follower, `"30 mm"`; of a rocker its swing angle, `"20 deg"`.')
    speed: Speed | None = Field(
        default=None,
        description="Speed of the cam, which loads need (default: of the crank, or of the shaft of `[torque]`). "
        "Without one the cam turns with the crank, and where the spec has a motor its forces take the "
        "speed that the stage `motion` finds.",
    )
    shaft: Shaft | None = Field(
        default=None,
        description='Shaft of the machine that drives the cam, which then loads it: `"crank"`, also the shaft of '
        '`[torque]`, or `"motor"`, before the gears, reduced by their ratio alone as its rotor is. The stages from '
        "`reduction` on include the follower's inertia, spring, weight, forces and friction "
        "(default: the machine does not feel the cam).",
    )
    ratio: Ratio = Field(
        default=Fraction(1),
        description='Speed of the cam over that of its `shaft`: `0.5` of a four-stroke engine, `"1/3"`. The cycle of '
        f"the machine gets as long as the cam needs to repeat, up to {MOST_TURNS} turns of the crank.",
    )
    crank_angle: CrankAngle = Field(
        default=0.0,
        description="Phase: angle of the crank from position 0 at which the rise begins, where the cam turns with it.",
    )
    rise: PhaseAngle = Field(description="Angle of the cam during the rise.")
    high_dwell: Dwell = Field(default=0.0, description="Angle of the cam while the follower rests at the top.")
    return_angle: PhaseAngle = Field(description="Angle of the cam during the return; the low dwell fills the turn.")
    law: Law | None = Field(
        default=None, description="Law of motion of rise and return: a name, or a table of one's own."
    )
    rise_law: Law | None = Field(default=None, description="Law of the rise (default: `law`).")
    return_law: Law | None = Field(default=None, description="Law of the return (default: `law`).")
    start_distance: Size | None = Field(
        default=None,
        description="S0: from the cam's axis to the roller centre (to a flat face) along the lift, at the lowest "
        "position (default: found).",
    )
    start_angle: SwingAngle | None = Field(
        default=None,
        description="psi0: angle of the rocker from the line of centres, at the lowest position (default: found).",
    )
    base_radius: Size | None = Field(
        default=None, description="R0: radius of the base circle of the pitch curve, under a flat face of the profile."
    )
    offset: Offset | None = Field(
        default=None,
        description="e: how far the stem of a roller stands to the right of the cam's axis; negative: "
        "to the left (default: 0, found if the start is).",
    )
    roller_radius: Distance | None = Field(
        default=None,
        description='r2: radius of the roller (default: found); `0` without quotes or `"0 mm"`: knife edge.',
    )
    centre_distance: Size | None = Field(
        default=None, description="l0: distance of the axes of cam and rocker (default: found)."
    )
    rocker_length: Size | None = Field(
        default=None, description="l2: from the rocker's pivot to the roller centre (default: found)."
    )
    rocker_turn: RockerTurn = Field(
        default="with", description='`"with"`: on the rise the rocker turns as the cam does; or `"against"`.'
    )
    steps: Steps | None = Field(
        default=None, description="Rows of the tables: equal steps of each moving phase, in place of `step`."
    )
    step: Step = Field(default=math.pi / 180, description="Rows of the tables: step of the angle of the cam.")
    tool_radius: Size | None = Field(
        default=None, description="Radius of the cutter or grinding wheel whose path is asked for."
    )
    tolerance: Size = Field(default=1e-6, description="Chord error of exported curves.")
    face_margin: Distance = Field(
        default=0.0, description="Length by which a flat face is longer than the contact needs, on both sides."
    )
    refuse: bool = Field(
        default=True,
        description="Whether a profile that is undercut or crosses itself is an error; `false`: it is told and shown.",
    )
    limits: CamLimitsTable = Field(default_factory=CamLimitsTable, description="Pressure angles and radii.")
    loads: CamLoadsTable | None = Field(
        default=None, description="Masses, forces and friction of the follower; forces are positive along the lift."
    )
    spring: CamSpringTable | None = Field(default=None, description="The spring that keeps it on the cam.")
    guide: CamGuideTable = Field(default_factory=CamGuideTable, description="The guide of a stem.")
    requirements: CamRequirementsTable | None = Field(default=None, description="Data of strength and slip.")
    optimum: CamOptimumTable | None = Field(default=None, description="The search for the lowest mechanism.")
    elastic: CamElasticTable | None = Field(default=None, description="The follower as a mass on a spring.")
