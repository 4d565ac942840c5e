"""Singular places, reach, joint limits, obstacles: against closed forms and dense sampling."""

from __future__ import annotations

import math
import warnings
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from sparing import sparing

from tmmcalc.core.errors import NoSolutionError, SingularityError
from tmmcalc.manipulators.obstacles import crossed, inside
from tmmcalc.manipulators.routes import legs_of
from tmmcalc.manipulators.solve import solve_manipulator
from tmmcalc.manipulators.task import ArcRoute, Arm, JointLimit, Obstacle, PolyRoute

from .scenes import ARMS, PLANE, SPACE, task

BOX = Obstacle("box", (0.8 + 0.5j, 1.0 + 0.5j, 1.0 + 0.9j, 0.8 + 0.9j))
STAR = Obstacle("star", (0.6 + 0.4j, 1.1 + 0.3j, 0.85 + 0.6j, 1.1 + 1.0j, 0.7 + 0.8j, 0.75 + 0.6j))


def test_a_path_through_the_shoulder_is_singular() -> None:
    with pytest.raises(SingularityError, match=r"l_3 = .*shoulder") as caught:
        solve_manipulator(task(Arm("spherical"), PolyRoute(((0.5, 0.5), (-0.5, -0.5)))))
    assert f"t = {(math.sqrt(2) / 0.6 + 0.3) / 2:.6g} s" in str(caught.value)  # half of T by symmetry


def test_a_path_across_the_axis_of_the_base_is_singular() -> None:
    with pytest.raises(SingularityError, match=r"r = .*psi is not defined"):
        solve_manipulator(task("cylindrical, base", PolyRoute(((0.5, 0.5, 0.4), (-0.5, -0.5, 0.4)))))


@pytest.mark.parametrize("gap", [1e-4, 1e-2])
def test_a_path_near_the_shoulder_is_told_with_time_and_number(gap: float) -> None:
    """The foot of the perpendicular, in the middle of the way and of the time."""
    result = solve_manipulator(task(Arm("spherical"), PolyRoute(((-0.8, gap), (0.8, gap)))))
    (place,) = result.singular
    assert (place.what, place.t) == ("l_3", pytest.approx(result.duration / 2, rel=1e-9))
    assert place.value == pytest.approx(gap, rel=1e-7)
    assert result.grades[0].severity == "warning"
    assert f"l_3 = {gap:.4g} m" in str(result.grades[0])
    # at that place the arm turns with v/gap
    fastest = next(each for each in result.extremes if each.name == "omega_2")
    assert -fastest.least == pytest.approx(0.6 / gap, rel=1e-9)


def test_a_stretched_elbow() -> None:
    arm = ARMS["elbow up"]
    with pytest.raises(NoSolutionError, match=r"the arms reach from 0\.1 m to 1\.7 m") as caught:
        solve_manipulator(task(arm, PolyRoute(((1.0, 0.4), (1.9, 0.4)))))
    assert caught.value.limit == pytest.approx(1.7)
    assert caught.value.value == pytest.approx(math.hypot(1.9, 0.1), rel=1e-12)
    with pytest.raises(SingularityError, match="both arms are in line"):
        solve_manipulator(task(arm, PolyRoute(((1.0, 0.3), (1.7, 0.3)))))


def test_a_nearly_stretched_elbow_is_told() -> None:
    arm = ARMS["elbow down"]
    end = 1.7 * (1 - 1e-4)
    result = solve_manipulator(task(arm, PolyRoute(((1.0, 0.3), (end, 0.3)))))
    (place,) = result.singular
    cosine = (end**2 - arm.upper**2 - arm.forearm**2) / (2 * arm.upper * arm.forearm)
    assert (place.what, place.t) == ("elbow", pytest.approx(result.duration, rel=1e-12))
    assert place.value == pytest.approx(math.sqrt(1 - cosine**2), rel=1e-9)


def test_too_near_to_the_shoulder() -> None:
    with pytest.raises(NoSolutionError, match=r"0\.05 m from the shoulder"):
        solve_manipulator(task("elbow up", PolyRoute(((0.05, 0.3), (0.9, 0.3)))))


def test_joint_limits_with_time_and_excess() -> None:
    limits = (JointLimit("l_3", 0.9, 1.2), JointLimit("phi_2", None, 1.2))
    result = solve_manipulator(task(Arm("spherical"), "arc", limits=limits))
    low, high = result.excesses
    # the least l_3 on the circle about C with R = 0.8 is |OC| - R
    centre = math.hypot(*result.legs[0].pieces[0].centre)
    assert (low.joint, low.limit, low.value) == ("l_3", 0.9, pytest.approx(centre - 0.8, rel=1e-12))
    assert low.excess == pytest.approx(0.9 - centre + 0.8, rel=1e-9)
    assert (high.value, high.t, high.first) == (pytest.approx(math.hypot(1.2, 0.3)), 0.0, 0.0)
    dense = solve_manipulator(task(Arm("spherical"), "arc", steps=40_000))
    passed = dense.t[np.flatnonzero(dense.q[0, 1] < 0.9)[0]]
    assert low.first == pytest.approx(passed, abs=2 * dense.duration / 40_000)
    assert [str(grade)[:9] for grade in result.grades] == ["warning: "] * 2


def test_the_elbow_has_limits_of_its_own() -> None:
    limits = (JointLimit("elbow", math.radians(-100), 0.0),)
    (excess,) = solve_manipulator(task("elbow up", "arc", limits=limits)).excesses
    result = solve_manipulator(task("elbow up", "arc", steps=4000))
    assert excess.value == pytest.approx(np.min(result.q[0, 1] - result.q[0, 0]), abs=1e-6)


@pytest.mark.parametrize("obstacle", [BOX, STAR], ids=["box", "star"])
@pytest.mark.parametrize("route", PLANE)
def test_crossings_in_the_plane(route: str, obstacle: Obstacle) -> None:
    for leg in legs_of(PLANE[route]):
        for piece in leg:
            check_crossings(piece, obstacle)


@pytest.mark.parametrize("route", SPACE)
def test_crossings_in_space(route: str) -> None:
    for obstacle in (
        Obstacle("a", (0.7 - 0.3j, 1.2 - 0.2j, 1.1 + 0.5j, 0.6 + 0.6j), 0.3, 0.55),
        Obstacle("b", STAR.corners, 0.0, 2.0),
    ):
        for leg in legs_of(SPACE[route]):
            for piece in leg:
                check_crossings(piece, obstacle)


def check_crossings(piece, obstacle: Obstacle) -> None:
    """Against a dense sample, whose points are judged by the winding of the polygon about them."""
    s = np.linspace(0, piece.length, 3001)
    place = piece.at(s)[0]
    corners = np.array(obstacle.corners)
    seen = np.angle(np.roll(corners, -1)[:, None] - place[0] - 1j * place[1]) - np.angle(
        corners[:, None] - place[0] - 1j * place[1]
    )
    winding = np.sum((seen + np.pi) % (2 * np.pi) - np.pi, axis=0) / (2 * np.pi)
    truth = np.abs(winding) > 0.5
    if len(place) == 3:
        truth &= (place[2] > obstacle.low) & (place[2] < obstacle.high)
    found = np.zeros(len(s), bool)
    for low, high in crossed(piece, obstacle):
        found |= (s >= low) & (s <= high)
    borders = [edge for pair in crossed(piece, obstacle) for edge in pair]
    clear = np.ones(len(s), bool)
    for border in borders:
        clear &= np.abs(s - border) > 1e-9
    assert np.array_equal(found[clear], truth[clear])


def test_a_path_that_only_touches() -> None:
    """The arc's lowest point on the upper edge of a box: one instant."""
    result = solve_manipulator(
        task(
            Arm("spherical"),
            ArcRoute((1.0, 1.0), (0.2, 1.0), 0.4, -1),
            (Obstacle("table", (0.3 + 0.3j, 0.9 + 0.3j, 0.9 + 0.6j, 0.3 + 0.6j)),),
            check_arm=False,
        )
    )
    contact = next(each for each in result.contacts if each.what == "path")
    ((a, b),) = contact.intervals
    assert a == b == pytest.approx(result.duration / 2, rel=1e-6)
    assert "touches it" in str(result.grades[0])


def test_times_of_a_crossing() -> None:
    result = solve_manipulator(task(Arm("spherical"), PolyRoute(((1.3, 0.7), (0.5, 0.7))), (BOX,)))
    path, straight, arm = result.contacts
    law = result.legs[0].law
    # x = 1.0 and x = 0.8 are passed in the uniform phase
    times = tuple(law.ramp + (way - law.ramp_travel) / law.speed for way in (0.3, 0.5))
    assert path.intervals[0] == pytest.approx(times, rel=1e-12)
    assert straight.intervals[0] == pytest.approx((0.375, 0.625), rel=1e-12)
    # the arm reaches through the box from its first corner in line until the gripper has left it
    assert arm.intervals[0][1] == pytest.approx(times[1], abs=1e-9)
    # from the begin: 0.7/1.3 is steeper than 0.5/1.0, so the arm passes over the lower right corner
    assert arm.intervals[0][0] == 0.0


@sparing("arm", ARMS, every=4)
def test_the_arm_against_a_dense_sample(arm: str) -> None:
    """Points along all parts of the arm at many instants."""
    own = ARMS[arm]
    obstacle = (
        Obstacle("post", (0.3 + 0.1j, 0.45 + 0.1j, 0.45 + 0.6j, 0.3 + 0.6j), 0.2, 0.9)
        if own.spatial
        else Obstacle("post", (0.3 + 0.4j, 0.45 + 0.4j, 0.45 + 0.6j, 0.3 + 0.6j))
    )
    result = solve_manipulator(task(arm, "arc", (obstacle,), steps=400))
    contact = next(each for each in result.contacts if each.what == "arm")
    hand = result.gripper[0]
    shoulder = np.zeros_like(hand)
    shoulder[-1] = own.height
    joints = [shoulder, hand]
    if result.elbow is not None:
        joints.insert(1, result.elbow)
    if own.kind == "cylindrical":
        column = shoulder.copy()
        column[-1] = hand[-1]
        joints.insert(1, column)
    truth = np.zeros(len(result.t), bool)
    for a, b in pairwise(joints):
        for part in np.linspace(0, 1, 1500):
            truth |= inside(obstacle, a + part * (b - a))
    found = np.zeros(len(result.t), bool)
    for low, high in contact.intervals:
        found |= (result.t >= low) & (result.t <= high)
    edges = np.array([t for pair in contact.intervals for t in pair] or [-9.0])
    clear = np.min(np.abs(result.t[:, None] - edges), axis=1) > 2 * result.duration / 400
    assert np.array_equal(found[clear], truth[clear])


def test_inside_knows_the_border() -> None:
    points = np.array([[0.9, 0.8, 1.0, 0.79, 0.9], [0.7, 0.5, 0.7, 0.7, 0.95]])
    assert inside(BOX, points).tolist() == [True, True, True, False, False]


def test_a_corner_that_is_named_twice_is_one() -> None:
    again = replace(BOX, corners=(BOX.corners[0], *BOX.corners))
    x, y = np.meshgrid(np.linspace(0.0, 2.0, 41), np.linspace(0.0, 2.0, 41))
    points = np.stack((x.ravel(), y.ravel()))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert np.array_equal(inside(again, points), inside(BOX, points))
