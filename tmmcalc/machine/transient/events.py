"""Events inside a step: what is watched, and the exact time at which it happens."""

from __future__ import annotations

import math
from collections.abc import Callable
from operator import itemgetter
from typing import NamedTuple

from tmmcalc.core.numerics.steps import Derivative, State
from tmmcalc.machine.transient.steppers import Stepper
from tmmcalc.machine.transient.turning import Point, settled, turnings

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
        return _locate(watch, stepper, (stepper.t0, before), (stepper.t, after)) if after >= 0 else None
    i, sign = watch.component, watch.direction
    before, after = sign * (stepper.y0[i] - watch.level), sign * (stepper.y[i] - watch.level)
    if before < 0 <= after:
        return _locate(watch, stepper, (stepper.t0, before), (stepper.t, after))
    if before < 0 and sign * stepper.rate0[i] > 0 > sign * stepper.rate[i]:
        return _touch(watch, stepper, before, after)
    if before == 0 < after and sign * stepper.rate0[i] < 0 < sign * stepper.rate[i]:
        return _return(watch, stepper, after)
    return None


def extreme(stepper: Stepper, f: Derivative, component: int) -> tuple[Point, State] | None:
    """Where a component turns back within the last step, and a state beside it."""
    i = component
    if stepper.rate0[i] * stepper.rate[i] >= 0:
        return None
    found, _, y = settled(stepper, f, itemgetter(i), _ends(stepper, i), _middle(stepper, i))
    return found, y


def _middle(stepper: Stepper, component: int) -> float:
    """The time at which the cubic through both ends of the step turns back, for slopes of different sign."""
    # without a turning point, where the squares of the slopes underflow, it is the end
    return next((at for at, _ in turnings(*_ends(stepper, component))), stepper.t)


def _ends(stepper: Stepper, i: int) -> tuple[Point, Point]:
    return Point(stepper.t0, stepper.y0[i], stepper.rate0[i]), Point(stepper.t, stepper.y[i], stepper.rate[i])


def _touch(watch: Watch, stepper: Stepper, before: float, after: float) -> Hit | None:
    """A level reached and left again within one step, which the cubic of both ends tells."""
    slope = (stepper.t - stepper.t0) * max(abs(rate[watch.component]) for rate in (stepper.rate0, stepper.rate))
    # a cubic rises above its ends by no more than a third of its largest slope
    if slope < -3 * max(before, after):
        return None
    middle = _middle(stepper, watch.component)
    top = watch.gap(stepper.to(middle))
    return _locate(watch, stepper, (stepper.t0, before), (middle, top)) if top >= 0 else None


def _return(watch: Watch, stepper: Stepper, after: float) -> Hit | None:
    """A level left at the beginning of the step and reached again before its end."""
    middle = _middle(stepper, watch.component)
    bottom = watch.gap(stepper.to(middle))
    return _locate(watch, stepper, (middle, bottom), (stepper.t, after)) if bottom < 0 else None


def _locate(watch: Watch, stepper: Stepper, begin: tuple[float, float], end: tuple[float, float]) -> Hit:
    """The time within the last step at which the gap closes, to rounding, between two times with their gaps.

    Secants through the two latest points, kept inside the bracket by halving it.
    """
    (last, gap_last), (t, gap) = begin, end
    low, high = last, t
    y = stepper.y if t == stepper.t else stepper.to(t)
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
