"""The pendulum-rotor: whirl at its spin, Campbell diagram, critical speeds, torsion, motion in time."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import pi, sqrt
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Said, held
from tmmcalc.core.numerics.extended import EPS, MARGIN
from tmmcalc.core.numerics.panels import Values
from tmmcalc.vibration.pendulum.basis import sample
from tmmcalc.vibration.pendulum.energies import Matrices, matrices
from tmmcalc.vibration.pendulum.errors import Energies, critical_error, steady_end, whirl_error
from tmmcalc.vibration.pendulum.resolution import resolved
from tmmcalc.vibration.pendulum.results import Campbell, PendulumResult, WhirlModes
from tmmcalc.vibration.pendulum.swing import SwingCourse, swing
from tmmcalc.vibration.pendulum.task import PendulumTask
from tmmcalc.vibration.pendulum.torsion import torsion_frequencies
from tmmcalc.vibration.pendulum.whirl import Plane, lowest, unbalance_curve, unbalance_whirl, whirl

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
    settled = [resolved(task, number) for number in ((0,) if task.axisymmetric else (0, 1))]
    planes = [plane for plane, _ in settled]
    place = np.linspace(0.0, 1.0, PLACES)
    forward, backward = (each.speeds for each in planes[0].critical) if planes[0].critical else (np.empty(0),) * 2
    shape = _unbalanced(task, planes[0].parts)
    deflection = None if shape is None else float(planes[0].parts.tip @ shape)
    found = None if task.swing is None else swing(task, task.swing, (planes[0].basis, planes[-1].basis))
    return PendulumResult(
        spin=task.spin,
        place=place * task.rod.length,
        modes=tuple(modes for plane in planes for modes in _modes(task, plane, place)),
        forward_critical=forward,
        backward_critical=backward,
        torsion=torsion_frequencies(task, task.modes),
        rigid=_rigid(task),
        deflection=deflection,
        campbell=_campbell(task, planes[0]),
        swing=found,
        functions=max(plane.basis.count for plane in planes),
        error=_errors(task, settled, shape, found),
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


def _unbalanced(task: PendulumTask, parts: Matrices) -> Values | None:
    """The shape (n,) that turns with the rotor by its unbalance; None: it has none or does not spin."""
    moment = task.disc.mass * task.disc.eccentricity
    return unbalance_whirl(parts, moment, task.spin) if task.axisymmetric and moment and task.spin else None


def _errors(
    task: PendulumTask, settled: Sequence[tuple[Plane, float]], shape: Values | None, moved: SwingCourse | None
) -> dict[str, float]:
    """Relative errors: of every frequency and speed, of the whirl of the unbalance, of the path over its size."""
    left = max(change for _, change in settled)
    energies = [Energies(task, plane.basis, plane.number) for plane, _ in settled]
    rounding = [_rounding(each, plane) for each, (plane, _) in zip(energies, settled, strict=True)]
    found = {"frequencies": left + MARGIN * max(rounding) + EPS}
    missed = [critical_error(energies[0], *each) for each in settled[0][0].critical if len(each.speeds)]
    if missed:
        found["critical"] = left + MARGIN * max(missed) + EPS
    if shape is not None:
        found["whirl"] = _whirl_error(task, settled[0][0], energies[0], shape)
    if task.rod.torsion is not None:
        found["torsion"] = TORSION
    if moved is not None:
        found["displacement"] = moved.error
    return found


def _whirl_error(task: PendulumTask, plane: Plane, energies: Energies, shape: Values) -> float:
    """Of the lower end in the whirl of the unbalance: by a finer basis, and by rounding."""
    deflection = float(plane.parts.tip @ shape)
    parts = matrices(task, replace(plane.basis, degree=plane.basis.degree + FINER), 0)
    moment = task.disc.mass * task.disc.eccentricity
    finer = float(parts.tip @ unbalance_whirl(parts, moment, task.spin))
    exact = steady_end(energies, moment * task.spin**2, task.spin, shape)
    return MARGIN * (abs(finer / deflection - 1) + abs(deflection / exact - 1)) + EPS


def _rounding(energies: Energies, plane: Plane) -> float:
    """Of the frequencies of whirl at the speeds by which the basis is judged."""
    worst = 0.0
    for k, spin in enumerate(plane.spins.tolist()):
        mu, y, _ = plane.at(k)
        listed = np.r_[: plane.count, len(mu) - plane.count : len(mu)]
        worst = max(worst, whirl_error(energies, spin, mu[listed], y[:, listed]))
    return worst


def _modes(task: PendulumTask, plane: Plane, place: Values) -> Iterator[WhirlModes]:
    pencil, count, basis = plane.at(0), plane.count, plane.basis
    forward, backward = lowest(pencil, count)
    n, value = basis.count, sample(basis, place).value
    upper = _normalised(pencil.y[:n, : -count - 1 : -1].T @ value)
    if not task.axisymmetric or task.spin == 0:
        yield _named(PLANES[plane.number] if not task.axisymmetric else "both planes", forward, upper)
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


class RigidBody(NamedTuple):
    """The rotor as a rigid pendulum."""

    inertia: float  # I_t about a horizontal axis through the joint [kg*m^2]
    polar: float  # I_p about the rod [kg*m^2]
    stiffness: float  # K_t against a tilt [N*m/rad]


def rigid_body(task: PendulumTask) -> RigidBody:
    """Inertia and stiffness of the rotor that does not bend."""
    rod, disc = task.rod, task.disc
    line = rod.density * rod.length
    return RigidBody(
        line * rod.length**2 / 3 + line * rod.radius[0] ** 2 + disc.mass * rod.length**2 + disc.diametral[0],
        2 * line * rod.radius[0] ** 2 + disc.polar,
        (line / 2 + disc.mass) * rod.length * task.gravity + (task.pivot or 0.0),
    )


def _rigid(task: PendulumTask) -> tuple[float, float] | None:
    """Frequencies of the rigid gyroscopic pendulum, forward and backward: I_t w^2 - I_p Omega w - K_t = 0."""
    if task.pivot is None or not task.axisymmetric:
        return None
    inertia, polar, stiffness = rigid_body(task)
    half = polar * abs(task.spin) / (2 * inertia)
    high = half + sqrt(half**2 + stiffness / inertia)
    low = stiffness / inertia / high
    return (high, low) if task.spin >= 0 else (low, high)


def _campbell(task: PendulumTask, plane: Plane) -> Campbell | None:
    if task.speeds is None:
        return None
    spin = np.linspace(task.speeds.low, task.speeds.high, task.speeds.points)
    forward, backward = lowest(whirl(plane.parts, spin), plane.count)
    moment = task.disc.mass * task.disc.eccentricity
    curve = unbalance_curve(plane.parts, moment, spin) if moment else np.empty(0)
    return Campbell(forward.shape[1], spin, forward.T, backward.T, curve)


def _notes(task: PendulumTask, critical: Values, slopes: tuple[Values, Values] | None) -> Iterator[Said]:
    if len(critical) and task.spin:
        near = float(critical[np.argmin(np.abs(critical - abs(task.spin)))])
        ratio = abs(task.spin) / near
        if abs(ratio - 1) < NEAR:
            rpm = near * 30 / pi
            text = "the spin is {ratio:.4g} of the critical speed {limit:.6g} rad/s ({rpm:.5g} rpm)"
            yield held("warning", text, abs(task.spin), near, "rad/s", name="spin", ratio=ratio, rpm=rpm)
    if slopes is not None:
        largest = float(np.max(np.hypot(*slopes)))
        if largest > LARGE:
            text = (
                "the lower end comes to a slope of {value:.4g} deg, more than the {limit:.3g} deg up to which the "
                "equations of small slopes hold"
            )
            yield held("warning", text, largest, LARGE, "rad", shown="deg", name="slope")
