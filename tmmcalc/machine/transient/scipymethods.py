"""The integrators of scipy behind the same face: RK45, DOP853, LSODA, Radau, BDF."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.steps import Derivative, State
from tmmcalc.machine.transient.jacobian import Jacobian
from tmmcalc.machine.transient.methods import HABITS

RELATIVE = 1e-13  # the tolerances are absolute; scipy wants a relative one, so it is set out of the way


class Library:
    """One scipy solver, begun anew for every piece of smooth motion."""

    def __init__(self, name: str, allowed: Sequence[float]) -> None:
        import scipy.integrate

        self._make = getattr(scipy.integrate, name)
        self._name, self._habit, self._allowed = name, HABITS[name], np.array(allowed)
        self._size: float | None = None
        self.error: State | None = None
        self.rejected = self.evaluations = 0

    def begin(self, f: Derivative, matrix: Jacobian, t: float, y: State, end: float) -> None:
        """Start a piece of smooth motion; a one-step method goes on with the step size of the piece before."""
        self._f, self._matrix = f, matrix
        self.t, self.y, self.rate = t, y, f(t, y)
        self._solver = self._solve(t, y, end, None if self._habit.multistep else self._size)

    def _solve(self, t: float, y: State, end: float, first: float | None) -> Any:
        more = {"jac": self._matrix} if self._habit.implicit else {}
        f = self._f
        return self._make(
            lambda t, y: f(t, y.tolist()),
            t,
            np.array(y),
            end,
            rtol=RELATIVE,
            atol=self._allowed,
            first_step=None if first is None else min(first, end - t),
            **more,
        )

    def step(self) -> None:
        """One step of the solver."""
        self.t0, self.y0, self.rate0 = self.t, self.y, self.rate
        self._advance(self._solver)
        self.t, self.y = float(self._solver.t), self._solver.y.tolist()
        self.rate = self._f(self.t, self.y)
        if self._solver.status != "finished":
            self._size = self.t - self.t0

    def _advance(self, solver: Any) -> None:
        before = solver.nfev
        with np.errstate(all="ignore"):
            message = solver.step()
        self.evaluations += solver.nfev - before
        if solver.status == "failed" or not math.isfinite(float(solver.y.sum())):
            raise AccuracyError(
                f"{self._name} failed at t = {float(solver.t):.9g} s: {message or 'values beyond all bounds'}",
                where="transient motion",
                value=float(solver.t),
                remedy="take another method, or raise the tolerance",
            )

    def to(self, t: float) -> State:
        """The state at a time within the last step: interpolated, or of a one-step method by a shorter step."""
        if self._habit.multistep:
            inside: list[float] = self._solver.dense_output()(t).tolist()
            return inside
        if t <= self.t0:
            return self.y0
        solver = self._solve(self.t0, self.y0, t, t - self.t0)
        while solver.status == "running":
            self._advance(solver)
        shorter: list[float] = solver.y.tolist()
        return shorter
