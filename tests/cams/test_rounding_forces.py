"""Estimates of spring, forces, extremes and work against the equilibrium at 50 digits on random cams."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import mpf
from sparing import sparing

from cams.exact import missed, motion_at
from cams.exact_forces import Loaded
from cams.exact_peaks import EXACT, extremes
from cams.loaded import random_loaded
from cams.scenes import briefly, judged, some
from tmmcalc.cams.forces.solve import solve_forces

FEW = 1
ROWS = {"load": "load", "contact": "contact", "torque": "torque", "driving": "driving"}
NAMED = {
    "P_c": "load",
    "M_c": "load",
    "R": "contact",
    "N1": "lower",
    "N2": "upper",
    "T": "torque",
    "M_drive": "driving",
}


def the_forces(random):
    """Rows, pivot or guide, and the spring; every second cam has a rocker."""
    task, follower, rate = random_loaded(random, "oscillating" if random.random() < 0.5 else None)
    found, rows = solve_forces(task, follower), task.positions
    exact = Loaded(task, follower, rate)
    which = some(random, len(rows.phi), 16)
    motion = [motion_at(task.program, rows.phi[i], rows.piece[i]) for i in which]
    phi = [mpf(float(rows.phi[i])) for i in which]
    true = [exact.at(EXACT, x, m, rows.piece[i]) for x, m, i in zip(phi, motion, which, strict=True)]
    pairs = {}
    for name in ("load", "contact", "torque", "driving"):
        values = getattr(found, name)
        size = float(np.max(np.abs(values)))
        if size:
            pairs[name] = found.error[name], missed(values[which], [getattr(each, name) for each in true], size)
    if found.lower is not None:
        size = float(np.max(np.abs([found.lower, found.upper])))
        off = [missed(getattr(found, name)[which], [getattr(each, name) for each in true], size)
               for name in ("lower", "upper")]  # fmt: skip
        pairs["guide"] = found.error["guide"], max(off)
    if found.pivot is not None:
        force = [exact.pivot(x, m, each.contact) for x, m, each in zip(phi, motion, true, strict=True)]
        size = float(np.max(np.abs(found.contact)))
        pairs["pivot"] = found.error["pivot"], missed(found.pivot[0][which] + 1j * found.pivot[1][which], force, size)
    if task.loads.spring.method in ("safety", "preload") and found.spring.stiffness:
        pairs["spring"] = found.error["spring"], max(_spring_missed(found.spring, exact.spring), default=0.0)
    return pairs


def _spring_missed(found, exact):
    for name in ("stiffness", "preload", "highest", "reached", "exact"):
        value, true = getattr(found, name), getattr(exact, name)
        if value and true:
            yield float(abs(value / true - 1))


def the_extremes(random):
    task, follower, rate = random_loaded(random)
    found, worst = solve_forces(task, follower), 0.0
    exact = Loaded(task, follower, rate)
    for each in found.extremes:
        low, high = extremes(task.program, exact.value(NAMED[each.name]))
        size = max(abs(low[0]), abs(high[0]))
        if size:
            worst = max(worst, float(max(abs(each.least - low[0]), abs(each.largest - high[0])) / size))
    return {"extremes": (found.error["extremes"], worst)}


def the_work(random):
    task, follower, rate = random_loaded(random)
    found = solve_forces(task, follower)
    exact = Loaded(task, follower, rate)
    driving, given, rubbed, own = exact.works()
    turned = given + abs(driving - given)
    pairs = [
        (found.work.driving, driving), (found.work.given, given), (found.work.returned, driving - given),
        (found.work.friction, rubbed), (found.work.force, own),
    ]  # fmt: skip
    return {"work": (found.error["work"], float(max(abs(a - b) for a, b in pairs) / turned))}


SCENES = (the_forces, the_extremes, the_work)


@sparing("scene", SCENES, every=3)
def test_estimates_in_a_few_scenes(scene):
    briefly(scene, 7, FEW)


@pytest.mark.slow
@pytest.mark.parametrize("scene", SCENES)
def test_estimates(scene):
    judged(scene, 107)
