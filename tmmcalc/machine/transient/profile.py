"""The reduced moment and inertia of a cycle as polynomial pieces, parted where the moment jumps or has a kink.

Where the moment or one of its first two derivatives jumps the pieces are parted into stretches: within a stretch
everything is smooth, and an integrator goes from stretch to stretch by landing on the angle between them. The
technological load is kept apart from the rest, because a load factor multiplies it alone.
"""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from dataclasses import replace
from functools import cache, cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.gauss import rule
from tmmcalc.core.numerics.panels import Panels, Values
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.transient.model import Drive

PARTS = 4  # pieces of a panel: they need fewer coefficients than the panel, and reading costs by coefficients
CUT = 1e-15  # a last coefficient that is smaller everywhere, relative to its function, is left out
JUMPS = (1e-9, 1e-6, 1e-4)  # of value, slope, curvature per radian, relative to the largest value: more is a break
NOISE = 1e-12  # relative error of a piece, which its derivatives amplify
NEAR = 1e-12  # of the period: an angle so near to a break lies on it
FUNCTIONS = ("inertia", "moment", "viscous", "quadratic")


class Profile(NamedTuple):
    """All functions of one cycle as P pieces of D coefficients in S stretches; its angles begin at the first break."""

    period: float
    edges: Values  # (P + 1,) [rad], over one period
    inertia: Values  # (P, D) coefficients about the middle of each piece, ascending
    idle: Values  # (3, P, D) moment, viscous and quadratic coefficient without the technological load
    load: Values  # (3, P, D) what the technological load adds at the factor 1
    starts: tuple[int, ...]  # (S + 1,) the first piece of every stretch, and P
    wraps: bool  # no break at all: the one stretch goes on round and round
    unloaded: tuple[bool, ...]  # (S,) the technological load is zero there

    @property
    def least_inertia(self) -> float:
        """Smallest J at the middles of the pieces [kg*m^2]."""
        return float(self.inertia[:, 0].min())

    @property
    def lightest(self) -> float:
        """An angle where J is least [rad]."""
        k = int(np.argmin(self.inertia[:, 0]))
        return float(self.edges[k] + self.edges[k + 1]) / 2

    @property
    def telling(self) -> tuple[float, ...]:
        """Angles [rad] that eigenvalues are told at: J least, the load steepest over the angle and over the speed."""
        full = self.idle + self.load
        steep = (full[0, :, 1], full[1, :, 0], full[2, :, 0])
        pieces = [int(np.argmax(np.abs(values))) for values in steep if values.any()]
        return tuple(dict.fromkeys((self.lightest, *(float(self.edges[k] + self.edges[k + 1]) / 2 for k in pieces))))

    @property
    def largest_moment(self) -> float:
        """Largest |M| with and without load at the middles of the pieces [N*m]."""
        idle, load = self.idle[0, :, 0], self.load[0, :, 0]
        return float(max(np.abs(idle).max(), np.abs(idle + load).max()))

    def place(self, angle: float, forward: bool) -> tuple[int, float]:
        """The stretch into which the crank turns from ``angle``, and the whole turns to take off [rad]."""
        first = float(self.edges[0])
        base = math.floor((angle - first) / self.period + NEAR) * self.period
        slack = (-NEAR if forward else NEAR) * self.period
        bounds = [float(self.edges[s]) + slack for s in self.starts]
        k = (bisect_right if forward else bisect_left)(bounds, angle - base) - 1
        return self.turned(k, base)

    def turned(self, k: int, base: float) -> tuple[int, float]:
        """The stretch numbered k beyond the ends of the period, as a stretch and the turns to take off."""
        turns, k = divmod(k, len(self.starts) - 1)
        return k, base + turns * self.period


def profile(cycle: Cycle | None, idle: Cycle | None = None) -> Profile:
    """Pieces of a cycle at full load and of the ``idle`` one, whose difference a load factor multiplies.

    Without ``idle`` the factor multiplies the whole moment. Raises `UsageError` if the periods differ.
    """
    if cycle is None:
        zero = np.zeros((3, 1, 3))
        return Profile(2 * np.pi, np.array([0.0, 2 * np.pi]), zero[0], zero, zero, (0, 1), True, (True,))
    if idle is not None and abs(idle.period - cycle.period) > NEAR * cycle.period:
        raise UsageError(
            f"the idle cycle has the period {idle.period:g} rad, the loaded one {cycle.period:g} rad",
            where="transient motion",
            value=idle.period,
            limit=cycle.period,
            remedy="reduce both from the same mechanism",
        )
    panels, full, free = _common(cycle, idle)
    values = np.concatenate((full[:1], free[1:], full[1:] - free[1:]))
    size = np.maximum(np.abs(full), np.abs(free)).max(axis=(1, 2))
    scales = np.where(size > 0, size, 1.0)[[0, 1, 2, 3, 1, 2, 3]]
    loaded = np.any(np.abs(values[4:]) > NOISE * scales[4:, None, None], axis=(0, 2))
    coefficients = _coefficients(panels, values, scales)
    noise = max(NOISE, cycle.error, idle.error if idle else 0.0)
    breaks = _breaks(panels, coefficients, scales, noise) | (loaded != np.roll(loaded, 1))
    return _parted(panels, coefficients, breaks, loaded)


def _common(cycle: Cycle, idle: Cycle | None) -> tuple[Panels, Values, Values]:
    """Common panels, the functions of the full cycle and those without load, each (4, K, N)."""
    full = np.stack([getattr(cycle, name) for name in FUNCTIONS])
    if idle is None:
        return cycle.panels, full, np.zeros_like(full)
    free = np.stack([getattr(idle, name) for name in FUNCTIONS])
    if np.array_equal(cycle.panels.edges, idle.panels.edges) and cycle.panels.order == idle.panels.order:
        return cycle.panels, full, free
    merged = np.sort(np.concatenate((cycle.panels.edges, idle.panels.edges)))
    keep = np.diff(merged, prepend=-np.inf) > NEAR * cycle.period
    panels = Panels(merged[keep], max(cycle.panels.order, idle.panels.order))
    shape = (4, *panels.x.shape)
    x = panels.x.ravel()
    return panels, cycle.panels.at(full, x).reshape(shape), idle.panels.at(free, x).reshape(shape)


def _coefficients(panels: Panels, values: Values, scales: Values) -> Values:
    """Monomials (F, K * PARTS, D) about the middles of the pieces, in radians."""
    monomials = values @ rule(panels.order).coefficients.T @ _to_pieces(panels.order)
    found = monomials.transpose(1, 2, 0, 3).reshape(len(values), -1, panels.order)
    needed = np.any(np.abs(found) > CUT * scales[:, None, None], axis=(0, 1))
    count = max(3, int(np.flatnonzero(needed)[-1]) + 1 if needed.any() else 0)
    half = np.repeat(panels.width, PARTS) / (2 * PARTS)
    return found[..., :count] / half[:, None] ** np.arange(count)


@cache
def _to_pieces(n: int) -> Values:
    """Matrices (PARTS, 1, n, n) from Legendre coefficients of a panel to monomials on [-1, 1] of each of its parts."""
    legendre = np.zeros((n + 1, n + 1))
    legendre[0, 0] = legendre[1, 1] = 1.0
    for k in range(1, n):
        legendre[k + 1, 1:] = (2 * k + 1) * legendre[k, :-1]
        legendre[k + 1] = (legendre[k + 1] - k * legendre[k - 1]) / (k + 1)
    parts = []
    for middle in range(1 - PARTS, PARTS, 2):  # t = (u + middle) / PARTS
        powers = [
            [math.comb(k, j) * middle ** (k - j) / PARTS**k if j <= k else 0.0 for j in range(n)] for k in range(n)
        ]
        parts.append(legendre[:n, :n] @ np.array(powers))
    return np.array(parts)[:, None]


def _breaks(panels: Panels, coefficients: Values, scales: Values, noise: float) -> Values:
    """At which lower edges of the panels (K,) a moment or one of its first two derivatives jumps."""
    half = panels.width / (2 * PARTS)
    above = taylor(coefficients[1:, ::PARTS], -half[:, None])
    below = np.roll(taylor(coefficients[1:, PARTS - 1 :: PARTS], half[:, None]), 1, axis=1)
    narrow = np.minimum(half, np.roll(half, 1)) * PARTS
    broken = np.zeros(len(half), dtype=bool)
    for order, limit in enumerate(JUMPS):
        allowed = (limit + noise * (panels.order**2 / narrow) ** order) * scales[1:, None]
        broken |= np.any(np.abs(above[..., order] - below[..., order]) > allowed, axis=0)
    return broken


def taylor(coefficients: Values, x: Values) -> Values:
    """Value, first and halved second derivative (F, P, 3) of every piece at x (P, 1) from its middle."""
    k = np.arange(coefficients.shape[-1])
    power = x**k
    slope, curvature = k[1:] * coefficients[..., 1:], k[2:] * (k[2:] - 1) / 2 * coefficients[..., 2:]
    parts = (coefficients * power, slope * power[:, :-1], curvature * power[:, :-2])
    return np.stack([part.sum(axis=-1) for part in parts], axis=-1)


def _parted(panels: Panels, coefficients: Values, breaks: Values, loaded: Values) -> Profile:
    """The pieces rolled so that the first break comes first, which closes the turn over the seam."""
    at = np.flatnonzero(breaks).tolist()
    first = at[0] if at else 0
    period = float(panels.edges[-1] - panels.edges[0])
    edges = np.concatenate((panels.edges[first:-1], panels.edges[: first + 1] + period))
    inner = np.diff(edges)[:, None] * np.arange(PARTS) / PARTS
    pieces = np.append((edges[:-1, None] + inner).ravel(), edges[-1])
    rolled = np.roll(coefficients, -first * PARTS, axis=1)
    starts = (*(k - first for k in at), panels.count) if at else (0, panels.count)
    turned = np.roll(loaded, -first)
    unloaded = tuple(not turned[a:b].any() for a, b in pairwise(starts))
    starts = tuple(PARTS * k for k in starts)
    return Profile(period, pieces, rolled[0], rolled[1:4], rolled[4:], starts, not at, unloaded)


class Profiles:
    """The profile of a drive forwards and, made when it is first needed, that backwards.

    Friction and quadratic resistances turn round with the motion; technological loads, weights and springs depend on
    the angle alone and stay as they are. What rubs presses on other places when it is turned back, so the friction
    backwards is not the mirror image of that forwards: a drive carries both cycles, and the one backwards is reduced
    when the crank is first asked whether it turns back.
    """

    def __init__(self, drive: Drive) -> None:
        self._drive = drive
        self.forward = profile(drive.cycle, drive.idle)
        own = [cycle for cycle in (drive.cycle, drive.idle) if cycle is not None]
        self.sided = drive.back is not None or any(bool(np.any(cycle.quadratic)) for cycle in own)

    @cached_property
    def back(self) -> Profile:
        """The profile of the crank turning back."""
        drive = self._drive
        cycle, idle = drive.back() if drive.back is not None else (drive.cycle, drive.idle)
        return profile(_turned(cycle), _turned(idle))

    def of(self, way: float) -> Profile:
        """The profile in a direction: 1 forwards, -1 backwards."""
        return self.forward if way > 0 or not self.sided else self.back


def _turned(cycle: Cycle | None) -> Cycle | None:
    """A cycle whose quadratic part, given for a positive speed, resists a negative one."""
    return None if cycle is None else replace(cycle, quadratic=-cycle.quadratic)
