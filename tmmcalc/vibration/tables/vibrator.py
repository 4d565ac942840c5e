"""``[vibrator]``: a vibratory assembly device: ring on rods, gripper on flat springs, exciter on an elastic plate."""

import math
from typing import Annotated

from pydantic import Field

from tmmcalc.spec.choices import Listed, Whole, Within
from tmmcalc.spec.identifiers import PointName
from tmmcalc.spec.quantities import AngularSpeed, Gravity, Number, Quantity
from tmmcalc.spec.table import Table

_POSITIVE = {"at_least_zero": True, "nonzero": True}
_ANGLE = ("angle", "deg", math.pi / 180)

Mass = Annotated[float, Quantity("mass", **_POSITIVE)]
Inertia = Annotated[float, Quantity("inertia", **_POSITIVE)]
RotorInertia = Annotated[float, Quantity("inertia", at_least_zero=True)]
Size = Annotated[float, Within("length", "mm", 1e-3, 1e-4, 1e5, bare=5.0)]
Distance = Annotated[float, Within("length", "mm", 1e-3, 0, 1e5, bare=5.0)]
Drop = Annotated[float, Within("length", "mm", 1e-3, -1e5, 1e5, bare=5.0)]
ArmAngle = Annotated[float, Within(*_ANGLE, -180, 180)]
Across = Annotated[float, Quantity("stiffness", **_POSITIVE)]
Turning = Annotated[float, Quantity("torsional stiffness", **_POSITIVE)]
Modulus = Annotated[float, Quantity("pressure", **_POSITIVE)]
Damper = Annotated[float, Quantity("damping", at_least_zero=True)]
TurningDamper = Annotated[float, Quantity("torsional damping", at_least_zero=True)]
Ratio = Annotated[float, Number("a part of critical damping", "0.02", at_least=0, below=1)]
Torsion = Annotated[float, Number("a torsion coefficient", "0.333", above=0, at_most=0.34)]
StaticMoment = Annotated[float, Quantity("static moment", **_POSITIVE)]
Acceleration = Annotated[float, Quantity("angular acceleration", **_POSITIVE)]
Duration = Annotated[float, Quantity("time", **_POSITIVE)]
InitialSpeed = Annotated[float, Quantity("angular speed", at_least_zero=True)]
Points = Annotated[int, Whole("a number of points", 3, 20_000)]
Rows = Annotated[int, Whole("a number of rows", 10, 100_000)]
Place = Annotated[list[float], Listed(Quantity("length"), '["20 mm", 0, "-80 mm"]', 3)]


class RingTable(Table):
    """The ring on its four rods."""

    mass: Mass = Field(description="m1: mass of the ring.")
    inertia: Inertia = Field(description="J_z1: its moment of inertia about the vertical axis.")


class GripperTable(Table):
    """The gripper with its part, hung in the ring."""

    mass: Mass = Field(description="m2: mass of the gripper with the part.")
    drop: Drop = Field(description="l: its centre of mass below the plane of the flat springs; negative: above.")
    inertia_x: Inertia = Field(
        description="J_xi: its moment of inertia about the axis along x through its centre of mass."
    )
    inertia_y: Inertia = Field(
        description="J_eta: its moment of inertia about the axis along y through its centre of mass."
    )
    inertia_z: Inertia = Field(
        description="J_zeta: its moment of inertia about the vertical through its centre of mass."
    )


class ExciterTable(Table):
    """Motor, tachometer and unbalance on their elastic plate, which turn about a hinge."""

    mass: Mass = Field(description="m3: mass of the exciter.")
    radius: Distance = Field(description="R0: distance of its centre of mass from the vertical axis.")
    arm: Distance = Field(description="R*: from the hinge to its centre of mass.")
    arm_angle: ArmAngle = Field(description="beta: angle at which that arm climbs above the horizontal.")
    inertia_hinge: Inertia = Field(description="J_x': moment of inertia about the line along the hinge.")
    inertia_vertical: Inertia | None = Field(
        default=None, description="J_z3: moment of inertia about the vertical; or `inertia_axis` and `inertia_cross`."
    )
    inertia_axis: Inertia | None = Field(
        default=None,
        description="J_z': moment of inertia about the motor's axis; with `inertia_cross` in place of "
        "`inertia_vertical`.",
    )
    inertia_cross: Inertia | None = Field(
        default=None,
        description="J_y': moment of inertia about the line across the motor's axis and the hinge.",
    )
    stiffness: Turning = Field(description="c2: stiffness of the plate against a turn about the hinge.")


class RodsTable(Table):
    """The four rods that carry the ring, clamped at both ends."""

    radius: Size = Field(description="R2: distance of the rods' ends from the vertical axis.")
    stiffness: Across | None = Field(
        default=None, description="c: stiffness of one rod across itself; or `diameter` and `length`."
    )
    diameter: Size | None = Field(default=None, description="d_c: diameter of a rod.")
    length: Size | None = Field(default=None, description="l_c: length of a rod.")
    young: Modulus = Field(default=206e9, description="E: modulus of elasticity.")


class FlatsTable(Table):
    """The four flat springs between ring and gripper, crossed along x and y."""

    vertical: Across | None = Field(
        default=None, description="c1: stiffness of one spring; with `tilt` in place of the sizes."
    )
    tilt: Turning | None = Field(
        default=None, description="c_t: stiffness of all four against a tilt, with the part of the weight."
    )
    width: Size | None = Field(default=None, description="b: width of a spring.")
    thickness: Size | None = Field(default=None, description="h: thickness of a spring.")
    length: Size | None = Field(default=None, description="l1: free length of a spring.")
    offset: Distance = Field(default=0.0, description="l2: from the axis to the inner end of a spring.")
    young: Modulus = Field(default=206e9, description="E: modulus of elasticity.")
    shear_modulus: Modulus = Field(default=79e9, description="G: shear modulus.")
    torsion: Torsion | None = Field(
        default=None,
        description="alpha_t: torsion coefficient of the section in J_t = alpha_t b h^3; "
        "0.333 of thin strips (default: of the rectangle).",
    )


class VibratorDampingTable(Table):
    """Damping of all modes alike, or of the coordinates one by one."""

    ratio: Ratio | None = Field(
        default=None, description="Part of critical damping of every mode; or the coefficients one by one."
    )
    x: Damper = Field(default=0.0, description="Damping coefficient of the ring along x.")
    y: Damper = Field(default=0.0, description="Damping coefficient of the ring along y.")
    phi: TurningDamper = Field(default=0.0, description="Damping coefficient of the turn of the ring.")
    tilt_x: TurningDamper = Field(default=0.0, description="Damping coefficient of the gripper's tilt about x.")
    tilt_y: TurningDamper = Field(default=0.0, description="Damping coefficient of the gripper's tilt about y.")
    z: Damper = Field(default=0.0, description="Damping coefficient of the gripper's vertical motion.")
    gamma: TurningDamper = Field(default=0.0, description="Damping coefficient of the exciter about its hinge.")


class VibratorUnbalanceTable(Table):
    """The unbalance on the motor's shaft."""

    moment: StaticMoment | None = Field(default=None, description="m r: static moment, in place of mass and radius.")
    mass: Mass | None = Field(default=None, description="m: mass of the unbalance.")
    radius: Size | None = Field(default=None, description="r: distance of its centre from the motor's axis.")
    distance: Distance | None = Field(
        default=None, description="R: middle of its path from the vertical axis (default: `radius` of the exciter)."
    )
    arm: Distance | None = Field(
        default=None, description="From the hinge to the middle of its path (default: `arm` of the exciter)."
    )
    arm_angle: ArmAngle | None = Field(
        default=None,
        description="delta: angle at which that arm climbs above the horizontal (default: `arm_angle` of the exciter).",
    )
    rotor_inertia: RotorInertia | None = Field(
        default=None,
        description="Moment of inertia of the whole rotor with the unbalance about its axis (default: "
        "that of the motor, or 0).",
    )


class VibratorCurveTable(Table):
    """Resonance curve: amplitudes over a range of speeds."""

    low: AngularSpeed = Field(alias="from", description="Lowest speed.")
    high: AngularSpeed = Field(alias="to", description="Highest speed.")
    points: Points = Field(default=400, description="Number of speeds of the resonance curve, in equal steps.")


class VibratorStartTable(Table):
    """Start with a given angle: the rotor speeds up evenly to the speed and keeps it."""

    acceleration: Acceleration = Field(description="Angular acceleration of the rotor.")
    duration: Duration = Field(description="Time that is shown.")
    rows: Rows = Field(default=1000, description="Rows of the table, at equal times.")
    tangential: bool = Field(
        default=True,
        description="Whether the unbalance also pulls along its path while it speeds up; `false`: "
        "the force of the paper, m r psi'^2 alone.",
    )


class VibratorDriveTable(Table):
    """Start of the rotor by the motor of the spec, as a degree of freedom of its own."""

    duration: Duration = Field(description="Time that is shown.")
    drag: TurningDamper = Field(default=0.0, description="Moment of bearings and air over the speed.")
    initial_speed: InitialSpeed = Field(default=0.0, description="Speed of the rotor at the beginning.")
    rows: Rows = Field(default=1000, description="Rows of the table, at equal times.")


class VibratorTable(Table):
    """A vibratory assembly device: its bodies, springs, exciter, and what is to be found of it."""

    gravity: Gravity = Field(default=9.81, description="Acceleration of free fall.")
    speed: AngularSpeed | None = Field(
        default=None, description="Speed of the rotor in the steady motion, and the one that a start runs up to."
    )
    ring: RingTable = Field(description="The ring.")
    gripper: GripperTable = Field(description="The gripper with the part.")
    exciter: ExciterTable = Field(description="Motor and unbalance on their plate.")
    rods: RodsTable = Field(description="The rods of the ring.")
    flats: FlatsTable = Field(description="The flat springs of the gripper.")
    damping: VibratorDampingTable = Field(
        default_factory=VibratorDampingTable, description="Damping, of all modes alike or coordinate by coordinate."
    )
    unbalance: VibratorUnbalanceTable | None = Field(default=None, description="The unbalance that excites it.")
    curve: VibratorCurveTable | None = Field(default=None, description="The resonance curve.")
    start: VibratorStartTable | None = Field(
        default=None, description="A start with a given angle: the rotor speeds up evenly to `speed` and keeps it."
    )
    drive: VibratorDriveTable | None = Field(
        default=None, description="A start of the rotor by its motor, as a degree of freedom of its own."
    )
    points: dict[PointName, Place] = Field(
        default={},
        description="Points `[x, y, z]` of the part whose paths are found, by name, at rest: "
        '`{ A = ["20 mm", 0, "-80 mm"] }`.',
    )
