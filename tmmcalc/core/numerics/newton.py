"""Newton's method for the collocation equations of all panels at once.

On every panel the states are the values at the Radau points, with the start handed on by the panel before. Linearised,
each panel is an affine map from its start to its end; the maps are chained, and a small linear system closes the chain.

States are held as a start and the rise above it, so that a period is closed to rounding of the rise and not of the
state: a solution that hardly varies keeps its digits.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.radau import Radau

NOISE = 1e-7  # relative step below which one that does not shrink is rounding
ITERATIONS = 30
SHORTENED = 8  # steps in a row that end at a floor: there is no solution above it
TINY = float(np.finfo(float).tiny)

Rates = Callable[[Values], tuple[Values, Values, Values]]
"""y (m, K, N) -> f (m, K, N), df/dy (m, m, K, N), and further functions (w, K, N) that have to be resolved."""


class Ends(NamedTuple):
    """Linear conditions ``first @ y(start) + last @ y(end) = value`` that close the problem."""

    first: Values  # (m, m)
    last: Values  # (m, m)
    value: Values  # (m,)


class State(NamedTuple):
    """The values of m states on K panels of N points."""

    start: Values  # (m,)
    rise: Values  # (m, K, N) y - start at the Radau points

    @property
    def y(self) -> Values:
        """The states (m, K, N) at the Radau points."""
        return self.start[:, None, None] + self.rise

    @property
    def before(self) -> Values:
        """Rise (m, K) at the start of every panel: a polynomial ends on its last point."""
        rise = np.zeros(self.rise.shape[:2])
        rise[:, 1:] = self.rise[:, :-1, -1]
        return rise


class Measure(NamedTuple):
    """How the m states are measured: from a floor up, by their value; without one, by their largest."""

    floor: Values  # (m,) what a state stays above; -inf: nothing
    typical: Values  # (m,) size below which a state without floor counts as zero

    def sizes(self, *y: Values) -> Values:
        """Sizes (m, K, N) of states, of the first of several where there is a floor, else of the largest."""
        size = np.abs(y[0])
        for i in np.flatnonzero(~np.isfinite(self.floor)):
            size[i] = max(float(self.typical[i]), TINY, *(float(np.max(np.abs(each[i]))) for each in y))
        return size


class Settled(NamedTuple):
    """Where Newton's method ended."""

    state: State
    monodromy: Values
    step: float  # last relative step
    next: float  # bound of the one that would come next
    iterations: int


def newton(
    scheme: Radau,
    width: Values,
    rates: Rates,
    ends: Ends,
    state: State,
    measure: Measure,
    target: float,
    last: float,
) -> Settled:
    """The solution on one mesh, when the next step is bound to fall below ``target``.

    ``width`` (K,) are the widths of the panels, ``last`` the step before. Raises `AccuracyError` if the method
    does not converge.
    """
    shortened = 0
    for iteration in range(1, ITERATIONS + 1):
        # a wild step may overflow: it is not finite then, and the search ends
        with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
            try:
                change, monodromy = _linear(scheme, width, rates, ends, state)
            except np.linalg.LinAlgError:
                break
            y, delta = state.y, change.start[:, None, None] + change.rise
            part = _safe(y - measure.floor[:, None, None], delta)
            step = float(np.max(np.abs(delta) / measure.sizes(y, y + delta)))
        state = State(state.start + part * change.start, state.rise + part * change.rise)
        shortened = 0 if part == 1 else shortened + 1
        if not np.isfinite(step) or shortened > SHORTENED:
            break
        # steps shrink at least as fast as they did, unless rounding stops them
        rate = step / last if last < np.inf else 1.0
        if part == 1 and (step * min(rate, 1.0) < target or (step < NOISE and rate > 0.25)):
            return Settled(state, monodromy, step, step * min(rate, 1.0), iteration)
        last = step
    raise AccuracyError("Newton's method does not converge", where="collocation", value=last, limit=target)


def _safe(room: Values, delta: Values) -> float:
    """The part of a step that leaves every state at least a fifth of its ``room`` above the floor."""
    shrink = float(np.max(-delta / room))
    return 1.0 if shrink <= 0.8 else 0.8 / shrink


def _linear(scheme: Radau, width: Values, rates: Rates, ends: Ends, state: State) -> tuple[State, Values]:
    """The full Newton step and the monodromy matrix of the linearised equations."""
    f, jacobian, _ = rates(state.y)
    m, count, n = f.shape
    before = state.before
    matrix = _matrices(scheme, width, jacobian)
    right = np.zeros((count, n, m, 1 + m))
    residual = width[:, None] * (f @ scheme.primitive.T) - (state.rise - before[..., None])
    right[..., 0] = residual.transpose(1, 2, 0)
    right[..., 1:] = np.eye(m)
    solved = np.linalg.solve(matrix, right.reshape(count, n * m, 1 + m)).reshape(right.shape)
    chain = _chain(solved[:, -1])
    total, end = chain[-1, 1:, 1:], state.rise[:, -1, -1] + chain[-1, 1:, 0]
    missing = ends.value - (ends.first + ends.last) @ state.start - ends.last @ end
    start = np.linalg.solve(ends.first + ends.last @ total, missing)
    at_starts = chain[:-1, 1:] @ np.append(1.0, start)
    delta = solved[..., 0] + np.einsum("kiab,kb->kia", solved[..., 1:], at_starts)
    return State(start, delta.transpose(2, 0, 1) - start[:, None, None]), total


def _matrices(scheme: Radau, width: Values, jacobian: Values) -> Values:
    """Matrices (K, N m, N m) of the panels: identity minus h A times the Jacobian of each point."""
    m, _, count, n = jacobian.shape
    scaled = -width[:, None, None] * scheme.primitive
    matrix = (scaled[:, :, None, :, None] * jacobian.transpose(2, 0, 3, 1)[:, None]).reshape(count, n * m, n * m)
    diagonal = np.arange(n * m)
    matrix[:, diagonal, diagonal] += 1
    return matrix


def _chain(last: Values) -> Values:
    """Affine maps (K + 1, 1 + m, 1 + m) of (1, state) from the first start to every edge.

    ``last`` (K, m, 1 + m) holds the constant and the matrix of each panel.
    """
    count, m, _ = last.shape
    chain = np.zeros((count + 1, 1 + m, 1 + m))
    chain[0] = np.eye(1 + m)
    chain[1:, 0, 0] = 1.0
    chain[1:, 1:] = last
    reach = 1  # every map takes the one before it as well, then the two before these, the four ...
    while reach < count:
        chain[1 + reach :] = chain[1 + reach :] @ chain[1:-reach]
        reach *= 2
    return chain
