"""The continuous least H2: sequential linear programming over S0, r2 and H2 within a trust region.

    minimise H2   where all margins are at least 0

Every step solves the linearised task exactly: its optimum is a corner of three planes, of constraints or of the
region, and there are few of them. A step that makes H2 + penalty less is taken, after a correction of the
constraints that it runs into; else the region shrinks. Where two constraints bind, the next region reaches to where
H2 stops falling along their line. At the end the active constraints are met to rounding.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
from functools import cache
from itertools import combinations

import numpy as np

from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.optimum.margins import SLACK, judge
from tmmcalc.cams.optimum.scene import Scene, mixed
from tmmcalc.core.records import record

NEAR = 1e-7  # of S0 + H2: step of the differences
REGION = 0.1  # of S0: first trust region
FINEST = 1e-8  # of S0: last one; H2 is then good to rounding, or its square where no corner holds it
QUICK = 1e-4  # the same where no more than the height is asked for
SHRINK = 8  # of the region where a step gains nothing
STEPS = 120
PENALTY = 10.0  # H2 for a margin of -1
NOTHING = 1e-13  # of H2: no gain
ALONG = 0.9  # cosine of a step that is along a line
TINY = 1e-12  # difference of two directions that is rounding


@record
class Least:
    """A lowest mechanism of any sizes."""

    start: float  # S0 [m]
    roller: float  # r2 [m]
    height: float  # H2 [m]
    margin: Values  # (8,)
    steps: int


Descent = Generator[Values, Values, Least]  # asks for the margins (8, B) at S0, r2 and H2 (3, B)


def least_height(scene: Scene, start: float, roller: float, height: float) -> Least:
    """The lowest mechanism near these sizes, which should be feasible."""
    return least_heights([scene], (start, roller, height))[0]


def least_heights(
    scenes: Sequence[Scene], sizes: tuple[float, float, float], region: float = REGION, finest: float = FINEST
) -> list[Least]:
    """The same of scenes that differ in their limits alone, all from these S0, r2 and H2.

    What does not depend on the limits is found for all of them at once.
    """
    going = {k: _descent(np.array(sizes), region * sizes[0], finest * sizes[0]) for k in range(len(scenes))}
    asked = {k: next(descent) for k, descent in going.items()}
    done: dict[int, Least] = {}
    scene_of = mixed(scenes)
    while asked:
        at = np.concatenate(list(asked.values()), axis=1)
        count = [own.shape[1] for own in asked.values()]
        margin = judge(scene_of(np.repeat(list(asked), count)), *at).margin
        for k, found in zip(list(asked), np.split(margin, np.cumsum(count)[:-1], axis=1), strict=True):
            try:
                asked[k] = going[k].send(found)
            except StopIteration as stop:
                done[k] = stop.value
                del asked[k]
    return [done[k] for k in range(len(scenes))]


def _descent(x: Values, region: float, last: float) -> Descent:
    """From x with a trust region of this size down to the last."""
    size = region
    value, slope = yield from _linear(x)
    steps = 0
    while size > last and steps < STEPS:
        steps += 1
        trial, binding = _corner(x, value, slope, size)
        if x[2] - trial[2] < NOTHING * x[2] and np.min(value) > -SLACK:
            break
        trial = yield from _corrected(trial, slope, binding)
        if np.all(trial > 0):
            fresh, tilt = yield from _linear(trial)
            gain = _merit(x, value) - _merit(trial, fresh)
            far = float(np.max(np.abs(trial - x)))
            turn = _turning(trial - x, slope[binding], tilt[binding])
            if gain > 0:
                wide = min(2 * size, region) if far > 0.9 * size else max(size / 2, 2 * far)
                size = wide if turn is None else min(wide, max(abs(turn - 1) * far, min(2 * last, size / SHRINK)))
                x, value, slope = trial, fresh, tilt
                if gain > NOTHING * x[2]:
                    continue
            elif turn is not None and turn < 1:
                size = min(max(turn * far, size / SHRINK), size / 2)
                continue
        size /= SHRINK
    return Least(float(x[0]), float(x[1]), float(x[2]), value, steps)


def _turning(step: Values, slope: Values, tilt: Values) -> float | None:
    """Where H2 stops falling along the line on which two constraints bind, by their slopes (2, 3) at both ends.

    As a part of the step (3,), by false position; None where they are not two, H2 falls on, or the step is not one
    along that line.
    """
    if len(slope) != 2:
        return None
    way, there = _cross(slope[:1], slope[1:])[0], _cross(tilt[:1], tilt[1:])[0]
    sizes = float(np.linalg.norm(way)), float(np.linalg.norm(there))
    if not min(sizes) or abs(float(way @ step)) < ALONG * sizes[0] * float(np.linalg.norm(step)):
        return None
    fall, left = float(way[2]) / sizes[0], float(there[2]) / sizes[1] * (1 if float(way @ there) > 0 else -1)
    return fall / (fall - left) if abs(fall - left) > TINY and fall / (fall - left) > 0 else None


def _linear(x: Values) -> Generator[Values, Values, tuple[Values, Values]]:
    """Margins (8,) and their slopes (8, 3)."""
    near = NEAR * (x[0] + x[2])
    shift = near * np.concatenate((np.zeros((3, 1)), np.eye(3), -np.eye(3)), axis=1)
    found = yield x[:, None] + shift
    return found[:, 0], (found[:, 1:4] - found[:, 4:]) / (2 * near)


def _merit(x: Values, value: Values) -> float:
    return float(x[2] * (1 + PENALTY * max(0.0, -float(np.min(value)))))


def _corner(x: Values, value: Values, slope: Values, size: float) -> tuple[Values, Indices]:
    """The lowest corner of the linearised task in the region, and the constraints (k,) that meet there."""
    near = np.flatnonzero(value <= size * np.sum(np.abs(slope), axis=1))  # the others no step of the region reaches
    slope, value = slope[near], value[near]
    steep = np.max(np.abs(slope), axis=1)  # planes of like normals, so that none is lost in a small region
    steep = np.where(steep > 0, steep, 1.0)
    scale = size * steep
    normal = np.concatenate((slope / steep[:, None], np.eye(3), -np.eye(3)))
    bound = np.concatenate((-value / scale, -np.ones(6)))
    i, j, k = _triples(len(bound))
    across = _cross(normal[j], normal[k]), _cross(normal[k], normal[i]), _cross(normal[i], normal[j])
    turn = np.einsum("nd,nd->n", normal[i], across[0])
    sound = np.abs(turn) > 1e-12
    corner = sum(bound[a][:, None] * b for a, b in zip((i, j, k), across, strict=True))
    corner = corner[sound] / turn[sound, None]
    corner = corner[np.max(np.abs(corner), axis=1) <= 1 + 1e-9]
    short = np.max((bound[: len(value)] - corner @ normal[: len(value)].T) * scale, axis=1, initial=0.0)
    short = np.where(short < 1e-12, 0.0, short)
    cost = corner[:, 2] * size + PENALTY * 100 * x[2] * short
    best = corner[int(np.argmin(cost))]
    binding = np.flatnonzero(np.abs(normal[: len(value)] @ best * scale + value) < 1e-9)
    return x + size * best, near[binding]


def _cross(a: Values, b: Values) -> Values:
    """Vector products (n, 3)."""
    turn = [1, 2, 0]
    found: Values = (a * b[:, turn] - a[:, turn] * b)[:, turn]
    return found


@cache
def _triples(count: int) -> Indices:
    """All choices (3, n) of three planes."""
    return np.array(list(combinations(range(count), 3))).T


def _corrected(trial: Values, slope: Values, binding: Indices) -> Generator[Values, Values, Values]:
    """The trial moved the shortest way to where the binding constraints, which are not linear, hold again."""
    if not len(binding) or not np.all(trial > 0):
        return trial
    found = yield trial[:, None]
    moved, *_ = np.linalg.lstsq(slope[binding], -found[binding, 0], rcond=None)
    better: Values = trial + moved
    return better if np.all(better > 0) else trial
