"""Where a quantity turns back within a step: by the cubic of its ends, then by the method's own state there."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

from tmmcalc.core.numerics.steps import Derivative, State
from tmmcalc.machine.transient.steppers import Stepper

SETTLED = 1e-12  # of its size: a turning point that moves by less is found
ROUNDS = 4  # of looking


class Point(NamedTuple):
    """A quantity at a time."""

    t: float
    value: float
    rate: float


def settled(
    stepper: Stepper, f: Derivative, of: Callable[[State], float], ends: tuple[Point, Point], at: float
) -> tuple[Point, float, State]:
    """The turning point near a time in the last step, how far its last correction moved it, and a state beside it.

    ``of`` is linear: the quantity of a state, and its rate of the state's rates.
    """
    before, after = ends
    for _ in range(ROUNDS):
        y = stepper.to(at)
        found = Point(at, of(y), of(f(at, y)))
        before, after = (before, found) if before.rate * found.rate < 0 else (found, after)
        turned = turnings(before, after) if before.rate * after.rate < 0 else []
        if not turned:
            return found, 0.0, y
        at, value = turned[0]
        moved = abs(value - found.value)
        if moved <= SETTLED * abs(value):
            break
    return Point(at, value, 0.0), moved, y


def turnings(before: Point, after: Point) -> list[tuple[float, float]]:
    """Times and values at which the cubic through two points with their rates turns back between them."""
    h = after.t - before.t
    rise, fall, gained = h * before.rate, h * after.rate, after.value - before.value
    # the slope of the cubic of Hermite is a s^2 + b s + rise
    a, b = 3 * (rise + fall - 2 * gained), 2 * (3 * gained - 2 * rise - fall)
    square = b * b - 4 * a * rise
    if square <= 0:
        return []
    # the roots without cancellation
    q = -(b + math.copysign(math.sqrt(square), b)) / 2
    parts = [p / d for p, d in ((q, a), (rise, q)) if abs(p) < abs(d) and p * d > 0]
    return [(before.t + s * h, before.value + s * (rise + s * (b / 2 + s * a / 3))) for s in parts]
