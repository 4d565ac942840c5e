"""The energy-mass curve: change of kinetic energy A(theta) against reduced inertia J(theta), and its tangents.

A tangent of slope k touches the curve where A - k J is largest or smallest; its slope is half the square of a speed,
k = omega^2 / 2 (textbook 3.50), and its intercept b = A - k J tells how much constant inertia and initial energy the
machine needs for that speed to be its extreme. All methods for the flywheel differ in the slopes alone.

The curve is held on panels, where the touching points are exact, or on the nodes of a textbook table.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.panels import Panels, Values
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle

BALANCED = 1e-6  # work of a cycle, against the largest work within it, that a given driving moment may leave
ROUNDING = 1e-13  # extremes that differ by less of the range count as equal: the first one is taken


class Touching(NamedTuple):
    """Where tangents touch the energy-mass curve; arrays (m,)."""

    theta: Values  # [rad], in [0, period)
    work: Values  # A [J]
    inertia: Values  # J [kg*m^2]


@record
class EnergyCurve:
    """A(theta) and J(theta) of one cycle, on panels (K, N) or on nodes (n + 1,)."""

    panels: Panels | None  # None: on nodes, between which nothing is known
    theta: Values  # [rad]
    work: Values  # A, change of kinetic energy since theta = 0 [J]
    inertia: Values  # J, variable reduced inertia [kg*m^2]
    drive: float  # constant moment that closes the work of the cycle [N*m]

    @property
    def period(self) -> float:
        """Angle of the cycle [rad]."""
        return float(self.panels.edges[-1] if self.panels else self.theta[-1])

    def touching(self, slopes: Values, upper: NDArray[np.bool_]) -> Touching:
        """Where A - k J is largest (``upper``) or smallest, for each of the ``slopes`` k (m,)."""
        sign = np.where(upper, 1.0, -1.0)
        if self.panels is None:
            values = sign[:, None] * (self.work - slopes[:, None] * self.inertia)[:, :-1]
            i = np.array([_first(row) for row in values])
            return Touching(self.theta[i], self.work[i], self.inertia[i])
        theta = _highest(self.panels, np.stack((self.work, self.inertia)), slopes, sign)
        work, inertia = self.panels.at(np.stack((self.work, self.inertia)), theta)
        return Touching(np.where(theta < self.period, theta, 0.0), work, inertia)


def energy_curve(cycle: Cycle, speed: float | None = None, moment: float | Values | None = None) -> EnergyCurve:
    """Energy-mass curve of a cycle whose forces are taken at the mean ``speed`` [rad/s] (by default the cycle's own).

    ``moment`` is the driving moment [N*m], constant or (K, N) on the panels; by default the constant one that makes
    the work of the cycle zero (3.45). Raises `UsageError` if a given one leaves work over.
    """
    w = cycle.speed if speed is None else speed
    on = cycle.panels
    load = cycle.moment + cycle.viscous * w + cycle.quadratic * w * w
    total = load if moment is None else load + moment
    rest = float(on.total(total))
    drive = -rest / cycle.period
    work, _ = on.primitive(total + drive)
    if moment is not None and abs(rest) > BALANCED * float(np.ptp(work)):
        raise UsageError(
            f"the given driving moment leaves work of {rest:.6g} J over in each cycle",
            where="flywheel",
            value=rest,
            limit=0.0,
            remedy=f"add {drive:.6g} N*m to it, or leave it out to take the constant one that closes the cycle",
        )
    return EnergyCurve(on, on.x, work, cycle.inertia, drive)


def nodal_curve(
    work: Values, inertia: Values, period: float = 2 * math.pi, theta: Values | None = None, drive: float = 0.0
) -> EnergyCurve:
    """Energy-mass curve on the nodes of a table: ``work`` A [J] and ``inertia`` J [kg*m^2], both (n + 1,).

    The nodes are equally spaced on [0, period] unless ``theta`` [rad] gives them; the last repeats the first.
    """
    work, inertia = np.asarray(work, float), np.asarray(inertia, float)
    at = np.linspace(0.0, period, len(work)) if theta is None else np.asarray(theta, float)
    if not len(at) == len(work) == len(inertia) or len(at) < 3:
        raise UsageError(
            f"work and inertia need the same nodes: {len(work)} and {len(inertia)} values at {len(at)} angles",
            where="flywheel",
            remedy="give n + 1 values each, the last repeating the first",
        )
    return EnergyCurve(None, at, work, inertia, drive)


def _first(values: Values) -> int:
    """Index of the largest value; of those that rounding alone tells apart, the first."""
    return int(np.argmax(values >= values.max() - ROUNDING * np.ptp(values)))


def _highest(on: Panels, pair: Values, slopes: Values, sign: Values) -> Values:
    """Places (m,) of the largest sign (A - k J) on panels; ``pair`` holds A and J, (2, K, N).

    Candidates are the edges and, of the stretches between neighbouring points where the derivative turns from rising to
    falling, those that may reach above the highest sample; all of them are solved at once.
    """
    rise = on.slope(pair)
    weights = np.stack((sign, -sign * slopes), axis=-1)  # (m, 2): of A and J in the function sought
    values, derivative = np.tensordot(weights, pair, 1), np.tensordot(weights, rise, 1)
    x = np.concatenate((on.edges[:-1, None], on.x, np.nextafter(on.edges[1:], -np.inf)[:, None]), axis=1)
    v, d = _with_ends(on, values), _with_ends(on, derivative)
    reach = np.maximum(v[..., 1:], v[..., :-1]) + np.maximum(d[..., :-1], -d[..., 1:]) * np.diff(x)
    best = v.max(axis=(1, 2))
    turns = (d[..., :-1] > 0) & (d[..., 1:] < 0) & (reach >= best[:, None, None])
    row, k, i = np.nonzero(turns)

    def slope(at: Values, which: NDArray[np.intp]) -> Values:
        return np.einsum("nm,mn->m", on.at(rise, at), weights[row[which]])

    inner = bracketed(slope, x[k, i], x[k, i + 1])
    top = np.einsum("nm,mn->m", on.at(pair, inner), weights[row])
    edges = np.append(v[:, :, 0], v[:, -1:, -1], axis=1)
    return np.array(
        [
            _place(np.append(on.edges, inner[row == m]), np.append(edges[m], top[row == m]), np.ptp(v[m]))
            for m in range(len(slopes))
        ]
    )


def _with_ends(on: Panels, values: Values) -> Values:
    """Values (..., K, N) with the limits at the edges of each panel before and after them, (..., K, N + 2)."""
    low, high = on.ends(values)
    return np.concatenate((low[..., None], values, high[..., None]), axis=-1)


def _place(theta: Values, values: Values, span: float) -> float:
    """The first place of the largest value."""
    order = np.argsort(theta, kind="stable")
    near = values[order] >= values.max() - ROUNDING * span
    return float(theta[order][np.argmax(near)])
