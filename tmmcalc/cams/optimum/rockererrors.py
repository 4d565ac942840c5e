"""By how much margins and the least l0 of a rocker may be off: nodes twice as dense, over what l0 costs."""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.springerrors import exact_spring, spring_miss
from tmmcalc.cams.forces.turn import loads_of
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.optimum.errors import DENSER, NEAR, missed
from tmmcalc.cams.optimum.results import ACTIVE, Choice
from tmmcalc.cams.optimum.rockersizes import NUMBERS, RockerScene, Sizes, judge_rocker, rocker_scene
from tmmcalc.cams.optimum.scene import Phases
from tmmcalc.cams.rounding import FLOOR, MARGIN, Errors
from tmmcalc.cams.task import CamTask


def rocker_errors(
    task: CamTask, follower: Follower, phases: Phases, of: RockerScene, chosen: Choice, least: Choice
) -> Errors:
    """Estimates of the margins, absolute, at the sizes chosen and at the least, and of the least l0, relative."""
    scene, denser = of.scene, rocker_scene(task, follower, phases, DENSER)
    unit = FLOOR + spring_miss(scene.spring, exact_spring(task, loads_of(task), scene.spring))
    pressed = scene.spring.preload + scene.spring.stiffness * np.abs(scene.motion[0])
    rounded = unit * np.array([1 + float(np.max(pressed / np.abs(scene.load))), *[1.0] * (len(NUMBERS) - 1)])
    both = [(_sizes(each), rounded) for each in (chosen, least)]
    return {
        "margins": max(missed(_margins(of, x), _margins(denser, x), own) for x, own in both),
        "height": _height(denser, _sizes(least), rounded),
    }


def _sizes(choice: Choice) -> Values:
    return np.array([choice.length, choice.start, choice.roller, choice.height])


def _margins(of: RockerScene, x: Values) -> Values:
    """Margins (k,) at l2, R0, r2, l0; far below 0 all alike."""
    return np.maximum(judge_rocker(of, Sizes(*x[:, None])).margin[:, 0], -1.0)


def _height(of: RockerScene, x: Values, rounded: Values) -> float:
    """The least l0 with the margins of the denser nodes, or with their rounding."""
    value = _margins(of, x)
    held = np.flatnonzero(np.abs(value) < ACTIVE)
    if not held.size:
        return FLOOR
    steps = NEAR * x[3] * np.eye(4)
    slope = np.array([(_margins(of, x + each) - _margins(of, x - each))[held] / (2 * NEAR * x[3]) for each in steps])
    price, *_ = np.linalg.lstsq(slope, np.eye(4)[3], rcond=None)
    off = np.maximum(MARGIN * np.abs(value), rounded)[held]
    return max(float(np.abs(price) @ off) / float(x[3]), FLOOR)
