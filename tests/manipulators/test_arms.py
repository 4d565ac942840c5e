"""Inverse and direct problem: round trips, derivatives in time, the dyad of the linkage room."""

from __future__ import annotations

import numpy as np
import pytest
from sparing import sparing

from tmmcalc.core.plane import Point
from tmmcalc.linkage.dyad import solve_dyad
from tmmcalc.linkage.dyads import RRR
from tmmcalc.manipulators.arms import direct, elbow_point, inverse, meridian
from tmmcalc.manipulators.routes import legs_of
from tmmcalc.manipulators.solve import solve_manipulator
from tmmcalc.manipulators.task import ArcRoute, Drive, PolyRoute
from tmmcalc.manipulators.timedroute import timed

from .scenes import ARMS, PLANE, SPACE, derivative, task

PAIRS = [(arm, route) for arm in ARMS for route in (SPACE if ARMS[arm].spatial else PLANE)]


@sparing(("arm", "route"), PAIRS, every=4)
def test_round_trip(arm: str, route: str) -> None:
    result = solve_manipulator(task(arm, route, steps=60))
    again = direct(result.arm, result.q)
    size = np.max(np.abs(result.gripper), axis=(1, 2))
    gap = np.max(np.abs(again - result.gripper), axis=(1, 2))
    assert np.all(gap < 1e-12 * size)
    assert result.residual is not None
    assert result.residual < 1e-12


@sparing(("arm", "route"), PAIRS, every=4)
def test_rates_are_the_derivatives_in_time(arm: str, route: str) -> None:
    """Of gripper and joints, by differences of the eighth order between the jumps."""
    asked = task(arm, route)
    course = timed(legs_of(asked.motion.route), asked.motion.drive).course
    own, h = ARMS[arm], 4e-4 * course.duration
    t = np.linspace(0, course.duration, 41)
    t = t[np.min(np.abs(t - np.array(course.breaks)[:, None]), axis=0) > 5 * h]
    assert t.size > 20
    p = course.at(t, 0)
    q = inverse(own, p)
    for order in (1, 2):
        mine = derivative(lambda at, n=order - 1: course.at(at, 0)[n], t, h)
        assert np.max(np.abs(mine - p[order])) < 1e-8 * np.max(np.abs(p[order]))
        mine = derivative(lambda at, n=order - 1: inverse(own, course.at(at, 0))[n], t, h)
        assert np.max(np.abs(mine - q[order])) < 1e-8 * np.max(np.abs(q[order]))


@pytest.mark.parametrize("elbow", ["elbow up", "elbow down"])
def test_two_links_are_the_dyad_between_shoulder_and_gripper(elbow: str) -> None:
    """Textbook 2.5.3: the forearm's angle in the dyad is that from the gripper to the elbow."""
    result = solve_manipulator(task(elbow, "arc", steps=12))
    arm = result.arm
    w = meridian(arm, result.gripper)
    still = np.zeros_like(w[0])
    found = solve_dyad(RRR(arm.upper, arm.forearm, arm.elbow), Point(still, still, still), Point(*w))
    for motion, k, turn in ((found.a, 0, 0.0), (found.b, 1, np.pi)):
        ahead = np.exp(1j * (result.q[0, k] + turn))
        assert np.max(np.abs(motion.u - ahead)) < 1e-13
        assert motion.omega == pytest.approx(result.q[1, k], abs=1e-12)
        assert motion.eps == pytest.approx(result.q[2, k], abs=1e-11)


@pytest.mark.parametrize(("elbow", "sign"), [("elbow up", 1), ("elbow down", -1)])
def test_side_of_the_elbow(elbow: str, sign: int) -> None:
    """To the left of the line from the shoulder to the gripper, which is above it in front of the base."""
    result = solve_manipulator(task(elbow, "arc"))
    hand, joint = (
        p[0] + 1j * (p[1] - result.arm.height) for p in (result.gripper[0], elbow_point(result.arm, result.q))
    )
    assert np.all(sign * (np.conj(hand) * joint).imag > 0)
    assert np.abs(joint) == pytest.approx(result.arm.upper, rel=1e-14)
    assert np.abs(hand - joint) == pytest.approx(result.arm.forearm, rel=1e-13)


def test_a_planar_arm_is_the_spatial_one_at_rest_of_its_base() -> None:
    """In the plane y = 0 the base does not turn, and the arm moves as without it."""
    plane = solve_manipulator(task("elbow up", "arc"))
    space = solve_manipulator(task("elbow up, base", ArcRoute((1.2, 0.0, 0.3), (0.5, 0.0, 1.1), 0.8, -1, (0, -1, 0))))
    assert space.q[:, 0] == pytest.approx(np.zeros_like(space.q[:, 0]), abs=1e-14)
    assert space.q[:, 1:] == pytest.approx(plane.q, abs=1e-12)


def test_overhead_the_angle_goes_on() -> None:
    """From in front of the shoulder to behind it: the textbook's arcsin would turn back."""
    result = solve_manipulator(task("spherical", PolyRoute(((0.8, 0.9), (-0.8, 0.9)))))
    assert result.q[0, 0, 0] < np.pi / 2 < result.q[0, 0, -1] < np.pi
    behind = solve_manipulator(task("spherical", PolyRoute(((-0.8, 0.9), (-0.8, -0.6)))))
    assert np.max(np.abs(np.diff(behind.q[0, 0]))) < 1
    assert behind.q[0, 0, -1] > np.pi


def test_the_path_does_not_depend_on_the_arm() -> None:
    drive = Drive(2.0, 0.6)
    path = timed(legs_of(PLANE["arc"]), drive).course.at(np.linspace(0, 1, 7), 0)
    for arm in ("spherical", "cylindrical", "elbow up"):
        q = inverse(ARMS[arm], path)
        assert direct(ARMS[arm], q) == pytest.approx(path, abs=1e-13)
