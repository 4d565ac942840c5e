"""What the parts of the chapter say alike: the table of the input data, long tables."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from tmmcalc.extras.facts.rows import even
from tmmcalc.report.formula.digits import significant
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Lexicon, Paragraph, Table
from tmmcalc.report.printing import printed_as
from tmmcalc.report.telling import column, tabulated

FIGURES = 7  # of a given number


def given(lexicon: Lexicon, names: Sequence[str], key: str, caption: str = "") -> Iterator[Block]:
    """The table of the given quantities that the scene has."""
    rows = []
    for name in names:
        found = lexicon.get(canonical(name))
        if found is not None and isinstance(found.value, float):
            unit, factor = printed_as(found.unit)
            value = f"${significant(factor * found.value, FIGURES)}$"
            rows.append((found.meaning, f"${name}$", value, "°" if unit == "deg" else tr_unit(unit)))
    yield Paragraph(tr("The input data are in table {tab}.", tab=f"{{tab:{key}}}"))
    head = tr("Quantity"), tr("Designation"), tr("Value"), tr("Unit")
    wide = 4 if any(unit for *_, unit in rows) else 3  # without a column of units where none has one
    yield Table(caption or tr("Input data"), head[:wide], tuple(row[:wide] for row in rows), key)


def course(caption: str, columns: Mapping[str, np.ndarray], key: str) -> Table:
    """Some rows at equal steps of long columns; the first column heads the rows."""
    (name, values), *others = columns.items()
    rows = even(len(values))
    head, labels = column(name, values[rows])
    return tabulated(caption, {other: found[rows] for other, found in others}, labels, head=head, key=key)
