"""Estimates of indexing drives against plain geometry at 50 digits on random drives."""

from __future__ import annotations

from dataclasses import replace
from math import radians

import numpy as np
import pytest
from mpmath import mp, mpf

from cams.exact import missed, motion_at
from cams.exact_indexing import SIDES, Wheel
from cams.exact_peaks import EXACT
from cams.scenes import briefly, judged, some
from tmmcalc.cams.indexing import solve_indexing
from tmmcalc.cams.indexing.laws import step_law
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.core.errors import NoSolutionError

FEW = 1
NAMES = ("sine", "cosine", "linear", "shun", "modified_trapezoid", "modified_sine", "poly4567", "const")


def drive(random):
    """A drive at random between the limits of lambda, or as it is chosen."""
    law = step_law(NAMES[random.integers(len(NAMES))])
    task = IndexingTask(law, 6, radians(random.uniform(80, 175)), 10 ** random.uniform(-3, 0), None, None)
    task = replace(task, rollers=int(random.choice([6, 8, 10, 12])), rows=int(random.integers(10, 60)))
    if random.random() < 0.5:
        task = replace(task, ratio=random.uniform(1.3, 3.5))
    return law.law, solve_indexing(replace(task, friction=random.uniform(0, 0.3), pin_friction=random.uniform(0, 0.3)))


def the_drive(random):
    law, found = drive(random)
    if found.cam is None or not found.roller:
        raise NoSolutionError("no roller", where="", remedy="")
    wheel, cam, error = Wheel(found, law), found.cam, found.error
    which = some(random, len(found.k), 10)
    k = [mpf(float(found.k[i])) for i in which]
    at = [
        motion_at(wheel.program, each, int(law.piece(found.k[i : i + 1])[0])) for i, each in zip(which, k, strict=True)
    ]
    pairs = {name: (error[name], max(each)) for name, each in _rows(wheel, cam, which, k, at).items()}
    pairs["limits"] = error["limits"], max(map(float, _limits(wheel, cam)))
    tip, working = wheel.tip(cam.handover.part), wheel.working_tip(cam.working_part)
    pairs["ends"] = error["ends"], float(max(abs(tip - cam.handover.part), abs(working - cam.working_part)))
    return pairs


def _rows(wheel, cam, which, k, at):
    found = {"points": [], "curvature": [], "pressure": [], "efficiency": []}
    rows = list(zip(k, at, strict=True))
    for name, table in (("A", cam.a), ("B", cam.b)):
        side, size = SIDES[name], float(np.max(table.radius))
        found["points"] += [
            missed(table.pitch[which], [wheel.curve(EXACT, *each, side)[0] for each in rows], size),
            missed(table.working[which], [wheel.working(*each, side) for each in rows], size),
        ]
        bend = [wheel.bend(side)(EXACT, *each, None) for each in rows]
        found["curvature"].append(missed(table.curvature[which], bend, float(np.max(np.abs(table.curvature)))))
        angle = [wheel.angle(side)(EXACT, *each, None) for each in rows]
        value = [float(each) for each in table.pressure[which]]
        turned = [true + mp.pi * mp.nint((each - true) / mp.pi) for each, true in zip(value, angle, strict=True)]
        found["pressure"].append(missed(value, turned, float(np.max(np.abs(table.pressure)))))
    drives = [SIDES["A" if each <= cam.handover.part else "B"] for each in k]
    both = [wheel.efficiency(*each, side) for each, side in zip(rows, drives, strict=True)]
    for values, true in zip((cam.efficiency.against, cam.efficiency.aiding), zip(*both, strict=True), strict=True):
        found["efficiency"].append(missed(values[which], true, 1))
    return found


def _limits(wheel, cam):
    """Each relative to itself: the largest pressure angles, the least convex radii."""
    end = cam.handover.part
    for reached, low, high in ((cam.run_up, 0.0, end), (cam.run_out, end, 1.0)):
        angle = wheel.angle(SIDES[reached.flank])
        true = wheel.largest(lambda *x, angle=angle: abs(angle(*x)), low, high)
        yield abs(reached.largest / true - 1)
    for limit, (name, high) in zip(cam.roller_limits, (("A", end), ("B", 1.0)), strict=False):
        if limit.radius is not None:
            yield abs(limit.radius * wheel.largest(wheel.bend(SIDES[name]), 0.0, high) - 1)


def test_estimates_in_a_few_scenes():
    briefly(the_drive, 9, FEW)


@pytest.mark.slow
def test_estimates():
    judged(the_drive, 109)
