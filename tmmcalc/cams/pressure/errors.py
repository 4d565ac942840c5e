"""What rounding leaves of the pressure angle, its extremes, and the angles between which it exceeds its limit."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pressure.angle import Reached, pressure_angle
from tmmcalc.cams.program import TURN, Program
from tmmcalc.cams.rounding import FLOOR, MARGIN, Errors, again, chosen, nearer, relative, root_error, sides, steep
from tmmcalc.cams.task import CamTask
from tmmcalc.cams.wide import wide

BESIDE = 1e-6  # [rad] of the differences at the ends of an interval


def pressure_errors(task: CamTask, follower: Follower, theta: Values, ends: tuple[Reached, Reached]) -> Errors:
    """Estimates of theta (n,) at the rows and of its extremes, relative to the largest, and of the intervals."""
    program, rows = task.program, task.positions
    which = chosen(len(theta), theta, *steep(rows.phi, task.motion))
    phi, motion = again(program, rows, which)
    size = float(np.max(np.abs(theta)))
    exact = pressure_angle(wide(follower), phi, motion)
    return {"angle": relative(theta[which], exact, size)} | reached_errors(program, follower, ends)


def reached_errors(program: Program, follower: Follower, ends: tuple[Reached, Reached]) -> Errors:
    """Estimates of the extremes on rise and return, and of the intervals beyond a limit over a turn."""
    extremes = [each for on in ends for each in (on.least, on.largest)]
    at = sides(program, np.array([each.phi for each in extremes]))
    phi, found = wide(at.phi), [each.value for each in extremes]
    exact = pressure_angle(wide(follower), phi, program.wider.at(phi, at.piece))
    errors = {"extremes": nearer(found, exact, max(map(abs, found)))}
    bounds = list(_bounds(program, follower, ends))
    return errors | ({"exceeded": max(MARGIN * max(bounds) / TURN, FLOOR)} if bounds else {})


def _bounds(program: Program, follower: Follower, ends: tuple[Reached, Reached]) -> Iterator[float]:
    """By how much the ends of the intervals miss the limit, as angles; ends of a phase are exact."""
    for on in ends:
        for phi in (each for interval in on.exceeded for each in interval):
            if on.limit is None or np.min(np.abs(program.edges - phi)) < 4 * BESIDE:
                continue
            piece = program.piece(np.full(7, phi))

            def beyond(x: Values, piece: np.ndarray = piece, limit: float = on.limit) -> Values:
                return np.abs(pressure_angle(wide(follower), x, program.wider.at(x, piece))) - np.longdouble(limit)

            yield root_error(beyond, phi, BESIDE)
