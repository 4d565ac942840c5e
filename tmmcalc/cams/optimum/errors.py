"""By how much margins and the least height may be off: against nodes twice as dense, over what the height costs.

At the lowest mechanism the active margins should be 0. With multipliers l of their slopes g, which add up to that of
H2 itself, a margin that in truth is m moves the least height by l m.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.turn import loads_of
from tmmcalc.cams.forces.widespring import exact_spring, spring_miss
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.optimum import flat
from tmmcalc.cams.optimum.margins import NUMBERS, margins
from tmmcalc.cams.optimum.results import ACTIVE, Choice
from tmmcalc.cams.optimum.scene import Phases, Scene, scene_of
from tmmcalc.cams.rounding import FLOOR, MARGIN, Errors
from tmmcalc.cams.task import CamTask

DENSER = 2  # nodes for each one of the search
NEAR = 1e-7  # of S0 + H2: step of the differences


def optimum_errors(
    task: CamTask, follower: Follower, phases: Phases, scene: Scene, chosen: Choice, least: Choice
) -> Errors:
    """Estimates of the margins, absolute, at the sizes chosen and at the lowest, and of the least H2, relative."""
    denser, loads = scene_of(task, follower, phases, DENSER), loads_of(task)
    held = exact_spring(task, loads, scene.spring)
    rounded = (FLOOR + spring_miss(scene.spring, held)) * _cancelled(scene)
    missed = [_missed(_at(scene, each), _at(denser, each), rounded) for each in (chosen, least)]
    return {"margins": max(missed), "height": _height(denser, least)}


def _cancelled(scene: Scene) -> Values:
    """What the rounding of margins (k,) grows by: the slip is largest where P is a small rest of inertia and spring."""
    if scene.follower.kind == "flat":
        return np.ones(1)
    pressed = scene.spring.preload + scene.spring.stiffness * np.abs(scene.motion[0])
    return np.array([1 + float(np.max(pressed / np.abs(scene.load))), *[1.0] * (len(NUMBERS) - 1)])


def _missed(found: Values, denser: Values, rounded: Values) -> float:
    """By the nodes, or by the rounding of the values, which are 1 less the margin of their limits."""
    return float(np.max(np.maximum(MARGIN * np.abs(found - denser), rounded * (1 + np.abs(1 - found)))))


def _at(scene: Scene, choice: Choice) -> Values:
    return _margins(scene, np.array([choice.start, choice.roller, choice.height]))


def _margins(scene: Scene, x: Values) -> Values:
    """Margins (k,) at S0, r2, H2; far below 0 all alike."""
    if scene.follower.kind == "flat":
        found = np.array([each.margin for each in flat.choice_of(scene, float(x[0]), float(x[2])).checks])
    else:
        found = margins(scene, *x[:, None])[:, 0]
    return np.maximum(found, -1.0)


def _height(scene: Scene, least: Choice) -> float:
    """The least H2 with the margins of the denser nodes."""
    x = np.array([least.start, least.roller, least.height])
    value = _margins(scene, x)
    held = np.flatnonzero(np.abs(value) < ACTIVE)
    if not held.size:
        return FLOOR
    near = NEAR * (x[0] + x[2])
    free = [0, 2] if scene.follower.kind == "flat" else [0, 1, 2]
    steps = near * np.eye(3)[free]
    slope = np.array([(_margins(scene, x + each) - _margins(scene, x - each))[held] / (2 * near) for each in steps])
    price, *_ = np.linalg.lstsq(slope, np.eye(3)[2][free], rcond=None)
    moved = float(np.abs(price) @ np.abs(value[held]))
    return max(MARGIN * moved / least.height, FLOOR)
