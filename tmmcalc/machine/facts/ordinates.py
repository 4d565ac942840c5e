"""The document of Simpson's rule: a row a position with the weighted ordinates of every cause, the sums above them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.columns import Column
from tmmcalc.core.quantity import in_degrees, keyed
from tmmcalc.machine.reduction.columns import columns, reduced
from tmmcalc.machine.reduction.ordinates import FACTOR, ORDINATE, Ordinates, ordinate_columns, ordinates
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import NOISE, number
from tmmcalc.report.positions import with_positions


def ordinates_document(
    result: Reduction,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
) -> Document:
    """Simpson's rule over the positions with these indices, by default all; ``patterns`` choose columns.

    Raises `UsageError` unless the positions are equal steps of even number.
    """
    taken = range(len(result.phi)) if rows is None else rows
    sums = ordinates(result, taken)
    unit, coordinate = reduced(result).moment.unit, "rad" if result.turns else "m"
    own = [*(_of(column, taken) for column in columns(result)), *ordinate_columns(result, taken)]
    by_name = {column.name: column for column in own}
    sizes = {c: float(np.sum(np.abs(by_name[ORDINATE.of(cause=c, unit=unit).name].make()))) for c in sums}
    facts = tuple(_fact(cause, each, sizes[cause], unit, coordinate) for cause, each in sums.items())
    told = reduced(result)
    pairs = ((told.of_cause.of(cause=cause).name, ORDINATE.of(cause=cause, unit=unit).name) for cause in sums)
    shown = ("phi", FACTOR.name, *(name for pair in pairs for name in pair if name in by_name))
    return with_positions(
        Document(title, facts),
        [result.labels[row] for row in taken],
        own,
        patterns,
        None,
        usual=own if everything else [by_name[name] for name in shown],
        everything=True,
        example="phi,Simpson,ordinate_*,sum_*",
        where="",
    )


def _of(column: Column, taken: Sequence[int]) -> Column:
    """The column of some of the positions."""
    return column._replace(make=lambda: column.make()[list(taken)])


def _fact(cause: str, found: Ordinates, peak: float, unit: str, coordinate: str) -> Fact:
    """The sum in the letters of the rule, and the work beside the exact one; less than noise of ``peak`` is none."""
    ends, odd, even = (number(value, peak=peak) for value in (found.ends, found.odd, found.even))
    lines = [
        f"h/3 (ends {ends} + 4 * {odd} + 2 * {even}) {unit}",
        f"= {number(found.step)}/3 {coordinate} * {number(found.weighted, peak=peak)} {unit}"
        f" = {number(found.work, peak=peak * found.step)} J",
    ]
    exact = f"exactly {number(found.exact, peak=peak * found.step)} J"
    if abs(found.exact) > NOISE * peak * found.step:
        exact += f", {100 * (found.work / found.exact - 1):+.3g} %"
    values = in_degrees(keyed(found, unit=unit, coordinate=coordinate))
    return Fact(f"work of {cause}", "\n".join((*lines, exact)), {f"Simpson_{cause}": values})
