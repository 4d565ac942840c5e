"""Estimates of the profile against 50 digits on random cams: curves, curvature, limits, where a wall fails."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from mpmath import mpf

from cams.exact import missed, motion_at
from cams.exact_peaks import EXACT, at, crossing, extremes
from cams.exact_rims import away_of, bend_of, crossing_at, neck_at, offset_of, placed
from cams.scenes import KINDS, briefly, judged, random_cam, some
from tmmcalc.cams.profile import solve_profile
from tmmcalc.cams.program import TURN

FEW = 1


def the_profile(random):
    task, follower = random_cam(random, random.choice(KINDS))
    found = solve_profile(task, follower)
    error = found.error
    pairs = {name: (error[name], true) for name, true in _rows(random, task, found)}
    pairs["limits"] = error["limits"], max(map(float, _limits(task.program, found)))
    if "loops" in error:
        pairs["loops"] = error["loops"], max(map(float, _loops(task.program, found)), default=0.0) / TURN
    return pairs


def _rows(random, task, found):
    rows, follower, program = task.positions, found.follower, task.program
    which = some(random, len(rows.phi), 12)
    here = [(EXACT, mpf(float(rows.phi[i])), motion_at(program, rows.phi[i], rows.piece[i]), None) for i in which]
    size = float(np.max(np.abs(found.working.points)))
    walls = [(wall.distance, wall.points) for wall in found.walls]
    if found.pitch is not None:
        walls.append((0.0, found.pitch))
    true = [[placed(follower, offset_of(follower, d)(*each)) for each in here] for d, _ in walls]
    off = max(missed(points[which], exact, size) for (_, points), exact in zip(walls, true, strict=True))
    yield "points", off
    unit = [offset_of(follower, 1.0)(*each) - offset_of(follower, 0.0)(*each) for each in here]
    yield "normals", missed(found.normal[which], [-placed(follower, each) for each in unit], 1)
    bend = [bend_of(follower)(*each) for each in here]
    working = [1 / each if found.flat else each / (1 - each * mpf(follower.roller)) for each in bend]
    yield "curvature", missed(found.curvature[which], working, float(np.max(np.abs(found.curvature))))
    if not found.flat:
        values = found.pitch_curvature
        yield "pitch_curvature", missed(values[which], bend, float(np.max(np.abs(values))))


def _limits(program, found):
    """Each relative to itself."""
    follower = found.follower
    (low, _), (high, _) = extremes(program, bend_of(follower))
    sharpest = low if found.flat else high
    yield abs(found.sharpest.value / sharpest - 1)
    if found.hollowest is not None:
        yield abs(found.hollowest.value / low - 1)
    (nearest, _), _ = extremes(program, away_of(follower, follower.roller))
    yield abs(found.nearest.value / nearest - 1)
    for reach, bend in ((found.inner_reach, high), (found.outer_reach, low)):
        if reach is not None and reach.cause == "cusp":
            yield abs(reach.distance * abs(bend) - 1)
        elif reach is not None:
            yield abs(reach.distance / neck_at(program, follower, reach.at, _pieces(program, reach.at)) - 1)


def _pieces(program, phi):
    return program.piece(np.array(phi)).tolist()


def _loops(program, found):
    """By how much crossings and the ends of loops are off [rad]; a loop that begins at a jump has an exact end."""
    follower, edges = found.follower, program.edges
    for wall in found.walls:
        for each in wall.crossings:
            phi = each.first, each.second
            true = crossing_at(program, follower, wall.distance, phi, _pieces(program, phi))
            yield max(abs(true[0] - mpf(phi[0])), abs(true[1] - mpf(phi[1])))
        for phi in (each % (2 * pi) for loop in wall.loops for each in loop):
            if np.min(np.abs(edges - phi)) < 1e-9:
                continue
            bend, distance, (piece,) = bend_of(follower), mpf(wall.distance), _pieces(program, [phi])

            def factor(x, piece=piece, bend=bend, distance=distance):
                kappa = at(program, bend, x, piece)
                return kappa - distance if found.flat else 1 - kappa * distance

            yield abs(crossing(factor, phi) - mpf(phi))


def test_estimates_in_a_few_scenes():
    briefly(the_profile, 4, FEW)


@pytest.mark.slow
def test_estimates():
    judged(the_profile, 104)
