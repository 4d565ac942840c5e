"""By how much margins and the least height may be off: against nodes twice as dense, over what the height costs.

At the lowest mechanism the active margins should be 0. With multipliers l of their slopes g, which add up to that of
H2 itself, a margin that in truth is m moves the least height by l m.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.springerrors import exact_spring, spring_miss
from tmmcalc.cams.forces.turn import loads_of
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.optimum import flatface
from tmmcalc.cams.optimum.margins import NUMBERS, margins
from tmmcalc.cams.optimum.results import ACTIVE, Choice
from tmmcalc.cams.optimum.scene import Phases, Scene, scene_of
from tmmcalc.cams.rounding import FLOOR, MARGIN, Errors
from tmmcalc.cams.task import CamTask
from tmmcalc.cams.wide import wide

CONVEX = 3  # number of the constraint of a flat face that the motion alone decides
DENSER = 2  # nodes for each one of the search
NEAR = 1e-7  # of S0 + H2: step of the differences


def optimum_errors(
    task: CamTask, follower: Follower, phases: Phases, scene: Scene, chosen: Choice, least: Choice
) -> Errors:
    """Estimates of the margins, absolute, at the sizes chosen and at the lowest, and of the least H2, relative."""
    denser, loads = scene_of(task, follower, phases, DENSER), loads_of(task)
    unit = FLOOR + spring_miss(scene.spring, exact_spring(task, loads, scene.spring))
    rounded = unit * _cancelled(scene, least)
    if scene.follower.kind == "flat":
        rounded[[each.number == CONVEX for each in least.checks]] += MARGIN * _bent(task, scene) / least.start
    off = [missed(_at(scene, each), _at(denser, each), rounded) for each in (chosen, least)]
    return {"margins": max(off), "height": _height(denser, least, rounded)}


def _cancelled(scene: Scene, least: Choice) -> Values:
    """What the rounding of margins (k,) grows by, as P is a rest of inertia and spring.

    The slip is largest where P is small, the pressure in the guide where P |S'| is large.
    """
    pressed = scene.spring.preload + scene.spring.stiffness * np.abs(scene.motion[0])
    if scene.follower.kind == "flat":
        slide = np.abs(scene.motion[1])
        carried = 1 + float(np.max(pressed * slide) / np.max(np.abs(scene.load) * slide))
        return np.array([1.0 if each.number == CONVEX else carried for each in least.checks])
    return np.array([1 + float(np.max(pressed / np.abs(scene.load))), *[1.0] * (len(NUMBERS) - 1)])


def _bent(task: CamTask, scene: Scene) -> float:
    """By what rounding of the motion moves dS + S'' [m] where it is least, at the nodes of its panel."""
    nodes = scene.by_panel(scene.phi)
    found = scene.by_panel(scene.motion[0] + scene.motion[2])
    k = int(np.argmin(np.min(found, axis=1)))
    piece = task.program.piece(np.full(nodes.shape[1], np.mean(nodes[k])))
    exact = task.program.wider.at(wide(nodes[k]), piece)
    return float(np.max(np.abs(found[k] - (exact[0] + exact[2]))))


def missed(found: Values, denser: Values, rounded: Values) -> float:
    """By the nodes, or by the rounding of the values, which are 1 less the margin of their limits."""
    return float(np.max(np.maximum(MARGIN * np.abs(found - denser), rounded * (1 + np.abs(1 - found)))))


def _at(scene: Scene, choice: Choice) -> Values:
    return _margins(scene, np.array([choice.start, choice.roller, choice.height]))


def _margins(scene: Scene, x: Values) -> Values:
    """Margins (k,) at S0, r2, H2; far below 0 all alike."""
    if scene.follower.kind == "flat":
        found = np.array([each.margin for each in flatface.choice_of(scene, float(x[0]), float(x[2])).checks])
    else:
        found = margins(scene, *x[:, None])[:, 0]
    return np.maximum(found, -1.0)


def _height(scene: Scene, least: Choice, rounded: Values) -> float:
    """The least H2 with the margins of the denser nodes, or with their rounding."""
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
    off = np.maximum(MARGIN * np.abs(value), rounded)[held]
    return max(float(np.abs(price) @ off) / least.height, FLOOR)
