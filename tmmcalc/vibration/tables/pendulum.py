"""``[pendulum]``: a pendulum-rotor: an elastic rod that hangs in a joint, spins, and carries a disc."""

import math
from typing import Annotated, Literal

from pydantic import Field

from tmmcalc.spec.choices import Listed, OneOrMore, Whole, Within
from tmmcalc.spec.quantities import Gravity, Number, Quantity
from tmmcalc.spec.table import Table

_POSITIVE = {"at_least_zero": True, "nonzero": True}
_LENGTH = ("length", "mm", 1e-3)

Mass = Annotated[float, Quantity("mass", **_POSITIVE)]
DiscMass = Annotated[float, Quantity("mass", at_least_zero=True)]
Length = Annotated[float, Within(*_LENGTH, 0.1, 1e6, bare=100.0)]
Size = Annotated[float, Within(*_LENGTH, 1e-4, 1e5, bare=5.0)]
Distance = Annotated[float, Within(*_LENGTH, 0, 1e5, bare=5.0)]
Radii = Annotated[list[float], OneOrMore(Within(*_LENGTH, 0, 1e5, bare=5.0))]
Bending = Annotated[list[float], OneOrMore(Number("a bending stiffness E I in N*m^2", "120", above=0))]
TorsionStiffness = Annotated[float, Number("a torsional stiffness G I_p in N*m^2", "90", above=0)]
Inertia = Annotated[float, Quantity("inertia", at_least_zero=True)]
Inertias = Annotated[list[float], OneOrMore(Quantity("inertia", at_least_zero=True))]
Density = Annotated[float, Quantity("density", **_POSITIVE)]
Modulus = Annotated[float, Quantity("pressure", **_POSITIVE)]
JointStiffness = Annotated[
    float | Literal["clamped"], Quantity("torsional stiffness", at_least_zero=True, words=("clamped",))
]
Spin = Annotated[float, Quantity("angular speed")]
LowSpeed = Annotated[float, Quantity("angular speed", at_least_zero=True)]
HighSpeed = Annotated[float, Quantity("angular speed", **_POSITIVE)]
Modes = Annotated[int, Whole("a number of modes", 1, 12)]
Elements = Annotated[int, Whole("a number of elements", 1, 60)]
Degree = Annotated[int, Whole("a degree", 3, 30)]
Points = Annotated[int, Whole("a number of points", 3, 2_000)]
Rows = Annotated[int, Whole("a number of rows", 10, 100_000)]
Duration = Annotated[float, Quantity("time", **_POSITIVE)]
Tilt = Annotated[float, Within("angle", "deg", math.pi / 180, -45, 45)]
Deflection = Annotated[float, Within(*_LENGTH, -1e5, 1e5, bare=5.0)]
Speed = Annotated[float, Quantity("speed")]
Times = Annotated[list[float], Listed(Quantity("time", at_least_zero=True), '["0 s", "2 s", "5 s"]')]
Speeds = Annotated[list[float], Listed(Quantity("speed"), '["0 m/s", "0.5 m/s", "0.5 m/s"]')]


class PendulumRodTable(Table):
    """The rod: its sizes and material, or mass and stiffness."""

    length: Length = Field(description="l: length of the rod.")
    mass: Mass | None = Field(default=None, description="Mass of the whole rod (default: by section and `density`).")
    diameter: Size | None = Field(
        default=None, description="Outer diameter of a round section; or `width` and `thickness` of a rectangle."
    )
    bore: Distance = Field(default=0.0, description="Inner diameter of a tube.")
    width: Size | None = Field(default=None, description="Side of a rectangular section along x.")
    thickness: Size | None = Field(default=None, description="Side of a rectangular section along y.")
    bending_stiffness: Bending | None = Field(
        default=None,
        description="E I as a number in N*m^2, in place of a section; two values: in the planes xz and yz.",
    )
    torsion_stiffness: TorsionStiffness | None = Field(
        default=None,
        description="G I_p as a number in N*m^2 (default: by the section); without one torsion is left out.",
    )
    section_radius: Radii | None = Field(
        default=None, description="Radius of gyration of the section, one or two (default: by the section, or 0)."
    )
    density: Density = Field(default=7850.0, description="Density of the material.")
    young: Modulus = Field(default=206e9, description="E: modulus of elasticity.")
    shear_modulus: Modulus = Field(default=79e9, description="G: shear modulus.")


class DiscTable(Table):
    """The disc on the lower end."""

    mass: DiscMass = Field(description="m: mass of the disc.")
    gyration: Radii | None = Field(
        default=None,
        description="r: radius of gyration of a thin disc, m r^2 about a diameter, 2 m r^2 about the axis; "
        "two values: along x, along y.",
    )
    diametral_inertia: Inertias | None = Field(
        default=None,
        description="Moment of inertia about a diameter, in place of `gyration`; two values: in xz, in yz.",
    )
    polar_inertia: Inertia | None = Field(
        default=None, description="Moment of inertia about the axis (default: twice the diametral one)."
    )
    eccentricity: Distance = Field(
        default=0.0,
        description="e: distance of its centre of mass from the axis. The rod whirls with the spin, in motion too, "
        "the heavy side towards x at its beginning.",
    )


class PendulumSpeedsTable(Table):
    """Campbell diagram: frequencies over a range of spin."""

    low: LowSpeed = Field(default=0.0, alias="from", description="Lowest speed of spin.")
    high: HighSpeed = Field(alias="to", description="Highest speed of spin.")
    points: Points = Field(default=121, description="Number of speeds, in equal steps.")


class CarrierTable(Table):
    """Motion of the joint: speeds at given times, straight lines between, the last one kept."""

    time: Times = Field(description="Times, ascending from 0.")
    x: Speeds | None = Field(default=None, description="Speed along x at each time.")
    y: Speeds | None = Field(default=None, description="Speed along y at each time.")
    up: Speeds | None = Field(default=None, description="Speed upwards at each time.")


class SwingTable(Table):
    """Motion in time: from a deflection, or under a carrier that moves."""

    duration: Duration = Field(description="Time that is shown.")
    rows: Rows = Field(default=1000, description="Rows of the table, at equal times.")
    tilt: Tilt = Field(default=0.0, description="At the beginning: straight, turned about the joint towards x.")
    deflection: Deflection = Field(
        default=0.0, description="At the beginning: lower end pulled along x by a force and let go."
    )
    push: Speed = Field(default=0.0, description="At the beginning: speed of the lower end along y, in that shape.")
    carrier: CarrierTable | None = Field(
        default=None,
        description='The joint moves: `{ time = ["0 s", "1 s"], x = [0, "0.2 m/s"] }`, speeds along `x`, `y` and '
        "`up`, straight lines between, the last one kept.",
    )


class PendulumTable(Table):
    """A pendulum-rotor: rod, disc, joint, spin, and what is to be found of it."""

    gravity: Gravity = Field(default=9.81, description="Acceleration of free fall.")
    stiffness: JointStiffness = Field(
        default=0.0, description='k: stiffness of the spherical joint against a tilt; `"clamped"`: it does not tilt.'
    )
    spin: Spin = Field(default=0.0, description="Speed of spin about the rod, positive from x to y.")
    modes: Modes = Field(default=4, description="Number of natural frequencies that are told.")
    elements: Elements | None = Field(
        default=None, description="Number of equal elements (default: as the accuracy asks)."
    )
    degree: Degree = Field(default=3, description="Degree of the polynomials in each element; 3: Hermite cubics.")
    rod: PendulumRodTable = Field(description="The rod.")
    disc: DiscTable | None = Field(default=None, description="The disc on its lower end.")
    speeds: PendulumSpeedsTable | None = Field(default=None, description="The Campbell diagram.")
    swing: SwingTable | None = Field(default=None, description="A motion in time.")
