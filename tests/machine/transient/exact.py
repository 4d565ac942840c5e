"""The motion of a random drive by DOP853 at its finest tolerance, from equations written out of its numbers alone.

A piece ends where the load jumps and where a crank that the load holds is pulled loose; its end is found by the
method itself and not by its dense output. So are the largest moments, near the tops of that output.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import DOP853
from scipy.optimize import brentq, minimize_scalar

from machine.transient.drives import TURN, Numbers

FINE = 3e-14  # relative tolerance
DENSE = 8  # looks at every step
EDGE = 1e-6  # of a step: a top nearer to its ends is as high as they are
CLOSE = 1e-8  # of a step, to a top
NEAR = 0.99  # of the largest so far: lower tops are not found exactly
BUDGET = 40_000  # evaluations
EARLY, PACE = 4_000, 1 / 30  # evaluations, and the part of the motion that has to be done by then
REST = 1e-9  # of the speed: a crank that turns back so fast has come to rest before
PROBE = 1e-4  # of a step: for a slope by differences
State = list[float]


class Exact(NamedTuple):
    """Speeds (N, S) at times (S,), and the largest sizes of the moments of shafts and motor (N,)."""

    t: np.ndarray
    omega: np.ndarray
    largest: np.ndarray


class _Drive:
    """y = angle of the crank, twists, their rates, speed of the crank, and the moment of a motor that lags."""

    def __init__(self, of: Numbers) -> None:
        self.of, self.n = of, len(of.masses)
        self.deep = self.held = False
        self.evaluations = 0

    def static(self, w: float) -> float:
        of = self.of
        if of.motor == 0:
            peak, critical, synchronous = of.kloss
            s = 1 - w / synchronous
            return 2 * peak / (s / critical + critical / s) if s else 0.0
        return of.line[0] * (of.line[1] - w) if of.motor == 1 else of.parabola[0] - of.parabola[1] * w * w

    def moments(self, y: Any) -> State:
        """Of the shafts, then of the motor."""
        n = self.n
        shafts = [c * y[1 + i] + k * y[n + i] for i, (c, k) in enumerate(self.of.shafts)]
        return [*shafts, y[2 * n] if self.of.lag else self.static(sum(y[n : 2 * n]))]

    def pull(self, y: Any) -> float:
        """What is left of all moments on the crank."""
        of, p, *inner = self.of, y[0], *self.moments(y)
        load = of.mean - (of.depth if self.deep else 0.0)
        load += sum(a * math.cos(k * p) + b * math.sin(k * p) for k, (a, b) in enumerate(of.waves, 1))
        return inner[-2 if self.n > 1 else -1] + load - of.swing * math.cos(2 * p) * y[2 * self.n - 1] ** 2

    def __call__(self, _: float, values: Any) -> State:
        self.evaluations += 1
        y, n = values.tolist(), self.n
        *shafts, motor = self.moments(y)
        flow = [motor, *shafts]
        inertia = self.of.masses[-1] + self.of.swing * (1 + math.sin(2 * y[0]))
        rates = [(flow[i] - flow[i + 1]) / self.of.masses[i] for i in range(n - 1)]
        rates.append(0.0 if self.held else self.pull(y) / inertia)
        apart = [rates[i] - rates[i + 1] for i in range(n - 1)]
        lagging = [(self.static(sum(y[n : 2 * n])) - motor) / self.of.lag] if self.of.lag else []
        return [y[2 * n - 1], *y[n : 2 * n - 1], *apart, rates[-1], *lagging]


def exact_motion(of: Numbers, fine: float = FINE, budget: int = BUDGET) -> Exact | None:
    """The motion; None where it is too dear, or where a crank that turns comes to rest."""
    drive = _Drive(of)
    n, lags, moment = len(of.masses), bool(of.lag), of.parabola[0]
    t, y = 0.0, np.array([0.0] * (2 * n - 1) + [of.start] + [0.0] * lags)
    drive.held = not of.start and drive.pull(y) <= 0
    twists = [(moment / c, moment / math.sqrt(c * mass)) for (c, _), mass in zip(of.shafts, of.masses, strict=False)]
    scale = np.array([1.0, *(a for a, _ in twists), *(b for _, b in twists), of.speed] + [moment] * lags)
    found: list[tuple[float, Any]] = [(0.0, y)]
    largest = np.abs(drive.moments(y))
    while t < of.duration:
        gap = _gap(drive, y)
        solver = _solver(drive, t, y, of.duration, scale, fine)
        while True:
            before = t, y
            solver.step()
            t, y = solver.t, solver.y
            slow = drive.evaluations > EARLY and t < PACE * of.duration
            if slow or drive.evaluations > budget or solver.status == "failed" or y[2 * n - 1] < -REST * of.speed:
                return None
            over = gap(y) >= 0
            if over:
                t, y = _located(drive, gap, before, solver, scale, fine)
            largest = np.maximum(largest, _tops(drive, largest, before, t, solver, scale, fine))
            found.append((t, y))
            if over or t >= of.duration:
                break
        if over and drive.held:
            drive.held = False
        elif over:
            drive.deep = not drive.deep
    rates = np.array([y for _, y in found]).T[n : 2 * n]
    return Exact(np.array([t for t, _ in found]), np.cumsum(rates[::-1], axis=0)[::-1], largest)


def _solver(drive: _Drive, t: float, y: Any, end: float, scale: Any, fine: float) -> DOP853:
    return DOP853(lambda t, y: np.array(drive(t, y)), t, y, end, rtol=max(fine, 2.3e-14), atol=fine * 1e-1 * scale)


def _gap(drive: _Drive, y: Any) -> Callable[[Any], float]:
    """What is negative until the piece ends."""
    if drive.held:
        return drive.pull
    if not drive.of.depth:
        return lambda _: -1.0
    at = drive.of.jumps[drive.deep]
    level = at + TURN * (math.floor((y[0] - at) / TURN + 1e-9) + 1)
    return lambda y: y[0] - level


def _on(drive: _Drive, before: tuple[float, Any], t: float, scale: Any, fine: float) -> Any:
    """The state at a time from that before it."""
    solver = _solver(drive, *before, t, scale, fine)
    while solver.status == "running":
        solver.step()
    return solver.y


def _located(
    drive: _Drive, gap: Callable[[Any], float], before: tuple[float, Any], solver: DOP853, scale: Any, fine: float
) -> tuple[float, Any]:
    dense = solver.dense_output()
    t = brentq(lambda t: gap(dense(t)), before[0], solver.t, xtol=1e-15 * solver.t) if gap(before[1]) < 0 else before[0]
    y = _on(drive, before, t, scale, fine) if t > before[0] else before[1]
    rate, step = np.array(drive(t, y)), PROBE * (solver.t - before[0])
    slope = (gap(y + step * rate) - gap(y)) / step
    late = -gap(y) / slope
    return t + late, y + late * rate


def _tops(
    drive: _Drive, least: Any, before: tuple[float, Any], end: float, solver: DOP853, scale: Any, fine: float
) -> np.ndarray:
    """The largest sizes of all moments in a step up to ``end``, as far as they are near the ``least`` of interest."""
    dense, parts = solver.dense_output(), np.sort([*np.linspace(0, 1, DENSE), EDGE, 1 - EDGE])
    at = before[0] + (end - before[0]) * parts
    sizes = np.abs([drive.moments(y) for y in dense(at).T])
    tops = sizes[-1].copy()
    for k, column in enumerate(sizes.T):
        i = int(np.argmax(column))
        if 0 < i < len(at) - 1 and column[i] > NEAR * least[k]:
            looked = minimize_scalar(
                lambda t, k=k: -abs(drive.moments(dense(t))[k]),
                bounds=(at[i - 1], at[i + 1]),
                method="bounded",
                options={"xatol": CLOSE * (end - before[0])},
            )
            tops[k] = abs(drive.moments(_on(drive, before, looked.x, scale, fine))[k])
    return tops
