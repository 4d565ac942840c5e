"""The results of the vibratory assembly device."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.notes import Said
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import Quantity, derived, quantity
from tmmcalc.core.records import record
from tmmcalc.vibration.vibrator.forced import Peak, Steady
from tmmcalc.vibration.vibrator.paths import PointPath
from tmmcalc.vibration.vibrator.regimes import Barrier, Regime
from tmmcalc.vibration.vibrator.runup import DeviceMotion
from tmmcalc.vibration.vibrator.springs import Stiffness


@record
class Curve:
    """Amplitudes over the speed of the rotor."""

    omega: Values = quantity("omega[rad/s]", "speed of the rotor")  # (m,)
    amplitude: Values  # (7, m) [m] and [rad]
    phase: Values  # (7, m) behind the unbalance [rad]
    peaks: tuple[Peak, ...]  # largest of every coordinate


@record
class Start:
    """The start with a prescribed angle of the rotor."""

    course: DeviceMotion
    points: Values  # (k, 3, n) displacements of the points of the part [m]
    largest: Values  # (7,) largest sizes of the coordinates [m] and [rad]


@record
class MotorStart:
    """The start of the rotor by its motor."""

    course: DeviceMotion
    motor: Values = quantity("M_motor[N*m]", "moment of the motor")  # (n,)
    points: Values  # (k, 3, n) [m]
    largest: Values  # (7,)
    mean: float = quantity("mean_omega[rad/s]", "mean speed over the last tenth of the time")
    gain: float  # of that speed over the tenth before [rad/s]
    regimes: tuple[Regime, ...]  # steady regimes by their speed
    barriers: tuple[Barrier, ...]  # what resonances ask of the motor
    stuck: int = quantity("stuck_at_mode", "number of the mode at whose resonance the rotor stays; 0: it does not")
    evaluations: int


@record
class VibratorResult:
    """Springs, modes, steady vibration and starts of a device."""

    springs: Stiffness
    mass: Values = quantity("M", "mass matrix")  # (7, 7) [kg], [kg*m], [kg*m^2]
    stiffness: Values = quantity("C", "stiffness matrix")  # (7, 7) [N/m], [N*m/rad]
    damping: Values = quantity("B", "damping matrix")  # (7, 7) [N*s/m], [N*m*s/rad]
    frequency: Values  # natural, w (7,) ascending [rad/s]
    shapes: Values  # (7, 7) a mode in each column, its largest displacement 1
    ratio: Values = quantity("zeta", "damping ratios of the modes")  # (7,)
    error: dict[str, float]  # relative: frequencies, amplitudes and power of the steady motion, the curve
    curve: Curve | None
    steady: Steady | None
    paths: tuple[PointPath, ...]  # of the points of the part in the steady motion
    run_up: Start | None
    drive: MotorStart | None
    points: tuple[str, ...]  # names of the points
    notes: tuple[Said, ...]

    @derived("natural_frequencies[Hz]", "natural frequencies", symbol="f", header="f[Hz]")
    def hertz(self) -> Values:
        """(7,)."""
        return self.frequency / (2 * np.pi)

    @derived("n[rpm]", "natural frequencies as speeds")
    def speeds(self) -> Values:
        """(7,)."""
        return 60 * self.hertz

    @derived("modes", "shapes of the modes, their largest displacement 1")
    def modes(self) -> Values:
        """(7, 7) a mode in each row."""
        return self.shapes.T

    @derived("frequency_error", "largest relative error of the natural frequencies")
    def frequency_error(self) -> float:
        """It is always found."""
        return self.error["frequencies"]

    @derived("amplitude_error", "error of the steady amplitudes over the largest")
    def amplitude_error(self) -> float:
        """Of a device with a steady motion."""
        return self.error["amplitudes"]


COORDINATE = Quantity("{coordinate}[{unit}]", "coordinate {coordinate}; of modes its shape, of the curve its amplitude")
OF_COURSES = (  # the same in the table: the ring, the gripper, the exciter
    Quantity("x[m]", "displacement of the ring along x, of modes its shape, of the curve the amplitude"),
    Quantity("y[m]", "displacement of the ring along y, of modes its shape, of the curve the amplitude"),
    Quantity("phi[rad]", "turn of the ring about the vertical, of modes its shape, of the curve the amplitude"),
    Quantity("tilt_x[rad]", "tilt of the gripper about x, of modes its shape, of the curve the amplitude"),
    Quantity("tilt_y[rad]", "tilt of the gripper about y, of modes its shape, of the curve the amplitude"),
    Quantity("z[m]", "vertical displacement of the gripper, of modes its shape, of the curve the amplitude"),
    Quantity("gamma[rad]", "turn of the exciter about its hinge, of modes its shape, of the curve the amplitude"),
)
DISPLACEMENT = Quantity("u{axis}_{point}[m]", "displacement of {point} along {axis}")
HEADERS = tuple(each.key for each in OF_COURSES)
