"""The follower let down on the generated profile of the real cam, as it turns, moves by its law.

The simulation knows only the points of the working profile in the user's axes, the sense in which the cam turns and
where the follower is guided; none of the formulas of the profile stage.
"""

from math import radians

import numpy as np
import pytest

from cams.turns import task_of, turn
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.profile import solve_profile
from tmmcalc.cams.profile.offsets import Rim

ANGLES = np.radians([0.0, 7.0, 22.5, 41.3, 60.0, 75.0, 97.7, 120.0, 139.9, 150.0, 251.0])
COARSE, FINE, ROUNDS = 4001, 41, 5


def highest(profile, height, rough):
    """The largest of height(points) over the profile, by finer and finer samples about the best of the rough ones."""
    values = height(rough[1])
    best, step = rough[0][int(np.argmax(values))], rough[0][1] - rough[0][0]
    for _ in range(ROUNDS):
        t = best + step * np.linspace(-1, 1, FINE)
        values = height(profile(t))
        best, step = t[int(np.argmax(values))], step / 10
    return float(np.max(values))


def simulated(profile, follower, angles, side):
    """Positions of the follower [m or rad] at the angles of the cam."""
    t = np.linspace(0, 2 * np.pi, COARSE)
    points = profile(t)
    found = []
    for angle in angles:
        real = np.exp(-1j * follower.sense * angle)  # clockwise: negative
        found.append(highest(lambda s, r=real: profile(s) * r, lambda z: lift(follower, z, side), (t, points * real)))
    return np.array(found)


def lift(follower, z, side):
    """How high each point z of the cam holds the follower; -1 where it cannot touch."""
    if follower.kind == "flat":
        return z.imag
    if follower.kind == "translating":
        away = follower.roller**2 - (z.real - side) ** 2
        return np.where(away >= 0, z.imag + np.sqrt(np.maximum(away, 0)), -1.0)
    # rocker on the side +y or -y of the line from O to its pivot
    arm = z - follower.centres if side > 0 else np.conj(z - follower.centres)
    length = np.abs(arm)
    cosine = (follower.rocker**2 + length**2 - follower.roller**2) / (2 * follower.rocker * length)
    touch = np.abs(cosine) <= 1
    return np.where(touch, np.angle(-np.conj(arm)) + np.arccos(np.clip(cosine, -1, 1)), -1.0)


def profile_of(program, follower):
    """Points of the working profile in the user's axes, by the parameter alone."""
    rim = Rim(follower, program)
    return lambda t: follower.placed(rim.at(t).offset(follower.roller))


def wanted(program, follower, angles):
    return follower.start + program.at(angles)[0]


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("right", [0.007, 0.0, -0.007])
@pytest.mark.parametrize("laws", [("sine", "shun"), ("const", "cosine")])
def test_roller_on_a_stem(sense, right, laws):
    program = turn(*laws, rise=60, high=30, back=60)
    follower = Follower("translating", 0.055, sense * right, 0.009, sense=sense)
    assert solve_profile(task_of(program), follower).working.sound
    found = simulated(profile_of(program, follower), follower, ANGLES, right)
    np.testing.assert_allclose(found, wanted(program, follower, ANGLES), atol=1e-12)


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("assembly", [1, -1])
@pytest.mark.parametrize("laws", [("sine", "shun"), ("linear", "modified_trapezoid")])
def test_roller_on_a_rocker(sense, assembly, laws):
    program = turn(*laws, rise=60, high=30, back=60, stroke=radians(20))
    follower = Follower(
        "oscillating", radians(35), roller=0.006, centres=0.1, rocker=0.09, assembly=assembly, sense=sense
    )
    assert solve_profile(task_of(program), follower).working.sound
    # on the rise delta = +1 turns as the cam does: for a clockwise cam the roller is on the side +y
    found = simulated(profile_of(program, follower), follower, ANGLES, sense * assembly)
    np.testing.assert_allclose(found, wanted(program, follower, ANGLES), atol=1e-11)


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("laws", [("sine", "shun"), ("cosine", "modified_sine")])
def test_flat_face(sense, laws):
    program = turn(*laws, rise=90, high=30, back=90, stroke=0.012)
    follower = Follower("flat", 0.045, sense=sense)
    assert solve_profile(task_of(program, "flat"), follower).working.sound
    angles = np.radians([0.0, 13.0, 45.0, 77.7, 90.0, 100.0, 150.0, 199.0, 250.0])
    found = simulated(profile_of(program, follower), follower, angles, 0.0)
    np.testing.assert_allclose(found, wanted(program, follower, angles), atol=1e-12)


def test_a_knife_edge_runs_on_the_pitch_curve():
    program, follower = turn("shun"), Follower("translating", 0.05, 0.004)
    found = solve_profile(task_of(program), follower)
    np.testing.assert_array_equal(found.working.points, found.pitch)
    rays = found.pitch * np.exp(-1j * found.positions.phi)
    np.testing.assert_allclose(rays.real, 0.004, atol=1e-15)
    np.testing.assert_allclose(rays.imag, 0.05 + program.at(found.positions.phi, found.positions.piece)[0], atol=1e-15)


def test_an_undercut_profile_does_not_keep_the_law_between_the_angles_of_its_crossing():
    program = turn("cosine")
    follower = Follower("translating", 0.055, roller=0.040)
    found = solve_profile(task_of(program, report_faults=True), follower)
    crossing = min(found.working.crossings, key=lambda c: c.first)
    lost = radians(58)
    kept = crossing.first - 0.05
    assert crossing.first < lost < crossing.second
    # the loop is cut away: only what is outside the crossings is left of the metal
    cut = [(c.first, c.second) for c in found.working.crossings]
    whole = profile_of(program, follower)

    def left(t):
        angle = np.mod(t, 2 * np.pi)
        return np.where(np.any([(angle > a) & (angle < b) for a, b in cut], axis=0), 0, whole(t))

    heights = simulated(left, follower, np.array([kept, lost]), 0.0)
    exact = wanted(program, follower, np.array([kept, lost]))
    assert heights[0] == pytest.approx(exact[0], abs=1e-9)
    assert heights[1] < exact[1] - 1e-5


def test_both_walls_of_a_groove_touch_the_roller():
    program = turn("sine")
    follower = Follower("translating", 0.045, 0.003, 0.008)
    found = solve_profile(task_of(program, closure="groove"), follower)
    for wall in (found.working, found.outer):
        np.testing.assert_allclose(np.abs(wall.points - found.pitch), 0.008, rtol=1e-13)
    chord = found.outer.points - found.working.points
    np.testing.assert_allclose(np.abs(chord), 0.016, rtol=1e-13)
    np.testing.assert_allclose(chord / 0.016, found.normal, atol=1e-13)
