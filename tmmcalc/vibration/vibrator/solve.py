"""The vibratory assembly device: its modes, steady vibration, starts, and what is to be said of them."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi
from typing import Any

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.notes import Phrase, Said, held
from tmmcalc.vibration.vibrator.energies import Excitation, excitation_of, mass_matrix, stiffness_matrix
from tmmcalc.vibration.vibrator.errors import Device, amplitude_errors, power_error, relative
from tmmcalc.vibration.vibrator.forced import Steady, amplitudes, peaks, steady
from tmmcalc.vibration.vibrator.modes import Modes, damping_matrix, modes_of, shown_shapes
from tmmcalc.vibration.vibrator.paths import displacements, point_paths
from tmmcalc.vibration.vibrator.regimes import Barrier
from tmmcalc.vibration.vibrator.results import Curve, MotorStart, Start, VibratorResult
from tmmcalc.vibration.vibrator.runup import run_up
from tmmcalc.vibration.vibrator.springs import stiffness_of
from tmmcalc.vibration.vibrator.task import COORDINATES, UNITS, VibratorTask

RPM = 30 / pi
NEAR = 0.05  # of a natural frequency: a speed so near is at resonance
LARGE_TURN = 0.15  # rad: beyond it a small turn is none
SHORT = 0.03  # of a regime's speed: a rotor that lacks more has not reached it
SETTLED = 2e-3  # of its speed that a rotor at least gains in a tenth of the time while it still speeds up


def solve_vibrator(task: VibratorTask) -> VibratorResult:
    """Springs, natural frequencies and modes; steady vibration, resonance curve and starts where they are asked for.

    Raises `NoSolutionError` if mass or stiffness is not positive definite, `SingularityError` at resonance without
    damping, `UsageError` where a start is asked without an unbalance or a speed.
    """
    springs = stiffness_of(task)
    mass, stiffness = mass_matrix(task), stiffness_matrix(task, springs)
    modes = modes_of(mass, stiffness, task.damping, task.rods.radius)
    damping = damping_matrix(modes, mass, stiffness, task.damping)
    ratio = 0.0 if task.damping.direct else task.damping.ratio
    device = Device(mass, stiffness, damping, ratio, modes.weight)
    excitation = None if task.unbalance is None else excitation_of(task.unbalance)
    found = None if excitation is None or task.speed is None else steady(modes, excitation, task.speed)
    driven = _driven(task, modes, excitation)
    started = _started(task, modes, excitation)
    curve = _curve(task, modes, excitation)
    return VibratorResult(
        springs=springs,
        mass=mass,
        stiffness=stiffness,
        damping=damping.astype(float),
        frequency=modes.frequency,
        shapes=shown_shapes(modes),
        ratio=np.diagonal(modes.damping) / (2 * modes.frequency),
        error=_errors(device, modes, excitation, found, curve),
        curve=curve,
        steady=found,
        paths=() if found is None else point_paths(task.points, found),
        run_up=started,
        drive=driven,
        points=tuple(name for name, _ in task.points),
        notes=(*_notes(modes, found, started, driven), *_validity(task, driven), *_undamped(task, modes)),
    )


def _errors(
    device: Device, modes: Modes, excitation: Excitation | None, found: Steady | None, curve: Curve | None
) -> dict[str, float]:
    """Of frequencies each relative to itself, of amplitudes to the largest as lengths, of the power to itself."""
    errors = {"frequencies": modes.error}
    if excitation is None:
        return errors
    force = excitation.amplitude(np.ones(1))[0]
    if found is not None:
        amplitude = (found.cosine - 1j * found.sine)[None]
        missed = amplitude_errors(device, force, np.array([found.speed]), amplitude)
        errors["amplitudes"] = relative(device, missed, amplitude)
        errors["power"] = power_error(device, modes, found, missed[0])
    if curve is not None:
        amplitude = (curve.amplitude * np.exp(-1j * curve.phase)).T
        errors["curve"] = relative(device, amplitude_errors(device, force, curve.omega, amplitude), amplitude)
    return errors


def _curve(task: VibratorTask, modes: Modes, excitation: Excitation | None) -> Curve | None:
    if task.curve is None or excitation is None:
        return None
    omega = np.linspace(task.curve.low, task.curve.high, task.curve.points)
    found = amplitudes(modes, excitation, omega)
    phase = np.where(found != 0, -np.angle(found), 0.0)
    listed = tuple(peaks(modes, excitation, omega, found, COORDINATES))
    return Curve(omega, np.abs(found).T, phase.T, listed)


def _started(task: VibratorTask, modes: Modes, excitation: Excitation | None) -> Start | None:
    if task.run_up is None:
        return None
    course = run_up(modes, _needed(excitation), _speed(task), task.run_up)
    return Start(course, displacements(task.points, course.q), np.max(np.abs(course.q), axis=1))


def _driven(task: VibratorTask, modes: Modes, excitation: Excitation | None) -> MotorStart | None:
    if task.drive is None:
        return None
    from tmmcalc.vibration.vibrator.regimes import regimes
    from tmmcalc.vibration.vibrator.rotor import driven, mean_speed

    exciting = _needed(excitation)
    found = driven(modes, exciting, task.drive, task.gravity)
    steady_ones, barriers = regimes(modes, exciting, task.drive)
    mean, gain = mean_speed(found.course)
    top = max((each.speed for each in steady_ones if each.stable), default=mean)
    stands = mean < top * (1 - SHORT) and gain < SETTLED * mean
    return MotorStart(
        course=found.course,
        motor=found.motor,
        points=displacements(task.points, found.course.q),
        largest=np.max(np.abs(found.course.q), axis=1),
        mean=mean,
        gain=gain,
        regimes=steady_ones,
        barriers=barriers,
        stuck=_nearest(modes, barriers, mean) if stands else 0,
        evaluations=found.evaluations,
    )


def _nearest(modes: Modes, barriers: tuple[Barrier, ...], speed: float) -> int:
    """Number of the mode whose resonance is nearest to a speed, of those that ask a moment of the motor if any do."""
    if barriers:
        return min(barriers, key=lambda each: abs(each.speed - speed)).mode
    return int(np.argmin(np.abs(modes.frequency - speed))) + 1


def _needed(excitation: Excitation | None) -> Excitation:
    if excitation is None:
        raise UsageError("nothing excites the device", where="vibrator", remedy="add [vibrator.unbalance]")
    return excitation


def _speed(task: VibratorTask) -> float:
    if task.speed is None:
        raise UsageError("a start runs up to a speed", where="vibrator", remedy='add speed = "1450 rpm" to [vibrator]')
    return task.speed


def _notes(modes: Modes, found: Steady | None, started: Start | None, driven: MotorStart | None) -> Iterator[Said]:
    if found is not None:
        near = int(np.argmin(np.abs(modes.frequency - found.speed)))
        ratio = found.speed / float(modes.frequency[near])
        if abs(ratio - 1) < NEAR:
            text = "the speed is {value:.4g} of natural frequency {mode}: the device works at resonance"
            yield held("note", text, ratio, 1.0, name="speed/natural frequency", mode=near + 1)
        yield from _large("steady motion", found.amplitude)
    if started is not None:
        yield from _large("start", started.largest)
    if driven is not None:
        yield from _large("start by the motor", driven.largest)
        yield from _of_motor(modes, driven)


def _large(what: str, sizes: np.ndarray) -> Iterator[Said]:
    turns = [(size, name) for size, name, unit in zip(sizes.tolist(), COORDINATES, UNITS, strict=True) if unit == "rad"]
    size, name = max(turns)
    if size > LARGE_TURN:
        text = (
            "{turn} comes to {value:.4g} deg, more than the {limit:.3g} deg up to which the equations of small turns "
            "hold"
        )
        numbers = size, LARGE_TURN, "rad"
        yield held("warning", text, *numbers, shown="deg", name=name, place=what, turn=name)


def _of_motor(modes: Modes, driven: MotorStart) -> Iterator[Said]:
    stable = [each for each in driven.regimes if each.stable]
    if not stable:
        yield "warning: the motor has no steady regime up to its no-load speed"
        return
    top = stable[-1].speed
    if driven.stuck:
        w = float(modes.frequency[driven.stuck - 1])
        text = (
            "the rotor is stuck at resonance (Sommerfeld): it stays at {value:.5g} rpm, {part:.4g} of natural "
            "frequency {mode} ({frequency:.5g} Hz), although the motor could keep {limit:.5g} rpm; take a stronger "
            "motor, more damping or less unbalance"
        )
        words: dict[str, Any] = {"part": driven.mean / w, "mode": driven.stuck, "frequency": w / (2 * pi)}
        yield held("warning", text, driven.mean, top, "rad/s", shown="rpm", name="mean speed", **words)
    elif driven.mean < top * (1 - SHORT):
        text = (
            "the start has not ended: {value:.5g} rpm of {limit:.5g} rpm, still gaining {gain:.5g} rpm in a tenth of "
            "the time; write a longer duration"
        )
        numbers = driven.mean, top, "rad/s"
        yield held("warning", text, *numbers, shown="rpm", name="mean speed", gain=driven.gain * RPM)
    for each in driven.barriers:
        if each.speed < top and each.motor < each.load:
            text = (
                "resonance {mode} asks {limit:.5g} N*m at {rpm:.5g} rpm, the motor gives {value:.5g} N*m: only inertia "
                "carries the rotor past it"
            )
            at: dict[str, Any] = {"mode": each.mode, "rpm": each.speed * RPM}
            yield held("note", text, each.motor, each.load, "N*m", name="moment of the motor", **at)


def _validity(task: VibratorTask, driven: MotorStart | None) -> Iterator[Said]:
    """Where the formula of the motor's characteristic does not hold."""
    least = None if task.drive is None else task.drive.characteristic.least
    if task.drive is None or driven is None or least is None:
        return
    lowest = float(np.min(driven.course.omega))
    if lowest < least * (1 - SHORT):
        text = (
            'the characteristic "{kind}" holds from {limit:.5g} rpm, the start begins at {value:.5g} rpm; take one of '
            "the whole range, such as kloss or table"
        )
        numbers = lowest, least, "rad/s"
        yield held("warning", text, *numbers, shown="rpm", name="least speed", kind=task.drive.kind)


def _undamped(task: VibratorTask, modes: Modes) -> Iterator[Said]:
    """Which peaks of the curve have no bound."""
    if task.curve is None:
        return
    inside = (modes.frequency >= task.curve.low) & (modes.frequency <= task.curve.high)
    bare = np.flatnonzero(inside & (np.diagonal(modes.damping) == 0)) + 1
    if len(bare):
        modes_without = bare.tolist()
        yield Phrase(
            "warning: no damping in mode {modes}: at its resonance the curve has no bound, its peaks are arbitrary",
            modes=list(map(str, modes_without)),
        )
