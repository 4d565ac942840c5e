"""What the machine stages read of a spec: a torque diagram, the motor or the wish for one, gears and shafts, the
flywheel, motions, an engine, a rotor.

Plain values: the pipeline hashes them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, NamedTuple

from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.gears.openpair import OpenPair
    from tmmcalc.machine.balance.cylinders import Cylinder
    from tmmcalc.machine.balance.rotors import Rotor
    from tmmcalc.machine.motors.braking import Braking
    from tmmcalc.machine.motors.model import CharacteristicKind, Motor
    from tmmcalc.machine.transient.methods import Method
    from tmmcalc.machine.transient.model import Shaft
    from tmmcalc.machine.transient.scenario import Scenario


Interpolation = Literal["linear", "pchip", "spline"]  # of points over a period


@record
class TorqueFormula:
    """A formula of theta, as `diagram.from_formula` reads it."""

    text: str
    constants: tuple[tuple[str, float], ...] = ()


@record
class TorqueHarmonics:
    """A constant moment and harmonics, as `diagram.from_harmonics` takes them."""

    constant: float  # [N*m]
    terms: tuple[tuple[float, float, float], ...]  # order k, amplitudes of cos and sin [N*m]


@record
class TorquePoints:
    """Moments at angles, as `diagram.from_table` takes them."""

    theta: tuple[float, ...]  # ascending, of linear ones two equal at a jump [rad]
    moment: tuple[float, ...]  # [N*m]
    interpolation: Interpolation = "linear"


@record
class InertiaPoints:
    """Reduced inertia at angles, as `diagram.from_inertia` takes it."""

    theta: tuple[float, ...]  # ascending [rad]
    inertia: tuple[float, ...]  # J [kg*m^2]
    period: float  # after which it repeats [rad]
    interpolation: Interpolation = "spline"


@record
class TorqueTask:
    """A torque diagram in place of a mechanism: the moment on the input shaft, and the shaft's inertia."""

    name: str
    speed: float  # mean speed [rad/s]
    period: float  # of the cycle [rad]
    law: TorqueFormula | TorqueHarmonics | TorquePoints
    delays: tuple[float, ...] = ()  # of equal diagrams on the shaft [rad]; empty: one alone
    inertia: float = 0.0  # constant, of the shaft [kg*m^2]
    balanced: bool = False  # with the constant moment that closes the work of a cycle
    reduced: InertiaPoints | None = None  # what varies with the angle, of each diagram


@record
class MotorChoice:
    """The motor of the spec: given, or to be chosen."""

    motor: Motor | None  # None: choose one
    characteristic: CharacteristicKind
    time_constant: float | None = 0.0  # electromagnetic tau_e [s]; None: by the formula, from the critical slip
    catalogue: tuple[Motor, ...] = ()  # of the user's own; empty: the program's
    synchronous: float | None = None  # of the motor to choose [rad/s]
    reserve: float = 0.0  # part by which the motor to choose exceeds what is asked of it


@record
class Gears:
    """What the spec gives of the gears between the motor and the input shaft; None: nothing, see `drive_line`."""

    ratio: float | None = None  # motor speed over input speed, an open pair included
    efficiency: float | None = None  # of the gears before the open pair
    inertia: float | None = None  # of the same, reduced to the input shaft [kg*m^2]
    open: OpenPair | None = None  # on the crank; None: the output shaft of these gears is the input shaft


@record
class FlywheelTask:
    """The flywheel: what it must keep, what is there, where it sits, what rim it may have."""

    delta: float | None  # allowed coefficient of unevenness
    inertia: float  # of the flywheel that is there, on its own shaft [kg*m^2]
    shaft: Literal["input", "motor", "other"]
    ratio: float | None  # speed of the other shaft over that of the input shaft
    diameter: float | None  # mean diameter of the rim [m]
    width: float | None  # [m]
    thickness: float | None  # [m]
    material: str  # of the rim, a name of `flywheel.materials.MATERIALS`
    density: float | None  # [kg/m^3]; None: that of the material
    speed_limit: float | None  # of the rim [m/s]; None: that of the material


@record
class MotionTask:
    """How the motion is found."""

    positional: bool  # no motor: a constant driving moment, or none
    inertia: float = 0.0  # further constant inertia of the input shaft [kg*m^2]
    speed: float | None = None  # mean speed of the positional motion [rad/s]; None: that of the input
    undriven: bool = False  # nothing drives but the loads, which set the speed


@record
class TrialTask:
    """What a motor to choose has to do in the machine: its steady motion, and the starts that are asked for."""

    motion: MotionTask
    wheel: FlywheelTask | None
    starts: tuple[TransientTask, ...]
    shafts: tuple[DriveShaft, ...]


@record
class DriveShaft:
    """A shaft of the elastic drive, with the gear and the mass behind it."""

    name: str
    shaft: Shaft
    inertia: float  # of the mass behind, on its own shaft [kg*m^2]; of the last, the crank, what is its own


class TransientTask(NamedTuple):
    """A motion in time, and how it is integrated."""

    scenario: Scenario
    method: Method
    steady: bool  # it begins in the steady motion at theta = 0: the scenario's speed is not known yet
    braking: Braking | None = None  # how the motor is connected, where it brakes


@record
class EngineTask:
    """An engine whose shaking forces and couples are asked for."""

    cylinders: tuple[Cylinder, ...]
    speed: float  # [rad/s]
    orders: tuple[int, ...]  # of the shaft speed, told apart
    strokes: Literal[2, 4]
    firing_order: tuple[int, ...] | None  # cylinder numbers from 1; None: not given


@record
class RotorTask:
    """A rotor to be balanced."""

    rotor: Rotor
    planes: tuple[float, float]  # of correction, z [m]
    static_plane: float | None  # z [m]; None: that of the centre of mass
    grade: float | None  # balance quality to be kept [mm/s]
    radius: float | None  # of the correction masses [m]; None: static moments alone
