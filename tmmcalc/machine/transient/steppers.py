"""Integrators that go step by step in plain floats: Kutta-Merson with step control, and fixed steps.

A stepper is told to ``begin`` a piece of smooth motion and then steps until its end. It keeps the last step's
beginning, so that ``to`` can repeat the step shorter: that is how an event is located to the accuracy of the
method and not to that of an interpolation.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Protocol

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.steps import Derivative, State, merson_step, rk4_step
from tmmcalc.machine.transient.equations import WORKS
from tmmcalc.machine.transient.jacobian import Jacobian

SAFETY, SMALLEST, LARGEST = 0.9, 0.2, 4.0  # of the next step against the last
FIRST = 1e4  # change in the first step over the error allowed
LEAST = 16 * math.ulp(1.0)  # a step shorter than this part of the time does not advance
Step = Callable[[Derivative, float, State, float, State | None, int], tuple[list[float], list[float] | None]]


class Stepper(Protocol):
    """What an integrator offers to the driver of a run."""

    t0: float  # beginning of the last step [s]
    y0: State
    rate0: State
    t: float  # end of the last step
    y: State
    rate: State  # f(t, y)
    error: State | None  # signed estimate of the last step's error; None: the method has none
    rejected: int
    evaluations: int

    def begin(self, f: Derivative, matrix: Jacobian, t: float, y: State, end: float) -> None:
        """Start a piece of smooth motion from (t, y), to be integrated up to ``end``."""

    def step(self) -> None:
        """One accepted step, not beyond the end."""

    def to(self, t: float) -> State:
        """The state at a time within the last step."""


class Fixed:
    """Fixed steps on the grid of the multiples of ``size`` [s]; a piece that ends between two of them shortens one."""

    def __init__(self, step: Step, size: float) -> None:
        self._step, self._cost, self.size = step, 4 if step is rk4_step else 5, size
        self.error: State | None = None
        self.rejected = self.evaluations = 0

    def begin(self, f: Derivative, matrix: Jacobian, t: float, y: State, end: float) -> None:
        """Start a piece of smooth motion."""
        self._f, self._end = f, end
        self.t, self.y, self.rate = t, y, f(t, y)
        self.evaluations += 1

    def step(self) -> None:
        """To the next multiple of the step size, or to the end."""
        self.t0, self.y0, self.rate0 = self.t, self.y, self.rate
        after = (math.floor(self.t / self.size + 1e-9) + 1) * self.size
        after = after if after < self._end - 1e-9 * self.size else self._end
        self.y, self.error = self._step(self._f, self.t, self.y, after - self.t, self.rate, WORKS)
        self.t = after
        self.rate = self._f(self.t, self.y)
        self.evaluations += self._cost
        if not math.isfinite(sum(self.y)):
            raise AccuracyError(
                f"the solution grew beyond all bounds at t = {self.t:.6g} s with steps of {self.size:g} s",
                where="transient motion",
                value=self.size,
                remedy="take a smaller step, or step control, or an implicit method",
            )

    def to(self, t: float) -> State:
        """The state at a time within the last step, by one shorter step."""
        self.evaluations += self._cost - 1
        return self._step(self._f, self.t0, self.y0, t - self.t0, self.rate0, WORKS)[0]


class Controlled:
    """Kutta-Merson steps whose estimated error stays below ``allowed`` (m,) in every component."""

    def __init__(self, allowed: Sequence[float]) -> None:
        self._weights = [1 / a for a in allowed]
        self._size = 0.0
        self.error: State | None = None
        self.rejected = self.evaluations = 0

    def begin(self, f: Derivative, matrix: Jacobian, t: float, y: State, end: float) -> None:
        """Start a piece of smooth motion; the step size is that of the piece before."""
        self._f, self._end = f, end
        self.t, self.y, self.rate = t, y, f(t, y)
        self.evaluations += 1
        self._size = self._size or self._first()

    def _first(self) -> float:
        """A first step in which nothing changes by more than a multiple of the error allowed."""
        fastest = max(abs(r) * w for r, w in zip(self.rate, self._weights, strict=True))
        return min((self._end - self.t) / 8, FIRST / fastest if fastest else math.inf)

    def step(self) -> None:
        """One step whose error is small enough."""
        self.t0, self.y0, self.rate0 = self.t, self.y, self.rate
        rest = self._end - self.t0
        while True:
            last = rest <= self._size
            h = rest if last else self._size
            y, error = merson_step(self._f, self.t0, self.y0, h, self.rate0, WORKS)
            self.evaluations += 4
            worst = max(abs(e) * w for e, w in zip(error, self._weights, strict=True))
            if worst <= 1:
                break
            self.rejected += 1
            self._size = h * (max(SMALLEST, SAFETY * worst**-0.2) if worst < math.inf else SMALLEST)
            if self._size < LEAST * max(abs(self.t0), self._end - self.t0):
                raise AccuracyError(
                    f"the steps shrink to nothing at t = {self.t0:.9g} s",
                    where="transient motion",
                    value=self._size,
                    remedy="look for a jump in the moment there, or raise the tolerance",
                )
        self.t, self.y, self.error = (self._end if last else self.t0 + h), y, error
        growth = min(LARGEST, SAFETY * worst**-0.2) if worst > 0 else LARGEST
        self._size = max(self._size, h * growth) if last else h * growth
        self.rate = self._f(self.t, self.y)
        self.evaluations += 1

    def to(self, t: float) -> State:
        """The state at a time within the last step, by one shorter step."""
        self.evaluations += 4
        return merson_step(self._f, self.t0, self.y0, t - self.t0, self.rate0, WORKS)[0]


def fixed(name: str, size: float) -> Fixed:
    """Fixed steps of Kutta-Merson ("merson") or of the classical method ("rk4")."""
    return Fixed(merson_step if name == "merson" else rk4_step, size)
