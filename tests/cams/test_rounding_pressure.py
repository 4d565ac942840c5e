"""Estimates of the pressure angle against 50 digits on random cams: rows, extremes, where it exceeds its limits."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import mpf

from cams.exact import missed, motion_at, theta_at
from cams.exact_peaks import at, crossing, edges_of, extremes
from cams.scenes import briefly, judged, random_cam, some
from tmmcalc.cams.pressure.solve import solve_pressure
from tmmcalc.cams.program import TURN

FEW = 2
PHASES = {"rise": "rise", "back": "return"}


def of_theta(follower):
    """theta from its tangent (5.42), (5.48)."""

    def theta(lib, phi, motion, piece):
        y, y1 = motion[0], motion[1]
        if follower.kind == "translating":
            return lib.atan2(y1 + lib.mpf(follower.offset), lib.mpf(follower.start) + y)
        psi, l0 = lib.mpf(follower.start) + y, lib.mpf(follower.centres)
        lean = lib.mpf(follower.rocker) * (1 - follower.assembly * y1) - l0 * lib.cos(psi)
        return lib.atan2(lean, l0 * lib.sin(psi))

    return theta


def the_pressure(random):
    task, follower = random_cam(random, random.choice(["translating", "oscillating"]))
    found, rows = solve_pressure(task, follower), task.positions
    which = some(random, len(rows.phi))
    exact = [theta_at(follower, motion_at(task.program, rows.phi[i], rows.piece[i])) for i in which]
    size = float(abs(found.theta).max())
    pairs = {"angle": (found.error["angle"], missed(found.theta[which], exact, size))}
    theta = of_theta(follower)
    ends = {name: extremes(task.program, theta, {kind}) for name, kind in PHASES.items()}
    size = max(abs(value) for both in ends.values() for value, _ in both)
    off = [
        abs(each.value - value)
        for name, both in ends.items()
        for each, (value, _) in zip((getattr(found, name).least, getattr(found, name).largest), both, strict=True)
    ]
    pairs["extremes"] = found.error["extremes"], float(max(off) / size)
    if "exceeded" in found.error:
        pairs["exceeded"] = found.error["exceeded"], max(_ends_missed(task, theta, found))
    return pairs


def _ends_missed(task, theta, found):
    """By how much the ends of the intervals are off, over a turn; an end of a phase against its exact angle."""
    program, edges = task.program, edges_of(task.program)
    for name in PHASES:
        on = getattr(found, name)
        for phi in (each for interval in on.exceeded for each in interval):
            near = min(edges, key=lambda edge, phi=phi: abs(edge - phi))
            if abs(near - phi) < 1e-9:
                yield float(abs(near - phi)) / TURN
                continue
            piece = int(program.piece(np.array([phi]))[0])

            def beyond(x, piece=piece, limit=on.limit):
                return abs(at(program, theta, x, piece)) - mpf(limit)

            yield float(abs(crossing(beyond, phi) - mpf(phi))) / TURN


def test_estimates_in_a_few_scenes():
    briefly(the_pressure, 2, FEW)


@pytest.mark.slow
def test_estimates():
    judged(the_pressure, 102)
