"""The pendulum-rotor: whirl at its spin, Campbell diagram, critical speeds, torsion, motion in time."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from math import pi, sqrt

import numpy as np

from tmmcalc.errors import NoSolutionError, UsageError
from tmmcalc.machine.vibration.pendulum.basis import Basis, sample
from tmmcalc.machine.vibration.pendulum.energies import matrices
from tmmcalc.machine.vibration.pendulum.resolution import resolved
from tmmcalc.machine.vibration.pendulum.results import Campbell, PendulumResult, WhirlModes
from tmmcalc.machine.vibration.pendulum.swing import swing
from tmmcalc.machine.vibration.pendulum.task import PendulumTask
from tmmcalc.machine.vibration.pendulum.torsion import torsion_frequencies
from tmmcalc.machine.vibration.pendulum.whirl import (
    critical_speeds,
    lowest,
    unbalance_curve,
    unbalance_whirl,
    whirl,
)
from tmmcalc.numerics.panels import Values

PLACES = 101  # along the rod
PLANES = ("plane xz", "plane yz")
NEAR = 0.05  # of a critical speed: a spin so near is critical
LARGE = 0.15  # slope [rad]: beyond it a small one is none


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
    forward, backward = critical_speeds(parts, task.modes) if spun else (empty, empty)
    deflection = None
    if spun and moment and task.spin:
        deflection = float(parts.tip @ unbalance_whirl(parts, moment, task.spin))
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
        error=max(change for _, change in settled),
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


def _all(task: PendulumTask, plane: int, basis: Basis) -> Values:
    """The frequencies whose change tells how fine the basis is: at the spin, and at the ends of the diagram."""
    spins = [task.spin] if task.speeds is None else [task.spin, task.speeds.low, task.speeds.high]
    both = lowest(whirl(matrices(task, basis, plane), np.array(spins)), min(task.modes, basis.count))
    return np.concatenate([part.ravel() for part in both])


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
