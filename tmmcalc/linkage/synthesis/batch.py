"""Many systems of nonlinear equations of one shape from many starts at once: Levenberg's and Marquardt's method.

Slopes are central differences, whose error a residual that vanishes does not feel. After a few steps hopeless
starts are dropped, so that the cost goes into those that converge.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tmmcalc.core.plane import Real

Course = tuple[int, float]  # of an iteration: how many are iterated, the best of them
Equations = Callable[[Real], Real]  # unknowns (k, p) -> residuals (k, q)

STEP = 1e-6  # of the differences, of unknowns of unit size
PATIENCE = (15, 40)  # iterations after which only the better third is kept
ITERATIONS = 100
TIGHT = 1e-13  # a residual this small is a solution


def levenberg(
    f: Equations, x: Real, iterations: int = ITERATIONS, large: float = np.inf, course: list[Course] | None = None
) -> tuple[Real, Real]:
    """Unknowns (k, p), k at most as many as the starts (m, p), and their largest residuals (k,), the least first.

    Unknowns that grow beyond ``large`` are hopeless. ``course`` takes of every iteration how many systems are iterated
    and the least of their largest residuals.
    """
    x = x.copy()
    r = _finite(f(x))
    cost = np.sum(r**2, axis=1)
    damping = np.full(len(x), 1e-2)
    identity = np.eye(x.shape[1])
    for done in range(iterations):
        if done in PATIENCE and len(x) > 60:
            kept = np.argsort(np.where(np.max(np.abs(x), axis=1) > large, np.inf, cost))[: max(len(x) // 3, 60)]
            x, r, cost, damping = x[kept], r[kept], cost[kept], damping[kept]
        active = np.flatnonzero((np.max(np.abs(r), axis=1) > TIGHT) & (damping < 1e12))
        if course is not None:
            course.append((len(active), float(np.min(np.max(np.abs(r), axis=1)))))
        if not active.size:
            break
        slopes = _slopes(f, x[active])
        normal = np.einsum("kqi,kqj->kij", slopes, slopes)
        scale = np.maximum(np.einsum("kii->ki", normal), 1e-12)
        normal += (damping[active, None] * scale)[:, :, None] * identity
        step = np.linalg.solve(normal, -np.einsum("kqi,kq->ki", slopes, r[active])[..., None])[..., 0]
        tried = x[active] + step
        new = _finite(f(tried))
        new_cost = np.sum(new**2, axis=1)
        better = new_cost < cost[active]
        rows = active[better]
        x[rows], r[rows], cost[rows] = tried[better], new[better], new_cost[better]
        damping[active] *= np.where(better, 0.2, 4.0)
        damping = np.maximum(damping, 1e-15)
    near = np.max(np.abs(x), axis=1) <= large
    x, r = x[near], r[near]
    worst = np.max(np.abs(r), axis=1)
    order = np.argsort(worst)
    return x[order], worst[order]


def _finite(r: Real) -> Real:
    return np.nan_to_num(r, nan=1e6, posinf=1e6, neginf=-1e6)


def _slopes(f: Equations, x: Real) -> Real:
    columns = []
    for i in range(x.shape[1]):
        h = STEP * np.maximum(1.0, np.abs(x[:, i]))
        high, low = x.copy(), x.copy()
        high[:, i] += h
        low[:, i] -= h
        columns.append(_finite(f(high) - f(low)) / (2 * h)[:, None])
    return np.stack(columns, axis=2)
