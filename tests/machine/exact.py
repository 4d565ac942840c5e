"""Steady motions in extended precision, independent of the program: Chebyshev collocation for the speed itself.

    J omega domega/dtheta = M_d + M + c omega - J' omega^2 / 2,   tau omega dM_d/dtheta = M_static(omega) - M_d

The unknown is the difference w from a reference speed, and the motor a function of it, so that a steep motor costs no
digits; the functions of the cycle are formulas, evaluated in extended precision at the points. Newton's method has its
residual in extended and its matrices in double precision. Panels are halved until they resolve the solution.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np

WIDE = np.longdouble
PI = 4 * np.arctan(WIDE(1))
RESOLVED = 3e-17  # last coefficients, relative
SETTLED = 1e-12  # relative step of Newton's method from which on it is left to rounding
Function = Callable[[Any], Any]


def chebyshev(n: int) -> tuple[Any, Any, Any]:
    """Points on [0, 1] with both ends, barycentric weights, differentiation matrix; all (n + 1,) in extended."""
    t: Any = -np.cos(PI * np.arange(n + 1, dtype=WIDE) / n)
    weights: Any = WIDE(-1) ** np.arange(n + 1)
    weights[[0, -1]] /= 2
    gap = t[:, None] - t + np.eye(n + 1)
    matrix = weights / weights[:, None] / gap
    np.fill_diagonal(matrix, 0)
    np.fill_diagonal(matrix, -matrix.sum(axis=1))
    return (t + 1) / 2, weights, 2 * matrix


def gauss(n: int) -> tuple[Any, Any]:
    """Points and weights on [0, 1] in extended precision: the roots of P_n polished by Newton's method."""
    x: Any = np.polynomial.legendre.leggauss(n)[0].astype(WIDE)
    for _ in range(3):
        below, p = np.ones_like(x), x
        for k in range(1, n):
            below, p = p, ((2 * k + 1) * x * p - k * below) / (k + 1)
        slope = n * (x * p - below) / (x * x - 1)
        x = x - p / slope
    return (x + 1) / 2, 1 / ((1 - x * x) * slope * slope)


class Exact:
    """A steady motion: ``inertia`` in all, ``bend`` dJ/dtheta, ``load``, a motor, from a first guess of the speed.

    ``moment`` and ``slope`` of the motor are functions of w = omega - ``reference``.
    """

    def __init__(
        self,
        inertia: Function,
        bend: Function,
        load: Callable[[Any, Any], Any],
        moment: Function,
        slope: Function,
        reference: float,
        guess: Function,
        *,
        jumps: tuple[float, ...] = (),
        viscous: float = 0.0,
        lag: float = 0.0,
        widest: float = np.pi / 12,
        order: int = 20,
    ) -> None:
        self.moment, self.slope, self.lag, self.reference = moment, slope, lag, WIDE(reference)
        self.order, self.viscous, self._given = order, WIDE(viscous), (inertia, bend, load)
        self.t, self.weights, self.matrix = chebyshev(order)
        self._on(cut(jumps, widest))
        w = guess(self._x.astype(float)).astype(WIDE) - self.reference
        self.y = np.stack([w] if not lag else [w, moment(w)])  # (m, K, n + 1)
        for _ in range(14):
            self._solve()
            rough = self._rough()
            if not rough.any():
                return
            self._split(rough)
        raise RuntimeError("the panels do not resolve the motion")

    def _on(self, edges: Any) -> None:
        """The functions of the cycle on other panels."""
        self.edges, self.h = edges, edges[1:] - edges[:-1]
        self._x = edges[:-1, None] + self.h[:, None] * self.t
        middle = (edges[:-1] + edges[1:])[:, None] / 2  # tells on which side of a jump an edge lies
        inertia, bend, load = self._given
        self.inertia, self.bend, self.load = inertia(self._x), bend(self._x), load(self._x, middle)

    def _rough(self) -> Any:
        """Panels (K,) whose last Chebyshev coefficients are not negligible."""
        n = self.order
        k = np.arange(n + 1)
        halves = np.where((k == 0) | (k == n), 2, 1)
        last = [2 * np.cos(PI * j * (n - k) / n) / n / halves / halves[j] for j in (n - 2, n - 1, n)]
        tail = np.max(np.abs(self.y @ np.array(last).T), axis=2)
        return np.any(tail > RESOLVED * np.max(np.abs(self.y), axis=(1, 2))[:, None], axis=0) & (self.h > 1e-11)

    def _split(self, rough: Any) -> None:
        """Halve panels; the solution moves along."""
        middle = ((self.edges[:-1] + self.edges[1:]) / 2)[rough]
        edges = np.sort(np.concatenate((self.edges, middle)))
        parent = np.searchsorted(self.edges, (edges[:-1] + edges[1:]) / 2) - 1
        old, before, width = self.y, self.edges, self.h
        self._on(edges)
        t = (self._x - before[parent][:, None]) / width[parent][:, None]
        gap = t[..., None] - self.t
        hit = gap == 0
        part = np.where(hit.any(axis=-1, keepdims=True), hit, self.weights / np.where(hit, 1, gap))
        part = part / part.sum(axis=-1, keepdims=True)
        self.y = np.einsum("kij,akj->aki", part, old[:, parent])

    def _solve(self) -> None:
        best = np.inf
        for _ in range(60):
            change, size = self._newton()
            step = float(max(np.max(np.abs(change), axis=(1, 2)) / size))
            self.y = self.y + (change if step < 1e3 else 1e3 / step * change)
            if step > 0.5 * best and best < SETTLED:
                return
            best = min(step, best)
        raise RuntimeError(f"Newton's method left {best:.2g}")

    def rates(self) -> tuple[Any, Any]:
        """f (m, K, n + 1) and df/dy (m, m, K, n + 1)."""
        omega = self.reference + self.y[0]
        static, fall = self.moment(self.y[0]), self.slope(self.y[0])
        drive = self.y[1] if self.lag else static
        per = 1 / (self.inertia * omega)
        net = drive + self.load + self.viscous * omega - self.bend * omega * omega / 2
        f, j = np.empty_like(self.y), np.zeros((len(self.y), *self.y.shape), WIDE)
        f[0] = net * per
        j[0, 0] = (self.viscous - self.bend * omega) * per - f[0] / omega
        if not self.lag:
            j[0, 0] += fall * per
            return f, j
        pace = 1 / (self.lag * omega)
        f[1] = (static - drive) * pace
        j[0, 1], j[1, 0], j[1, 1] = per, fall * pace - f[1] / omega, -pace
        return f, j

    def _newton(self) -> tuple[Any, Any]:
        f, j = self.rates()
        m, count, n = len(self.y), len(self.h), self.order
        residual = f[:, :, 1:] - (self.y @ self.matrix.T)[:, :, 1:] / self.h[:, None]
        steep = (self.matrix.astype(float)[None] / self.h.astype(float)[:, None, None])[:, 1:]
        system = np.zeros((count, n, m, n + 1, m))
        for a in range(m):
            system[:, :, a, :, a] = steep
            for b in range(m):
                spots = np.arange(n)
                system[:, spots, a, spots + 1, b] -= j[a, b, :, 1:].T.astype(float).T
        square = system[:, :, :, 1:].reshape(count, n * m, n * m)
        right = np.concatenate(
            (residual.transpose(1, 2, 0).reshape(count, n * m, 1), -system[:, :, :, 0].reshape(count, n * m, m)), axis=2
        )
        solved = np.linalg.solve(square, right.astype(float)).reshape(count, n, m, 1 + m)
        # jumps between panels are closed too: start of a panel = end of the one before
        gaps = (np.roll(self.y[:, :, -1], 1, axis=1) - self.y[:, :, 0]).astype(float)  # (m, K)
        total, shift = np.eye(m), np.zeros(m)
        chain = []
        for k in range(count):
            if k:
                shift = shift + gaps[:, k]
            chain.append((total, shift))
            end = solved[k, -1]
            total, shift = end[:, 1:] @ total, end[:, 0] + end[:, 1:] @ shift
        first = np.linalg.solve(np.eye(m) - total, shift + gaps[:, 0])
        change = np.empty((m, count, n + 1), WIDE)
        for k, (gain, off) in enumerate(chain):
            start = gain @ first + off
            change[:, k, 0] = start
            change[:, k, 1:] = (solved[k, :, :, 0] + solved[k, :, :, 1:] @ start).T
        return change, np.maximum(np.max(np.abs(self.y), axis=(1, 2)), WIDE(1e-300))

    def _matrix(self, theta: Any, before: bool = False) -> tuple[Any, Any]:
        k = np.clip(np.searchsorted(self.edges, theta, "left" if before else "right") - 1, 0, len(self.h) - 1)
        gap = ((theta - self.edges[k]) / self.h[k])[:, None] - self.t
        hit = gap == 0
        part = self.weights / np.where(hit, 1, gap)
        some = hit.any(axis=1)
        part[some] = hit[some]
        return k, part / part.sum(axis=1)[:, None]

    def at(self, values: Any, theta: Any) -> Any:
        """A function (K, n + 1) at angles (m,)."""
        k, part = self._matrix(np.asarray(theta, WIDE))
        return np.einsum("mn,mn->m", values[k], part)

    @property
    def omega(self) -> Any:
        """Speed (K, n + 1)."""
        return self.reference + self.y[0]

    @property
    def driving(self) -> Any:
        """Driving moment (K, n + 1)."""
        return self.y[1] if self.lag else self.moment(self.y[0])

    @property
    def acceleration(self) -> Any:
        """Angular acceleration (K, n + 1) from the slope of the polynomials."""
        return self.omega * (self.y[0] @ self.matrix.T) / self.h[:, None]

    def extremes(self) -> tuple[Any, Any]:
        """Least and largest w: of the panels that come near, the best of many points moved on by Newton's method."""
        t = np.linspace(0, 1, 101, dtype=WIDE)
        values, slopes = self.y[0], self.y[0] @ self.matrix.T
        bends = slopes @ self.matrix.T
        found = []
        for sign in (-1, 1):
            many = sign * values @ self._inside(t).T
            tops = []
            for k in np.flatnonzero(many.max(axis=1) > many.max() - 0.01 * np.ptp(many)):
                s, best = t[np.argmax(many[k])], many[k].max()
                for _ in range(5):
                    at = self._inside(np.array([s]))[0]
                    bend = bends[k] @ at
                    s = min(max(s - (slopes[k] @ at) / bend, WIDE(0)), WIDE(1)) if bend else s
                    best = max(best, sign * values[k] @ self._inside(np.array([s]))[0])
                tops.append(best)
            found.append(sign * max(tops))
        return found[0], found[1]

    def _inside(self, t: Any) -> Any:
        """Interpolation (m, n + 1) from the points of a panel to parts ``t`` (m,) of it."""
        gap = t[:, None] - self.t
        hit = gap == 0
        part = np.where(hit.any(axis=1, keepdims=True), hit, self.weights / np.where(hit, 1, gap))
        return part / part.sum(axis=1, keepdims=True)

    @property
    def delta(self) -> Any:
        """Coefficient of speed fluctuation."""
        low, high = self.extremes()
        return (high - low) / (self.reference + (high + low) / 2)

    def total(self, values: Any) -> Any:
        """Integral of a function (K, n + 1) over the cycle."""
        points, weights = gauss(24)
        return np.sum((values @ self._inside(points).T @ weights) * self.h)

    @property
    def cycle_time(self) -> Any:
        """Time of a cycle."""
        return self.total(1 / self.omega)


def cut(jumps: tuple[float, ...], widest: float) -> Any:
    """Panels of a turn between jumps."""
    ends = np.unique([0.0, *jumps, 2 * np.pi]).astype(WIDE)
    edges = [ends[:1]]
    for a, b in pairwise(ends):
        count = int(np.ceil(float(b - a) / widest))
        own = a + (b - a) * np.arange(1, count + 1) / WIDE(count)
        own[-1] = b
        edges.append(own)
    return np.concatenate(edges)
