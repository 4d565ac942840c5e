"""The closure of a function generator as linear equations in three coefficients, and its exact solutions.

With u the offset of the crank and v that of the output, row j is [p(phi_j, psi_j), q, w] K = h. Three points give K for
every pair of offsets; a fourth is a root in one offset, and with a fifth both are roots, sought by Newton's method from
a grid of starts.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.plane import Real
from tmmcalc.linkage.synthesis.task import FunctionTask

TURN = 2 * np.pi
STEPS = 40  # of Newton's method
TIGHT = 1e-11  # residual of an exact solution, rows of unit size
SATISFIED = 1e-8  # of the terms of a row: more is left of a point that is not met
REACH = 4.0  # offsets of a slider's place that are tried, in ranges of its travel


class Closure(NamedTuple):
    """The wanted motion without its offsets, and the offsets that are given."""

    inputs: Real  # (n,)
    outputs: Real  # (n,)
    fine: tuple[Real, Real]  # (m,) inputs and outputs where the error is taken
    slides: bool
    given: tuple[float | None, float | None]
    frame: float
    unit: float  # by which a slider's places are divided; 1 for angles

    def system(self, u: Real, v: Real, rows: slice = slice(None)) -> tuple[Real, Real]:
        """Matrices (k, n, 3) and right sides (k, n) at offsets u, v (k,)."""
        phi, psi = self.inputs[rows] + u[:, None], self.outputs[rows] + v[:, None]
        if self.slides:
            matrix = np.stack((psi * np.cos(phi), np.sin(phi), -np.ones_like(phi)), axis=-1)
            return matrix, psi**2
        return np.stack((np.cos(psi), -np.cos(phi), np.ones_like(phi)), axis=-1), np.cos(phi - psi)


class Coefficients(NamedTuple):
    """Coefficients K (k, 3) at offsets (k, 2)."""

    coefficients: Real
    offsets: Real


def exact_points(closure: Closure) -> int:
    """How many points can be met exactly: three, and one for every offset that is free."""
    return 3 + sum(offset is None for offset in closure.given)


def closure_of(asked: FunctionTask) -> Closure:
    """The closure of a task; a slider's places are scaled to the travel."""
    slides = asked.mechanism == "slider_crank"
    unit = float(np.ptp(asked.outputs)) or 1.0 if slides else 1.0
    start = asked.output_start
    fine = (asked.fine_inputs, asked.fine_outputs / unit)
    if not len(asked.fine_inputs):
        fine = (asked.inputs, asked.outputs / unit)
    given = (asked.input_start, start if start is None else start / unit)
    return Closure(asked.inputs, asked.outputs / unit, fine, slides, given, asked.frame, unit)


def solved_exactly(closure: Closure, grid: int) -> Coefficients:
    """All exact solutions on the grid of offsets that are left free, or at the roots where they are not."""
    count = len(closure.inputs)
    u, v = (values.ravel() for values in np.meshgrid(*offsets(closure, grid), indexing="ij"))
    if count > 3:
        u, v = _one_root(closure, grid) if count == 4 else _both_roots(closure, grid // 2)
    return _kept(closure, coefficients(closure, u, v))


def _kept(closure: Closure, found: Coefficients) -> Coefficients:
    """Those that meet all points: the determinants vanish too where three points say the same."""
    matrix, right = closure.system(*found.offsets.T)
    open_ = np.abs(np.einsum("kni,ki->kn", matrix, found.coefficients) - right)
    terms = np.einsum("kni,ki->kn", np.abs(matrix), np.abs(found.coefficients)) + np.abs(right)
    good = np.all(open_ <= SATISFIED * terms, axis=1)
    return Coefficients(found.coefficients[good], found.offsets[good])


def offsets(closure: Closure, grid: int) -> tuple[Real, Real]:
    """Values of both offsets that are tried."""
    angles = TURN * (np.arange(grid) + 0.5) / grid
    places = REACH * np.linspace(-1, 1, grid)
    u, v = closure.given
    return (
        angles if u is None else np.array([u]),
        (places if closure.slides else angles) if v is None else np.array([v]),
    )


def coefficients(closure: Closure, u: Real, v: Real) -> Coefficients:
    """Coefficients in the least squares, exact for three points; singular systems are left out."""
    matrix, right = closure.system(u, v)
    normal = np.einsum("kni,knj->kij", matrix, matrix)
    regular = np.abs(np.linalg.det(normal)) > 1e-16
    matrix, right = matrix[regular], right[regular]
    solved = np.linalg.pinv(matrix) @ right[..., None]
    solved += np.linalg.pinv(matrix) @ (right[..., None] - matrix @ solved)
    places = np.stack((u[regular], v[regular]), axis=1)
    return Coefficients(solved[..., 0], places)


def _gaps(closure: Closure, u: Real, v: Real) -> Real:
    """Determinants (k, n - 3) of three points and each further one: rows with right sides, zero if all are met."""
    matrix, right = closure.system(u, v)
    whole = np.concatenate((matrix, right[..., None]), axis=2)
    whole = whole / np.linalg.norm(whole, axis=2, keepdims=True)
    return np.stack([np.linalg.det(whole[:, [0, 1, 2, last]]) for last in range(3, whole.shape[1])], axis=1)


def _one_root(closure: Closure, grid: int) -> tuple[Real, Real]:
    """Offsets at which four points are met: roots along one free offset, with the other at its value or on its grid."""
    found = []
    for axis in (0, 1):
        if closure.given[axis] is None:
            fixed = offsets(closure, grid)[1 - axis]
            found.append(_along(closure, axis, offsets(closure, 4 * grid)[axis], fixed))
    u, v = (np.concatenate(parts) for parts in zip(*found, strict=True))
    return u, v


def _along(closure: Closure, axis: int, moving: Real, fixed: Real) -> tuple[Real, Real]:
    """Roots of the gap along one offset, for every value of the other."""
    moving = np.append(moving, 2 * moving[-1] - moving[-2])
    cells = len(moving) - 1
    low, high = np.tile(moving[:-1], len(fixed)), np.tile(moving[1:], len(fixed))
    other = np.repeat(fixed, cells)

    def gap(at: Real, which: np.ndarray) -> Real:
        places = (at, other[which]) if axis == 0 else (other[which], at)
        return _gaps(closure, *places)[:, 0]

    every = np.arange(len(low))
    change = np.flatnonzero(np.signbit(gap(low, every)) != np.signbit(gap(high, every)))
    roots = bracketed(lambda at, which: gap(at, change[which]), low[change], high[change])
    return (roots, other[change]) if axis == 0 else (other[change], roots)


def _both_roots(closure: Closure, grid: int) -> tuple[Real, Real]:
    """Offsets at which five points are met, by Newton's method from all starts of a grid at once."""
    u, v = np.meshgrid(*offsets(closure, grid), indexing="ij")
    x = np.stack((u.ravel(), v.ravel()), axis=1)

    def gaps(at: Real) -> Real:
        return _gaps(closure, at[:, 0], at[:, 1])

    h = 1e-7
    for _ in range(STEPS):
        f = gaps(x)
        slopes = np.stack([(gaps(x + h * e) - gaps(x - h * e)) / (2 * h) for e in np.eye(2)], axis=2)
        det = np.linalg.det(slopes)
        safe = np.abs(det) > 1e-18
        step = np.zeros_like(x)
        step[safe] = np.linalg.solve(slopes[safe], f[safe][..., None])[..., 0]
        size = np.max(np.abs(step), axis=1, keepdims=True)
        x = x - step * np.minimum(1.0, 0.3 / np.maximum(size, 1e-300))
    good = np.all(np.isfinite(x), axis=1)
    x = x[good]
    good = np.max(np.abs(gaps(x)), axis=1) < TIGHT
    x = x[good]
    if not closure.slides:
        x = np.mod(x, TURN)
    else:
        x[:, 0] = np.mod(x[:, 0], TURN)
    return _distinct(x)


def _distinct(x: Real) -> tuple[Real, Real]:
    """Roots (k, 2) without copies."""
    kept: list[int] = []
    for k in range(len(x)):
        if all(np.max(np.abs(x[k] - x[j])) > 1e-6 for j in kept):
            kept.append(k)
    return x[kept, 0], x[kept, 1]
