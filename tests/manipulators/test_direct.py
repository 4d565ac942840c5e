"""The direct problem: laws of the joints, together or each for itself, and a table."""

from __future__ import annotations

import numpy as np
import pytest

import tmmcalc
from tmmcalc.core.errors import UsageError
from tmmcalc.core.timelaw import by_travel, motion
from tmmcalc.manipulators.arms import direct
from tmmcalc.manipulators.courses import course_of_table
from tmmcalc.manipulators.solve import solve_manipulator
from tmmcalc.manipulators.task import (
    Arm,
    Drive,
    JointMove,
    LawTask,
    ManipulatorTask,
    PathTask,
    PolyRoute,
    TableTask,
)
from tmmcalc.project import templates

from .scenes import derivative

ARM = Arm("angular", True, upper=0.9, forearm=0.8, height=0.4)
MOVES = (
    JointMove("psi", -0.5, 1.2, 1.0, 2.0),
    JointMove("phi_2", 0.4, 1.1, 0.8, 3.0),
    JointMove("phi_3", -0.9, -0.3, 0.5, 1.0),
)


def test_each_joint_for_itself() -> None:
    result = solve_manipulator(ManipulatorTask(ARM, LawTask(MOVES, together=False), steps=50))
    laws = [by_travel(move.end - move.start, move.speed, move.acceleration) for move in MOVES]
    assert result.duration == pytest.approx(max(law.duration for law in laws), rel=1e-14)
    for k, (law, move) in enumerate(zip(laws, MOVES, strict=True)):
        late = result.t > law.duration + 1e-9
        assert result.q[0, k, late] == pytest.approx(move.end, rel=1e-14)
        assert not np.any(result.q[1:, k, late])
        early = ~late & (result.t < law.duration - 1e-9)
        expected = motion(law, result.t[early], result.side[early])
        assert result.q[1:, k, early] == pytest.approx(expected[1:], abs=1e-14)


def test_together_they_end_at_once() -> None:
    result = solve_manipulator(ManipulatorTask(ARM, LawTask(MOVES), steps=10))
    assert [law.duration for law in result.laws] == pytest.approx([result.duration] * 3, rel=1e-13)
    assert result.q[0, :, -1] == pytest.approx([move.end for move in MOVES], rel=1e-14)
    for law, move in zip(result.laws, MOVES, strict=True):
        assert law.acceleration == move.acceleration
        assert law.speed <= move.speed * (1 + 1e-14)


def test_the_gripper_is_the_direct_problem_of_the_joints() -> None:
    result = solve_manipulator(ManipulatorTask(ARM, LawTask(MOVES), steps=10))
    assert result.gripper == pytest.approx(direct(ARM, result.q), abs=1e-15)
    psi, a, b = result.q[0]
    r = 0.9 * np.cos(a) + 0.8 * np.cos(b)
    place = np.array([r * np.cos(psi), r * np.sin(psi), 0.4 + 0.9 * np.sin(a) + 0.8 * np.sin(b)])
    assert result.gripper[0] == pytest.approx(place, abs=1e-14)
    assert not result.inverse
    assert result.residual is not None
    assert result.residual < 1e-12


def test_a_table_is_smooth_and_at_rest_at_its_ends() -> None:
    t = np.array([1.0, 1.5, 2.2, 3.0])
    rows = np.array([[0.1, 0.3, 0.2, 0.6], [0.9, 1.1, 1.2, 1.0]])
    asked = ManipulatorTask(Arm("spherical"), TableTask(t, rows), steps=40)
    result = solve_manipulator(asked)
    assert result.duration == 2.0
    for k, at in enumerate(t - 1):
        near = int(np.argmin(np.abs(result.t - at)))
        assert result.t[near] == pytest.approx(at, abs=1e-12)
        assert result.q[0, :, near] == pytest.approx(rows[:, k], abs=1e-14)
    assert result.q[1, :, [0, -1]] == pytest.approx(np.zeros((2, 2)), abs=1e-13)
    course, h = course_of_table(asked.motion), 1e-3
    inner = np.array([0.2, 0.8, 1.0, 1.7])
    q = course.at(inner, 0)
    for order in (1, 2):
        mine = derivative(lambda at, n=order - 1: course.at(at, 0)[n], inner, h)
        assert mine == pytest.approx(q[order], abs=1e-9)


def test_a_joint_without_an_end_stays() -> None:
    moves = (JointMove("phi_2", 0.3, 0.9, 1.0, 2.0), JointMove("l_3", 0.7, 0.7))
    result = solve_manipulator(ManipulatorTask(Arm("spherical"), LawTask(moves)))
    assert result.q[0, 1] == pytest.approx(0.7, rel=1e-15)
    assert np.hypot(*result.gripper[0]) == pytest.approx(0.7, rel=1e-14)


def test_a_joint_that_moves_needs_limits() -> None:
    moves = (JointMove("phi_2", 0.3, 0.9), JointMove("l_3", 0.7, 0.7))
    with pytest.raises(UsageError, match="joint phi_2 moves"):
        solve_manipulator(ManipulatorTask(Arm("spherical"), LawTask(moves)))


def test_a_singular_place_is_no_fault_of_the_direct_problem() -> None:
    """The arm is stretched on its way; the gripper moves on, the inverse problem has no rates there."""
    moves = (JointMove("phi_2", 0.3, 0.3), JointMove("phi_3", 0.0, 0.6, 0.5, 1.0))
    result = solve_manipulator(ManipulatorTask(Arm("angular", upper=0.9, forearm=0.8), LawTask(moves)))
    (place,) = result.singular
    assert (place.what, place.t) == ("elbow", pytest.approx(result.duration / 2, rel=1e-6))
    assert "singular at t" in str(result.grades[0])
    assert np.isfinite(result.gripper).all()


@pytest.mark.parametrize("name", ["manipulator", "manipulator-angular", "manipulator-direct"])
def test_ready_specs(name: str) -> None:
    result = tmmcalc.solve_manipulator(tmmcalc.load_spec(templates.folder() / f"{name}.toml"))
    assert result.residual is not None
    assert result.residual < 1e-12
    assert not result.grades


def test_no_motion_is_one_row_at_rest() -> None:
    moves = (JointMove("phi_2", 0.3, 0.3), JointMove("l_3", 0.7, 0.7))
    result = solve_manipulator(ManipulatorTask(Arm("spherical"), LawTask(moves)))
    assert result.labels == ("0",)
    assert result.duration == 0
    assert not np.any(result.gripper[1:])
    path = PathTask(PolyRoute(((0.5, 0.4), (0.5, 0.4))), Drive(2.0, 0.6))
    still = solve_manipulator(ManipulatorTask(Arm("angular", upper=0.5, forearm=0.5), path))
    assert still.labels == ("0",)
    assert direct(still.arm, still.q)[0, :, 0] == pytest.approx([0.5, 0.4], abs=1e-15)
