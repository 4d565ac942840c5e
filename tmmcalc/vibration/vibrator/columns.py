"""The columns of the vibratory device: resonance curve, a turn of the steady motion, the starts.

series                    "modes", "curve", "steady", "start" or "drive"
f, zeta                   natural frequency, part of critical damping
t, psi, omega             time, angle and speed of the rotor
x y phi tilt_x ...        coordinates; of modes their shapes, of the curve their amplitudes
ux_A uy_A uz_A            displacement of the point A
E, W, D                   energy; work put in and taken by the dampers so far
M_motor                   moment of the motor
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import headed, keys
from tmmcalc.vibration.series import as_text, stacked
from tmmcalc.vibration.vibrator.paths import STEPS
from tmmcalc.vibration.vibrator.results import DISPLACEMENT, OF_COURSES, MotorStart, Start, VibratorResult
from tmmcalc.vibration.vibrator.runup import DeviceMotion


def vibrator_columns(result: VibratorResult) -> dict[str, np.ndarray]:
    """All columns by header."""
    return stacked(dict(_series(result)))


def columns(result: VibratorResult) -> dict[str, np.ndarray]:
    """One row a time or a speed, blanks as texts; the first column tells of what."""
    return {header: as_text(column) for header, column in vibrator_columns(result).items()}


def _series(result: VibratorResult) -> Iterator[tuple[str, dict[str, np.ndarray]]]:
    yield "modes", headed(result, "hertz", "ratio") | _coordinates(result.shapes)
    if result.curve is not None:
        yield "curve", headed(result.curve, "omega") | _coordinates(result.curve.amplitude)
    if result.steady is not None:
        yield "steady", _turn(result)
    if result.run_up is not None:
        yield "start", _course(result.run_up, result.points)
    if result.drive is not None:
        yield "drive", _course(result.drive, result.points) | headed(result.drive, "motor")


def _coordinates(q: Values) -> dict[str, np.ndarray]:
    return {told.key: values for told, values in zip(OF_COURSES, q, strict=True)}


def _turn(result: VibratorResult) -> dict[str, np.ndarray]:
    """A turn of the steady motion."""
    steady = result.steady
    assert steady is not None
    psi = np.linspace(0.0, 2 * np.pi, STEPS + 1)
    q = steady.cosine[:, None] * np.cos(psi) + steady.sine[:, None] * np.sin(psi)
    moved = np.array([each.path.T for each in result.paths]).reshape(-1, 3, len(psi))
    turned = (psi / steady.speed, psi, np.full_like(psi, steady.speed))
    found = dict(zip(keys(DeviceMotion, "t", "psi", "omega"), turned, strict=True))
    return found | _coordinates(q) | _points(result.points, moved)


def _points(names: tuple[str, ...], moved: Values) -> dict[str, np.ndarray]:
    return {
        DISPLACEMENT.of(axis=axis, point=name).key: moved[k, i]
        for k, name in enumerate(names)
        for i, axis in enumerate("xyz")
    }


def _course(start: Start | MotorStart, names: tuple[str, ...]) -> dict[str, np.ndarray]:
    course = start.course
    moved = _coordinates(course.q) | _points(names, start.points)
    return headed(course, "t", "psi", "omega") | moved | headed(course, "energy", "work", "lost")
