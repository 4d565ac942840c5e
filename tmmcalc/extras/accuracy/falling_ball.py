"""Methods for the fall of a ball: its speed in closed form beside the equations of motion in time.

The reference is extrapolation of the equations in extended precision, which knows nothing of Bessel functions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.core.studies.extrapolation import extrapolated
from tmmcalc.core.studies.measure import Way, relative, series
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Study
from tmmcalc.core.studies.timed import Run, Start, controlled, stepped
from tmmcalc.extras.falling_ball import Ball, BallTask, solve_falling_ball

INSTANTS = 8  # of the fall, at equal steps
STEPS = (16, 32, 64, 128, 256, 512, 1024, 2048)
PARTS = (6, 12)  # of the time between two instants: steps of the reference, and of what it is compared with
GOOD = 1e-13  # of the reference; where the drag is too stiff for it there is none
CLOSED = "Bessel functions, the way by Gauss's rule on panels; with the place of the largest speed"


def studies(scene: Scene) -> Iterator[Study]:
    """Speed and way at equal instants."""
    task: BallTask = scene.inputs
    result: Ball = scene.results["falling_ball"]
    if not WIDER:
        return
    instants = float(result.t[-1]) * np.arange(1, INSTANTS + 1) / INSTANTS
    slopes, begun = _slopes(task), np.array([task.initial, 0.0])
    with np.errstate(over="ignore", invalid="ignore"):
        coarse, exact = (extrapolated(slopes, begun, instants, parts) for parts in PARTS)

    def error(run: Run) -> float:
        return max(relative(a, b) for a, b in zip(run.states, exact, strict=True))

    own = error(Run(coarse, 0))
    if not own < GOOD:
        return
    start = Start(slopes, begun, instants, np.max(np.abs(exact), axis=1).astype(float))

    def closed() -> Run:
        found = solve_falling_ball(replace(task, times=tuple(instants.tolist()), duration=instants[-1], rows=1))
        return Run(np.array([[each.v for each in found.asked], [each.way for each in found.asked]]), 0)

    yield Study(
        "falling_ball",
        "speed and way",
        Reference("extrapolation of order 18 in extended precision (64-bit mantissa), beside steps twice as long", own),
        (
            series("closed form", [Way("", None, closed)], error, scene.clock, note=CLOSED),
            *controlled(start, error, scene.clock),
            stepped(start, STEPS, error, scene.clock),
        ),
    )


def _slopes(task: BallTask) -> Callable[[float, Any], list[Any]]:
    """Derivatives of speed and way."""
    push = 3 * task.sign * task.decay

    def slopes(t: float, y: Any) -> list[Any]:
        v = y[0]
        drag = task.drag / task.radius * np.exp(task.decay * t) * v * abs(v)
        return [task.gravity - drag + push * (v if task.relative is None else task.relative), v]

    return slopes
