"""The document of Simpson's rule: a row a position with the weighted ordinates of every cause, the sums above them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.columns import Column
from tmmcalc.core.quantity import in_degrees, keyed
from tmmcalc.machine.reduction.columns import EFFICIENCY, columns, reduced
from tmmcalc.machine.reduction.ordinates import (
    EVERYTHING,
    FACTOR,
    ORDINATE,
    SUM,
    Ordinates,
    ordinate_columns,
    ordinates,
)
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
    unit = reduced(result).moment.unit
    known = (column for column in columns(result) if column.name != EFFICIENCY.name)  # which has no value everywhere
    own = [*(_of(column, taken) for column in known), *ordinate_columns(result, taken)]
    by_name = {column.name: column for column in own}
    sizes = {c: float(np.sum(np.abs(by_name[ORDINATE.of(cause=c, unit=unit).name].make()))) for c in sums}
    facts = tuple(_fact(cause, each, sizes[cause]) for cause, each in sums.items())
    told = reduced(result)
    terms = (ORDINATE, SUM) if everything else (ORDINATE,)
    shown = ["phi", FACTOR.name]
    for cause in sums:
        own_moment = told.moment if cause == EVERYTHING else told.of_cause.of(cause=cause)
        shown += [own_moment.name, *(term.of(cause=cause, unit=unit).name for term in terms)]
    return with_positions(
        Document(title, facts),
        [result.labels[row] for row in taken],
        own,
        patterns,
        None,
        usual=[by_name[name] for name in shown],
        everything=True,
        example="phi,Simpson,ordinate_*,sum_*",
        where="",
    )


def _of(column: Column, taken: Sequence[int]) -> Column:
    """The column of some of the positions."""
    return column._replace(make=lambda: column.make()[list(taken)])


def _fact(cause: str, found: Ordinates, peak: float) -> Fact:
    """The sum in the letters of the rule, and the work beside the exact one; less than noise of ``peak`` is none."""
    unit, coordinate = found.unit, found.coordinate
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
