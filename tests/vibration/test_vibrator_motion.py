"""Steady vibration and starts of the device: direct solutions, scipy's integrators, power and energy, Sommerfeld."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar
from sparing import sparing

from tmmcalc.core.errors import NoSolutionError, SingularityError, UsageError
from tmmcalc.machine.motors.model import Motor
from tmmcalc.vibration.vibrator.energies import excitation_of
from tmmcalc.vibration.vibrator.results import VibratorResult
from tmmcalc.vibration.vibrator.runup import exponential
from tmmcalc.vibration.vibrator.solve import solve_vibrator
from tmmcalc.vibration.vibrator.task import Damping, Drive, Range, RunUp, VibratorTask

from .scenes import device, motor

PART = (("A", (0.02, 0.015, -0.09)), ("B", (-0.03, 0.01, -0.05)))


def direct(task: VibratorTask, found: VibratorResult, w: float) -> np.ndarray:
    """Complex amplitudes from the matrices themselves."""
    excitation = excitation_of(task.unbalance)
    force = task.unbalance.moment * w**2 * (excitation.cosine - 1j * excitation.sine)
    return np.linalg.solve(found.stiffness - w**2 * found.mass + 1j * w * found.damping, force)


@pytest.mark.parametrize("damping", [Damping(0.02), Damping(0.0, (8.0, 3.0, 0.01, 0.02, 0.05, 1.0, 0.03))])
@pytest.mark.parametrize("speed", [30.0, 152.05, 271.0, 900.0])
def test_steady_against_the_direct_solution(speed: float, damping: Damping) -> None:
    task = replace(device(), damping=damping, speed=speed)
    found = solve_vibrator(task)
    steady = found.steady
    x = direct(task, found, speed)
    assert steady.amplitude == pytest.approx(np.abs(x), rel=1e-9, abs=1e-13 * np.abs(x).max())
    assert steady.cosine - 1j * steady.sine == pytest.approx(x, rel=1e-9, abs=1e-13 * np.abs(x).max())
    assert abs(steady.balance) < 1e-12
    taken = speed**2 / 2 * (x.conj() @ found.damping @ x).real
    assert steady.power == pytest.approx(taken, rel=1e-9)
    assert found.error["amplitudes"] < 1e-11


def test_the_error_of_the_amplitudes_holds_for_stiffnesses_far_apart() -> None:
    """Against forty digits: at a resonance the error of its frequency counts, not rounding alone."""
    found = []
    for plate in (6e3, 6e5, 6e7):
        task = replace(device(), plate=plate, damping=Damping(0.0, (0.5, 0.5, 0.005, 0.002, 0.002, 0.5, 0.002)))
        task = replace(task, speed=float(solve_vibrator(task).frequency[1]))
        result = solve_vibrator(task)
        w, excitation = task.speed, excitation_of(task.unbalance)
        with mpmath.workdps(40):
            mass, stiffness = mpmath.matrix(result.mass.tolist()), mpmath.matrix(result.stiffness.tolist())
            force = mpmath.matrix((task.unbalance.moment * (excitation.cosine - 1j * excitation.sine)).tolist())
            dynamic = stiffness - mpmath.mpf(w) ** 2 * mass + mpmath.mpc(0, w) * mpmath.diag(list(task.damping.direct))
            exact = np.array([complex(x) for x in mpmath.lu_solve(dynamic, mpmath.mpf(w) ** 2 * force)])
        arm = np.array([1.0, 1.0, *[task.rods.radius] * 3, 1.0, task.rods.radius])
        off = np.abs(result.steady.cosine - 1j * result.steady.sine - exact) * arm
        found.append(float(np.max(off) / np.max(np.abs(exact) * arm)) / result.error["amplitudes"])
    assert max(found) < 1, found


def test_undamped_resonance_is_refused() -> None:
    still = device(0.0)
    w = float(solve_vibrator(still).frequency[1])
    with pytest.raises(SingularityError, match="resonance without damping"):
        solve_vibrator(replace(still, speed=w))
    near = solve_vibrator(replace(still, speed=w * 1.0001))
    assert near.error["amplitudes"] > 1e-12
    assert near.steady.power == 0


def test_peaks_of_the_curve() -> None:
    task = replace(device(), curve=Range(60.0, 450.0, 120))
    found = solve_vibrator(task)
    assert [each.coordinate for each in found.curve.peaks] == ["x", "y", "phi", "tilt_x", "tilt_y", "gamma"]
    for k, each in zip((0, 1, 2, 3, 4, 6), found.curve.peaks, strict=True):
        step = 390.0 / 119
        best = minimize_scalar(
            lambda w, k=k: -abs(direct(task, found, w)[k]),
            bounds=(each.speed - step, each.speed + step),
            method="bounded",
            options={"xatol": 1e-9},
        )
        assert each.amplitude == pytest.approx(-best.fun, rel=1e-10)
        assert each.amplitude >= found.curve.amplitude[k].max()


def test_a_curve_over_undamped_resonances_is_told() -> None:
    found = solve_vibrator(replace(device(0.0), curve=Range(60.0, 450.0, 120)))
    assert any("no damping in mode 1, 2, 3, 4, 5, 6:" in note for note in found.notes)
    assert np.isfinite([each.amplitude for each in found.curve.peaks]).all()


def test_paths_are_those_of_the_turned_part() -> None:
    """The ellipse against the path of the point: extent, semi-axes, plane."""
    found = solve_vibrator(replace(device(), speed=152.05, points=PART))
    steady = found.steady
    psi = np.linspace(0, 2 * pi, 24001)
    q = steady.cosine[:, None] * np.cos(psi) + steady.sine[:, None] * np.sin(psi)
    for (name, at), each in zip(PART, found.paths, strict=True):
        assert each.name == name
        moved = q[[0, 1, 5]] + np.cross(q[[3, 4, 2]].T, at).T
        sizes = np.linalg.norm(moved, axis=0)
        assert each.amplitude == pytest.approx(np.abs(moved).max(axis=1), rel=1e-6)
        assert (each.major, each.minor) == (pytest.approx(sizes.max(), rel=1e-6), pytest.approx(sizes.min(), rel=1e-6))
        assert np.abs(each.normal @ moved).max() < 1e-15
        assert abs(each.direction @ moved).max() == pytest.approx(each.major, rel=1e-6)
        assert each.path == pytest.approx(moved.T[:: (len(psi) - 1) // 120], abs=1e-15)


def integrated(task: VibratorTask, found: VibratorResult) -> np.ndarray:
    """The coordinates at the end of the start by scipy, in two pieces."""
    excitation, asked = excitation_of(task.unbalance), task.run_up
    inverse = np.linalg.inv(found.mass)
    until = task.speed / asked.acceleration

    def slopes(t: float, y: np.ndarray, running: bool) -> np.ndarray:
        eps = asked.acceleration if running else 0.0
        s = t if running else until
        psi, omega = asked.acceleration * s**2 / 2 + task.speed * (t - s), asked.acceleration * s
        values = (np.array(value) for value in (psi, omega, eps))
        force = excitation.force(*values, tangential=asked.tangential)
        return np.append(y[7:], inverse @ (force - found.damping @ y[7:] - found.stiffness @ y[:7]))

    options = {"rtol": 1e-12, "atol": 1e-17, "method": "DOP853"}
    first = solve_ivp(slopes, (0, until), np.zeros(14), args=(True,), **options)
    last = solve_ivp(slopes, (until, asked.duration), first.y[:, -1], args=(False,), **options)
    return last.y[:7, -1]


@sparing("tangential", [True, False], every=2)
def test_start_with_a_given_angle(tangential: bool) -> None:
    task = replace(device(), speed=152.0, run_up=RunUp(400.0, 0.6, 300, tangential), points=PART)
    found = solve_vibrator(task)
    course = found.run_up.course
    assert course.error < 1e-11
    end = course.q[:, -1]
    assert end == pytest.approx(integrated(task, found), abs=2e-11 * np.abs(course.q).max())
    assert course.t[-1] == 0.6
    assert course.omega[-1] == 152.0
    assert np.all(np.diff(course.t) > 0)
    moved = end[[0, 1, 5]] + np.cross(end[[3, 4, 2]], PART[0][1])
    assert found.run_up.points[0, :, -1] == pytest.approx(moved, abs=1e-16)


def test_a_long_start_ends_in_the_steady_motion() -> None:
    task = replace(device(0.05), speed=152.0, run_up=RunUp(800.0, 3.0, 400))
    found = solve_vibrator(task)
    course, steady = found.run_up.course, found.steady
    psi = course.psi[-1]
    expected = steady.cosine * np.cos(psi) + steady.sine * np.sin(psi)
    assert course.q[:, -1] == pytest.approx(expected, abs=1e-7 * np.abs(expected).max())


def test_a_start_that_never_reaches_its_speed() -> None:
    found = solve_vibrator(replace(device(), speed=152.0, run_up=RunUp(100.0, 0.5, 100)))
    assert found.run_up.course.omega[-1] == pytest.approx(50.0)


def test_the_series_of_the_exponential() -> None:
    from scipy.linalg import expm

    a = np.random.default_rng(3).normal(size=(14, 14))
    a *= 0.7 / np.linalg.norm(a, 2)
    found = exponential(a, np.array([0.0, 0.4, 1.0]))
    for k, factor in enumerate((0.0, 0.4, 1.0)):
        assert found[k] == pytest.approx(expm(a * factor), abs=1e-15)


def test_too_long_a_start_is_refused() -> None:
    with pytest.raises(UsageError, match="steps"):
        solve_vibrator(replace(device(), speed=152.0, run_up=RunUp(400.0, 1e4)))


def test_too_long_a_start_by_the_motor_is_refused() -> None:
    """A plate so stiff that every second has tens of thousands of oscillations."""
    stiff = replace(device(), plate=6e9, drive=Drive(motor(5.0), "linear", 1.0))
    with pytest.raises(UsageError, match="steps") as caught:
        solve_vibrator(stiff)
    assert caught.value.where == "vibrator.drive"


def test_what_is_asked_needs_its_data() -> None:
    bare = replace(device(), unbalance=None)
    with pytest.raises(UsageError, match="nothing excites"):
        solve_vibrator(replace(bare, speed=100.0, run_up=RunUp(10.0, 1.0)))
    with pytest.raises(UsageError, match="runs up to a speed"):
        solve_vibrator(replace(device(), run_up=RunUp(10.0, 1.0)))


def whole_system(task: VibratorTask, found: VibratorResult, rows: np.ndarray) -> np.ndarray:
    """Device and rotor as one system of eight equations, its mass matrix solved at every call."""
    excitation, asked = excitation_of(task.unbalance), task.drive
    moment = asked.characteristic.moment
    mr = excitation.moment

    def slopes(_: float, y: np.ndarray) -> np.ndarray:
        q, v, psi, omega = y[:7], y[7:14], y[14], y[15]
        along = excitation.cosine * np.cos(psi) + excitation.sine * np.sin(psi)
        over = excitation.sine * np.cos(psi) - excitation.cosine * np.sin(psi)
        mass = np.zeros((8, 8))
        mass[:7, :7], mass[7, 7] = found.mass, excitation.rotor
        mass[:7, 7] = mass[7, :7] = mr * over + excitation.spin
        force = np.append(
            mr * omega**2 * along - found.damping @ v - found.stiffness @ q,
            moment(omega) - asked.drag * omega + mr * task.gravity * excitation.rise * np.sin(psi),
        )
        a = np.linalg.solve(mass, force)
        return np.concatenate((v, a[:7], [omega, a[7]]))

    start = np.zeros(16)
    start[15] = asked.initial
    done = solve_ivp(slopes, (0, rows[-1]), start, t_eval=rows, rtol=1e-11, atol=1e-14, method="DOP853")
    return done.y


def test_start_by_the_motor_against_the_whole_system() -> None:
    task = replace(device(), drive=Drive(motor(3.0), "linear", 0.4, 1e-5, rows=40))
    found = solve_vibrator(task)
    course = found.drive.course
    y = whole_system(task, found, course.t)
    assert course.q == pytest.approx(y[:7], abs=2e-6 * np.abs(y[:7]).max())
    assert course.psi == pytest.approx(y[14], rel=1e-7, abs=1e-9)
    assert course.omega == pytest.approx(y[15], rel=1e-7, abs=1e-7)
    assert course.error < 1e-8


def test_without_motor_drag_and_damping_energy_is_kept() -> None:
    """A motor of no power: the rotor that was set turning hands energy to the device and back."""
    task = replace(device(0.0), drive=Drive(motor(1e-12), "linear", 0.3, 0.0, 160.0, 50))
    course = solve_vibrator(task).drive.course
    assert np.ptp(course.energy) < 1e-8 * course.energy[0]
    assert np.ptp(course.omega) > 0.1


@pytest.mark.slow
def test_a_weak_motor_is_stuck_at_resonance() -> None:
    weak = solve_vibrator(replace(device(), drive=Drive(motor(0.8), "linear", 2.0, 1e-5, 140.0, 200)))
    drive = weak.drive
    assert drive.stuck == 2
    assert any("stuck at resonance (Sommerfeld)" in note for note in weak.notes)
    stable = [each.speed for each in drive.regimes if each.stable]
    assert len(stable) == 2
    assert drive.mean == pytest.approx(stable[0], rel=4e-3)


def test_a_strong_motor_passes() -> None:
    strong = solve_vibrator(replace(device(), drive=Drive(motor(8.0), "linear", 1.5, 1e-5, 100.0, 200)))
    assert strong.drive.stuck == 0
    assert not [note for note in strong.notes if "Sommerfeld" in note]
    (only,) = strong.drive.regimes
    assert strong.drive.mean == pytest.approx(only.speed, rel=1e-3)


def test_regimes_balance_motor_and_dampers() -> None:
    task = replace(device(), drive=Drive(motor(0.8), "linear", 0.05, 2e-5, rows=10))
    found = solve_vibrator(task)
    moments = task.drive.characteristic.moment
    for each in found.drive.regimes:
        x = direct(task, found, each.speed)
        load = each.speed / 2 * (x.conj() @ found.damping @ x).real + 2e-5 * each.speed
        assert moments(each.speed) == pytest.approx(load, rel=1e-9)
    speeds = np.linspace(20.0, 235.0, 4001)
    surplus = [
        moments(w) - w / 2 * (np.conj(x) @ found.damping @ x).real - 2e-5 * w
        for w in speeds
        for x in (direct(task, found, w),)
    ]
    changes = np.flatnonzero(np.diff(np.sign(surplus)))
    assert len(changes) == len(found.drive.regimes)
    assert [each.stable for each in found.drive.regimes] == [surplus[k] > 0 for k in changes]


def test_a_rotor_lighter_than_its_unbalance_is_refused() -> None:
    heavy = replace(device().unbalance, moment=5e-3, rotor=1e-7)
    with pytest.raises(NoSolutionError, match="kinetic energy is not positive"):
        solve_vibrator(device(unbalance=heavy, drive=Drive(motor(3.0), "linear", 0.1)))


def test_a_characteristic_of_the_working_branch_alone_is_told() -> None:
    induction = Motor("motor", 5.0, 150.0, 157.0, 2.2)
    for kind, told in (("parabolic", True), ("kloss", False)):
        found = solve_vibrator(replace(device(), drive=Drive(induction, kind, 0.05, 1e-5, rows=20)))
        assert any(f'characteristic "{kind}" holds from' in note for note in found.notes) == told
