"""Estimates of law, pressure angle and profile against 50 digits on random cams; both formulas and their precision."""

from __future__ import annotations

from math import radians

import numpy as np
import pytest
from mpmath import mpf

from tests.cams.exact import SCENES, judge, law_at, missed, motion_at, pitch_at, random_program, theta_at
from tmmcalc.cams.follower import Follower, contact_path, curvature
from tmmcalc.cams.lawresult import solve_law
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.pressure import solve_pressure
from tmmcalc.cams.profile import solve_profile
from tmmcalc.cams.task import AngleLimits, Asked, CamTask

pytestmark = pytest.mark.slow

LIMITS = AngleLimits(radians(30), radians(40))
ROWS = 24


def random_follower(random, kind):
    if kind == "translating":
        return Follower(kind, random.uniform(0.03, 0.08), random.uniform(-0.01, 0.01), random.uniform(0.001, 0.02))
    if kind == "flat":
        return Follower(kind, random.uniform(0.05, 0.2))
    centres = random.uniform(0.08, 0.15)
    rocker = centres * random.uniform(0.6, 0.9)
    return Follower(kind, random.uniform(0.4, 0.9), 0.0, random.uniform(0.001, 0.02), centres, rocker, 1)


def scene(random, kind):
    stroke = random.uniform(0.1, 0.5) if kind == "oscillating" else 10 ** random.uniform(-3, -1.5)
    task = CamTask(
        random_program(random, stroke), Asked(kind, report_faults=True, tool=0.004), LIMITS, int(random.integers(5, 40))
    )
    return task, random_follower(random, kind)


def some(random, n):
    return np.sort(random.permutation(n)[:ROWS])


@pytest.mark.parametrize("name", LAWS)
def test_laws_and_their_derivatives(name):
    """To the last digits: all pieces at random places and at their ends."""
    law, random = LAWS[name], np.random.default_rng(3)
    for piece in range(law.count):
        low, high = law.breaks[piece : piece + 2]
        k = np.concatenate(([low], random.uniform(low, high, 40), [high]))
        found = law.at(k, np.full(len(k), piece))
        exact = [law_at(law, each, piece) for each in map(mpf, k.tolist())]
        for order in range(4):
            size = max(1.0, float(np.max(np.abs(law.at(np.linspace(0, 1, 99))[order]))))
            assert missed(found[order], [each[order] for each in exact], size) < 1e-13


@pytest.mark.parametrize("kind", ["translating", "oscillating", "flat"])
def test_points_and_curvature(kind):
    random = np.random.default_rng(5)
    for _ in range(12):
        task, follower = scene(random, kind)
        rows = task.positions
        path = contact_path(follower, rows.phi, task.motion)
        which = some(random, len(rows.phi))
        exact = [pitch_at(follower, rows.phi[i], motion_at(task.program, rows.phi[i], rows.piece[i])) for i in which]
        assert missed(path[0][which], [each[0] for each in exact]) < 1e-13
        if kind != "flat":
            assert missed(curvature(path)[which], [each[2] for each in exact]) < 1e-12


def test_estimates_of_the_law():
    random, pairs = np.random.default_rng(1), {}
    for _ in range(SCENES):
        task, _ = scene(random, "translating")
        found, rows = solve_law(task), task.positions
        exact = [motion_at(task.program, phi, piece) for phi, piece in zip(rows.phi, rows.piece, strict=True)]
        for order, name in enumerate(("displacement", "velocity", "acceleration", "jerk")):
            true = missed(found.motion[order], [each[order] for each in exact])
            pairs.setdefault(name, []).append((found.error[name], true))
        pairs.setdefault("extremes", []).append((found.error["extremes"], extremes_missed(task, found)))
    judge(pairs)


def extremes_missed(task, found):
    """Of the extremes of y', y'', y''' against 50 digits at their angles, on the side of a jump that is meant."""
    worst = 0.0
    program = task.program
    for each in found.extremes:
        values = []
        for side in (-1e-9, 1e-9):
            piece = int(np.clip(np.searchsorted(program.edges, each.phi + side) - 1, 0, len(program.edges) - 2))
            values.append(motion_at(program, each.phi, piece)[each.order])
        size = max(abs(other.value) for other in found.extremes if other.order == each.order)
        if size:
            worst = max(worst, float(min(abs(value - each.value) for value in values)) / size)
    return worst


@pytest.mark.parametrize("kind", ["translating", "oscillating"])
def test_estimates_of_the_pressure_angle(kind):
    random, pairs = np.random.default_rng(2), {}
    while len(pairs.get("angle", ())) < SCENES:
        task, follower = scene(random, kind)
        found, rows = solve_pressure(task, follower), task.positions
        which = some(random, len(rows.phi))
        exact = [theta_at(follower, motion_at(task.program, rows.phi[i], rows.piece[i])) for i in which]
        true = missed(found.theta[which], exact, float(np.max(np.abs(found.theta))))
        pairs.setdefault("angle", []).append((found.error["angle"], true))
    judge(pairs)


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["translating", "oscillating", "flat"])
def test_estimates_of_the_profile(kind):
    random, pairs = np.random.default_rng(4), {}
    while len(pairs.get("points", ())) < SCENES:
        task, follower = scene(random, kind)
        found, rows = solve_profile(task, follower), task.positions
        which = some(random, len(rows.phi))
        exact = [pitch_at(follower, rows.phi[i], motion_at(task.program, rows.phi[i], rows.piece[i])) for i in which]
        points = [z + follower.roller * 1j * tangent for z, tangent, _ in exact]
        true = missed(found.working.points[which], points, float(np.max(np.abs(found.working.points))))
        pairs.setdefault("points", []).append((found.error["points"], true))
        bend = [kappa / (1 - kappa * follower.roller) for *_, kappa in exact]
        true = missed(found.curvature[which], bend, float(np.max(np.abs(found.curvature))))
        pairs.setdefault("curvature", []).append((found.error["curvature"], true))
    judge(pairs)
