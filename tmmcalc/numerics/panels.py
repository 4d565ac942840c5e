"""Piecewise smooth functions on panels: exact integrals, values, slopes and extremes from Gauss points.

A function of one variable is held by its values at the Gauss-Legendre points of panels whose edges lie at every
jump and kink. No point lies on an edge, so a jump needs no convention. Within a panel the function is the
interpolating polynomial; integrals are exact to its degree and beyond, and the decay of its Legendre
coefficients says how good it is.

Arrays of values have the shape (..., K, N): K panels of N points.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from functools import cache
from itertools import pairwise
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.numerics.roots import bracketed
from tmmcalc.records import record

Values = NDArray[np.floating[Any]]

ORDER = 16  # points of a panel
WIDEST = np.pi / 6  # of a first panel, in the variable's unit
NARROWEST = 2.0**-24  # of the whole range: a panel is not halved below it
PASSES = 40
NEWTON = 4  # steps to an extreme


class Rule(NamedTuple):
    """Gauss-Legendre rule of n points on [0, 1] and the matrices that act on values at its points."""

    points: Values  # (n,)
    weights: Values  # (n,)
    primitive: Values  # (n, n) integral from 0 to each point
    slope: Values  # (n, n) derivative at each point
    barycentric: Values  # (n,)
    coefficients: Values  # (n, n) values -> Legendre coefficients
    ends: Values  # (2, n) interpolation at 0 and 1


@cache
def rule(n: int = ORDER) -> Rule:
    """The rule of n points.

    >>> rule(2).points.round(6).tolist()
    [0.211325, 0.788675]
    """
    k = np.arange(1, n)
    beta = k / np.sqrt(4.0 * k * k - 1)
    t = np.linalg.eigvalsh(np.diag(beta, 1) + np.diag(beta, -1))
    for _ in range(2):  # the eigenvalues carry a few roundings; Newton on P_n removes them
        p = legendre(t, n)
        t = t - p[n] * (t * t - 1) / (n * (t * p[n] - p[n - 1]))
    t = (t - t[::-1]) / 2
    p = legendre(t, n)
    degree = np.arange(n)
    # near the ends 1 - t^2 has lost digits, so weights from the closed formulas would be good to 1e-14 only
    coefficients = np.linalg.inv(p[:n].T)
    weights = coefficients[0] + coefficients[0, ::-1]
    upper = np.vstack((p[1] + 1, (p[2 : n + 1] - p[: n - 1]) / (2 * degree[1:] + 1)[:, None]))
    gap = t[:, None] - t + np.eye(n)
    barycentric = 1 / np.prod(2 * gap, axis=1)
    slope = barycentric / barycentric[:, None] / gap
    np.fill_diagonal(slope, 0.0)
    np.fill_diagonal(slope, -slope.sum(axis=1))
    ends = np.vstack(((-1.0) ** degree, np.ones(n))) @ coefficients
    return Rule((t + 1) / 2, weights / 2, upper.T @ coefficients / 2, 2 * slope, barycentric, coefficients, ends)


def legendre(t: Values, n: int) -> Values:
    """Legendre polynomials of degree 0 to n at t, (n + 1, m)."""
    p = np.empty((n + 1, len(t)))
    p[0], p[1] = 1.0, t
    for k in range(1, n):
        p[k + 1] = ((2 * k + 1) * t * p[k] - k * p[k - 1]) / (k + 1)
    return p


@record
class Panels:
    """Panels of a range by their ascending ``edges`` (K + 1,), with ``order`` points each."""

    edges: Values
    order: int = ORDER

    @property
    def count(self) -> int:
        """Number of panels K."""
        return len(self.edges) - 1

    @property
    def width(self) -> Values:
        """Widths (K,)."""
        return self.edges[1:] - self.edges[:-1]

    @property
    def x(self) -> Values:
        """The points (K, N), ascending."""
        return self.edges[:-1, None] + self.width[:, None] * rule(self.order).points

    def total(self, values: Values) -> Values:
        """Integral over the whole range, (...)."""
        return np.einsum("...kn,n,k->...", values, rule(self.order).weights, self.width)

    def primitive(self, values: Values) -> tuple[Values, Values]:
        """Integral from the first edge to every point (..., K, N) and to every edge (..., K + 1)."""
        r = rule(self.order)
        whole = values @ r.weights * self.width
        edges = np.concatenate((np.zeros((*whole.shape[:-1], 1)), np.cumsum(whole, axis=-1)), axis=-1)
        return edges[..., :-1, None] + values @ r.primitive.T * self.width[:, None], edges

    def primitive_at(self, values: Values, x: Values) -> Values:
        """Integral of one function (K, N) from the first edge to ``x`` (m,) in the range."""
        k = self._panel(x, "right")
        t = (x - self.edges[k]) / self.width[k]
        p = legendre(2 * t - 1, self.order)
        inner = np.vstack((p[1] + 1, (p[2:] - p[:-2]) / (2 * np.arange(1, self.order) + 1)[:, None])) / 2
        coefficients = values @ rule(self.order).coefficients.T
        return self.primitive(values)[1][k] + self.width[k] * np.einsum("mn,nm->m", coefficients[k], inner)

    def slope(self, values: Values) -> Values:
        """Derivative at the points, (..., K, N)."""
        return values @ rule(self.order).slope.T / self.width[:, None]

    def ends(self, values: Values) -> tuple[Values, Values]:
        """Limits at the lower and at the upper edge of every panel, each (..., K)."""
        low, high = rule(self.order).ends
        return values @ low, values @ high

    def at(self, values: Values, x: Values, *, before: bool = False) -> Values:
        """Values (..., m) at ``x`` (m,) in the range; on an edge the limit from above, or from below if ``before``."""
        k = self._panel(x, "left" if before else "right")
        return np.moveaxis(self._inside(np.moveaxis(values, -2, 0), k, x), 0, -1)

    def _panel(self, x: Values, side: Literal["left", "right"]) -> NDArray[np.intp]:
        """Numbers (m,) of the panels that hold ``x`` (m,)."""
        return np.clip(np.searchsorted(self.edges, x, side=side) - 1, 0, self.count - 1)

    def _inside(self, rows: Values, k: NDArray[np.intp], x: Values) -> Values:
        """Interpolate row k (m,) of ``rows`` (K, ..., N) at x (m,): (m, ...)."""
        r = rule(self.order)
        t = (x - self.edges[k]) / self.width[k]
        gap = t[:, None] - r.points
        hit = gap == 0
        part = r.barycentric / np.where(hit, 1.0, gap)
        exact = hit.any(axis=1)
        part[exact] = hit[exact]
        part /= part.sum(axis=1)[:, None]
        return np.einsum("m...n,mn->m...", rows[k], part)

    def turning(self, values: Values) -> tuple[Values, Values]:
        """Places (m,) and values (m,) of all local extremes of one function (K, N), the limits at edges included."""
        slopes = self.slope(values)
        ends = self.ends(slopes)
        row = np.concatenate((ends[0][:, None], slopes, ends[1][:, None]), axis=1)
        t = np.concatenate((self.edges[:-1, None], self.x, self.edges[1:, None]), axis=1)
        k, i = np.nonzero(np.signbit(row[:, 1:]) != np.signbit(row[:, :-1]))
        at = self._level(slopes, k, t[k, i], t[k, i + 1], row[k, i], row[k, i + 1])
        inner = self._inside(values, k, at)
        low, high = self.ends(values)
        return np.concatenate((at, self.edges[:-1], self.edges[1:])), np.concatenate((inner, low, high))

    def _level(self, slopes: Values, k: NDArray[np.intp], low: Values, high: Values, a: Values, b: Values) -> Values:
        """Roots (m,) of rows k of ``slopes`` (K, N) between ``low`` and ``high``, where the values are a and b.

        Newton from the chord ends in four steps nearly everywhere; the rest is bracketed.
        """
        if not len(k):
            return np.empty(0)
        both = np.stack((slopes, self.slope(slopes)), axis=1)
        x = low + (high - low) * (a / np.where(a == b, 1.0, a - b))
        with np.errstate(divide="ignore", invalid="ignore"):
            for _ in range(NEWTON):
                value = self._inside(both, k, x)
                step = np.where(value[:, 0] == 0, 0.0, value[:, 0] / value[:, 1])
                x = np.minimum(np.maximum(x - step, low), high)
        left = np.flatnonzero(np.abs(step) > 1e-12 * (high - low))
        if left.size:
            x[left] = bracketed(lambda s, which: self._inside(slopes, k[left][which], s), low[left], high[left])
        return x

    def extremes(self, values: Values) -> tuple[tuple[float, float], tuple[float, float]]:
        """Smallest and largest value of one function (K, N), each as (value, place)."""
        at, value = self.turning(values)
        low, high = int(np.argmin(value)), int(np.argmax(value))
        return (float(value[low]), float(at[low])), (float(value[high]), float(at[high]))

    def tail(self, values: Values) -> Values:
        """Size (..., K) of the last coefficients: what the polynomial of a panel leaves out, with a margin."""
        last = np.abs(values @ rule(self.order).coefficients[-3:].T)
        return np.maximum(np.maximum(last[..., 0], last[..., 1]), last[..., 2])  # a reduction over three takes twice it

    def split(self, which: NDArray[np.bool_]) -> Panels:
        """The panels with those of ``which`` (K,) halved."""
        middle = (self.edges[:-1] + self.edges[1:])[which] / 2
        return Panels(np.sort(np.concatenate((self.edges, middle))), self.order)


def panels(low: float, high: float, breaks: Iterable[float] = (), widest: float = WIDEST) -> Panels:
    """Panels of [low, high] with an edge at every break inside it, none wider than ``widest``.

    Breaks nearer to each other than the narrowest panel count as one.
    """
    least = NARROWEST * (high - low)
    edges = [low]
    for b in sorted(b for b in breaks if low + least < b < high - least):
        if b - edges[-1] > least:
            edges.append(b)
    edges.append(high)
    parts = [_parts(a, b, widest) for a, b in pairwise(edges)]
    return Panels(np.append(np.concatenate(parts), high))


def _parts(low: float, high: float, widest: float) -> Values:
    """Lower edges of the equal panels of one piece."""
    count = math.ceil((high - low) / widest - 1e-9)
    return low + (high - low) / count * np.arange(count)


def resolved(
    f: Callable[[Values], Values], first: Panels, tolerance: float = 1e-13, scale: Values | None = None
) -> tuple[Panels, Values, float]:
    """Halve panels until every function of ``f(x) -> (F, n)`` is resolved on all of them.

    Returns the panels, the values (F, K, N) and the largest tail left, each in proportion to the width of its panel
    and relative to ``scale`` (F,), by default the largest value of the function. A panel at the narrowest width
    is left as it is: it holds a jump that no edge marks.
    """
    now, values = first, _sampled(f, first)
    span = float(np.max(first.width))
    for _ in range(PASSES):
        size = np.max(np.abs(values), axis=(1, 2)) if scale is None else scale
        size = np.where(size > 0, size, 1.0)
        # a panel counts by what it adds to an integral: neither a kink nor rounding is chased to the end
        tail = np.max(now.tail(values) / size[:, None], axis=0) * now.width / span
        rough = (tail > tolerance) & (now.width > NARROWEST * (now.edges[-1] - now.edges[0]))
        if not rough.any():
            break
        finer = now.split(rough)
        kept = np.repeat(~rough, np.where(rough, 2, 1))
        fresh = f(finer.x[~kept].ravel())
        grown = np.empty((len(values), *finer.x.shape))
        grown[:, kept] = values[:, ~rough]
        grown[:, ~kept] = fresh.reshape(len(values), -1, now.order)
        now, values = finer, grown
    return now, values, float(np.max(tail))


def _sampled(f: Callable[[Values], Values], at: Panels) -> Values:
    x = at.x
    return np.asarray(f(x.ravel())).reshape(-1, *x.shape)
