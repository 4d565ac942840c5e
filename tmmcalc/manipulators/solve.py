"""A manipulator: the gripper along its path and the joints that lead it there, or the joints and what they do to it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from tmmcalc.manipulators.arms import direct, elbow_point, inverse
from tmmcalc.manipulators.courses import Course, Timed, course_of_laws, course_of_table, speed_limit, timed
from tmmcalc.manipulators.obstacles import arm_contacts, contact_grades, crossed, joined
from tmmcalc.manipulators.ranges import excess_grades, find_excesses
from tmmcalc.manipulators.results import Contact, LegFacts, LimitExcess, Manipulator, PieceFacts
from tmmcalc.manipulators.routes import chord, legs_of
from tmmcalc.manipulators.singular import SINGULAR, check_reach, find_singular, singular_grades
from tmmcalc.manipulators.task import ELBOW, Drive, LawTask, ManipulatorTask, Obstacle, PathTask
from tmmcalc.numerics.panels import Values
from tmmcalc.numerics.roots import Indices
from tmmcalc.timelaw import TimeLaw
from tmmcalc.timerows import TimedExtreme, extremes, time_rows

DENSE = 1441  # instants along which angles are followed
TURN = 2 * math.pi


class _Motion(NamedTuple):
    """The whole motion as functions of time and side: gripper states and joint states."""

    task: ManipulatorTask
    duration: float
    breaks: tuple[float, ...]
    gripper: Callable[[Values, Indices | int], Values]
    joints: Callable[[Values, Indices | int], Values]
    route: Timed | None
    laws: tuple[TimeLaw, ...]


def solve_manipulator(task: ManipulatorTask) -> Manipulator:
    """The motion of a manipulator, its extremes, its singular places, its joint limits and obstacles (2.10.3).

    Raises `NoSolutionError` for a path out of reach or a time that cannot be kept, `SingularityError` where the joints'
    rates are not defined.
    """
    moved = _inverse(task) if isinstance(task.motion, PathTask) else _direct(task)
    rows = time_rows(moved.duration, task.steps, moved.breaks)
    p, q = moved.gripper(rows.t, rows.side), moved.joints(rows.t, rows.side)
    places = find_singular(task.arm, _course(moved), lambda t: moved.gripper(t, 0)[0])
    found = _extremes(moved)
    excesses = _excesses(moved, found)
    contacts = tuple(_contacts(moved))
    grades = (*singular_grades(places, moved.route is not None), *excess_grades(excesses), *contact_grades(contacts))
    return Manipulator(
        arm=task.arm,
        inverse=moved.route is not None,
        duration=moved.duration,
        labels=rows.labels,
        t=rows.t,
        side=rows.side,
        way=np.zeros((3, len(rows.t))) if moved.route is None else moved.route.way(rows.t, rows.side),
        phase=np.zeros(len(rows.t), int) if moved.route is None else moved.route.phase(rows.t, rows.side),
        gripper=p,
        joints=tuple(name for name, _ in task.arm.joints),
        angular=tuple(turns for _, turns in task.arm.joints),
        q=q,
        elbow=elbow_point(task.arm, q) if task.arm.kind == "angular" else None,
        legs=() if moved.route is None else tuple(_legs(moved.route, _drive(task))),
        laws=moved.laws,
        extremes=found,
        singular=places,
        excesses=excesses,
        contacts=contacts,
        grades=grades,
        residual=None if any(place.relative < SINGULAR for place in places) else _residual(moved, p),
        counters={"rows": len(rows.t)},
    )


def _drive(task: ManipulatorTask) -> Drive:
    assert isinstance(task.motion, PathTask)
    return task.motion.drive


def _inverse(task: ManipulatorTask) -> _Motion:
    """The joints that lead the gripper along its route; angles are followed from the start."""
    assert isinstance(task.motion, PathTask)
    route = timed(legs_of(task.motion.route), task.motion.drive)
    course = route.course
    check_reach(task.arm, course, lambda t: course.at(t, 0)[0])
    dense = np.linspace(0.0, course.duration, DENSE)
    angles = [k for k, (_, turns) in enumerate(task.arm.joints) if turns]
    tracks = np.unwrap(inverse(task.arm, course.at(dense, 0))[0, angles], axis=1)

    def joints(t: Values, side: Indices | int) -> Values:
        q = inverse(task.arm, course.at(t, side))
        for k, track in zip(angles, tracks, strict=True):
            q[0, k] += TURN * np.rint((np.interp(t, dense, track) - q[0, k]) / TURN)
        return q

    return _Motion(task, course.duration, course.breaks, course.at, joints, route, ())


def _direct(task: ManipulatorTask) -> _Motion:
    """The gripper that the joints lead."""
    names = tuple(name for name, _ in task.arm.joints)
    laws: tuple[TimeLaw, ...] = ()
    if isinstance(task.motion, LawTask):
        course, laws = course_of_laws(task.motion, names)
    else:
        assert not isinstance(task.motion, PathTask)
        course = course_of_table(task.motion)
    return _Motion(
        task,
        course.duration,
        course.breaks,
        lambda t, side: direct(task.arm, course.at(t, side)),
        course.at,
        None,
        laws,
    )


def _course(moved: _Motion) -> Course:
    return Course(moved.duration, moved.breaks, moved.gripper)


def _residual(moved: _Motion, p: Values) -> float:
    """Largest difference of the gripper from direct(inverse), each derivative against its largest value."""
    again = direct(moved.task.arm, inverse(moved.task.arm, p))
    size = np.max(np.abs(p), axis=(1, 2))
    gap = np.max(np.abs(again - p), axis=(1, 2))
    return float(np.max(gap / np.where(size > 0, size, 1.0)))


def _extremes(moved: _Motion) -> tuple[TimedExtreme, ...]:
    """Extremes of the gripper's speed and accelerations, and of every joint with both derivatives."""
    arm = moved.task.arm

    def rows(t: Values) -> Values:
        p, q = moved.gripper(t, 0), moved.joints(t, 0)
        own = np.stack((np.linalg.norm(p[1], axis=0), np.linalg.norm(p[2], axis=0)))
        path = np.empty((0, len(t)))
        if moved.route is not None:
            path = np.stack((moved.route.way(t, 0)[2], moved.route.normal(t, 0)))
        bend = q[:, -1:] - q[:, -2:-1] if arm.kind == "angular" else q[:, :0]
        states = np.concatenate((q, bend), axis=1)
        return np.concatenate((own, path, states.transpose(1, 0, 2).reshape(-1, len(t))))

    return extremes(rows, moved.duration, moved.breaks, _names(moved))


def _names(moved: _Motion) -> list[tuple[str, str]]:
    arm = moved.task.arm
    named = [("speed", "m/s"), ("acceleration", "m/s^2")]
    if moved.route is not None:
        named += [("a_tangential", "m/s^2"), ("a_normal", "m/s^2")]
    for name, turns in (*arm.joints, *((ELBOW,) if arm.kind == "angular" else ())):
        unit = "rad" if turns else "m"
        named += [(name, unit), (f"d{name}", f"{unit}/s"), (f"dd{name}", f"{unit}/s^2")]
    return named


def _excesses(moved: _Motion, found: tuple[TimedExtreme, ...]) -> tuple[LimitExcess, ...]:
    arm = moved.task.arm
    known = [*arm.joints, *((ELBOW,) if arm.kind == "angular" else ())]
    limits = moved.task.limits if moved.duration else ()
    order = [[name for name, _ in known].index(limit.name) for limit in limits]

    def joint(k: int, t: Values) -> Values:
        q = moved.joints(t, 0)[0]
        return q[order[k]] if order[k] < len(q) else q[-1] - q[-2]

    reached = [next(each for each in found if each.name == limit.name) for limit in limits]
    return find_excesses(limits, [known[k][1] for k in order], reached, joint, moved.duration)


def _contacts(moved: _Motion) -> Iterator[Contact]:
    """Path, straight line and arm against every obstacle."""
    for obstacle in moved.task.obstacles:
        if moved.route is not None:
            yield Contact(obstacle.name, "path", tuple(_path_contacts(moved.route, obstacle)))
            assert isinstance(moved.task.motion, PathTask)
            straight = chord(moved.task.motion.route)
            length = straight.length or 1.0
            parts = [(a / length, b / length) for a, b in crossed(straight, obstacle)]
            yield Contact(obstacle.name, "straight line", tuple(parts))
        if moved.task.check_arm:
            yield Contact(obstacle.name, "arm", tuple(arm_contacts(_segments(moved), obstacle, moved.duration)))


def _path_contacts(route: Timed, obstacle: Obstacle) -> list[tuple[float, float]]:
    """Intervals of time in which the gripper is inside of an obstacle."""
    found = []
    for k, leg in enumerate(route.legs):
        begin = 0.0
        for piece in leg:
            for a, b in crossed(piece, obstacle):
                found.append((route.times(k, begin + a), route.times(k, begin + b)))
            begin += piece.length
    return joined(found)


def _segments(moved: _Motion) -> Callable[[Values], list[tuple[Values, Values]]]:
    """The parts of the arm as segments (D, n) at times (n,)."""
    arm = moved.task.arm

    def at(t: Values) -> list[tuple[Values, Values]]:
        hand = moved.gripper(t, 0)[0]
        shoulder = np.zeros_like(hand)
        shoulder[-1] = arm.height
        if arm.kind == "spherical":
            return [(shoulder, hand)]
        middle = shoulder.copy()
        if arm.kind == "cylindrical":
            middle[-1] = hand[-1]
        else:
            middle = elbow_point(arm, moved.joints(t, 0))
        return [(shoulder, middle), (middle, hand)]

    return at


def _legs(route: Timed, drive: Drive) -> Iterator[LegFacts]:
    for k, (leg, law, begin) in enumerate(zip(route.legs, route.laws, route.begins, strict=True)):
        pieces, s = [], 0.0
        for piece in leg:
            arc = piece.radius is not None
            pieces.append(
                PieceFacts(
                    start=tuple(piece.start.tolist()),
                    end=tuple(piece.end.tolist()),
                    length=piece.length,
                    begin=route.times(k, s),
                    centre=None if piece.centre is None else tuple(piece.centre.tolist()),
                    radius=piece.radius,
                    theta=piece.theta if arc else None,
                    theta_end=piece.theta_end if arc else None,
                    sense=piece.sense if arc else None,
                )
            )
            s += piece.length
        yield LegFacts(begin, law, speed_limit(leg, drive), tuple(pieces))
