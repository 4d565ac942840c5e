"""Estimated errors of speed and way of falling balls against the equation of motion, by Taylor series in 40 digits."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest
from bounding import assert_bounds, part
from mpmath import mp, mpf

from tmmcalc.core.errors import TmmError
from tmmcalc.extras.falling_ball import BallTask, solve_falling_ball

TERMS = 26  # of a series
ROWS = 6


def random_ball(rng: np.random.Generator) -> BallTask:
    """Driven, braked to a stop and back, or in balance; reactions of their own or of the ball's speed."""
    decay, own = 10 ** rng.uniform(-2, 2), rng.random() < 0.3
    relative = None if own else float(rng.choice([0.0, 10 ** rng.uniform(-1, 3) / decay]))
    return BallTask(
        float(10 ** rng.uniform(-4, 0)), float(10 ** rng.uniform(-5, -1)), decay, 9.81, int(rng.choice([-1, 1])),
        relative, float(rng.choice([0.0, 10 ** rng.uniform(-1, 2)])), duration=float(rng.uniform(0.2, 4)) / decay,
        rows=ROWS,
    )  # fmt: skip


def _sum(row: Sequence[Any], h: Any) -> Any:
    """Of a power series."""
    total = mpf(0)
    for each in reversed(row):
        total = total * h + each
    return total


def exact(task: BallTask, times: list[float]) -> list[tuple[Any, Any]]:
    """Speed and way at ascending times."""
    decay, own = mpf(task.decay), task.relative is None
    drive = mpf(task.gravity) + (0 if own else 3 * task.sign * decay * mpf(task.relative or 0.0))
    self_ = 3 * task.sign * decay if own else mpf(0)
    t, v, way, found = mpf(0), mpf(task.initial), mpf(0), []
    for end in map(mpf, times):
        while t < end:
            down = v > 0 or (v == 0 and drive > 0)
            resisted = mpf(task.drag) / mpf(task.radius) * mp.exp(decay * t) * (1 if down else -1)
            speeds, squares, sizes = [v], [], [resisted]
            for k in range(TERMS):
                squares.append(sum(speeds[i] * speeds[k - i] for i in range(k + 1)))
                pull = sum(sizes[k - j] * squares[j] for j in range(k + 1))
                speeds.append(((drive if k == 0 else 0) + self_ * speeds[k] - pull) / (k + 1))
                sizes.append(sizes[k] * decay / (k + 1))
            last = max(abs(speeds[TERMS]), mpf(10) ** -300)
            reach = min(((abs(v) + mpf(10) ** -30) / last) ** (mpf(1) / TERMS), 1 / decay)
            h = min(reach * mpf(10) ** (mpf(-34) / TERMS), end - t)
            after = _sum(speeds, h)
            if v > 0 > after:
                h = mp.findroot(lambda s, row=tuple(speeds): _sum(row, s), (0, h), solver="anderson")
                after = mpf(0)
            way += h * _sum([each / (k + 1) for k, each in enumerate(speeds)], h)
            t, v = t + h, after
        found.append((v, way))
    return found


def _held(scenes: int) -> None:
    rng, done = np.random.default_rng(3), 0
    pairs: dict[str, list[tuple[float, float]]] = defaultdict(list)
    while done < scenes:
        task = random_ball(rng)
        try:
            found = solve_falling_ball(task)
        except TmmError:
            continue
        done += 1
        with mp.workdps(40):
            true = exact(task, found.t[1:].tolist())
            for k, (name, told) in enumerate((("speed", found.v), ("way", found.way))):
                size = max(abs(each[k]) for each in true)
                missed = max(abs(mpf(float(a)) - b[k]) for a, b in zip(told[1:], true, strict=True))
                pairs[name].append((found.error[name], float(missed / size)))
    for name, each in pairs.items():
        assert_bounds(each, name, scenes=scenes)


def test_estimates_of_some_balls() -> None:
    _held(2)


@pytest.mark.slow
def test_estimates() -> None:
    _held(part(200, 8))
