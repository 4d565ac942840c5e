"""Whole turns of the joints: behind the base, within their ranges, about the axis; instants of limits and knots."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from tmmcalc.manipulators.columns import manipulator_columns
from tmmcalc.manipulators.solve import solve_manipulator
from tmmcalc.manipulators.task import Arm, JointLimit, JointMove, LawTask, ManipulatorTask, PolyRoute, TableTask

from .scenes import ARMS, task

BEHIND = PolyRoute(((-1.2, 0.3), (-1.0, -0.5)))


@pytest.mark.parametrize(("elbow", "sign"), [("elbow up", -1), ("elbow down", 1)])
def test_the_elbow_behind_the_shoulder_is_that_before_it(elbow: str, sign: int) -> None:
    """By the law of cosines; the forearm's principal angle would be a whole turn off."""
    limits = (JointLimit("elbow", math.radians(-150), math.radians(150)),)
    result = solve_manipulator(task(elbow, BEHIND, limits=limits))
    arm = ARMS[elbow]
    distance = np.hypot(result.gripper[0, 0], result.gripper[0, 1] - arm.height)
    bend = np.arccos((distance**2 - arm.upper**2 - arm.forearm**2) / (2 * arm.upper * arm.forearm))
    assert result.elbow_angle is not None
    assert result.elbow_angle[0] == pytest.approx(sign * bend, rel=1e-13)
    assert result.excesses == ()
    shown = next(column for column in manipulator_columns(result) if column.name == "elbow")
    assert shown.make() == pytest.approx(np.degrees(sign * bend), rel=1e-13)


def test_the_elbow_of_given_joints_is_within_half_a_turn() -> None:
    """170 and -100 deg are 90 deg apart."""
    t, rows = np.array([0.0, 0.5, 1.0]), np.radians([[170.0, 120.0, 100.0], [-100.0, -120.0, -130.0]])
    limits = (JointLimit("elbow", 0.0, math.radians(140)),)
    result = solve_manipulator(ManipulatorTask(Arm("angular", upper=0.9, forearm=0.8), TableTask(t, rows), limits))
    assert result.elbow_angle is not None
    assert np.degrees(result.elbow_angle[0, [0, -1]]) == pytest.approx([90, 130], rel=1e-13)
    assert result.excesses == ()


def test_a_range_beyond_half_a_turn_is_kept_by_whole_turns() -> None:
    """The base from 190 to 225 deg, which is -170 to -135."""
    route = PolyRoute(((-1.0, -0.18, 0.4), (-0.7, -0.7, 0.4)))
    limits = (JointLimit("psi", math.radians(90), math.radians(270)),)
    result = solve_manipulator(task("cylindrical, base", route, limits=limits))
    assert np.degrees(result.q[0, 0, -1]) == pytest.approx(225, rel=1e-13)
    assert result.excesses == ()
    open_range = solve_manipulator(task("cylindrical, base", route))
    assert np.degrees(open_range.q[0, 0, -1]) == pytest.approx(-135, rel=1e-13)


@pytest.mark.parametrize("radius", [1e-2, 1e-4, 2e-5])
def test_around_the_axis_by_an_arc_that_takes_no_time(radius: float) -> None:
    """A hairpin whose rounding goes about the axis of the base: the base turns the long way."""
    half, inside = math.radians(30), 0.5 * radius
    corner = np.array([inside - radius / math.sin(half), 0.0])
    ahead = [corner + length * np.array([math.cos(half), y * math.sin(half)]) for length, y in ((1.0, 1), (0.7, -1))]
    points = tuple((*place.tolist(), 0.3) for place in (ahead[0], corner, ahead[1]))
    result = solve_manipulator(task("cylindrical, base", PolyRoute(points, radius)))
    first, last = (math.atan2(place[1], place[0]) for place in ahead)
    assert result.q[0, 0, [0, -1]] == pytest.approx([first, last + 2 * math.pi], rel=1e-12)


def test_the_first_instant_beyond_a_limit_is_not_that_of_the_farthest() -> None:
    """A first passing of 0.08 ms in 4 s, between two steps of a coarse look; the roots are those of the spline."""
    t = np.array([0.0, 1.0, 1.0005, 1.001, 2.5, 3.0, 4.0])
    rows = np.array([[0.7, 0.7, 0.70001, 0.7, 0.65, 0.9, 1.0], [0.3] * 7])
    spline = CubicSpline(t, rows[0], bc_type="clamped")
    limit = float(spline(1.0005)) - 1e-7
    limits = (JointLimit("h", None, limit),)
    (excess,) = solve_manipulator(ManipulatorTask(Arm("cylindrical"), TableTask(t, rows), limits)).excesses
    passed = spline.solve(limit, extrapolate=False)
    assert passed[1] - passed[0] < 1e-4 < passed[2] - passed[1]
    assert excess.first == pytest.approx(passed[0], rel=1e-9)
    assert excess.t > passed[-1]


def test_a_limit_counts_at_rest() -> None:
    moves = (JointMove("phi_2", 0.3, 0.3), JointMove("l_3", 0.7, 0.7))
    limits = (JointLimit("l_3", 0.8, 1.0),)
    (excess,) = solve_manipulator(ManipulatorTask(Arm("spherical"), LawTask(moves), limits)).excesses
    assert (excess.value, excess.t, excess.first) == (0.7, 0.0, 0.0)


def test_knots_and_points_on_one_line_are_no_jumps() -> None:
    table = TableTask(np.array([0.0, 0.5, 1.2, 2.0]), np.array([[0.1, 0.3, 0.2, 0.6], [0.9, 1.1, 1.2, 1.0]]))
    result = solve_manipulator(ManipulatorTask(Arm("spherical"), table, steps=4))
    assert result.labels == ("0", "1", "2", "2'", "3", "4")
    line = PolyRoute(((1.2, 0.3), (0.8, 0.3), (0.8, 0.3), (0.3, 0.3)))
    straight = solve_manipulator(task("spherical", line, steps=8))
    assert len(straight.legs[0].pieces) == 1
    assert sum(label.endswith("-") for label in straight.labels) == 2
