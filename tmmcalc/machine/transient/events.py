"""Events inside a step: what is watched, and the exact time at which it happens."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

from tmmcalc.machine.transient.steppers import Stepper
from tmmcalc.machine.transient.steps import State

ITERATIONS = 60
SAME = 8  # units in the last place of the time within which two events happen at once
Gap = Callable[[State], float]


class Watch(NamedTuple):
    """Something that happens when a ``gap`` goes from negative to zero."""

    kind: str
    gap: Gap
    component: int = -1  # of the state that is compared with ``level``; -1: the gap is another function
    level: float = 0.0
    direction: float = 1.0  # 1: happens when the component rises to the level, -1: when it falls
    group: int = -1  # the group of masses that is released
    halts: bool = True  # the motion is another one afterwards; otherwise it is only noted


class Hit(NamedTuple):
    """A watch and the moment at which it happened."""

    watch: Watch
    t: float
    y: State


def level(kind: str, index: int, at: float, direction: float, *, halts: bool = True) -> Watch:
    """Watch one component of the state reach a level."""
    return Watch(kind, lambda y: direction * (y[index] - at), index, at, direction, halts=halts)


def hits(watches: list[Watch], stepper: Stepper) -> list[Hit]:
    """What happened in the last step, in the order of time, up to the first that halts and what comes with it."""
    found = [hit for watch in watches if (hit := _hit(watch, stepper))]
    if len(found) < 2:
        return found
    found.sort(key=lambda hit: hit.t)
    end = next((hit.t for hit in found if hit.watch.halts), math.inf)
    return [hit for hit in found if hit.t <= end + SAME * math.ulp(hit.t)]


def _hit(watch: Watch, stepper: Stepper) -> Hit | None:
    if watch.component < 0:
        before = watch.gap(stepper.y0)
        after = watch.gap(stepper.y) if before < 0 else -1.0
        return _locate(watch, stepper, stepper.t, before, after) if after >= 0 else None
    i, sign = watch.component, watch.direction
    before = sign * (stepper.y0[i] - watch.level)
    if before >= 0:
        return None
    after = sign * (stepper.y[i] - watch.level)
    if after >= 0:
        return _locate(watch, stepper, stepper.t, before, after)
    if sign * stepper.rate0[i] > 0 > sign * stepper.rate[i]:
        return _touch(watch, stepper, before, after)
    return None


def _touch(watch: Watch, stepper: Stepper, before: float, after: float) -> Hit | None:
    """A level reached and left again within one step, which the cubic of both ends tells."""
    h = stepper.t - stepper.t0
    rise, fall = (watch.direction * h * rate[watch.component] for rate in (stepper.rate0, stepper.rate))
    # a cubic rises above its ends by no more than a third of its largest slope
    if max(rise, -fall) < -3 * max(before, after):
        return None
    # derivative of the cubic of Hermite: a s^2 + b s + rise
    a, b = 3 * (rise + fall - 2 * (after - before)), 2 * (3 * (after - before) - 2 * rise - fall)
    root = math.sqrt(max(b * b - 4 * a * rise, 0.0))
    middle = stepper.t0 + 2 * rise / (root - b) * h
    top = watch.gap(stepper.to(middle))
    return _locate(watch, stepper, middle, before, top) if top >= 0 else None


def _locate(watch: Watch, stepper: Stepper, end: float, before: float, after: float) -> Hit:
    """The time between the beginning of the last step and ``end`` at which the gap closes, to rounding.

    Secants through the two latest points, kept inside the bracket by halving it.
    """
    low, high = stepper.t0, end
    last, gap_last = low, before
    t, gap = high, after
    y = stepper.y if end == stepper.t else stepper.to(end)
    for _ in range(ITERATIONS):
        if gap == 0:
            break
        new = t - gap * (t - last) / (gap - gap_last) if gap != gap_last else math.inf
        if not low < new < high:
            new = low + (high - low) / 2
        if abs(new - t) <= 2 * math.ulp(t) or not low < new < high:
            break
        last, gap_last = t, gap
        t, y = new, stepper.to(new)
        gap = watch.gap(y)
        low, high = (t, high) if gap < 0 else (low, t)
    return Hit(watch, t, y)
