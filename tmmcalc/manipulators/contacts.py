"""What crosses an obstacle, and when: the gripper's path, the straight line between its ends, the arm.

Path and line are cut in closed form. The arm, which sweeps a surface, is looked at densely, and its times of contact
are narrowed down by halving.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from tmmcalc.core.notes import Phrase, listed
from tmmcalc.core.numerics.panels import Values
from tmmcalc.linkage.results import Grade
from tmmcalc.manipulators.arms import elbow_point
from tmmcalc.manipulators.motions import Motion
from tmmcalc.manipulators.obstacles import Flags, crossed, joined, segment_hits
from tmmcalc.manipulators.results import Contact
from tmmcalc.manipulators.routes import chord
from tmmcalc.manipulators.task import ManipulatorTask, Obstacle, PathTask
from tmmcalc.manipulators.timedroute import Timed

HALVINGS = 40


def find_contacts(task: ManipulatorTask, moved: Motion) -> Iterator[Contact]:
    """Path, straight line and arm against every obstacle."""
    for obstacle in task.obstacles:
        if moved.route is not None and isinstance(task.motion, PathTask):
            yield Contact(obstacle.name, "path", tuple(_path_contacts(moved.route, obstacle)))
            straight = chord(task.motion.route)
            length = straight.length or 1.0
            parts = [(a / length, b / length) for a, b in crossed(straight, obstacle)]
            yield Contact(obstacle.name, "straight line", tuple(parts))
        if task.check_arm:
            yield Contact(obstacle.name, "arm", tuple(_arm_contacts(moved, obstacle)))


def _path_contacts(route: Timed, obstacle: Obstacle) -> list[tuple[float, float]]:
    """Intervals of time [s] in which the gripper is inside of an obstacle."""
    found = []
    for k, leg in enumerate(route.legs):
        begin = 0.0
        for piece in leg:
            for a, b in crossed(piece, obstacle):
                found.append((route.time(k, begin + a), route.time(k, begin + b)))
            begin += piece.length
    return joined(found)


def _arm_contacts(moved: Motion, obstacle: Obstacle) -> list[tuple[float, float]]:
    """Intervals of time [s] in which a part of the arm crosses an obstacle."""

    def hit(at: Values) -> Flags:
        return np.any([segment_hits(obstacle, a, b) for a, b in _segments(moved, at)], axis=0)

    t = moved.given.dense
    within = hit(t)
    change = np.flatnonzero(within[1:] != within[:-1])
    low, high = t[change].copy(), t[change + 1].copy()
    for _ in range(HALVINGS if change.size else 0):
        middle = (low + high) / 2
        same = hit(middle) == within[change]
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    edges = [0.0, *((low + high) / 2).tolist(), moved.given.duration]
    return [(a, b) for k, (a, b) in enumerate(pairwise(edges)) if within[0] == (k % 2 == 0)]


def _segments(moved: Motion, t: Values) -> list[tuple[Values, Values]]:
    """The parts of the arm as segments with their ends (D, n) at times (n,)."""
    arm, hand = moved.arm, moved.gripper(t, 0)[0]
    shoulder = np.zeros_like(hand)
    shoulder[-1] = arm.height
    if arm.kind == "spherical":
        return [(shoulder, hand)]
    if arm.kind == "angular":
        middle = elbow_point(arm, moved.joints(t, 0))
    else:
        middle = shoulder.copy()
        middle[-1] = hand[-1]
    return [(shoulder, middle), (middle, hand)]


def contact_grades(contacts: Sequence[Contact]) -> tuple[Grade, ...]:
    """A warning where path or arm crosses an obstacle; what the straight line does is no fault."""
    return tuple(
        Grade(
            "warning",
            Phrase("obstacle {obstacle}", obstacle=each.obstacle),
            Phrase("the {what} {words}", what=each.what, words=_words(each)),
        )
        for each in contacts
        if each.what != "straight line" and each.intervals
    )


def _words(each: Contact) -> str:
    if all(a == b for a, b in each.intervals):
        return Phrase("touches it at t = {intervals} s", intervals=[f"{a:.6g}" for a, _ in each.intervals])
    shown = listed([Phrase("from t = {a:.6g} to {b:.6g} s", a=a, b=b) for a, b in each.intervals], " and ")
    return Phrase("crosses it {shown}", shown=shown)
