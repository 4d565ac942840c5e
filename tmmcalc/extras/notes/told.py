"""What the parts of the chapter say alike: the table of the input data, long tables."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

import numpy as np

from tmmcalc.extras.facts.rows import even
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Paragraph, Table
from tmmcalc.report.telling import column, data_table, tabulated

FIGURES = 7  # of a given number


def given(data: Iterable[Block], key: str, caption: str = "") -> Iterator[Block]:
    """The table of the given quantities."""
    yield Paragraph(tr("The input data are in table {tab}.", tab=f"{{tab:{key}}}"))
    yield data_table(caption or tr("Input data"), data, key, FIGURES)


def course(caption: str, columns: Mapping[str, np.ndarray], key: str) -> Table:
    """Some rows at equal steps of long columns; the first column heads the rows."""
    (name, values), *others = columns.items()
    rows = even(len(values))
    head, labels = column(name, values[rows])
    return tabulated(caption, {other: found[rows] for other, found in others}, labels, head=head, key=key)
