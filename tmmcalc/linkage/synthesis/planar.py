"""Many four-bars or slider-cranks at once, by their sizes: places of their pins, and where they assemble.

The crank AB carries the coupler BC; C is on the rocker DC, or on a line. Sizes have the shape (m, 1), angles of the
crank (m, n) or (n,); the result is (m, n). The margin is the squared sine of the transmission angle, negative where the
links do not reach.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Real, cross, square


class Placed(NamedTuple):
    """Pins B and C, the unit direction of the coupler, the coupler point, and the margin, each (m, n)."""

    b: Plane
    c: Plane
    turn: Plane
    point: Plane
    margin: Real


class Bars(NamedTuple):
    """Sizes: A, crank a, coupler b, the other end (D and rocker c, or a guide point), direction, point, sign."""

    pivot: Plane
    crank: Real
    coupler: Real
    end: Plane  # D, or a point of the guide
    rocker: Real  # unused by a slider-crank
    guide: Plane  # unit direction of the guide, unused by a four-bar
    point: Plane  # coupler point in the axes of BC
    sign: Real  # variant of the dyad
    slides: bool

    def at(self, phi: Real) -> Placed:
        """Place the linkage at angles of the crank [rad]; beyond its limits C stands at the nearest reach."""
        b = self.pivot + self.crank * np.exp(1j * phi)
        if self.slides:
            local = (b - self.end) * np.conj(self.guide)
            margin = 1 - (local.imag / self.coupler) ** 2
            c = self.end + self.guide * (local.real + self.sign * self.coupler * np.sqrt(np.maximum(margin, 0)))
        else:
            q = self.end - b
            q2 = np.maximum(square(q), 1e-300)
            long, short = (self.coupler + self.rocker) ** 2, (self.coupler - self.rocker) ** 2
            spread = (long - q2) * (q2 - short)
            along = (self.coupler**2 - self.rocker**2 + q2) / (2 * q2)
            c = b + q * (along + 1j * self.sign * np.sqrt(np.maximum(spread, 0)) / (2 * q2))
            margin = spread / (2 * self.coupler * self.rocker) ** 2
        turn = (c - b) / self.coupler
        return Placed(b, c, turn, b + turn * self.point, margin)

    def rows(self, which: np.ndarray) -> Bars:
        """The linkages with these indices."""
        return bars_of([part[which] for part in self[:-1]], self.slides)

    def moved(self, ratio: Plane | float, shift: Plane | complex) -> Bars:
        """The linkages turned and scaled by ``ratio``, (m, 1) or one for all, then shifted."""
        size = np.abs(ratio)
        return self._replace(
            pivot=self.pivot * ratio + shift,
            crank=self.crank * size,
            coupler=self.coupler * size,
            end=self.end * ratio + shift,
            rocker=self.rocker * size,
            guide=self.guide * ratio / size,
            point=self.point * size,
        )

    def lengths(self) -> Real:
        """Lengths (k, m): crank, coupler, rocker, frame; of a slider-crank crank and coupler."""
        if self.slides:
            return np.array([self.crank[:, 0], self.coupler[:, 0]])
        frame = np.abs(self.end - self.pivot)
        return np.array([self.crank[:, 0], self.coupler[:, 0], self.rocker[:, 0], frame[:, 0]])

    def offset(self) -> Real:
        """Distance (m,) of the crank's pivot from the guide, to the left of it."""
        return cross(self.guide, self.pivot - self.end)[:, 0]

    def turns(self) -> np.ndarray:
        """Whether the crank turns fully (m,)."""
        if self.slides:
            return np.asarray(self.crank[:, 0] + np.abs(self.offset()) < self.coupler[:, 0])
        a, b, c, d = self.lengths()
        far, near = a + d, np.abs(a - d)
        return np.asarray((far < b + c) & (near > np.abs(b - c)))


def bars_of(parts: Sequence[Any], slides: bool) -> Bars:
    """Linkages from their sizes in the order of the fields, each (m, 1)."""
    return Bars._make([*(np.asarray(part) for part in parts), slides])


def grashof(lengths: Real) -> list[str]:
    """The type of every four-bar by its lengths (4, m): crank, coupler, rocker, frame.

    >>> grashof(np.array([[1.0], [3.0], [2.5], [3.0]]))
    ['crank-rocker']
    """
    names = ("crank-rocker", "double rocker of Grashof", "rocker-crank", "double crank")
    margin = lengths.sum(axis=0) - 2 * (lengths.min(axis=0) + lengths.max(axis=0))
    shortest = lengths.argmin(axis=0)
    return [names[k] if m > 0 else "triple rocker" for k, m in zip(shortest, margin, strict=True)]
