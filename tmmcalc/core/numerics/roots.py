"""Many bracketed roots at once: Chandrupatla's method, vectorised.

Every iteration evaluates all unfinished problems in one call, so a function that is cheap on arrays
(a whole mechanism) is called about ten times however many roots there are.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.extended import EPS

Values = NDArray[np.floating[Any]]
Indices = NDArray[np.intp]
Problems = Callable[[Values, Indices], Values]

ITERATIONS = 120  # bisection alone needs 64 halvings of a double


def bracketed(
    f: Problems,
    low: Values,
    high: Values,
    *,
    absolute: float = 0.0,
    known: tuple[Values, Values, Values] | None = None,
    level: float = 0.0,
) -> Values:
    """Roots of m functions, each with a change of sign between ``low`` and ``high``; arrays of shape (m,).

    ``f(x, which)`` returns the values at ``x`` of the problems numbered ``which``. The result is exact to
    2 ulp of the root plus ``absolute``. An end that is a root itself is returned; so is the end nearer to zero
    where the signs do not differ, because one end is a root but for rounding. ``known`` are the values at ``low`` and
    ``high`` and first guesses between them, where there are any. A place whose value is within ``level`` of 0 is a
    root. Source: T. R. Chandrupatla, Adv. Eng. Software 28 (1997) 145.
    """
    low, high = np.asarray(low, float), np.asarray(high, float)
    every = np.arange(low.size)
    root = np.empty(low.size)
    if not low.size:
        return root
    x1, x2 = high.copy(), low.copy()
    f1, f2 = (f(x1, every), f(x2, every)) if known is None else (known[1], known[0])
    root[:] = np.where(np.abs(f1) < np.abs(f2), x1, x2)
    active = np.flatnonzero(np.signbit(f1) != np.signbit(f2))
    if not active.size:
        return root
    x1, x2, f1, f2 = (v[active] for v in (x1, x2, f1, f2))
    x3, f3 = x2.copy(), f2.copy()
    t = np.full(active.size, 0.5) if known is None else (known[2][active] - x1) / (x2 - x1)
    for _ in range(ITERATIONS):
        x = x1 + t * (x2 - x1)
        fx = f(x, active)
        same = np.signbit(fx) == np.signbit(f1)
        x3, f3 = np.where(same, x1, x2), np.where(same, f1, f2)
        x2, f2 = np.where(same, x2, x1), np.where(same, f2, f1)
        x1, f1 = x, fx
        best = np.where(np.abs(f1) < np.abs(f2), x1, x2)
        zero = np.minimum(np.abs(f1), np.abs(f2)) <= level
        width = np.abs(x2 - x1)
        tolerance = 2 * EPS * np.abs(best) + absolute
        done = zero | (width <= 2 * tolerance)
        root[active[done]] = best[done]
        keep = ~done
        if not keep.any():
            return root
        active = active[keep]
        x1, x2, x3, f1, f2, f3 = (v[keep] for v in (x1, x2, x3, f1, f2, f3))
        t = _step(x1, x2, x3, f1, f2, f3, tolerance[keep] / width[keep])
    root[active] = np.where(np.abs(f1) < np.abs(f2), x1, x2)
    return root


def _step(x1: Values, x2: Values, x3: Values, f1: Values, f2: Values, f3: Values, least: Values) -> Values:
    """Inverse quadratic step where it is safe, the middle elsewhere."""
    with np.errstate(divide="ignore", invalid="ignore"):
        xi, phi = (x1 - x2) / (x3 - x2), (f1 - f2) / (f3 - f2)
        safe = (phi**2 < xi) & ((1 - phi) ** 2 < 1 - xi)
        alpha = (x3 - x1) / (x2 - x1)
        quadratic = f1 / (f2 - f1) * f3 / (f2 - f3) + alpha * f1 / (f3 - f1) * f2 / (f3 - f2)
    t = np.where(safe & np.isfinite(quadratic), quadratic, 0.5)
    return np.asarray(np.minimum(np.maximum(t, least), 1 - least))  # of few values np.clip takes three times it
