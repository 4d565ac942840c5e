"""What rounding leaves of the forces at the rows, of their extremes over the turn, of the spring and of the work."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.cams.forces.results import CamWork, ForceExtreme, SpringFound
from tmmcalc.cams.forces.springerrors import exact_carried, exact_spring, spring_error
from tmmcalc.cams.forces.state import Carried, State, pivot_force, state
from tmmcalc.cams.forces.turn import Points, acceleration, at_rows
from tmmcalc.cams.forces.turnforces import TurnForces
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.pressure.angle import tangent_terms
from tmmcalc.cams.program import TURN
from tmmcalc.cams.rounding import FLOOR, MARGIN, Errors, chosen, joints, nearer, relative, sides, steep
from tmmcalc.cams.task import CamTask, Loads
from tmmcalc.cams.wide import wide

MOVED = 3  # y, y', y'', of which forces are made


def wide_points(task: CamTask, loads: Loads, points: Points, piece: Indices, which: Indices | None = None) -> Points:
    """Some of the points on the pieces of the motion (n,), their motion in extended precision; all by default."""
    on = slice(None) if which is None else which
    phi = wide(points.phi[on])
    motion = task.program.wider.at(phi, piece[on])
    return Points(phi, motion, points.sense[on], wide(points.force[on]), acceleration(task, wide(loads), phi, motion))


def moved_points(task: CamTask, loads: Loads, at: Points) -> Points:
    """Points (m,) of extended precision, y, y' and y'' moved in turn (3 m,) by the rounding of the laws' coefficients.

    Extended precision shares that rounding.
    """
    off = joints(task.program) * np.max(np.abs(task.program.sampled), axis=(1, 2))
    step = np.where(at.motion != 0, off[:, None], 0.0)
    motion = np.concatenate([at.motion + step * (np.arange(len(off)) == k)[:, None] for k in range(MOVED)], axis=1)
    phi, sense, force = np.tile((at.phi, at.sense, at.force), MOVED)
    return Points(phi, motion, sense, force, acceleration(task, wide(loads), phi, motion))


def shift(moved: Values, exact: Values, size: float) -> float:
    """By how much rows (3 m,) at `moved_points` differ from those (m,) at the points, in sum, over a size."""
    apart = np.sum(np.abs(moved.reshape(MOVED, -1) - exact), axis=0)
    return float(np.max(apart, initial=0.0)) / size if size else 0.0


def at_sides(task: CamTask, loads: Loads, phi: Values) -> Points:
    """The points before and after angles (m,), (2 m,), in extended precision."""
    rows = sides(task.program, phi)
    return wide_points(task, loads, at_rows(task, loads, rows), rows.piece)


def force_errors(
    task: CamTask,
    loads: Loads,
    course: TurnForces,
    spring: SpringFound,
    points: Points,
    now: State,
    extremes: tuple[ForceExtreme, ...],
    work: CamWork,
) -> Errors:
    """Estimates for the state at the rows of the task, and over the turn."""
    near = np.hypot(
        *tangent_terms(
            course.carried.follower, points.motion, course.carried.follower.start, course.carried.follower.offset
        )
    )
    which = chosen(len(points.phi), now.load, now.contact, now.ratio, 1 / near, *steep(points.phi, points.motion))
    again = wide_points(task, loads, points, task.positions.piece, which)
    follower, held = course.carried.follower, exact_spring(task, loads, spring)
    of = exact_carried(task, follower, loads, held)
    exact, moved = state(of, again), state(of, moved_points(task, loads, again))
    errors = {}
    for (name, found, true), (_, _, off) in zip(_rows(course, now, exact), _rows(course, now, moved), strict=True):
        size = float(np.max(np.abs(found)))
        errors[name] = relative(found[which], true, size) + shift(off, true, size)
    if of.follower.kind == "oscillating":
        found = pivot_force(follower, points.motion[:, which], now.contact[which], now.sine[which], now.cosine[which])
        true = pivot_force(of.follower, again.motion, exact.contact, exact.sine, exact.cosine)
        errors["pivot"] = relative(found, true, float(np.max(np.abs(now.contact))))
    errors["extremes"] = _extremes(task, loads, of, extremes)
    missed = float(np.mean(np.abs(now.driving[which] - exact.driving)))
    return errors | {"spring": spring_error(task, loads, spring, held), "work": _work(work, missed)}


def _work(work: CamWork, missed: float) -> float:
    """Of the energies, by what the balance misses, and by the mean miss of the driving torque over the turn."""
    turned = work.given + abs(work.returned)
    return max(MARGIN * work.error, MARGIN * TURN * missed / turned if turned else 0.0, FLOOR)


def _rows(course: TurnForces, now: State, exact: State) -> Iterator[tuple[str, Values, Values]]:
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


def _extremes(task: CamTask, loads: Loads, of: Carried, extremes: tuple[ForceExtreme, ...]) -> float:
    """The largest of the estimates of all extremes, each relative to the largest of its quantity."""
    turned = of.follower.sense
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
