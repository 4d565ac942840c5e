"""The results of the vibratory assembly device."""

from __future__ import annotations

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.vibration.vibrator.forced import Peak, Steady
from tmmcalc.vibration.vibrator.paths import PointPath
from tmmcalc.vibration.vibrator.regimes import Barrier, Regime
from tmmcalc.vibration.vibrator.runup import Course
from tmmcalc.vibration.vibrator.springs import Stiffness


@record
class Curve:
    """Amplitudes over the speed of the rotor."""

    omega: Values  # (m,) [rad/s]
    amplitude: Values  # (7, m) [m] and [rad]
    phase: Values  # (7, m) behind the unbalance [rad]
    peaks: tuple[Peak, ...]  # largest of every coordinate


@record
class Start:
    """The start with a prescribed angle of the rotor."""

    course: Course
    points: Values  # (k, 3, n) displacements of the points of the part [m]
    largest: Values  # (7,) largest sizes of the coordinates [m] and [rad]


@record
class MotorStart:
    """The start of the rotor by its motor."""

    course: Course
    motor: Values  # (n,) moment of the motor [N*m]
    points: Values  # (k, 3, n) [m]
    largest: Values  # (7,)
    mean: float  # speed over the last tenth of the time [rad/s]
    gain: float  # of that speed over the tenth before [rad/s]
    regimes: tuple[Regime, ...]  # steady regimes by their speed
    barriers: tuple[Barrier, ...]  # what resonances ask of the motor
    stuck: int  # number of the mode at whose resonance the rotor stays; 0: it does not
    evaluations: int


@record
class VibratorResult:
    """Springs, modes, steady vibration and starts of a device."""

    springs: Stiffness
    mass: Values  # M (7, 7) [kg], [kg*m], [kg*m^2]
    stiffness: Values  # C (7, 7) [N/m], [N*m/rad]
    damping: Values  # B (7, 7) [N*s/m], [N*m*s/rad]
    frequency: Values  # natural, w (7,) ascending [rad/s]
    shapes: Values  # (7, 7) a mode in each column, its largest displacement 1
    ratio: Values  # (7,) part of critical damping of the modes
    error: dict[str, float]  # relative: frequencies, amplitudes and power of the steady motion, the curve
    curve: Curve | None
    steady: Steady | None
    paths: tuple[PointPath, ...]  # of the points of the part in the steady motion
    run_up: Start | None
    drive: MotorStart | None
    points: tuple[str, ...]  # names of the points
    notes: tuple[str, ...]
