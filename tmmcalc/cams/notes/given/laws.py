"""What is given of a law of motion of one's own: its points, accelerations or coefficients."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.cams.tables.cam_law import LawTable
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Datum
from tmmcalc.report.telling import between, in_rows, owned


def of_laws(rise: str | LawTable, back: str | LawTable) -> Iterator[Datum]:
    """The numbers of the laws of rise and return, once where they are one."""
    if rise is back:
        yield from of_law(rise, tr("law of rise and return"))
    else:
        yield from of_law(rise, tr("law of the rise"))
        yield from of_law(back, tr("law of the return"))


def of_law(law: str | LawTable, said: str) -> Iterator[Datum]:
    """A law by its table; one of the catalogue has no numbers. Only the shape counts, to any scale."""
    if isinstance(law, str):
        return
    of = owned(said)
    if law.polynomial is not None:
        what = tr("coefficients of the powers 0, 1, 2 ... of the part of the phase, to any scale")
        yield Datum(of(what), (), tuple(law.polynomial))
        return
    places, values = zip(*(law.points or law.acceleration or ()), strict=True)
    parts = tuple(place / places[-1] for place in places)
    curve = between("linear")
    there = Datum(of(tr("accelerations there, to any scale")), (), values)
    if law.points is not None:
        strokes = tuple(value / values[-1] for value in values)
        there = Datum(of(tr("displacements there, in parts of the stroke")), (), strokes)
        curve = tr("smooth curve, at rest and without acceleration at both ends")
    yield from in_rows(Datum(of(tr("parts of the phase at which its points stand")), (), parts), there)
    yield Datum(of(tr("between the points")), text=curve)
