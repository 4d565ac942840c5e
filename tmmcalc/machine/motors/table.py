"""Characteristic given by points: polynomials between them, straight lines beyond the ends.

For motors that have no closed form: measured curves, saturated direct-current motors, engines with a governor.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.records import record
from tmmcalc.machine.motors.characteristics import N

INTERPOLATIONS = ("linear", "pchip")
Piece = tuple[float, float, float, float]  # cubic by falling powers of omega - origin

WHERE = "motor characteristic by points"


@record
class Table:
    """Piecewise cubic moment: n + 1 pieces about n points, the first and the last of them straight."""

    speeds: tuple[float, ...]  # of the points [rad/s], ascending, n
    pieces: tuple[Piece, ...]  # n + 1
    edges: Values  # the speeds again, (n,)
    columns: Values  # the pieces again, (4, n + 1): arrays are served from these
    synchronous: float | None  # highest speed where the moment falls through zero [rad/s]
    critical: float | None  # speed of the largest moment, if the moment is less on both sides [rad/s]
    nominal: float | None = None  # [rad/s]
    name: str = "table"

    @property
    def least(self) -> float:
        """Speed of the first point."""
        return self.speeds[0]

    @property
    def most(self) -> float:
        """Speed of the last point."""
        return self.speeds[-1]

    def moment(self, omega: N) -> N:
        """Moment [N*m]."""
        if isinstance(omega, (float, int)):
            x, (a, b, c, d) = self._at(omega)
            return ((a * x + b) * x + c) * x + d
        y, (e, f, g, h) = self._across(omega)
        return ((e * y + f) * y + g) * y + h

    def slope(self, omega: N) -> N:
        """Derivative [N*m*s/rad]; at a kink that of the side above."""
        if isinstance(omega, (float, int)):
            x, (a, b, c, _) = self._at(omega)
            return (3 * a * x + 2 * b) * x + c
        y, (e, f, g, _) = self._across(omega)
        return (3 * e * y + 2 * f) * y + g

    def _at(self, omega: float) -> tuple[float, Piece]:
        k = bisect_right(self.speeds, omega)
        return omega - self.speeds[max(k - 1, 0)], self.pieces[k]

    def _across(self, omega: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        k = np.searchsorted(self.edges, omega, side="right")
        return omega - self.edges[np.maximum(k - 1, 0)], self.columns[:, k]


def table(points: Sequence[tuple[float, float]], interpolation: str = "linear", nominal: float | None = None) -> Table:
    """Characteristic through ``points`` (omega [rad/s], M [N*m]), ascending in omega.

    "linear" joins them by lines, "pchip" by monotone cubics (Fritsch and Carlson); beyond the ends the moment goes
    on with the end slope. Raises `UsageError` for fewer than two points, points out of order, another interpolation.

    >>> table([(0.0, 8.0), (10.0, 4.0)]).moment(20.0)
    0.0
    """
    if interpolation not in INTERPOLATIONS:
        known = ", ".join(INTERPOLATIONS)
        raise UsageError(f"there is no interpolation {interpolation!r}", where=WHERE, remedy=f"interpolations: {known}")
    _check(points)
    speeds, moments = (tuple(float(value) for value in column) for column in zip(*points, strict=True))
    if interpolation == "pchip" and len(points) > 2:
        inner = _monotone(speeds, moments)
    else:
        inner = [(0.0, 0.0, (n - m) / (y - x), m) for (x, m), (y, n) in pairwise(zip(speeds, moments, strict=True))]
    width = speeds[-1] - speeds[-2]
    a, b, c, _ = inner[-1]
    first = (0.0, 0.0, inner[0][2], moments[0])
    last = (0.0, 0.0, (3 * a * width + 2 * b) * width + c, moments[-1])
    pieces = (first, *inner, last)
    whole = Table(speeds, pieces, np.array(speeds), np.array(pieces).T, None, _break_down(speeds, moments), nominal)
    return replace(whole, synchronous=_no_load(whole, moments))


def _monotone(speeds: tuple[float, ...], moments: tuple[float, ...]) -> list[Piece]:
    from scipy.interpolate import PchipInterpolator  # late: 0.3 s, and few motors come as a curve

    return [(a, b, c, d) for a, b, c, d in PchipInterpolator(speeds, moments).c.T.tolist()]


def _no_load(whole: Table, moments: tuple[float, ...]) -> float | None:
    """Highest speed within the points where the moment falls from positive to zero or below."""
    falls = [k for k, (m, n) in enumerate(pairwise(moments)) if m > 0 >= n]
    if not falls:
        return None
    low, high = whole.speeds[falls[-1]], whole.speeds[falls[-1] + 1]
    return float(bracketed(lambda x, _: whole.moment(x), np.array([low]), np.array([high]))[0])


def _break_down(speeds: tuple[float, ...], moments: tuple[float, ...]) -> float | None:
    """Both interpolations have their extremes at points."""
    k = moments.index(max(moments))
    return speeds[k] if 0 < k < len(speeds) - 1 else None


def _check(points: Sequence[tuple[float, float]]) -> None:
    if len(points) < 2:
        raise UsageError(
            f"{len(points)} point{'s' if len(points) != 1 else ''} of speed and moment; a curve needs two",
            where=WHERE,
            value=float(len(points)),
            limit=2.0,
            remedy="give more points, or use a constant moment",
        )
    for number, point in enumerate(points, 1):
        if not all(map(math.isfinite, point)):
            raise UsageError(f"point {number} is {point}; both are finite numbers", where=WHERE)
    for number, ((x, _), (y, _)) in enumerate(pairwise(points), 2):
        if not x < y:
            raise UsageError(
                f"point {number} at {y:g} rad/s does not lie above the point before it at {x:g} rad/s",
                where=WHERE,
                value=y,
                limit=x,
                remedy="list the points by ascending speed, each speed once",
            )
