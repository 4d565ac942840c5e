"""Courses: states over the time, of the gripper along its route or of the joints by laws or a table."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.timelaw import TimeLaw, by_travel, by_travel_and_duration, motion
from tmmcalc.manipulators.task import JointMove, LawTask, TableTask

WHERE = "manipulator"
SAME = 1e-12  # of the duration or the length
DENSE = 1440  # equal steps along which a course is followed
PARTS = 8  # further steps between two breaks


class Course(NamedTuple):
    """States over the time: ``at(t (n,), side (n,)) -> (3, K, n)``, one-sided where something jumps."""

    duration: float  # [s]
    jumps: tuple[float, ...]  # where accelerations jump, with both ends [s]
    at: Callable[[Values, Indices | int], Values]
    knots: tuple[float, ...] = ()  # where accelerations only have kinks [s]

    @property
    def breaks(self) -> tuple[float, ...]:
        """Instants between which the course is smooth [s]."""
        return distinct([*self.jumps, *self.knots], self.duration)

    @property
    def dense(self) -> Values:
        """Ascending instants (m,) [s] that leave out no part of the course, however short."""
        parts = [np.linspace(a, b, PARTS + 1) for a, b in pairwise(self.breaks)]
        return np.sort(np.concatenate((np.linspace(0.0, self.duration, DENSE + 1), *parts)))


def distinct(instants: list[float], duration: float) -> tuple[float, ...]:
    """Ascending instants, of those within rounding the first."""
    kept: list[float] = []
    for t in sorted(instants):
        if not kept or t - kept[-1] > 4 * SAME * duration:
            kept.append(t)
    return tuple(kept)


def course_of_laws(task: LawTask, names: tuple[str, ...]) -> tuple[Course, tuple[TimeLaw, ...]]:
    """The joints by their laws, in the order of ``names``; all begin at once."""
    moves = [next(move for move in task.moves if move.name == name) for name in names]
    laws = [_joint_law(move) for move in moves]
    duration = max(law.duration for law in laws)
    if task.together and duration:
        laws = [_stretched(law, duration) for law in laws]

    def at(t: Values, side: Indices | int) -> Values:
        rows = np.empty((3, len(laws), len(t)), t.dtype)
        for k, (law, move) in enumerate(zip(laws, moves, strict=True)):
            # what stops before the others rests from then on
            early = law.duration < duration * (1 - SAME)
            rows[:, k] = motion(law, t, np.where(np.asarray(side) == 0, 1, side) if early else side)
            rows[0, k] += move.start
        return rows

    instants = [t for law in laws for t in law.instants]
    return Course(duration, distinct([0.0, duration, *instants], duration), at), tuple(laws)


def _joint_law(move: JointMove) -> TimeLaw:
    if move.end == move.start:
        return TimeLaw(0.0, 0.0, move.acceleration or 1.0, 0.0, 0.0)
    if move.speed is None or move.acceleration is None:
        lacking = f"joint {move.name} moves, and has no largest speed and acceleration"
        raise UsageError(lacking, where=WHERE, remedy="give speed and acceleration")
    return by_travel(move.end - move.start, move.speed, move.acceleration)


def _stretched(law: TimeLaw, duration: float) -> TimeLaw:
    if not law.speed or law.duration >= duration * (1 - SAME):
        return law
    return by_travel_and_duration(law.travel, duration, law.acceleration)


def course_of_table(task: TableTask) -> Course:
    """The joints by cubic splines through the rows of a table, at rest at both ends; accelerations have no jump."""
    from scipy.interpolate import CubicSpline  # only a table needs it

    spline = CubicSpline(task.t, task.q, axis=1, bc_type="clamped")
    rates = [spline, spline.derivative(1), spline.derivative(2)]

    def at(t: Values, side: Indices | int) -> Values:
        return np.stack([f(t + task.t[0]) for f in rates])

    knots = tuple((task.t - task.t[0]).tolist())
    return Course(knots[-1], (), at, knots)


def table_in(task: TableTask, course: Course) -> Callable[[Values, Indices | int], Values]:
    """The course of a table in the numbers of ``task``, from its rates at the knots, which one correction mends.

    The slopes s of a clamped spline keep h_i s_(i-1) + 2 (h_(i-1) + h_i) s_i + h_(i-1) s_(i+1) =
    3 (h_i d_(i-1) + h_(i-1) d_i) with the steps h and the slopes d of the chords.
    """
    from scipy.linalg import solve_banded

    h, rise = np.diff(task.t), np.diff(task.q, axis=1)
    chord = rise / h
    s = course.at(np.array(course.knots), 0)[1].astype(task.q.dtype)
    s[:, [0, -1]] = 0.0
    if len(h) > 1:
        left, right = h[:-1], h[1:]
        open_ = 3 * (right * chord[:, :-1] + left * chord[:, 1:])
        open_ -= right * s[:, :-2] + 2 * (left + right) * s[:, 1:-1] + left * s[:, 2:]
        bands = np.zeros((3, len(left)))
        bands[0, 1:], bands[1], bands[2, :-1] = left[:-1], 2 * (left + right), right[1:]
        s[:, 1:-1] += solve_banded((1, 1), bands, open_.T.astype(float)).T

    def at(t: Values, side: Indices | int) -> Values:
        at = t + task.t[0]
        k = np.clip(np.searchsorted(task.t, at, side="right") - 1, 0, len(h) - 1)
        x, size = (at - task.t[k]) / h[k], h[k]
        begin, end, d = s[:, k], s[:, k + 1], chord[:, k]
        bend, twist = 3 * d - 2 * begin - end, begin + end - 2 * d
        place = task.q[:, k] + size * x * (begin + x * (bend + x * twist))
        return np.stack((place, begin + x * (2 * bend + 3 * x * twist), (2 * bend + 6 * x * twist) / size))

    return at
