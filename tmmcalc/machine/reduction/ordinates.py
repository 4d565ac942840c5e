"""Simpson's rule as it is worked out on paper: the ordinates of a cause with their weights and their sum (3.38).

work = h/3 (y_0 + 4 y_1 + 2 y_2 + ... + 4 y_(n-1) + y_n)        h the step of the positions, n even
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np

from tmmcalc.core.columns import Column, column
from tmmcalc.core.errors import UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.simpson import simpson, simpson_weights
from tmmcalc.core.plane import Real
from tmmcalc.core.quantity import Quantity, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.reduction.columns import called, contribution_name, reduced
from tmmcalc.machine.reduction.results import Reduction

FACTOR = Quantity("Simpson[-]", "what an ordinate is multiplied by in Simpson's rule", source="(3.38)")
ORDINATE = Quantity("ordinate_{cause}[{unit}]", "ordinate of {cause} times its weight", source="(3.38)")
SUM = Quantity("sum_ordinates_{cause}[{unit}]", "sum of the weighted ordinates of {cause} so far", source="(3.38)")
EVERYTHING = "everything"


@record
class Ordinates:
    """The sums of Simpson's rule for one cause over chosen positions; forces [N] for a driven slider."""

    unit: str  # of the ordinates
    coordinate: str  # unit of the input coordinate
    step: float = quantity("step[{coordinate}]", "step of the positions", symbol="h")
    ends: float = quantity("ordinates_ends[{unit}]", "first and last ordinate together")
    odd: float = quantity("ordinates_odd[{unit}]", "ordinates that are taken four times, together")
    even: float = quantity("ordinates_even[{unit}]", "ordinates that are taken twice, together")
    weighted: float = quantity("ordinates_sum[{unit}]", "all ordinates times their weights")
    work: float = quantity("work_Simpson[J]", "a third of the step times that sum", source="(3.38)")
    exact: float = quantity("work[J]", "work over the same positions, exactly")


def ordinates(result: Reduction, rows: Sequence[int] | None = None) -> dict[str, Ordinates]:
    """The sums by cause over the positions with these indices, by default all.

    Raises `UsageError` unless these are equal steps of even number.
    """
    taken = _taken(result, rows)
    theta = _theta(result)[taken]
    _check(theta)
    weights, found = simpson_weights(len(taken)), {}
    for cause, (values, part) in _causes(result).items():
        y = values[taken]
        work = simpson(theta, np.copysign(1.0, result.speed) * y)  # done along the motion
        assert work is not None
        exact = np.diff(result.cycle.panels.primitive_at(part, theta[[0, -1]]))[0]
        found[cause] = Ordinates(
            unit=reduced(result).moment.unit,
            coordinate="rad" if result.turns else "m",
            step=float(theta[1] - theta[0]),
            ends=float(y[0] + y[-1]),
            odd=float(y[1:-1:2].sum()),
            even=float(y[2:-2:2].sum()),
            weighted=float(weights @ y),
            work=work,
            exact=float(exact),
        )
    return found


def _causes(result: Reduction) -> dict[str, tuple[Real, Real]]:
    """Moments (n,) and those on the panels (K, N) by their causes, and the sum of all where there are several."""
    names = (contribution_name(result, contribution) for contribution in result.contributions)
    found = dict(zip(names, zip(result.moment, result.parts, strict=True), strict=True))
    return {**found, EVERYTHING: (result.total, result.parts.sum(axis=0))} if len(found) > 1 else found


def _theta(result: Reduction) -> Real:
    """Angles (n,) of the positions along the motion."""
    return np.abs(result.phi - result.phi[0])


def _taken(result: Reduction, rows: Sequence[int] | None) -> np.ndarray:
    return np.arange(len(result.phi)) if rows is None else np.array(rows, int)


def _check(theta: Real) -> None:
    """Refuse positions over which there is no such rule."""
    count = len(theta) - 1
    steps = np.diff(theta)
    if count < 2 or count % 2:
        said = f"Simpson's rule takes an even number of steps, these are {max(count, 0)}"
    elif np.ptp(steps) > 1e-9 * abs(steps[0]) or steps[0] <= 0:
        said = "Simpson's rule takes equal steps, these positions differ in theirs"
    else:
        return
    remedy = "name positions that do, such as --positions 0:24:2, or set positions in [mechanism.grid]"
    raise UsageError(said, where="--ordinates", remedy=remedy)


def ordinate_columns(result: Reduction, rows: Sequence[int] | None = None) -> Iterator[Column]:
    """The weight of every position, and of every cause the ordinates with it and their sums; none without the rule.

    With ``rows``, which must be fit for the rule, the columns are theirs alone.
    """
    theta, taken = _theta(result), _taken(result, rows)
    if rows is None and simpson(theta, theta) is None:
        return
    weights, unit = simpson_weights(len(taken)), reduced(result).moment.unit

    def weighted(values: Real, *, summed: bool) -> Real:
        found = weights * values[taken]
        return np.cumsum(found) if summed else found

    words = {contribution_name(result, each): called(each) for each in result.contributions}
    yield column(FACTOR, lambda: weights)
    for cause, (values, _) in _causes(result).items():
        for told, summed in ((ORDINATE, False), (SUM, True)):
            meaning = Phrase(told.meaning, cause=words.get(cause, cause))
            own = told.of(cause=cause, unit=unit)._replace(meaning=meaning)
            yield column(own, partial(weighted, values, summed=summed))
