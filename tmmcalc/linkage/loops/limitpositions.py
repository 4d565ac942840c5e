"""Where the input turns back: the limit position beyond the last regular place of a branch, exactly.

The unknown that moves fastest takes over as the variable p. With it the place (q, x) is regular through the limit, and
dx/dp vanishes there.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.systems import solve
from tmmcalc.core.plane import Real
from tmmcalc.linkage.loops.closure import Loops

FORWARD = 60  # steps of p towards the limit
REFINED = 60  # and to narrow it down
FIRST = 1e-5  # first step of p, in radians or parts of the group's size
NEWTON = 12
SETTLED = 1e-9  # step of Newton that rounding may keep it from undercutting
EXACT = 1e-13
FLAT = 1e-14  # dx/dp that is zero


class _Pinned(NamedTuple):
    """The place (q, x) (N + 1,) where the variable has the value p, and its derivative by p."""

    p: float
    y: Real
    slope: Real

    @property
    def rate(self) -> float:
        """dx/dp."""
        return float(self.slope[-1])


def turning(at: Callable[[Real], Loops], x: float, q: Real, q1: Real, sense: float, size: Real) -> float:
    """The input coordinate of the limit beyond x in this sense; q, q1 (N,) are the unknowns there with their rates.

    Where the branch does not turn back, because the last place is singular itself, it is x.
    """
    m = int(np.argmax(np.abs(q1) / size))
    here = _Pinned(float(q[m]), np.append(q, x), np.append(q1, 1.0) / q1[m])
    step = FIRST * float(size[m]) * math.copysign(1.0, sense * q1[m])
    for _ in range(FORWARD):
        found = _pinned(at, here.y + step * here.slope, m, here.p + step)
        if found is None:
            step /= 4
            continue
        if found.rate * here.rate <= 0:
            return _refined(at, here, found, m)
        here, step = found, step * 1.5
    return x


def _refined(at: Callable[[Real], Loops], a: _Pinned, b: _Pinned, m: int) -> float:
    """The input coordinate between two places where dx/dp vanishes, by a safeguarded secant."""
    for _ in range(REFINED):
        width = abs(b.p - a.p)
        if min(abs(a.rate), abs(b.rate)) < FLAT or width <= FLAT * max(1.0, abs(a.p)):
            break
        low, high = min(a.p, b.p) + 1e-3 * width, max(a.p, b.p) - 1e-3 * width
        p = min(max(b.p - b.rate * (b.p - a.p) / (b.rate - a.rate), low), high)
        found = _pinned(at, a.y + (b.y - a.y) * (p - a.p) / (b.p - a.p), m, p)
        if found is None:
            break
        a, b = (a, found) if found.rate * a.rate <= 0 else (found, b)
    return float(min(a, b, key=lambda place: abs(place.rate)).y[-1])


def _pinned(at: Callable[[Real], Loops], y: Real, m: int, p: float) -> _Pinned | None:
    """Newton from y (N + 1,) with unknown m held at p; None if it does not converge."""
    y = y.copy()
    y[m] = p
    others = [k for k in range(len(y)) if k != m]
    for count in range(NEWTON):
        loops = at(y[-1:])
        placed = loops.place(y[:-1, None])
        columns = np.concatenate((placed.jacobian[..., 0], loops.by_drive(placed)), axis=1)
        left = np.concatenate((placed.residual.real, placed.residual.imag))
        if not (np.isfinite(columns).all() and np.isfinite(left).all()):
            return None
        step = solve(columns[:, others, None], -left)[:, 0]
        y[others] += step
        largest = float(np.max(np.abs(step)))
        if largest < EXACT * max(1.0, float(np.max(np.abs(y)))) or (largest < SETTLED and count > NEWTON // 2):
            slope = np.ones(len(y))
            slope[others] = solve(columns[:, others, None], -columns[:, m, None])[:, 0]
            return _Pinned(p, y, slope)
    return None
