"""Estimates of the optimum against 50 digits on random cams: margins, and what they leave of the least height.

To the first order the least height is off by what the active margins miss times their multipliers; the margins are
those of the requirements written out by hand at the sizes that are found.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from mpmath import mp, mpf

from cams.exact import random_program
from cams.exact_forces import Loaded
from cams.exact_peaks import extremes
from cams.exact_strength import Judged
from cams.optimum_scene import flat_task, roller_task
from cams.scenes import briefly, judged
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.optimum import flatface
from tmmcalc.cams.optimum.checks import choice_of
from tmmcalc.cams.optimum.errors import optimum_errors
from tmmcalc.cams.optimum.leastheight import least_height
from tmmcalc.cams.optimum.margins import margins
from tmmcalc.cams.optimum.results import ACTIVE
from tmmcalc.cams.optimum.scene import scene_of
from tmmcalc.core.errors import NoSolutionError

FEW = 1
NEAR = 1e-6  # [m] of the differences for the slopes of margins


def the_roller(random):
    """Margins at sizes of any kind and at the lowest, and the least height."""
    task = replace(roller_task(), program=random_program(random, 10 ** random.uniform(-2.3, -1.7), own=False))
    follower = Follower("translating", 0.06, float(random.choice([0.0, 0.003, -0.004])))
    scene = scene_of(task, follower)
    sizes = random.uniform(0.04, 0.1), random.uniform(0.005, 0.02), random.uniform(0.15, 0.3)
    lowest = least_height(scene, *sizes)
    if np.min(lowest.margin) < -1e-9:
        raise NoSolutionError("no sizes", where="", remedy="")
    chosen, least = choice_of(scene, *sizes), choice_of(scene, lowest.start, lowest.roller, lowest.height)
    error = optimum_errors(task, follower, "turn", scene, chosen, least)
    both = [dict(_margins(task, follower, each)) for each in (chosen, least)]
    off = [abs(check.margin - true[check.number]) for choice, true in zip((chosen, least), both, strict=True)
           for check in choice.checks if check.number in true and check.margin > -1]  # fmt: skip
    held = [k for k, check in enumerate(least.checks[1:]) if abs(check.margin) < ACTIVE]
    missed = np.array([float(both[1][least.checks[1 + k].number]) for k in held])
    moved = abs(_multipliers(scene, least, held) @ missed) / least.height
    return {"margins": (error["margins"], float(max(off))), "height": (error["height"], moved)}


def _multipliers(scene, least, held):
    x, steps = np.array([least.start, least.roller, least.height]), NEAR * np.eye(3)
    slope = np.array([
        (margins(scene, *(x + each)[:, None]) - margins(scene, *(x - each)[:, None]))[held, 0] / (2 * NEAR)
        for each in steps
    ])  # fmt: skip
    return np.linalg.lstsq(slope, np.array([0.0, 0.0, 1.0]), rcond=None)[0]


def _margins(task, follower, choice):
    """Number and margin of the constraints 2 to 9 of table 5.5."""
    sized = replace(follower, start=choice.start, roller=choice.roller)
    task = replace(task, guide=replace(task.guide, top=choice.height))
    exact, need, limits = Judged(Loaded(task, sized)), task.requirements, task.limits
    roller, (low, high) = mpf(choice.roller), exact.ends(exact.curvature)
    yield 2, 1 - exact.ends(exact.slip(*exact.factors()))[1]
    yield 3, 1 - (roller + mpf(limits.convex)) * high
    yield 4, 1 + (mpf(limits.concave) - roller) * min(low, 0)
    yield 5, 1 - mpf(need.roller_ratio) * exact.pin / roller
    shaft = mpf(int(mp.ceil(max(exact.shafts()) * 1000 - mpf(1) / 10**9))) / 1000
    yield 6, 1 - (roller + shaft) / mp.hypot(mpf(choice.start), mpf(follower.offset))
    for number, formula, limit in ((7, exact.bending, need.bending), (8, exact.pressure, need.guide_pressure),
                                   (9, exact.stress, need.contact)):  # fmt: skip
        yield number, 1 - exact.ends(formula)[1] / mpf(limit)


def the_face(random):
    """The least height by convexity and the length of the guide (fig. 5.37), where these decide."""
    task = replace(flat_task(), program=random_program(random, 10 ** random.uniform(-2.5, -2.0), own=False))
    follower = Follower("flat", 0.1)
    scene = scene_of(task, follower)
    least = flatface.choice_of(scene, *flatface.lowest(scene))
    loaded, need, program = Loaded(task, follower), task.requirements, task.program
    start = mpf(task.limits.convex) - extremes(program, lambda lib, phi, m, piece: m[0] + m[2])[0][0]
    limit = mpf(need.guide_pressure) * 2 * mpf(task.guide.land) * mpf(task.guide.stem)

    def length(lib, phi, m, piece):
        force = -loaded.at(lib, phi, m, piece).load
        return (
            force * abs(m[1]) / (float(limit) if lib.mpf is float else limit) + 2 * lib.mpf(task.loads.friction) * m[1]
        )

    height = start + mpf(program.stroke) + extremes(program, length)[1][0]
    if abs(least.height - height) > 1e-9:
        raise NoSolutionError("another constraint decides", where="", remedy="")
    error = optimum_errors(task, follower, "turn", scene, least, least)
    return {"height": (error["height"], float(abs(least.height / height - 1)))}


SCENES = (the_roller, the_face)


def test_an_estimate_of_a_face():
    briefly(the_face, 11, FEW)


@pytest.mark.slow
@pytest.mark.parametrize("scene", SCENES)
def test_estimates(scene):
    judged(scene, 111)
