"""What is given of an indexing drive: the law of its step, sizes, friction."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.cams.notes.given.laws import of_law
from tmmcalc.cams.notes.indexing import given_names, law_name
from tmmcalc.cams.notes.stepping.quantities import stepping_of
from tmmcalc.cams.tables.cam_law import LawTable
from tmmcalc.cams.tables.tasks.indexing import to_indexing
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Datum
from tmmcalc.report.telling import data_of


def of_indexing(order: Order) -> Iterator[Datum]:
    """The indexing drive, and in how many parts its step is told."""
    if "indexing" not in order.results:
        return
    table, of = order.spec.indexing, stepping_of(to_indexing(order.spec), order.results["indexing"])
    yield Datum(tr("law of the step"), text=law_name(of.found))
    if isinstance(table.law, LawTable):
        yield from of_law(table.law, tr("law of the step"))
    yield from data_of(of.lexicon, given_names(of))
    if of.found.cam is not None:
        yield Datum(tr("number of equal parts of the step in the tables"), (), (float(table.steps),))
