"""The device's matrices, springs, natural frequencies and forces: worked case, expanded formulas, scipy, beams."""

from __future__ import annotations

from dataclasses import replace
from math import acos, cos, radians, sin, sqrt
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.linalg import eigh

import tmmcalc
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.vibration.vibrator.energies import excitation_of, mass_matrix, stiffness_matrix
from tmmcalc.vibration.vibrator.modes import damping_matrix, modes_of
from tmmcalc.vibration.vibrator.solve import solve_vibrator
from tmmcalc.vibration.vibrator.springs import stiffness_of, torsion_coefficient
from tmmcalc.vibration.vibrator.task import Damping, Exciter, Flats, Gripper, Ring, Rods, VibratorTask

from .scenes import case, device

CONFIG = Path(__file__).parents[2] / "configs" / "vibratory-device.toml"
HALF = sqrt(0.5)


def random_device(seed: int) -> VibratorTask:
    draw = np.random.default_rng(seed).uniform
    return VibratorTask(
        Ring(draw(0.5, 3), draw(1e-3, 1e-2)),
        Gripper(draw(0.5, 3), draw(-0.02, 0.08), draw(1e-4, 1e-2), draw(1e-4, 1e-2), draw(1e-4, 1e-2)),
        Exciter(draw(0.2, 2), draw(0.02, 0.2), draw(0.01, 0.1), draw(-1, 1), draw(1e-4, 1e-2), draw(1e-4, 1e-2)),
        Rods(draw(0.03, 0.2), diameter=draw(0.002, 0.005), length=draw(0.05, 0.2)),
        Flats(width=draw(0.005, 0.02), thickness=draw(5e-4, 2e-3), length=draw(0.02, 0.08), offset=draw(0, 0.03)),
        draw(20, 200),
    )


def expanded(task: VibratorTask) -> np.ndarray:
    """The mass matrix as it is written out element by element."""
    m1, m2, m3 = task.ring.mass, task.gripper.mass, task.exciter.mass
    l, r0, arm, beta = task.gripper.drop, task.exciter.radius, task.exciter.arm, task.exciter.arm_angle
    m = np.zeros((7, 7))
    m[0, 0] = m[1, 1] = m1 + m2 + m3
    m[0, 4], m[1, 3] = -m2 * l, m2 * l
    m[0, 2], m[1, 2] = -m3 * r0 * HALF, m3 * r0 * HALF
    m[0, 6] = m[1, 6] = -m3 * arm * sin(beta) * HALF
    m[2, 2] = task.ring.inertia + task.gripper.inertia_z + task.exciter.inertia_z + m3 * r0**2
    m[3, 3] = task.gripper.inertia_x + m2 * l**2
    m[4, 4] = task.gripper.inertia_y + m2 * l**2
    m[5, 5] = m2
    m[6, 6] = m3 * arm**2 + task.exciter.inertia_hinge
    return m + np.triu(m, 1).T


def test_the_worked_case_through_the_spec() -> None:
    """The ready spec has the sizes of the worked case."""
    _, expected = case("c2008-vibro-01")
    overrides = ["vibrator.start.duration='0.1 s'", "vibrator.drive.duration='0.05 s'"]
    found = tmmcalc.solve_vibrator(tmmcalc.load_spec(CONFIG, overrides))
    springs, mass = found.springs, found.mass
    pairs = [
        (springs.rod, "c_rod"),
        (springs.push, "a"),
        (springs.bend, "d"),
        (springs.twist, "d1"),
        (springs.tilt, "ct"),
        (springs.vertical, "c1"),
        (mass[0, 0], "M_xx"),
        (mass[0, 2], "M_xphi"),
        (mass[0, 6], "M_xgamma"),
        (mass[2, 2], "M_phiphi"),
        (mass[6, 6], "M_gammagamma"),
    ]
    for value, name in pairs:
        assert value == pytest.approx(expected[name], rel=1e-8), name
    hertz = found.frequency / (2 * np.pi)
    assert hertz == pytest.approx(expected["natural_frequencies_Hz"], rel=1e-6)
    assert found.error["frequencies"] < 1e-14


@pytest.mark.parametrize("seed", range(6))
def test_mass_and_stiffness_against_the_expanded_matrices(seed: int) -> None:
    task = random_device(seed)
    springs = stiffness_of(task)
    mass, stiffness = mass_matrix(task), stiffness_matrix(task, springs)
    assert mass == pytest.approx(expanded(task), rel=1e-14, abs=1e-17)
    c, r2 = springs.rod, task.rods.radius
    diagonal = [4 * c, 4 * c, 4 * c * r2**2, springs.tilt, springs.tilt, 4 * springs.vertical, task.plate]
    assert stiffness == pytest.approx(np.diag(diagonal), rel=1e-14, abs=1e-9)
    reference = eigh(stiffness, mass, eigvals_only=True)
    found = modes_of(mass, stiffness, Damping(), r2)
    assert found.frequency == pytest.approx(np.sqrt(reference), rel=1e-12)
    shapes = found.shapes
    assert shapes.T @ mass @ shapes == pytest.approx(np.eye(7), abs=1e-12)
    assert stiffness @ shapes == pytest.approx(mass @ shapes * found.frequency**2, rel=1e-9, abs=1e-9 * stiffness.max())


def test_the_vertical_mode_stands_alone() -> None:
    found = solve_vibrator(device())
    alone = [k for k in range(7) if np.count_nonzero(found.shapes[:, k]) == 1]
    assert len(alone) == 1
    w = sqrt(4 * found.springs.vertical / 0.9)
    assert found.frequency[alone[0]] == pytest.approx(w, rel=1e-13)


@pytest.mark.parametrize("seed", range(3))
def test_forces_against_the_printed_ones(seed: int) -> None:
    """P of the paper, with xi = arccos(1/sqrt 3), where the unbalance does not pull along its path."""
    draw = np.random.default_rng(seed).uniform
    task = device()
    given = replace(task.unbalance, radius=draw(0.02, 0.1), arm=draw(0.01, 0.1), arm_angle=draw(-1, 2), rotor=2e-4)
    psi, omega, epsilon = draw(-6, 6, 9), draw(1, 200, 9), draw(-50, 50, 9)
    force = given.moment * omega**2
    xi = acos(1 / sqrt(3))
    zero = np.zeros(9)
    printed = [
        sqrt(3) / 2 * force * np.cos(psi + xi),
        sqrt(3) / 2 * force * np.cos(psi - xi),
        force * given.radius * np.sin(psi) - given.rotor * epsilon * cos(radians(45)),
        zero,
        zero,
        zero,
        -force * np.cos(psi) * given.arm * np.sin(given.arm_angle - radians(45)),
    ]
    found = excitation_of(given).force(psi, omega, epsilon, tangential=False)
    assert pytest.approx(np.array(printed), rel=1e-12, abs=1e-14) == found.T


def test_the_pull_along_the_path_is_the_rest_of_the_acceleration() -> None:
    """m r d2u/dt2 = m r (psi'' du/dpsi - psi'^2 u), by differences of the path of the unbalance."""
    excitation = excitation_of(device().unbalance)
    h, t = 1e-4, 0.37

    def angle(s: float) -> float:
        return 1.3 + 20 * s + 15 * s**2

    def reach(s: float) -> Any:
        return excitation.cosine * np.cos(angle(s)) + excitation.sine * np.sin(angle(s))

    second = (reach(t + h) - 2 * reach(t) + reach(t - h)) / h**2
    at = np.array(angle(t)), np.array(20 + 30 * t), np.array(30.0)
    found = excitation.force(*at, tangential=True) + 30.0 * excitation.spin
    assert found == pytest.approx(-excitation.moment * second, rel=1e-5, abs=1e-7)


def test_torsion_of_a_rectangle() -> None:
    """Timoshenko's table for b/h = 1, 1.5, 2, 3, 5, 10, and the reciprocal section has the same J_t."""
    for ratio, alpha in ((1, 0.1406), (1.5, 0.196), (2, 0.229), (3, 0.263), (5, 0.291), (10, 0.312)):
        assert torsion_coefficient(ratio * 0.01, 0.01) == pytest.approx(alpha, abs=6e-4)
    assert torsion_coefficient(1.0, 1.0) == pytest.approx(0.140577014955154, rel=1e-14)  # the series
    lying = torsion_coefficient(0.01, 0.03) * 0.01 * 0.03**3
    assert lying == pytest.approx(torsion_coefficient(0.03, 0.01) * 0.03 * 0.01**3, rel=1e-14)


def test_a_flat_spring_is_a_clamped_beam() -> None:
    """Forces of a beam of length l1, clamped outside, whose inner end goes l2 and turns by -1, about the axis."""
    task = device()
    flats, springs = task.flats, stiffness_of(task)
    ei, l, l2 = flats.young * flats.width * flats.thickness**3 / 12, flats.length, flats.offset
    beam = ei / l**3 * np.array([[12, -6 * l], [-6 * l, 4 * l**2]])
    force, moment = beam @ [l2, -1.0]
    assert springs.push == pytest.approx(force, rel=1e-13)
    assert springs.bend == pytest.approx(-moment, rel=1e-13)


def test_damping_by_ratio_and_direct() -> None:
    task = device(0.03)
    mass, stiffness = mass_matrix(task), stiffness_matrix(task, stiffness_of(task))
    modes = modes_of(mass, stiffness, task.damping, 0.07)
    b = damping_matrix(modes, mass, stiffness, task.damping).astype(float)
    assert modes.shapes.T @ b @ modes.shapes == pytest.approx(np.diag(0.06 * modes.frequency), abs=1e-10)
    square = 0.06**2 * stiffness
    assert b @ np.linalg.solve(mass, b) == pytest.approx(square, abs=1e-14 * np.abs(square).max())
    direct = Damping(0.0, (1.0, 2.0, 0.03, 0.01, 0.02, 4.0, 0.05))
    other = modes_of(mass, stiffness, direct, 0.07)
    assert np.array_equal(damping_matrix(other, mass, stiffness, direct), np.diag(direct.direct))


def test_refusals_say_the_number() -> None:
    tall = replace(device(), gripper=replace(device().gripper, drop=-20.0))
    with pytest.raises(NoSolutionError, match=r"stiffness matrix .* diagonal element is -"):
        solve_vibrator(tall)
    empty = replace(device(), ring=Ring(-1.5, 0.002))
    with pytest.raises(NoSolutionError, match="mass matrix"):
        solve_vibrator(empty)
    with pytest.raises(UsageError, match=r"-0\.01"):
        solve_vibrator(replace(device(), damping=Damping(-0.01)))
