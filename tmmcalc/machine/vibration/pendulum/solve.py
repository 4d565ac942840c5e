"""The pendulum-rotor: whirl at its spin, Campbell diagram, critical speeds, torsion, motion in time."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial
from math import pi, sqrt

import numpy as np

from tmmcalc.errors import NoSolutionError, UsageError
from tmmcalc.machine.vibration.pendulum.basis import Basis, sample
from tmmcalc.machine.vibration.pendulum.energies import Matrices, matrices
from tmmcalc.machine.vibration.pendulum.resolution import resolved
from tmmcalc.machine.vibration.pendulum.results import Campbell, PendulumResult, WhirlModes
from tmmcalc.machine.vibration.pendulum.rounding import Energies, critical_error, steady_end, whirl_error
from tmmcalc.machine.vibration.pendulum.swing import SwingCourse, swing
from tmmcalc.machine.vibration.pendulum.task import PendulumTask
from tmmcalc.machine.vibration.pendulum.torsion import torsion_frequencies
from tmmcalc.machine.vibration.pendulum.whirl import (
    Critical,
    critical_speeds,
    lowest,
    unbalance_curve,
    unbalance_whirl,
    whirl,
)
from tmmcalc.numerics.extended import EPS, MARGIN
from tmmcalc.numerics.panels import Values

PLACES = 101  # along the rod
PLANES = ("plane xz", "plane yz")
NEAR = 0.05  # of a critical speed: a spin so near is critical
LARGE = 0.15  # slope [rad]: beyond it a small one is none
FINER = 3  # degrees more, by which the error of the whirl is seen
TORSION = 8 * EPS  # a root to two of its last digits, and the roundings of its scale


def solve_pendulum(task: PendulumTask) -> PendulumResult:
    """Natural frequencies and modes at the spin, and what else is asked for.

    Raises `UsageError` for a spin of a rotor that is not axisymmetric, `NoSolutionError` where nothing holds the rod,
    `SingularityError` for an unbalance at a critical speed, `AccuracyError` where the modes cannot be resolved.
    """
    _check(task)
    planes = (0,) if task.axisymmetric else (0, 1)
    settled = [resolved(task, partial(_all, task, plane), plane) for plane in planes]
    bases = tuple(basis for basis, _ in settled)
    place = np.linspace(0.0, 1.0, PLACES)
    modes = [each for k, basis in zip(planes, bases, strict=True) for each in _modes(task, basis, k, place)]
    spun = _may_spin(task)
    parts = matrices(task, bases[0], 0)
    moment = task.disc.mass * task.disc.eccentricity
    empty = np.empty(0)
    critical = critical_speeds(parts, task.modes) if spun else ()
    forward, backward = (each.speeds for each in critical) if spun else (empty, empty)
    deflection = _deflection(task, parts) if spun and moment and task.spin else None
    found = None if task.swing is None else swing(task, task.swing, (bases[0], bases[-1]))
    return PendulumResult(
        spin=task.spin,
        place=place * task.rod.length,
        modes=tuple(modes),
        forward_critical=forward,
        backward_critical=backward,
        torsion=torsion_frequencies(task, task.modes),
        rigid=_rigid(task),
        deflection=deflection,
        campbell=_campbell(task, bases[0]),
        swing=found,
        functions=max(basis.count for basis in bases),
        error=_errors(task, settled, critical, deflection, found),
        notes=tuple(_notes(task, forward, None if found is None else (found.slope_v, found.slope_w))),
    )


def _check(task: PendulumTask) -> None:
    if not task.axisymmetric and (task.spin or task.speeds is not None):
        raise UsageError(
            "a rotor with different stiffness or inertia in its two planes has no constant equations while it spins",
            where="pendulum",
            remedy="make the section round, or leave spin and [pendulum.speeds] out",
        )
    if task.pivot == 0 and task.gravity == 0:
        raise NoSolutionError(
            "neither gravity nor a stiffness of the joint holds the rod: it turns freely",
            where="pendulum",
            value=0.0,
            limit=0.0,
            remedy='give gravity, stiffness = "20 N*m/rad", or stiffness = "clamped"',
        )


def _may_spin(task: PendulumTask) -> bool:
    return task.axisymmetric and (task.spin != 0 or task.speeds is not None)


def _spins(task: PendulumTask) -> list[float]:
    """Speeds of spin by which the basis is judged: that of the task, and the ends of the diagram."""
    return [task.spin] if task.speeds is None else [task.spin, task.speeds.low, task.speeds.high]


def _all(task: PendulumTask, plane: int, basis: Basis) -> Values:
    """What tells by its change how fine the basis is: frequencies of whirl, and critical speeds."""
    parts, count = matrices(task, basis, plane), min(task.modes, basis.count)
    both = lowest(whirl(parts, np.array(_spins(task))), count)
    critical = critical_speeds(parts, count) if _may_spin(task) else ()
    return np.concatenate([part.ravel() for part in (*both, *(each.speeds for each in critical))])


def _deflection(task: PendulumTask, parts: Matrices) -> float:
    """Displacement of the lower end by the unbalance, turning with the rotor [m]."""
    return float(parts.tip @ unbalance_whirl(parts, task.disc.mass * task.disc.eccentricity, task.spin))


def _errors(
    task: PendulumTask,
    settled: Sequence[tuple[Basis, float]],
    critical: Sequence[Critical],
    deflection: float | None,
    moved: SwingCourse | None,
) -> dict[str, float]:
    """Relative errors: of every frequency and speed, of the whirl of the unbalance, of the path over its size."""
    left = max(change for _, change in settled)
    rounding = [_rounding(task, basis, plane) for plane, (basis, _) in enumerate(settled)]
    found = {"frequencies": left + MARGIN * max(rounding) + EPS}
    basis = settled[0][0]
    if any(len(each.speeds) for each in critical):
        energies = Energies(task, basis, 0)
        missed = [critical_error(energies, *each) for each in critical if len(each.speeds)]
        found["critical"] = left + MARGIN * max(missed) + EPS
    if deflection is not None:
        finer = _deflection(task, matrices(task, replace(basis, degree=basis.degree + FINER), 0))
        found["whirl"] = MARGIN * (abs(finer / deflection - 1) + _whirl_rounding(task, basis, deflection)) + EPS
    if task.rod.torsion is not None:
        found["torsion"] = TORSION
    if moved is not None:
        found["swing"] = moved.error
    return found


def _whirl_rounding(task: PendulumTask, basis: Basis, deflection: float) -> float:
    moment = task.disc.mass * task.disc.eccentricity
    shape = unbalance_whirl(matrices(task, basis, 0), moment, task.spin)
    exact = steady_end(Energies(task, basis, 0), moment * task.spin**2, task.spin, shape)
    return abs(deflection / exact - 1)


def _rounding(task: PendulumTask, basis: Basis, plane: int) -> float:
    """Of the frequencies of whirl at the speeds by which the basis is judged."""
    energies, parts = Energies(task, basis, plane), matrices(task, basis, plane)
    count, worst = min(task.modes, basis.count), 0.0
    for spin in _spins(task):
        pencil = whirl(parts, np.array(spin))
        listed = np.r_[:count, len(pencil.mu) - count : len(pencil.mu)]
        worst = max(worst, whirl_error(energies, spin, pencil.mu[listed], pencil.y[:, listed]))
    return worst


def _modes(task: PendulumTask, basis: Basis, plane: int, place: Values) -> Iterator[WhirlModes]:
    parts = matrices(task, basis, plane)
    pencil = whirl(parts, np.array(task.spin))
    count = min(task.modes, basis.count)
    forward, backward = lowest(pencil, count)
    n, value = basis.count, sample(basis, place).value
    upper = _normalised(pencil.y[:n, : -count - 1 : -1].T @ value)
    if not task.axisymmetric or task.spin == 0:
        yield _named(PLANES[plane] if not task.axisymmetric else "both planes", forward, upper)
        return
    yield _named("forward", forward, upper)
    yield _named("backward", backward, _normalised(pencil.y[:n, :count].T @ value))


def _named(name: str, frequency: Values, shapes: Values) -> WhirlModes:
    inner = shapes[:, 1:]
    nodes = tuple(int(np.count_nonzero(np.signbit(row[1:]) != np.signbit(row[:-1]))) for row in inner)
    return WhirlModes(name, frequency, shapes, nodes)


def _normalised(shapes: Values) -> Values:
    """The largest displacement of every shape (m, p) is 1."""
    at = np.argmax(np.abs(shapes), axis=1)
    found: Values = shapes / shapes[np.arange(len(shapes)), at][:, None]
    return found


def _rigid(task: PendulumTask) -> tuple[float, float] | None:
    """Frequencies of the rigid gyroscopic pendulum, forward and backward: I_t w^2 - I_p Omega w - K_t = 0."""
    rod, disc = task.rod, task.disc
    if task.pivot is None or not task.axisymmetric:
        return None
    line = rod.density * rod.length
    inertia = line * rod.length**2 / 3 + line * rod.radius[0] ** 2 + disc.mass * rod.length**2 + disc.diametral[0]
    polar = 2 * line * rod.radius[0] ** 2 + disc.polar
    stiffness = (line / 2 + disc.mass) * rod.length * task.gravity + task.pivot
    half = polar * abs(task.spin) / (2 * inertia)
    high = half + sqrt(half**2 + stiffness / inertia)
    low = stiffness / inertia / high
    return (high, low) if task.spin >= 0 else (low, high)


def _campbell(task: PendulumTask, basis: Basis) -> Campbell | None:
    if task.speeds is None:
        return None
    spin = np.linspace(task.speeds.low, task.speeds.high, task.speeds.points)
    parts = matrices(task, basis, 0)
    forward, backward = lowest(whirl(parts, spin), min(task.modes, basis.count))
    moment = task.disc.mass * task.disc.eccentricity
    curve = unbalance_curve(parts, moment, spin) if moment else np.empty(0)
    return Campbell(forward.shape[1], spin, forward.T, backward.T, curve)


def _notes(task: PendulumTask, critical: Values, slopes: tuple[Values, Values] | None) -> Iterator[str]:
    if len(critical) and task.spin:
        near = float(critical[np.argmin(np.abs(critical - abs(task.spin)))])
        ratio = abs(task.spin) / near
        if abs(ratio - 1) < NEAR:
            rpm = near * 30 / pi
            yield f"warning: the spin is {ratio:.4g} of the critical speed {near:.6g} rad/s ({rpm:.5g} rpm)"
    if slopes is not None:
        largest = float(np.max(np.hypot(*slopes)))
        if largest > LARGE:
            yield (
                f"warning: the lower end comes to a slope of {np.degrees(largest):.4g} deg, more than the "
                f"{np.degrees(LARGE):.3g} deg up to which the equations of small slopes hold"
            )
