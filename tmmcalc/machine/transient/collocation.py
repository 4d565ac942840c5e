"""Implicit steps of high order for stiff drives: Radau IIA with many stages, which is collocation at Radau points.

    Y_i = y_0 + h sum a_ij f(Y_j),   a_ij = integral from 0 to c_i of the j-th Lagrange polynomial,   c_s = 1

It damps what is fast, however fast, and follows a swing with a few steps a period. The equations of a step are solved
by simplified Newton iteration with the analytic Jacobian. Every stage is handed out as a step of its own: the
polynomial is as good between the ends as the step control asks, and peaks between them are not missed.
Source: E. Hairer, G. Wanner, Solving ODE II, IV.5 and IV.8.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.radau import radau
from tmmcalc.core.numerics.steps import Derivative, State
from tmmcalc.machine.transient.equations import WORKS
from tmmcalc.machine.transient.jacobian import Jacobian

STAGES = 7  # order 13 at the ends, 7 between them
ITERATIONS = 10  # of Newton, after which the step is halved
CLOSE = 1e-3  # of the error allowed: what Newton leaves
ROUNDING = 0.1  # of the error allowed: corrections that no longer shrink, but are so small, are rounding
SLOW = 0.2  # contraction of Newton above which the next step has a Jacobian of its own
SAFETY, SMALLEST, LARGEST = 0.85, 0.2, 5.0  # of the next step against the last
STEADY = 1.3  # a step that could grow by less is repeated with the matrix at hand
FIRST = 1e3  # change in the first step over the error allowed
LEAST = 16 * math.ulp(1.0)  # a step shorter than this part of the time does not advance


class _Solved(NamedTuple):
    """The stages of one step from (t, y)."""

    t: float
    h: float
    y: Values  # (m,) at its beginning
    grown: Values  # (s, m) Y - y
    rates: Values  # (s, m + works)
    contraction: float


class Collocation:
    """Radau steps whose polynomial differs from the solution by less than ``allowed`` (m,) in every component."""

    def __init__(self, allowed: Sequence[float]) -> None:
        self._weights = 1 / np.array(allowed[:-WORKS])
        self._rule = radau(STAGES)
        # of the derivative of the polynomial: its own rates, not those of f, which magnify what Newton leaves
        self._tail = self._rule.coefficients[-2:] @ np.linalg.inv(self._rule.primitive) / (2 * STAGES)
        self._size = 0.0
        self.error: State | None = None
        self.rejected = self.evaluations = 0

    def begin(self, f: Derivative, matrix: Jacobian, t: float, y: State, end: float) -> None:
        """Start a piece of smooth motion; the step size is that of the piece before."""
        self._f, self._matrix, self._end = f, matrix, end
        self.t, self.y, self.rate = t, y, f(t, y)
        self.evaluations += 1
        self._size = self._size or self._first()
        self._jacobian: Values | None = None
        self._inverse: tuple[float, Values] | None = None
        self._now: _Solved | None = None
        self._waiting: list[tuple[float, list[float], State]] = []

    def _first(self) -> float:
        fastest = float(np.max(np.abs(self.rate[:-WORKS]) * self._weights))
        return min((self._end - self.t) / 8, FIRST / fastest if fastest else math.inf)

    def step(self) -> None:
        """To the next stage, of a new step after the last one."""
        self.t0, self.y0, self.rate0 = self.t, self.y, self.rate
        if not self._waiting:
            self._advance()
        self.t, self.y, self.rate = self._waiting.pop(0)

    def _advance(self) -> None:
        """One step whose error is small enough, all its stages."""
        rest = self._end - self.t
        began = np.array(self.y)
        while True:
            last = rest <= self._size * (1 + 1e-9)
            h = rest if last else self._size
            if h < LEAST * max(abs(self.t), self._end - self.t):
                raise AccuracyError(
                    f"the steps shrink to nothing at t = {self.t:.9g} s",
                    where="transient motion",
                    value=h,
                    remedy="look for a jump in the moment there, or raise the tolerance",
                )
            found = self._solved(h, began)
            if found is None:
                self.rejected += 1
                self._size = h / 2
                continue
            worst = self._worst(found)
            factor = min(LARGEST, max(SMALLEST, SAFETY * worst ** (-1 / STAGES))) if worst > 0 else LARGEST
            if worst <= 1:
                break
            self.rejected += 1
            self._size = h * factor
        self._take(found, last, factor, h)

    def _take(self, found: _Solved, last: bool, factor: float, h: float) -> None:
        """Hand the stages out, choose the next step."""
        rule, m = self._rule, len(self._weights)
        works = np.array(self.y[m:]) + found.h * rule.primitive @ found.rates[:, m:]
        states = np.concatenate((found.y + found.grown, works), axis=1).tolist()
        times = (found.t + found.h * rule.points).tolist()
        times[-1] = self._end if last else found.t + h
        self._waiting = list(zip(times, states, found.rates.tolist(), strict=True))
        self._now, self._origin = found, self.y
        if not last:
            self._size = h * factor if not 1 <= factor < STEADY else h
        elif factor > 1:
            self._size = max(self._size, h * factor)
        if found.contraction > SLOW:
            self._jacobian = None

    def _worst(self, found: _Solved) -> float:
        """The part of the polynomial's highest powers in the state, over what is allowed."""
        return float(np.max(np.abs(self._tail @ found.grown) * self._weights))

    def _solved(self, h: float, began: Values, guess: Values | None = None) -> _Solved | None:
        """The stages of a step from the beginning of the present one; None if Newton does not settle."""
        rule, m = self._rule, len(self._weights)
        y = began[:m]
        fresh = self._jacobian is None
        if self._jacobian is None:
            self._jacobian, self._inverse = self._matrix(self.t, began)[:m, :m], None
        if self._inverse is None or self._inverse[0] != h:
            system = np.eye(STAGES * m) - h * np.kron(rule.primitive, self._jacobian)
            self._inverse = h, np.linalg.inv(system)
        inverse = self._inverse[1]
        grown = self._guess(h, m) if guess is None else guess
        before, contraction = math.inf, 0.0
        for _ in range(ITERATIONS):
            rates = self._rates(y + grown)
            residual = grown - h * rule.primitive @ rates[:, :m]
            change = (inverse @ residual.ravel()).reshape(STAGES, m)
            grown = grown - change
            size = float(np.max(np.abs(change) * self._weights))
            if not math.isfinite(size):
                break
            ratio = size / before if before < math.inf else 0.5
            left = ratio / (1 - ratio) * size if ratio < 1 else math.inf
            if left <= CLOSE or (ratio >= 1 and size <= ROUNDING):
                return _Solved(self.t, h, y, grown, self._rates(y + grown), contraction)
            contraction = max(contraction, ratio)
            if contraction > 1:
                break
            before = size
        self._jacobian = None
        return None if fresh else self._solved(h, began, guess)

    def _rates(self, stages: Values) -> Values:
        """f at all stages (s, m + works)."""
        self.evaluations += STAGES
        return np.array([self._f(self.t, stage) for stage in stages.tolist()])

    def _guess(self, h: float, m: int) -> Values:
        """The polynomial of the step before beyond its end; after a restart the tangent."""
        points, before = self._rule.points, self._now
        if before is None:
            return np.outer(h * points, self.rate[:m])
        return self._along(before, 1 + points * h / before.h) - before.grown[-1]

    def _along(self, step: _Solved, part: Values) -> Values:
        """The polynomial of a step at parts (k,) of it, less its beginning (k, m)."""
        return part[:, None] * (self._rule.interpolation(part) @ (step.grown / self._rule.points[:, None]))

    def to(self, t: float) -> State:
        """The state at a time within the last step, by one shorter step from the beginning of that step."""
        found, m = self._now, len(self._weights)
        if found is None or t <= found.t:
            return self.y0
        keep = self.t, self._jacobian, self._inverse
        self.t = found.t
        guess = self._along(found, (t - found.t) / found.h * self._rule.points)
        shorter = self._solved(t - found.t, np.array(self._origin), guess)
        self.t, self._jacobian, self._inverse = keep
        if shorter is None:
            return self._read(found, (t - found.t) / found.h)
        works = np.array(self._origin[m:]) + shorter.h * self._rule.primitive[-1] @ shorter.rates[:, m:]
        return [*(shorter.y + shorter.grown[-1]).tolist(), *works.tolist()]

    def _read(self, step: _Solved, part: float) -> State:
        """The state by the polynomial of a step at a part of it: where a shorter one is lost in rounding."""
        m, rule = len(self._weights), self._rule
        rates = rule.interpolation(part * rule.points) @ step.rates[:, m:]
        works = np.array(self._origin[m:]) + part * step.h * rule.primitive[-1] @ rates
        return [*(step.y + self._along(step, np.array([part]))[0]).tolist(), *works.tolist()]
