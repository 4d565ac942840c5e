"""Formulas of the forces against the worked cases, direct solutions of the equilibrium, and limits."""

import json
from math import radians
from pathlib import Path

import numpy as np
import pytest

from tmmcalc.cams.follower import Follower, contact_path
from tmmcalc.cams.forces.formulas import (
    cam_torque,
    contact_force,
    driving_torque,
    friction_ratio,
    guide_forces,
    guided_forces,
    inclination,
    protrusion,
    resultant,
)
from tmmcalc.cams.laws.catalogue import LAWS

CASES = {case["id"]: case for case in json.loads((Path(__file__).parents[1] / "cases/cams.json").read_text())}


def rise(law: str, k: np.ndarray, stroke: float, angle: float) -> np.ndarray:
    s = LAWS[law].at(np.asarray(k, float))
    return stroke * s / angle ** np.arange(4)[:, None]


@pytest.mark.parametrize("case", ["cams-s14", "cams-s14b"])
def test_reactions_of_the_worked_cases(case):
    expected, tolerance = CASES[case]["expected"], CASES[case]["tolerance"]
    motion = rise("cosine", expected["k"], 0.02, radians(60))
    spring = (0.0, 0.0) if case.endswith("b") else (9500.0, 10.0)
    load = resultant(motion, 0.2 * 100**2, *spring)
    found = guided_forces(
        Follower("translating", 0.06, roller=0.008),
        motion, load, np.ones(len(load)),
        stroke=0.02, friction=0.1, start=0.06, roller=0.008, top=0.12,
    )  # fmt: skip
    figures = {
        "P_c_N": load, "R_N": found.contact, "mu": found.ratio, "q_mm": 1e3 * found.protrusion,
        "theta_deg": np.degrees(np.arctan2(found.sine, found.cosine)),
        "N1_N": np.abs(found.lower), "N2_N": np.abs(found.upper),
    }  # fmt: skip
    for name, values in figures.items():
        assert values == pytest.approx(expected[name], rel=tolerance["rel"], abs=1e-6), name
    assert found.works.all()


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("load", [-120.0, 75.0])
@pytest.mark.parametrize("offset", [-0.012, 0.0, 0.009])
def test_the_stem_is_in_equilibrium(sense, load, offset):
    """R, N1, N2 of the three equations of the stem solved as they stand, friction by the signs that come out."""
    follower = Follower("translating", 0.05, offset, 0.008)
    motion = np.array([[0.011], [sense * 0.017], [0.02], [0.0]])
    f, h, length = 0.12, 0.02, 0.045
    sine, cosine = inclination(follower, motion)
    q = protrusion(motion, h, 0.008, 0.002)
    ratio, _ = friction_ratio(follower, motion, sine, q, length, f)
    contact, works = contact_force(np.array([load]), cosine, ratio, np.array([float(sense)]))
    lower, upper = guide_forces(follower, motion, contact, sine, q, length)
    assert works.all()
    signs = np.sign(lower[0]), np.sign(upper[0])
    rows = [
        [sine[0], 1.0, 1.0],  # across
        [cosine[0], -sense * f * signs[0], -sense * f * signs[1]],  # along the lift
        [-sine[0] * q[0], 0.0, length],  # about the lower edge; friction acts on the stem's axis
    ]
    right = [0.0, -load, 0.0]
    # moment of N2 about edge 1 is -N2 l, of R sin(theta), q below it, is +R sin(theta) q
    assert np.linalg.solve(rows, right) == pytest.approx([contact[0], lower[0], upper[0]], rel=1e-12)
    assert np.sign(contact[0]) == -np.sign(load)


@pytest.mark.parametrize("sense", [1, -1])
def test_the_flat_face_is_in_equilibrium(sense):
    follower = Follower("flat", 0.05)
    motion = np.array([[0.004], [sense * 0.015], [0.01], [0.0]])
    f, length, load = 0.1, 0.03, -90.0
    ratio, _ = friction_ratio(follower, motion, np.zeros(1), 0.0, length, f)
    contact, _ = contact_force(np.array([load]), 1.0, ratio, np.array([float(sense)]))
    lower, upper = guide_forces(follower, motion, contact, np.zeros(1), 0.0, length)
    place = contact_path(follower, np.zeros(1), motion)[0, 0].real  # where R stands, by the profile
    rows = [[0.0, 1.0, 1.0], [1.0, -sense * f * np.sign(lower[0]), -sense * f * np.sign(upper[0])], [place, 0, -length]]
    assert np.linalg.solve(rows, [0.0, -load, 0.0]) == pytest.approx([contact[0], lower[0], upper[0]], rel=1e-12)
    assert contact[0] == pytest.approx(-load / (1 - 2 * f * motion[1, 0] / length), rel=1e-14)  # (5.103)


@pytest.mark.parametrize("kind", ["translating", "oscillating"])
@pytest.mark.parametrize("assembly", [1, -1])
def test_the_force_stands_along_the_normal_of_the_pitch_curve(kind, assembly):
    """sin and cos of theta by the direction of the roller's velocity and of the curve's normal."""
    follower = Follower(
        kind, 0.05 if kind == "translating" else 0.7, 0.006, 0.008, 0.1, 0.07, assembly
    )  # fmt: skip
    phi, motion = np.array([0.3]), np.array([[0.02], [0.31 if kind == "oscillating" else 0.03], [0.1], [0.0]])
    path = contact_path(follower, phi, motion)
    normal = -1j * path[1] / np.abs(path[1])
    # velocity of the roller in the fixed frame when the follower alone moves: derivative by y at a standing cam
    step = 1e-6
    near = [contact_path(follower, phi, motion + np.array([[d], [0], [0], [0]]))[0] for d in (step, -step)]
    velocity = (near[0] - near[1]) / (2 * step)
    velocity = velocity / np.abs(velocity)
    sine, cosine = inclination(follower, motion)
    assert (normal * np.conj(velocity)).real == pytest.approx(cosine, abs=1e-9)
    turn = (normal * np.conj(velocity)).imag
    # canonical cam turns clockwise: theta of a stem is positive clockwise; of a rocker outwards along it
    assert (-turn if kind == "translating" else assembly * turn) == pytest.approx(sine, abs=1e-9)


def test_power_of_contact_is_power_of_forces_and_friction():
    motion = rise("shun", np.linspace(0.05, 0.95, 19), 0.02, radians(70))
    follower = Follower("translating", 0.04, 0.004, 0.008)
    load = resultant(motion, 900.0, 5000.0, 40.0)
    found = guided_forces(
        follower, motion, load, np.ones(19), stroke=0.02, friction=0.15, start=0.04, roller=0.008, top=0.11
    )
    lost = 0.15 * (np.abs(found.lower) + np.abs(found.upper)) * np.abs(motion[1])
    given = cam_torque(found.contact, found.cosine, motion)
    assert given - lost == pytest.approx(driving_torque(load, motion), rel=1e-13)


def test_sizes_broadcast_against_the_motion():
    motion = rise("cosine", np.linspace(0, 1, 7), 0.02, radians(60))
    load = resultant(motion, 2000.0, 9500.0, 10.0)
    starts, rollers = np.array([0.04, 0.06, 0.08]), np.array([0.006, 0.01])
    follower = Follower("translating", 0.05)
    grid = guided_forces(
        follower, motion, load, np.ones(7),
        stroke=0.02, friction=0.1, start=starts[:, None, None], roller=rollers[:, None], top=0.12,
    )  # fmt: skip
    assert grid.contact.shape == (3, 2, 7)
    for i, start in enumerate(starts):
        for j, roller in enumerate(rollers):
            one = guided_forces(
                follower, motion, load, np.ones(7), stroke=0.02, friction=0.1, start=start, roller=roller, top=0.12
            )
            assert np.array_equal(one.contact, grid.contact[i, j])
            assert np.array_equal(one.lower, grid.lower[i, j])


def test_jamming_and_a_guide_without_length_are_masked_and_finite():
    motion = rise("cosine", np.linspace(0, 1, 21), 0.03, radians(20))
    load = resultant(motion, 100.0, 1000.0, 50.0)
    tops = np.array([0.2, 0.075, 0.05])[:, None]
    found = guided_forces(
        Follower("translating", 0.02), motion, load, np.ones(21),
        stroke=0.03, friction=0.2, start=0.02, roller=0.006, top=tops,
    )  # fmt: skip
    for values in found:
        assert np.isfinite(values).all()
    assert not found.works[2].any()  # H2 below the lower edge
    critical = 1 / (0.2 * (1 + 2 * found.protrusion / found.length[0]))
    steep = found.sine / found.cosine > critical
    assert 0 < np.count_nonzero(steep) < len(steep.ravel())
    assert np.array_equal(found.works[0], ~steep)


def test_without_friction_the_force_is_the_projection():
    motion = rise("sine", np.linspace(0, 1, 9), 0.02, radians(60))
    load = resultant(motion, 500.0, 4000.0, 90.0)
    follower = Follower("translating", 0.05, 0.003, 0.008)
    errors = []
    for f in (1e-3, 1e-6, 0.0):
        found = guided_forces(
            follower, motion, load, np.ones(9), stroke=0.02, friction=f, start=0.05, roller=0.008, top=0.12
        )
        errors.append(np.max(np.abs(found.contact + load / found.cosine)))
    assert errors[2] < 1e-12 * np.max(np.abs(load))
    assert 500 < errors[0] / errors[1] < 2000
