"""The continuous least H2: sequential linear programming over S0, r2 and H2 within a trust region.

    minimise H2   where all margins are at least 0

Every step solves the linearised task exactly: its optimum is a corner of three planes, of constraints or of the
region, and there are few of them. A step that makes H2 + penalty less is taken, after a correction of the
constraints that it runs into; else the region shrinks. At the end the active constraints are met to rounding.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import combinations

import numpy as np

from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.optimum.margins import SLACK, margins
from tmmcalc.cams.optimum.scene import Scene
from tmmcalc.records import record

NEAR = 1e-7  # of S0 + H2: step of the differences
REGION = 0.1  # of S0: first trust region
FINEST = 1e-8  # of S0: last one; H2 is then good to rounding, or its square where no corner holds it
QUICK = 1e-4  # the same where no more than the height is asked for
SHRINK = 8  # of the region where a step gains nothing
STEPS = 120
PENALTY = 10.0  # H2 for a margin of -1
NOTHING = 1e-13  # of H2: no gain


@record
class Least:
    """A lowest mechanism of any sizes."""

    start: float  # S0 [m]
    roller: float  # r2 [m]
    height: float  # H2 [m]
    margin: Values  # (8,)
    steps: int


Constraints = Callable[[Values], Values]  # (3, B) -> (8, B)


def least_height(
    scene: Scene, start: float, roller: float, height: float, region: float = REGION, finest: float = FINEST
) -> Least:
    """The lowest mechanism near these sizes, which should be feasible."""

    def held(x: Values) -> Values:
        return margins(scene, x[0], x[1], x[2])

    x = np.array([start, roller, height])
    size, last = region * start, finest * start
    value, slope = _linear(held, x)
    steps = 0
    while size > last and steps < STEPS:
        steps += 1
        trial, binding = _corner(x, value, slope, size)
        if x[2] - trial[2] < NOTHING * x[2] and np.min(value) > -SLACK:
            break
        trial = _corrected(held, trial, slope, binding)
        if np.all(trial > 0):
            fresh, tilt = _linear(held, trial)
            gain = _merit(x, value) - _merit(trial, fresh)
            if gain > 0:
                far = float(np.max(np.abs(trial - x)))
                size = min(2 * size, region * start) if far > 0.9 * size else max(size / 2, 2 * far)
                x, value, slope = trial, fresh, tilt
                if gain > NOTHING * x[2]:
                    continue
        size /= SHRINK
    return Least(float(x[0]), float(x[1]), float(x[2]), value, steps)


def _linear(held: Constraints, x: Values) -> tuple[Values, Values]:
    """Margins (8,) and their slopes (8, 3)."""
    near = NEAR * (x[0] + x[2])
    shift = near * np.concatenate((np.zeros((3, 1)), np.eye(3), -np.eye(3)), axis=1)
    found = held(x[:, None] + shift)
    return found[:, 0], (found[:, 1:4] - found[:, 4:]) / (2 * near)


def _merit(x: Values, value: Values) -> float:
    return float(x[2] * (1 + PENALTY * max(0.0, -float(np.min(value)))))


def _corner(x: Values, value: Values, slope: Values, size: float) -> tuple[Values, Indices]:
    """The lowest corner of the linearised task in the region, and the constraints (k,) that meet there."""
    near = np.flatnonzero(value <= size * np.sum(np.abs(slope), axis=1))  # the others no step of the region reaches
    slope, value = slope[near], value[near]
    normal = np.concatenate((slope * size, np.eye(3), -np.eye(3)))
    bound = np.concatenate((-value, -np.ones(6)))
    i, j, k = _triples(len(bound))
    across = _cross(normal[j], normal[k]), _cross(normal[k], normal[i]), _cross(normal[i], normal[j])
    turn = np.einsum("nd,nd->n", normal[i], across[0])
    sound = np.abs(turn) > 1e-12
    corner = sum(bound[a][:, None] * b for a, b in zip((i, j, k), across, strict=True))
    corner = corner[sound] / turn[sound, None]
    corner = corner[np.max(np.abs(corner), axis=1) <= 1 + 1e-9]
    short = np.maximum(np.max(bound[: len(value)] - corner @ normal[: len(value)].T, axis=1, initial=0.0), 0.0)
    short = np.where(short < 1e-12, 0.0, short)
    cost = corner[:, 2] * size + PENALTY * 100 * x[2] * short
    best = corner[int(np.argmin(cost))]
    binding = np.flatnonzero(np.abs(normal[: len(value)] @ best + value) < 1e-9)
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


def _corrected(held: Constraints, trial: Values, slope: Values, binding: Indices) -> Values:
    """The trial moved the shortest way to where the binding constraints, which are not linear, hold again."""
    if not len(binding) or not np.all(trial > 0):
        return trial
    value = held(trial[:, None])[binding, 0]
    moved, *_ = np.linalg.lstsq(slope[binding], -value, rcond=None)
    better = trial + moved
    return better if np.all(better > 0) else trial
