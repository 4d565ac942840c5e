"""Equations of motion in time, to be set beside closed forms: methods with step control and with fixed steps."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.steps import merson_step
from tmmcalc.core.records import record
from tmmcalc.core.studies.measure import Clock, Way, series
from tmmcalc.core.studies.study import Series

CONTROLLED = ("RK45", "DOP853", "LSODA", "Radau", "BDF")
TOLERANCES = (1e-4, 1e-6, 1e-8, 1e-10)
ORDER = 4.0  # of Kutta-Merson
STAGES = 5  # evaluations of a step of it

Slopes = Callable[[Any, Any], Any]


@record
class Run:
    """States (m, n) at the n instants asked for, and the evaluations that they took."""

    states: Values
    evaluations: int


@record
class Start:
    """y' = f(t, y) from t = 0 on: the state there, the instants (n,), the sizes (m,) of the states."""

    slopes: Slopes
    state: Values
    instants: Values
    sizes: Values


def controlled(
    start: Start, error: Callable[[Run], float], clock: Clock, names: Sequence[str] = CONTROLLED
) -> Iterator[Series]:
    """The methods of scipy at several tolerances."""
    for name in names:
        ways = [Way(f"tolerance {t:.0e}", t, partial(_by_scipy, start, name, t), _evaluations) for t in TOLERANCES]
        yield series(name, ways, error, clock, stepwise=False)


def stepped(start: Start, counts: Sequence[int], error: Callable[[Run], float], clock: Clock, note: str = "") -> Series:
    """Kutta-Merson in n equal steps to the last instant; instants have to be nodes of all of them."""
    ways = [Way(f"{n} steps", 1 / n, partial(_by_merson, start, n), _evaluations) for n in counts]
    return series("merson, fixed steps", ways, error, clock, expected=ORDER, note=note)


def _evaluations(run: Run) -> int:
    return run.evaluations


def _by_scipy(start: Start, name: str, tolerance: float) -> Run:
    from scipy.integrate import solve_ivp

    done = solve_ivp(
        start.slopes,
        (0.0, float(start.instants[-1])),
        start.state,
        method=name,
        t_eval=start.instants,
        rtol=max(tolerance, 1e-13),
        atol=tolerance * start.sizes,
    )
    if not done.success:
        raise AccuracyError(f"{name} ends before the motion does", where="accuracy", remedy="a coarser tolerance")
    return Run(done.y, int(done.nfev))


def _by_merson(start: Start, count: int) -> Run:
    step = float(start.instants[-1]) / count
    kept = np.rint(start.instants / step).astype(int)
    state, states = start.state.tolist(), [start.state.tolist()]
    with np.errstate(over="ignore", invalid="ignore"):
        for k in range(count):
            state, _ = merson_step(start.slopes, k * step, state, step)
            states.append(state)
    found: Values = np.array(states).T[:, kept]
    if not np.all(np.isfinite(found)):
        raise AccuracyError("fixed steps are unstable", where="accuracy", remedy="a shorter step")
    return Run(found, STAGES * count)
