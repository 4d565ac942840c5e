"""What rounding leaves of the forces at the rows, of their extremes over the turn, of the spring and of the work."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.cams.forces.course import Course
from tmmcalc.cams.forces.results import ForceExtreme, SpringFound
from tmmcalc.cams.forces.spring import lifting_force
from tmmcalc.cams.forces.state import State, pivot_force, state
from tmmcalc.cams.forces.turn import Points, acceleration, at_rows
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.rounding import APART, FLOOR, MARGIN, Errors, chosen, nearer, relative, sides, slopes
from tmmcalc.cams.task import CamTask, Loads
from tmmcalc.cams.wide import wide


def wide_points(task: CamTask, loads: Loads, points: Points, piece: Indices, which: Indices | None = None) -> Points:
    """Some of the points on the pieces of the motion (n,), their motion in extended precision; all by default."""
    on = slice(None) if which is None else which
    phi = wide(points.phi[on])
    motion = task.program.wider.at(phi, piece[on])
    return Points(phi, motion, points.sense[on], wide(points.force[on]), acceleration(task, wide(loads), phi, motion))


def at_sides(task: CamTask, loads: Loads, phi: Values) -> Points:
    """The points before and after angles (m,), (2 m,), in extended precision."""
    rows = sides(task.program, phi)
    return wide_points(task, loads, at_rows(task, loads, rows), rows.piece)


def force_errors(
    task: CamTask,
    loads: Loads,
    course: Course,
    spring: SpringFound,
    points: Points,
    now: State,
    extremes: tuple[ForceExtreme, ...],
    balance: float,
) -> Errors:
    """Estimates for the state at the rows of the task, and over the turn; ``balance`` is what its energies miss."""
    which = chosen(len(points.phi), now.load, now.contact, now.ratio)
    again = wide_points(task, loads, points, task.positions.piece, which)
    of = wide(course.carried)
    exact = state(of, again)
    errors = {
        name: relative(found[which], true, float(np.max(np.abs(found))))
        for name, found, true in _rows(course, now, exact)
    }
    if of.follower.kind == "oscillating":
        found = pivot_force(
            course.carried.follower, points.motion[:, which], now.contact[which], now.sine[which], now.cosine[which]
        )
        true = pivot_force(of.follower, again.motion, exact.contact, exact.sine, exact.cosine)
        errors["pivot"] = relative(found, true, float(np.max(np.abs(now.contact))))
    errors["extremes"] = _extremes(task, loads, course, extremes)
    return errors | {"spring": _spring(task, loads, spring), "work": max(MARGIN * balance, FLOOR)}


def _rows(course: Course, now: State, exact: State) -> Iterator[tuple[str, Values, Values]]:
    yield "load", now.load, exact.load
    yield "contact", now.contact, exact.contact
    if course.carried.guide:
        yield (
            "guide",
            np.maximum(np.abs(now.lower), np.abs(now.upper)),
            np.maximum(np.abs(exact.lower), np.abs(exact.upper)),
        )
    yield "torque", now.torque, exact.torque
    yield "driving", now.driving, exact.driving


def _extremes(task: CamTask, loads: Loads, course: Course, extremes: tuple[ForceExtreme, ...]) -> float:
    """The largest of the estimates of all extremes, each relative to the largest of its quantity."""
    of, turned = wide(course.carried), course.carried.follower.sense
    phi = np.array([[each.least_phi, each.largest_phi] for each in extremes])
    exact = state(of, at_sides(task, loads, phi.ravel()))
    values = {
        "P_c": exact.load, "M_c": exact.load, "R": exact.contact, "N1": turned * exact.lower,
        "N2": turned * exact.upper, "T": -exact.torque, "M_drive": exact.driving,
    }  # fmt: skip
    worst = 0.0
    for k, each in enumerate(extremes):
        true = values[each.name].reshape(2, -1)[:, 2 * k : 2 * k + 2]
        worst = max(worst, nearer([each.least, each.largest], true, each.size))
    return worst


def _spring(task: CamTask, loads: Loads, spring: SpringFound) -> float:
    """Of stiffness and preload: P_M and dS_M where the spring is found from them; 0 where it is given."""
    if spring.method in ("none", "given") or spring.phi is None or not spring.lifting or not spring.stiffness:
        return 0.0
    worst = 0.0
    places = [(spring.phi, spring.lifting, spring.lift or 0.0)]
    if spring.governing is not None:
        places.append((spring.governing.phi, spring.governing.force, spring.governing.lift))
    for phi, force, lift in places:
        at = at_sides(task, loads, np.array([phi]))
        missed = nearer([force], lifting_force(task, wide(loads), at.acceleration))
        gone = _astray(task, loads, phi) * float(np.max(np.abs(at.motion[1])))
        found = nearer([lift], at.motion[0]) + MARGIN * gone / abs(lift) if lift else FLOOR
        worst = max(worst, missed + found)
    return worst


def _astray(task: CamTask, loads: Loads, phi: float) -> float:
    """How far a place is from that of the largest P near it [rad]; one on an edge stays there."""
    if np.min(np.abs(task.program.edges - phi)) < 4 * APART:
        return 0.0
    piece = task.program.piece(np.full(7, phi))

    def force(x: Values) -> Values:
        motion = task.program.wider.at(x, piece)
        return lifting_force(task, wide(loads), acceleration(task, wide(loads), x, motion))

    _, slope, bend = slopes(force, phi)
    return abs(slope / bend) if bend else 0.0
