"""The largest values between the rows of a run, of quantities that are linear in the state.

Their rates are known at both ends of a step. Where the cubic of the ends rises beyond all rows the step is made again,
and the turning point found by the method's own states.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.steps import Derivative, State
from tmmcalc.machine.transient.equations import derivative
from tmmcalc.machine.transient.jacobian import jacobian
from tmmcalc.machine.transient.run import Run
from tmmcalc.machine.transient.turning import Point, settled, turnings

NOISE = 1e-13  # relative: a turning point that is beyond the rows by less is not looked at
LOOKS = 8  # steps that are made again for one quantity
Key = Callable[[Any], Any]  # of a number, or of numbers one by one


class Reading(NamedTuple):
    """A quantity that is linear in the state, c y_i + k (y_a - y_b)."""

    i: int
    c: float = 1.0
    k: float = 0.0
    a: int = 0
    b: int = 0

    def of(self, y: State) -> float:
        """Its value in a state, its rate of the state's rates."""
        value = self.c * y[self.i]
        return value + self.k * (y[self.a] - y[self.b]) if self.k else value


class Found(NamedTuple):
    """The largest value of a quantity, its time, and what it may be larger by."""

    value: float = 0.0
    time: float = 0.0
    gap: float = 0.0


def jumps(run: Run) -> list[int]:
    """The rows before each at which another regime begins."""
    rows = run.rows
    return [k for k in range(len(rows) - 1) if rows[k + 1].regime is not rows[k].regime]


def farthest(run: Run, reading: Reading, course: tuple[Values, Values, Values], key: Key, lost: list[int]) -> Found:
    """Where the ``key`` (abs, or the value with a sign) of a quantity is largest, in any of its steps.

    ``course`` are times, values and rates at the rows (S,). Steps after the rows ``lost`` are always made again:
    the state at their ends is not that of the next row. The gap is what a step may have beyond the value: of one made
    again by its own gap, of any other by its cubic, of a lost one that cannot be made again by its tangent.
    """
    t, values, rates = course
    best = int(np.argmax(key(values)))
    found = Found(float(values[best]), float(t[best]))
    if len(t) < 2:
        return found
    tops, first = _tops(run, reading, course, key), list(lost)
    tops[lost] = [key(values[k] + (t[k + 1] - t[k]) * rates[k]) for k in lost]
    reach = key(found.value)
    for _ in range(LOOKS + len(lost)):
        k = first.pop() if first else int(np.argmax(tops))
        if k not in lost and tops[k] <= key(found.value) + NOISE * abs(found.value):
            break
        again = _again(run, reading, k, key)
        reach = max(reach, key(again.value) + again.gap if again else float(tops[k]))
        found = again if again and key(again.value) > key(found.value) else found
        tops[k] = -np.inf
    return found._replace(gap=max(reach, float(tops.max())) - key(found.value))


def _tops(run: Run, reading: Reading, course: tuple[Values, Values, Values], key: Key) -> Values:
    """The largest key of the turning points of the cubics of all steps (S - 1,); -inf where none turns back."""
    t, values, rates = course
    ends = rates[1:].copy()
    for k in jumps(run):
        row, after = run.rows[k], run.rows[k + 1]
        ends[k] = reading.of(derivative(run.system, row.regime, run.stretch(row.regime))(after.t, after.y))
    h, gained = np.diff(t), np.diff(values)
    rise, fall = h * rates[:-1], h * ends
    tops = np.full(len(h), -np.inf)
    low, high = np.minimum(0, 3 * gained), np.maximum(0, 3 * gained)
    bends = np.minimum(rise, fall) < low
    bends |= np.maximum(rise, fall) > high
    for k in np.flatnonzero(bends).tolist():
        ends_of = Point(t[k], values[k], rates[k]), Point(t[k + 1], values[k + 1], ends[k])
        tops[k] = max((key(value) for _, value in turnings(*ends_of)), default=-np.inf)
    return tops


def _again(run: Run, reading: Reading, k: int, key: Key) -> Found | None:
    """The largest key in the step after row k, made again; None if that fails."""
    row, end, stepper = run.rows[k], run.rows[k + 1].t, run.stepper
    f = derivative(run.system, row.regime, run.stretch(row.regime))
    found: list[Found] = []
    try:
        stepper.begin(f, jacobian(run.system, run.ways.of(row.regime.way), row.regime, f), row.t, row.y, end)
        while stepper.t < end:
            stepper.step()
            found += _within(run, f, reading)
    except AccuracyError:
        return None
    return max(found, key=lambda each: key(each.value))


def _within(run: Run, f: Derivative, reading: Reading) -> list[Found]:
    """The end and the turning points of the last step."""
    stepper, of = run.stepper, reading.of
    ends = (
        Point(stepper.t0, of(stepper.y0), of(stepper.rate0)),
        Point(stepper.t, of(stepper.y), of(stepper.rate)),
    )
    found = [Found(ends[1].value, ends[1].t)]
    for at, _ in turnings(*ends):
        point, moved, _ = settled(stepper, f, of, ends, at)
        found.append(Found(point.value, point.t, moved))
    return found
