"""The whole motion as functions of the time: the gripper's route and what the joints do for it, or the other way.

Angles are continuous. That of a joint begins within half a turn of zero, or by whole turns beside it where the joint
has its range; the forearm begins within half a turn of the upper arm.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.timelaw import TimeLaw
from tmmcalc.manipulators.arms import TURN, direct, elbow_angle, inverse
from tmmcalc.manipulators.courses import Course, course_of_laws, course_of_table
from tmmcalc.manipulators.routes import legs_of
from tmmcalc.manipulators.singular import check_reach
from tmmcalc.manipulators.task import Arm, JointLimit, LawTask, ManipulatorTask, PathTask, TableTask
from tmmcalc.manipulators.timedroute import Timed, timed

States = Callable[[Values, Indices | int], Values]


class Motion(NamedTuple):
    """Gripper states (3, D, n) and joint states (3, J, n) over the time and its sides."""

    arm: Arm
    given: Course  # of the gripper or of the joints, whichever is asked
    gripper: States
    joints: States
    start: Values  # joint coordinates (J,) at the begin
    route: Timed | None = None  # of the inverse problem
    laws: tuple[TimeLaw, ...] = ()  # of the joints, in the direct problem by laws

    def ranged(self, t: Values, side: Indices | int = 0) -> Values:
        """States (3, R, n) of all that has a range, in the order of `Arm.ranged`."""
        q = self.joints(t, side)
        if self.arm.kind != "angular":
            return q
        return np.concatenate((q, elbow_angle(q, self.start)[:, None]), axis=1)


def motion_of(task: ManipulatorTask) -> Motion:
    """The motion that is asked for; raises what `solve_manipulator` does."""
    asked = task.motion
    return _inverse(task.arm, asked, task.limits) if isinstance(asked, PathTask) else _direct(task.arm, asked)


def _direct(arm: Arm, asked: LawTask | TableTask) -> Motion:
    """The gripper that the joints lead."""
    laws: tuple[TimeLaw, ...] = ()
    if isinstance(asked, LawTask):
        course, laws = course_of_laws(asked, tuple(joint.name for joint in arm.joints))
    else:
        course = course_of_table(asked)

    def gripper(t: Values, side: Indices | int) -> Values:
        return direct(arm, course.at(t, side))

    return Motion(arm, course, gripper, course.at, course.at(np.zeros(1), 1)[0, :, 0], laws=laws)


def _inverse(arm: Arm, asked: PathTask, limits: Sequence[JointLimit]) -> Motion:
    """The joints that lead the gripper along its route; angles are followed from the start."""
    route = timed(legs_of(asked.route), asked.drive)
    course = route.course
    check_reach(arm, course, lambda t: course.at(t, 0)[0])
    dense = course.dense
    angles = [k for k, joint in enumerate(arm.joints) if joint.turns]
    tracks = _placed(arm, np.unwrap(inverse(arm, course.at(dense, 0))[0, angles], axis=1), limits)

    def joints(t: Values, side: Indices | int) -> Values:
        q = inverse(arm, course.at(t, side))
        for k, track in zip(angles, tracks, strict=True):
            q[0, k] += TURN * np.rint((np.interp(t, dense, track) - q[0, k]) / TURN)
        return q

    return Motion(arm, course, course.at, joints, joints(np.zeros(1), 1)[0, :, 0], route)


def _placed(arm: Arm, tracks: Values, limits: Sequence[JointLimit]) -> Values:
    """Angles (A, m) over the time moved by whole turns: the forearm to the upper arm, arm and base to their ranges."""
    names = [joint.name for joint in arm.joints if joint.turns]
    ranges = {limit.name: limit for limit in limits}
    if arm.kind == "angular":
        tracks[-1] -= TURN * np.rint((tracks[-1, 0] - tracks[-2, 0]) / TURN)
    for group in (["psi"], ["phi_2", "phi_3"]):
        rows = [k for k, name in enumerate(names) if name in group]
        judged = next((k for k in rows if names[k] in ranges), None)
        if judged is not None:
            tracks[rows] += TURN * _turns(tracks[judged], ranges[names[judged]])
    return tracks


def _turns(track: Values, limit: JointLimit) -> float:
    """The whole turns by which an angle over the time (m,) comes nearest to its range; none where it is within."""
    low, high = float(track.min()), float(track.max())
    least = low if limit.low is None else limit.low
    most = high if limit.high is None else limit.high
    if least <= low and high <= most:
        return 0.0
    return float(np.rint(((least + most) - (low + high)) / (2 * TURN)))
