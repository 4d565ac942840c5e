"""What the machine stages read of a spec: the motor or the wish for one, the gears, the flywheel, constant inertias.

Plain values: the pipeline hashes them.
"""

from __future__ import annotations

from typing import Literal

from tmmcalc.machine.motors.model import CharacteristicKind, Motor
from tmmcalc.records import record


@record
class MotorChoice:
    """The motor of the spec: given, or to be chosen."""

    motor: Motor | None  # None: choose one
    characteristic: CharacteristicKind
    time_constant: float = 0.0  # electromagnetic tau_e [s]
    catalogue: tuple[Motor, ...] = ()  # of the user's own; empty: the program's
    synchronous: float | None = None  # of the motor to choose [rad/s]


@record
class Gears:
    """The gears between the motor and the input shaft."""

    ratio: float | None = None  # motor speed over input speed; None: rated speed over the mean input speed
    efficiency: float = 1.0
    inertia: float = 0.0  # reduced to the input shaft [kg*m^2]


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

    positional: bool  # a constant driving moment, and not a motor
    inertia: float = 0.0  # further constant inertia of the input shaft [kg*m^2]
    speed: float | None = None  # mean speed of the positional motion [rad/s]; None: that of the input
