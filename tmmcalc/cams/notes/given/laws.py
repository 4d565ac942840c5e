"""What is given of a law of motion of one's own: its points, accelerations or coefficients."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.cams.tables.cam_law import LawTable
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Datum


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
    if law.polynomial is not None:
        what = tr("coefficients of the powers 0, 1, 2 ... of the part of the phase, to any scale")
        yield Datum(f"{said}: {what}", (), tuple(law.polynomial))
        return
    places, values = zip(*(law.points or law.acceleration or ()), strict=True)
    parts = tuple(place / places[-1] for place in places)
    yield Datum(f"{said}: {tr('parts of the phase at which its points stand')}", (), parts)
    if law.points is not None:
        strokes = tuple(value / values[-1] for value in values)
        yield Datum(f"{said}: {tr('displacements there, in parts of the stroke')}", (), strokes)
        smooth = tr("smooth curve, at rest and without acceleration at both ends")
        yield Datum(f"{said}: {tr('between the points')}", text=smooth)
    else:
        yield Datum(f"{said}: {tr('accelerations there, to any scale')}", (), values)
        yield Datum(f"{said}: {tr('between the points')}", text=tr("straight lines"))
