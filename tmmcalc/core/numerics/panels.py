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
from itertools import pairwise
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.gauss import ORDER, legendre, rule, tail
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.records import record

Values = NDArray[np.floating[Any]]
Extreme = tuple[float, float]  # value and place

WIDEST = np.pi / 6  # of a first panel, in the variable's unit
NARROWEST = 2.0**-24  # of the whole range: a panel is not halved below it
PASSES = 40
LAID = 1 << 16  # first panels of a range, at most
MOST = 1 << 14  # panels that halving may add to them: what changes faster cannot be followed in reasonable time
NEWTON = 4  # steps to an extreme
SLOWEST = 0.25  # fall of the coefficients of a kink, which go with the square of the degree


class UnresolvedError(AccuracyError):
    """A function that `MOST` panels do not resolve: it turns ``turns`` times or more, most densely near ``at``."""

    def __init__(self, turns: int, at: float) -> None:
        self.turns = turns
        self.at = at
        super().__init__(
            f"a function changes its sense {turns} times or more over its range, most densely near {at:.6g}: "
            f"{MOST} panels do not resolve it",
            value=turns,
            limit=MOST,
            remedy="make what changes so fast smoother, or take it as its mean value",
        )


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
        return np.asarray(values @ rule(self.order).weights @ self.width)

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
        return np.minimum(np.maximum(np.searchsorted(self.edges, x, side=side) - 1, 0), self.count - 1)

    def _inside(self, rows: Values, row: NDArray[np.intp], x: Values) -> Values:
        """Interpolate row (m,) of ``rows`` (F K, ..., N), function by function, at x (m,): (m, ...)."""
        r, k = rule(self.order), row % self.count
        t = (x - self.edges[k]) / self.width[k]
        gap = t[:, None] - r.points
        hit = gap == 0
        part = r.barycentric / np.where(hit, 1.0, gap)
        exact = hit.any(axis=1)
        part[exact] = hit[exact]
        part /= part.sum(axis=1)[:, None]
        return np.einsum("m...n,mn->m...", rows[row], part)

    def turning(self, values: Values) -> tuple[Values, Values]:
        """Places (m,) and values (m,) of all local extremes of one function (K, N), the limits at edges included."""
        at, found, _ = self._turnings(values[None])
        return at, found

    def _turnings(self, values: Values) -> tuple[Values, Values, NDArray[np.intp]]:
        """Places, values and numbers of the functions (m,) of all local extremes of functions (F, K, N)."""
        slopes = self.slope(values)
        ends, limits = self.ends(slopes), self.ends(values)
        sloped = np.concatenate((ends[0][..., None], slopes, ends[1][..., None]), axis=-1).reshape(-1, self.order + 2)
        t = np.concatenate((self.edges[:-1, None], self.x, self.edges[1:, None]), axis=1)
        row, i = np.nonzero(np.signbit(sloped[:, 1:]) != np.signbit(sloped[:, :-1]))
        k = row % self.count
        at = self._level(slopes, row, t[k, i], t[k, i + 1], sloped[row, i], sloped[row, i + 1])
        inner = self._inside(values.reshape(-1, self.order), row, at)
        edges, every = (self.edges[:-1], self.edges[1:]), np.arange(len(values))
        return (
            np.concatenate((at, *(np.tile(side, len(values)) for side in edges))),
            np.concatenate((inner, *(limit.ravel() for limit in limits))),
            np.concatenate((row // self.count, *2 * [np.repeat(every, self.count)])),
        )

    def _level(self, slopes: Values, row: NDArray[np.intp], low: Values, high: Values, a: Values, b: Values) -> Values:
        """Roots (m,) of rows of ``slopes`` (F, K, N) between ``low`` and ``high``, where the values are a and b.

        Newton from the chord ends in four steps nearly everywhere; the rest is bracketed.
        """
        if not len(row):
            return np.empty(0)
        both = np.stack((slopes, self.slope(slopes)), axis=-2).reshape(-1, 2, self.order)
        x = low + (high - low) * (a / np.where(a == b, 1.0, a - b))
        with np.errstate(divide="ignore", invalid="ignore"):
            for _ in range(NEWTON):
                value = self._inside(both, row, x)
                step = np.where(value[:, 0] == 0, 0.0, value[:, 0] / value[:, 1])
                x = np.minimum(np.maximum(x - step, low), high)
                left = np.flatnonzero(np.abs(step) > 1e-12 * (high - low))
                if not left.size:
                    break
        if left.size:
            x[left] = bracketed(lambda s, which: self._inside(both[:, 0], row[left][which], s), low[left], high[left])
        return x

    def extremes(self, values: Values) -> tuple[Extreme, Extreme]:
        """Smallest and largest value of one function (K, N), each as (value, place)."""
        return self.extremes_of(values[None])[0]

    def extremes_of(self, values: Values) -> list[tuple[Extreme, Extreme]]:
        """Smallest and largest value of every function (F, K, N), each as (value, place): of several in one pass."""
        at, value, which = self._turnings(values)
        found = []
        for number in range(len(values)):
            own = np.flatnonzero(which == number)
            low, high = own[np.argmin(value[own])], own[np.argmax(value[own])]
            found.append(((float(value[low]), float(at[low])), (float(value[high]), float(at[high]))))
        return found

    def tail(self, values: Values) -> Values:
        """What the polynomials of the panels leave out (..., K): the size of their last coefficients."""
        return tail(values)

    def left_out(self, values: Values) -> Values:
        """What interpolation leaves out of functions (..., K): the coefficients go on to fall as in the second half.

        The largest of the last ones is at least two degrees before the next of its kind.
        """
        c = np.abs(values @ rule(self.order).coefficients.T)
        half, last = (np.max(c[..., at - 3 : at], axis=-1) for at in (self.order // 2, self.order))
        fall = np.clip(last / np.where(half > 0, half, 1.0), 0.0, SLOWEST) ** (2 / self.order)
        return np.asarray(2 * last * fall**2 / (1 - fall))

    def halved(self) -> Panels:
        """All panels in halves."""
        return self.split(np.ones(self.count, bool))

    def split(self, which: NDArray[np.bool_]) -> Panels:
        """The panels with those of ``which`` (K,) halved."""
        middle = (self.edges[:-1] + self.edges[1:])[which] / 2
        return Panels(np.sort(np.concatenate((self.edges, middle))), self.order)


def panels(low: float, high: float, breaks: Iterable[float] = (), widest: float = WIDEST) -> Panels:
    """Panels of [low, high] with an edge at every break inside it, none wider than ``widest``.

    Breaks nearer to each other than the narrowest panel count as one. Raises `AccuracyError` for more than `LAID` of
    them, and for a range of more than `LAID` times the widest panel.
    """
    if not (high - low) / widest <= LAID:
        raise AccuracyError(
            f"a range of {high - low:.6g} in panels of {widest:.6g} at most takes more than {LAID} of them",
            value=(high - low) / widest,
            limit=LAID,
            remedy="ask for a shorter range, or for scales that are nearer to each other",
        )
    least = NARROWEST * (high - low)
    edges = [low]
    for b in sorted(b for b in breaks if low + least < b < high - least):
        if b - edges[-1] > least:
            edges.append(b)
    edges.append(high)
    if len(edges) > LAID:
        raise AccuracyError(
            f"a function has {len(edges) - 2} jumps and kinks over its range, which take a panel each",
            value=len(edges) - 2,
            limit=LAID,
            remedy="thin out the table or the pieces that it is given by",
        )
    parts = [_parts(a, b, widest) for a, b in pairwise(edges)]
    return Panels(np.append(np.concatenate(parts), high))


def _parts(low: float, high: float, widest: float) -> Values:
    """Lower edges of the equal panels of one piece."""
    count = max(1, math.ceil((high - low) / widest - 1e-9))
    return low + (high - low) / count * np.arange(count)


def resolved(
    f: Callable[[Values], Values], first: Panels, tolerance: float = 1e-13, scale: Values | None = None
) -> tuple[Panels, Values, float]:
    """Halve panels until every function of ``f(x) -> (F, n)`` is resolved on all of them.

    Returns the panels, the values (F, K, N) and the largest tail left, each in proportion to the width of its panel
    and relative to ``scale`` (F,), by default the largest value of the function. A panel at the narrowest width
    is left as it is: it holds a jump that no edge marks. Raises `UnresolvedError` where this takes more than `MOST`
    panels.
    """
    now, values = first, _sampled(f, first)
    span = float(np.max(first.width))
    for _ in range(PASSES):
        size = np.max(np.abs(values), axis=(1, 2)) if scale is None else scale
        size = np.where(size > 0, size, 1.0)
        # a panel counts by what it adds to an integral: neither a kink nor rounding is chased to the end
        left = np.max(now.tail(values) / size[:, None], axis=0) * now.width / span
        rough = (left > tolerance) & (now.width > NARROWEST * (now.edges[-1] - now.edges[0]))
        if not rough.any():
            break
        if now.count + np.count_nonzero(rough) > first.count + MOST:
            raise unresolved(now, values)
        finer = now.split(rough)
        kept = np.repeat(~rough, np.where(rough, 2, 1))
        fresh = f(finer.x[~kept].ravel())
        grown = np.empty((len(values), *finer.x.shape))
        grown[:, kept] = values[:, ~rough]
        grown[:, ~kept] = fresh.reshape(len(values), -1, now.order)
        now, values = finer, grown
    return now, values, float(np.max(left))


def unresolved(on: Panels, values: Values) -> UnresolvedError:
    """What is to be said of functions (F, K, N) that turn more often than can be followed."""
    steps = np.diff(values.reshape(len(values), -1), axis=1)
    turns = np.signbit(steps[:, 1:]) != np.signbit(steps[:, :-1])
    worst = int(np.argmax(np.count_nonzero(turns, axis=1)))
    most = int(np.count_nonzero(turns[worst]))
    return UnresolvedError(most, float(on.edges[np.argmin(on.width)]))


def _sampled(f: Callable[[Values], Values], at: Panels) -> Values:
    x = at.x
    return np.asarray(f(x.ravel())).reshape(-1, *x.shape)
