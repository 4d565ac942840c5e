"""The least constant inertia for which the speed fluctuates little enough, on any model of the motion.

The model is a function inertia -> delta, None where the machine stalls. The search is a bracketed secant in the
variables J^2 and 1/delta^2: for one harmonic of load against a straight motor characteristic these depend on each other
by a straight line, delta^2 = 1/(a + b J^2), so three or four runs of the model give all digits.

The textbook's own correction J := J delta/[delta] (3.60) is here too. It comes from delta ~ 1/J and under-corrects,
because the slip of the motor damps the fluctuation as well.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from tmmcalc.core.errors import AccuracyError, NoSolutionError
from tmmcalc.machine.flywheel.results import Trial

Model = Callable[[float], float | None]  # constant inertia [kg*m^2] -> delta, or None where the machine stalls

REACHED = 1e-9  # relative deviation of delta from the one asked for
NARROW = 1e-13  # relative width of a bracket that cannot be told from a point
RUNS = 80
EAGER = 6  # runs that trust the secant alone
LEAST = 1e-3  # of the upper end: the lower one counts as this at least when a bracket is halved
LARGEST = 1e6  # times the first guess: where the search upwards gives up


def tried(model: Model, inertia: float, trials: list[Trial]) -> Trial:
    """Run the model and note it among the ``trials``."""
    trial = Trial(inertia, model(inertia))
    trials.append(trial)
    return trial


def sufficient(trial: Trial, delta: float) -> bool:
    """Whether the machine runs with a fluctuation of at most ``delta``, but for rounding."""
    return trial.delta is not None and trial.delta <= delta * (1 + REACHED)


def least_inertia(model: Model, delta: float, low: Trial, start: Trial, trials: list[Trial]) -> Trial:
    """The root of model(J) = ``delta`` above ``low``, which is too small, sought from ``start`` on upwards or down.

    Every run is added to ``trials``. Raises `NoSolutionError` if no inertia is large enough, and `AccuracyError` if the
    root is not reached.
    """
    last, trial = low, start
    while not sufficient(trial, delta):
        low, x = trial, trial.inertia
        if x > LARGEST * start.inertia:
            raise NoSolutionError(
                f"no constant inertia up to {x:.3g} kg*m^2 brings delta down to {delta:g}",
                where="flywheel",
                value=x,
                remedy="take a motor that regulates itself and carries the mean load, or allow a larger delta",
            )
        ahead = _ahead(last, trial, delta)
        last, trial = trial, tried(model, min(ahead, 4 * x) if ahead and ahead > x else 2 * x, trials)
    return inertia_between(model, delta, low, trial, trials)


def inertia_between(model: Model, delta: float, low: Trial, high: Trial, trials: list[Trial]) -> Trial:
    """The root of model(J) = ``delta`` between ``low`` (too small) and ``high`` (large enough)."""
    last, trial = low, high
    for run in range(RUNS):
        narrow = high.inertia - low.inertia <= NARROW * high.inertia
        if narrow or (high.delta is not None and high.delta >= delta * (1 - REACHED)):
            return high
        # the secant ends the search long before; halving in turn with it guards against a jump of delta
        x = _ahead(last, trial, delta) if run < EAGER or run % 2 else None
        if x is None or not low.inertia < x < high.inertia:
            x = math.sqrt(max(low.inertia, LEAST * high.inertia) * high.inertia)
        last, trial = trial, tried(model, x, trials)
        low, high = (low, trial) if sufficient(trial, delta) else (trial, high)
    raise AccuracyError(
        f"the inertia for delta = {delta:g} was not found within {RUNS} runs",
        where="flywheel",
        value=high.inertia,
        remedy="delta may jump with the inertia here; ask for a slightly different delta",
    )


def corrections(
    model: Model, delta: float, constant_inertia: float, *, tolerance: float = 1e-3, limit: int = 12
) -> tuple[Trial, ...]:
    """History of the textbook's correction (3.60): J := J delta(J)/[delta] until delta(J) <= [delta] (1 + tolerance).

    The exact [delta] is only approached, never undercut, hence the tolerance; at most ``limit`` runs are made. Raises
    `NoSolutionError` if the machine stalls on the way.
    """
    history: list[Trial] = []
    inertia = constant_inertia
    for _ in range(limit):
        reached = tried(model, inertia, history).delta
        if reached is None:
            raise NoSolutionError(
                f"the machine stalls with a constant inertia of {inertia:.6g} kg*m^2, so there is nothing to correct",
                where="flywheel, correction (3.60)",
                value=inertia,
                remedy="begin with a larger inertia",
            )
        if reached <= delta * (1 + tolerance):
            break
        inertia *= reached / delta
    return tuple(history)


def _ahead(last: Trial, trial: Trial, delta: float) -> float | None:
    """Where the line through two trials in (J^2, 1/delta^2) meets the asked delta.

    With one trial alone it is the line from the origin, which is the textbook's correction (3.60).
    """
    if not trial.delta:
        return None
    x, y = trial.inertia**2, trial.delta**-2
    if not last.delta or last.inertia == trial.inertia:
        return trial.inertia * trial.delta / delta
    if last.delta == trial.delta:
        return None
    square = x + (delta**-2 - y) * (x - last.inertia**2) / (y - last.delta**-2)
    return math.sqrt(square) if square > 0 else None
