"""The pendulum in time: rigid closed forms, the matrix exponential, energy, carriers."""

from __future__ import annotations

from dataclasses import replace
from math import cos, sin, sqrt

import numpy as np
import pytest
from scipy.linalg import expm

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.vibration.pendulum.basis import Basis
from tmmcalc.vibration.pendulum.energies import matrices
from tmmcalc.vibration.pendulum.solve import solve_pendulum
from tmmcalc.vibration.pendulum.task import Disc, Mesh, PendulumTask, Rod, Swing

from .scenes import centrifuge

RIGID = PendulumTask(Rod(0.9, 2.0, (1e9, 1e9), (0.0, 0.0)), Disc(3.0))
LINE = 2.0 * 0.9
INERTIA = LINE * 0.81 / 3 + 3 * 0.81
FIRST = LINE * 0.45 + 3 * 0.9  # static moment about the joint
OMEGA = sqrt(FIRST * 9.81 / INERTIA)


def test_rigid_pendulum_from_a_tilt() -> None:
    found = solve_pendulum(replace(RIGID, swing=Swing(3.0, 300, tilt=0.02))).swing
    assert found.v == pytest.approx(0.02 * 0.9 * np.cos(OMEGA * found.t), abs=2e-9)
    assert np.abs(found.w).max() < 1e-15
    assert found.balance < 1e-9
    assert found.slope_v == pytest.approx(found.v / 0.9, abs=2e-9)


def test_rigid_pendulum_under_a_carrier() -> None:
    """I th'' + S g th = -S a: by pieces of constant acceleration, with lifting as well."""
    speeds = Swing(2.0, 400, times=(0.0, 0.5, 1.2), x=(0.0, 0.3, 0.3), up=(0.0, 0.0, 0.7))
    found = solve_pendulum(replace(RIGID, swing=speeds)).swing
    theta, rate, begin = 0.0, 0.0, 0.0
    for end, a, lift in ((0.5, 0.6, 0.0), (1.2, 0.0, 1.0), (2.0, 0.0, 0.0)):
        w, rest = sqrt(FIRST * (9.81 + lift) / INERTIA), -a / (9.81 + lift)
        rows = (found.t >= begin) & (found.t <= end)
        s = found.t[rows] - begin
        angle = rest + (theta - rest) * np.cos(w * s) + rate / w * np.sin(w * s)
        assert found.v[rows] == pytest.approx(0.9 * angle, abs=1e-8)
        s = end - begin
        theta, rate = (
            rest + (theta - rest) * cos(w * s) + rate / w * sin(w * s),
            -(theta - rest) * w * sin(w * s) + rate * cos(w * s),
        )
        begin = end
    assert found.carrier_x[-1] == pytest.approx(0.3 * 0.5 / 2 + 0.3 * 1.5, rel=1e-14)
    assert found.carrier_y[-1] == 0


@pytest.mark.slow
def test_spinning_pendulum_against_the_matrix_exponential() -> None:
    """M z'' - i Omega G z' + K z = -b a + f m e Omega^2 exp(i Omega t): the carrier turns a corner, the bowl is off."""
    asked = Swing(
        0.6, 60, tilt=0.01, deflection=0.004, push=0.05, times=(0.0, 0.2, 0.4), x=(0.0, 0.1, 0.1), y=(0.0, 0.0, 0.2)
    )
    task = centrifuge(swing=asked, mesh=Mesh(2, 4))
    found = solve_pendulum(task).swing
    parts = matrices(task, Basis((0.0, 0.5, 1.0), 10, True), 0)
    n, inverse = len(parts.mass), np.linalg.inv(parts.mass)
    pulled = np.linalg.solve(parts.stiffness, parts.tip)
    pulled /= parts.tip @ pulled
    tilt = np.zeros(n)
    tilt[0] = 0.8
    y = np.concatenate((0.004 * pulled + 0.01 * tilt, 0.05j * pulled, [1.0])).astype(complex)

    def carried(y: np.ndarray, a: complex, step: float) -> np.ndarray:
        whole = np.zeros((2 * n + 2, 2 * n + 2), complex)
        whole[:n, n : 2 * n] = np.eye(n)
        whole[n : 2 * n, :n], whole[n : 2 * n, n : 2 * n] = -inverse @ parts.stiffness, 157j * inverse @ parts.spin
        whole[n : 2 * n, -1] = -a * inverse @ parts.load
        whole[n : 2 * n, -2], whole[-2, -2] = 157**2 * 4.0 * 2e-4 * inverse @ parts.tip, 157j
        return (expm(whole * step) @ np.append(y, 1.0))[:-1]

    for row, t in enumerate(found.t):
        tip = complex(parts.tip @ y[:n])
        assert found.v[row] + 1j * found.w[row] == pytest.approx(tip, abs=1e-9)
        a = 0.5 if t < 0.2 - 1e-9 else 1j if t < 0.4 - 1e-9 else 0.0
        y = carried(y, a, 0.01)
    assert found.balance < 1e-8


def test_free_motion_keeps_its_energy() -> None:
    task = centrifuge(swing=Swing(5.0, 200, deflection=0.02, push=0.1))
    found = solve_pendulum(replace(task, disc=replace(task.disc, eccentricity=0.0))).swing
    assert np.ptp(found.energy) < 1e-9 * found.energy[0]
    assert found.v[0] == pytest.approx(0.02, rel=1e-9)
    assert found.error < 1e-5


def test_the_unbalance_does_work_on_what_is_not_its_own_whirl() -> None:
    """From rest the motion is the steady whirl less modes; its energy is the work of the unbalance."""
    task = centrifuge(swing=Swing(2.0, 4000))
    result = solve_pendulum(task)
    found = result.swing
    tip = found.v + 1j * found.w
    assert np.abs(tip[0]) < 1e-9
    assert found.balance < 1e-9
    force = 4.0 * 2e-4 * 157.0**2 * np.exp(157j * found.t)
    power = np.real(np.conj(np.gradient(tip, found.t, edge_order=2)) * force)
    work = np.append(0.0, np.cumsum((power[1:] + power[:-1]) / 2 * np.diff(found.t)))
    assert found.energy == pytest.approx(work, abs=2e-2 * np.max(found.energy))
    turned = tip * np.exp(-157j * found.t)
    assert np.mean(turned.real) == pytest.approx(result.deflection, rel=0.2)


@pytest.mark.slow
def test_two_planes_move_apart() -> None:
    """Without spin a round rod moves as its planes would alone; of a flat one each plane has its own frequency."""
    round_ = centrifuge(spin=0.0, swing=Swing(1.0, 100, deflection=0.01, push=0.1))
    stiff = replace(round_.rod, bending=(209.7, 419.4))
    first, second = solve_pendulum(round_).swing, solve_pendulum(replace(round_, rod=stiff)).swing
    assert second.v == pytest.approx(first.v, abs=1e-9)
    assert np.abs(second.w - first.w).max() > 1e-6


def test_the_error_is_told() -> None:
    """A coarse mesh: the told error is that against a fine one, within a factor."""
    asked = Swing(1.0, 200, deflection=0.01, push=0.2)
    coarse = solve_pendulum(centrifuge(swing=asked, mesh=Mesh(1, 3))).swing
    fine = solve_pendulum(centrifuge(swing=asked)).swing
    real = np.abs(coarse.v + 1j * coarse.w - fine.v - 1j * fine.w).max() / np.abs(fine.v + 1j * fine.w).max()
    assert real <= 1.2 * coarse.error + 1e-7


def test_a_falling_carrier_is_refused() -> None:
    with pytest.raises(NoSolutionError, match="falls with 12"):
        solve_pendulum(replace(RIGID, swing=Swing(1.0, 50, tilt=0.01, times=(0.0, 1.0), up=(0.0, -12.0))))
