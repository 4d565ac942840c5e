"""A manipulator: the gripper along its path and the joints that lead it there, or the joints and what they do to it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.timerows import TimedExtreme, extremes, time_rows
from tmmcalc.manipulators.arms import direct, elbow_angle, elbow_point, inverse
from tmmcalc.manipulators.contacts import contact_grades, find_contacts
from tmmcalc.manipulators.errors import motion_errors
from tmmcalc.manipulators.jointlimits import excess_grades, find_excesses
from tmmcalc.manipulators.motions import Motion, motion_of
from tmmcalc.manipulators.results import LegFacts, Manipulator, PieceFacts
from tmmcalc.manipulators.routes import Piece
from tmmcalc.manipulators.singular import SINGULAR, find_singular, singular_grades
from tmmcalc.manipulators.task import Drive, ManipulatorTask, PathTask
from tmmcalc.manipulators.timedroute import Timed, speed_limit


def solve_manipulator(task: ManipulatorTask) -> Manipulator:
    """The motion of a manipulator, its extremes, its singular places, its joint limits and obstacles (2.10.3).

    Raises `NoSolutionError` for a path out of reach or a time that cannot be kept, `SingularityError` where the joints'
    rates are not defined.
    """
    arm, moved = task.arm, motion_of(task)
    course, route = moved.given, moved.route
    rows = time_rows(course.duration, task.steps, course.jumps, course.knots)
    p, q = moved.gripper(rows.t, rows.side), moved.joints(rows.t, rows.side)
    places = find_singular(arm, course, lambda t: moved.gripper(t, 0)[0])
    excesses = find_excesses(moved, task.limits)
    contacts = tuple(find_contacts(task, moved))
    angular = arm.kind == "angular"
    residual = None
    if not any(place.relative < SINGULAR for place in places):
        # of the gripper from direct(inverse), each derivative against its largest value
        size = np.max(np.abs(p), axis=(1, 2))
        gap = np.max(np.abs(direct(arm, inverse(arm, p)) - p), axis=(1, 2))
        residual = float(np.max(gap / np.where(size > 0, size, 1.0)))
    return Manipulator(
        arm=arm,
        inverse=route is not None,
        duration=course.duration,
        labels=rows.labels,
        t=rows.t,
        side=rows.side,
        way=np.zeros((3, len(rows.t))) if route is None else route.way(rows.t, rows.side),
        phase=np.zeros(len(rows.t), int) if route is None else route.phase(rows.t, rows.side),
        gripper=p,
        joints=tuple(joint.name for joint in arm.joints),
        angular=tuple(joint.turns for joint in arm.joints),
        q=q,
        elbow=elbow_point(arm, q) if angular else None,
        elbow_angle=elbow_angle(q, moved.start) if angular else None,
        legs=() if not isinstance(task.motion, PathTask) or route is None else tuple(_legs(route, task.motion.drive)),
        laws=moved.laws,
        extremes=_extremes(moved),
        singular=places,
        excesses=excesses,
        contacts=contacts,
        grades=(
            *singular_grades(places, route is not None),
            *excess_grades(excesses),
            *contact_grades(contacts),
        ),
        residual=residual,
        error=motion_errors(task, moved, rows.t, rows.side, p, q),
        counters={"rows": len(rows.t)},
    )


def _extremes(moved: Motion) -> tuple[TimedExtreme, ...]:
    """Extremes of the gripper's speed and accelerations, and of every joint with both derivatives."""
    route = moved.route

    def rows(t: Values) -> Values:
        p = moved.gripper(t, 0)
        own = [np.linalg.norm(p[1], axis=0), np.linalg.norm(p[2], axis=0)]
        along = [] if route is None else [route.way(t, 0)[2], route.normal(t, 0)]
        return np.stack((*own, *along, *moved.ranged(t).transpose(1, 0, 2).reshape(-1, len(t))))

    return extremes(rows, moved.given.duration, moved.given.breaks, _names(moved))


def _names(moved: Motion) -> list[tuple[str, str]]:
    """Names and units of the rows of `_extremes`."""
    named = [("speed", "m/s"), ("acceleration", "m/s^2")]
    if moved.route is not None:
        named += [("a_tangential", "m/s^2"), ("a_normal", "m/s^2")]
    for joint in moved.arm.ranged:
        unit = "rad" if joint.turns else "m"
        named += [(joint.name, unit), (joint.rate, f"{unit}/s"), (joint.acceleration, f"{unit}/s^2")]
    return named


def _legs(route: Timed, drive: Drive) -> Iterator[LegFacts]:
    for k, (leg, law, begin) in enumerate(zip(route.legs, route.laws, route.begins, strict=True)):
        ways = np.cumsum([0.0, *(piece.length for piece in leg)]).tolist()
        pieces = tuple(_facts(piece, route.time(k, way)) for piece, way in zip(leg, ways, strict=False))
        yield LegFacts(begin, law, speed_limit(leg, drive), pieces)


def _facts(piece: Piece, begin: float) -> PieceFacts:
    arc = piece.radius is not None
    return PieceFacts(
        start=tuple(piece.start.tolist()),
        end=tuple(piece.end.tolist()),
        length=piece.length,
        begin=begin,
        centre=None if piece.centre is None else tuple(piece.centre.tolist()),
        radius=piece.radius,
        theta=piece.theta if arc else None,
        theta_end=piece.theta_end if arc else None,
        sense=piece.sense if arc else None,
    )
