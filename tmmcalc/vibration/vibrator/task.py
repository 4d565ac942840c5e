"""What is asked of a vibratory assembly device.

Fixed axes: origin O in the plane of the flat springs, x and y along them, z up. Seven coordinates:

    q = (x, y, phi, tilt_x, tilt_y, z, gamma)

x, y, phi of the ring, which moves in its plane; tilt_x, tilt_y, z of the gripper against it; gamma of the exciter
about its hinge, a horizontal line across the bisector of x and y. The motor's axis is inclined by 45 deg and its
horizontal projection lies along the bisector.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.records import record
from tmmcalc.machine.motors.model import CharacteristicKind, Motor, characteristic

if TYPE_CHECKING:
    from tmmcalc.machine.motors.characteristics import Characteristic

COORDINATES = ("x", "y", "phi", "tilt_x", "tilt_y", "z", "gamma")
UNITS = ("m", "m", "rad", "rad", "rad", "m", "rad")


@record
class Ring:
    """The ring on its rods."""

    mass: float  # m1 [kg]
    inertia: float  # J_z1 about the vertical [kg*m^2]


@record
class Gripper:
    """The gripper with the part that it holds."""

    mass: float  # m2 [kg]
    drop: float  # l: centre of mass below the plane of the flat springs [m]
    inertia_x: float  # J_xi, about axes through the centre of mass [kg*m^2]
    inertia_y: float  # J_eta
    inertia_z: float  # J_zeta


@record
class Exciter:
    """Motor, tachometer and unbalance on their plate."""

    mass: float  # m3 [kg]
    radius: float  # R0: of the centre of mass from the vertical axis [m]
    arm: float  # R*: from the hinge to the centre of mass [m]
    arm_angle: float  # beta: of that arm above the horizontal [rad]
    inertia_hinge: float  # J_x'3: about the line through the centre of mass along the hinge [kg*m^2]
    inertia_z: float  # J_z3: about the vertical through the centre of mass


@record
class Rods:
    """One of the four rods that carry the ring: its stiffness, or what gives it."""

    radius: float  # R2: of the rods' ends from the vertical axis [m]
    stiffness: float | None = None  # c across the rod [N/m]
    diameter: float = 0.0  # d_c [m]
    length: float = 0.0  # l_c [m]
    young: float = 206e9  # E [Pa]


@record
class Flats:
    """The four flat springs between ring and gripper: the stiffnesses, or what gives them."""

    vertical: float | None = None  # c1 of one spring [N/m]
    tilt: float | None = None  # c_t of all, with the part of the weight [N*m/rad]
    width: float = 0.0  # b [m]
    thickness: float = 0.0  # h [m]
    length: float = 0.0  # l1 [m]
    offset: float = 0.0  # l2: from the axis to the spring's inner end [m]
    young: float = 206e9  # E [Pa]
    shear: float = 79e9  # G [Pa]
    torsion: float | None = None  # alpha_t of the section; None: of the rectangle exactly


@record
class Unbalance:
    """The unbalance on the motor's shaft."""

    moment: float  # m r [kg*m]
    radius: float  # R: of its centre from the vertical axis [m]
    arm: float  # from the hinge to its centre [m]
    arm_angle: float  # delta: of that arm above the horizontal [rad]
    rotor: float = 0.0  # inertia about its axis, with the unbalance [kg*m^2]


@record
class Damping:
    """Either a part of critical damping of every mode, or a coefficient for every coordinate."""

    ratio: float = 0.0
    direct: tuple[float, ...] = ()  # (7,) [N*s/m] or [N*m*s/rad]; empty: by the ratio


@record
class Range:
    """Speeds of the resonance curve."""

    low: float  # [rad/s]
    high: float
    points: int = 400


@record
class RunUp:
    """Start with a prescribed angle: constant angular acceleration up to the speed, then that speed."""

    acceleration: float  # [rad/s^2]
    duration: float  # [s]
    rows: int = 1000
    tangential: bool = True  # whether the unbalance pulls along its path while it speeds up; the paper leaves it out


@record
class Drive:
    """Start with the rotor as a degree of freedom of its own."""

    motor: Motor
    kind: CharacteristicKind  # which of its characteristics
    duration: float  # [s]
    drag: float = 0.0  # of bearings and air [N*m*s/rad]
    initial: float = 0.0  # speed at the beginning [rad/s]
    rows: int = 1000

    @property
    def characteristic(self) -> Characteristic:
        """Moment of the motor over its speed, which it follows at once."""
        return characteristic(self.motor, self.kind)


@record
class VibratorTask:
    """A device, and what is to be found of it."""

    ring: Ring
    gripper: Gripper
    exciter: Exciter
    rods: Rods
    flats: Flats
    plate: float  # c2: of the exciter about its hinge [N*m/rad]
    gravity: float = 9.81
    damping: Damping = Damping()
    unbalance: Unbalance | None = None
    speed: float | None = None  # of the steady motion [rad/s]
    curve: Range | None = None
    run_up: RunUp | None = None
    drive: Drive | None = None
    points: tuple[tuple[str, tuple[float, float, float]], ...] = ()  # of the part, from O at rest [m]
