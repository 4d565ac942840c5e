"""The task: what the person wrote of it, the scheme, the given data in a table, what is to be found."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmmcalc.note.assembled import shown_unit
from tmmcalc.report.formula.digits import of_given, significant
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Chapter, Datum, Figure, Paragraph, Table
from tmmcalc.report.printing import printed_as
from tmmcalc.report.telling import points


def task(given: Sequence[Block], sought: Sequence[str], own: Sequence[Block]) -> Iterator[Chapter]:
    """The chapter, which has no number; none where nothing is known of it."""
    blocks = (*own, *_blocks(given, sought))
    if blocks:
        yield Chapter("task", tr("Task"), blocks, number="")


def _blocks(given: Sequence[Block], sought: Sequence[str]) -> Iterator[Block]:
    figures = [block for block in given if isinstance(block, Figure)]
    data = [block for block in given if isinstance(block, Datum)]
    if figures:
        scheme = f"{{fig:{figures[0].key}}}"
        yield Paragraph(tr("The scheme is shown in figure {figure}.", figure=scheme))
        yield from figures
    if data:
        yield Paragraph(tr("The given data are listed in table {tab:given}."))
        head = (tr("Quantity"), tr("Designation"), tr("Value"))
        yield Table(tr("Given data"), head, tuple(map(row_of, data)), "given")
    if sought:
        yield Paragraph(tr("To be found:"))
        yield points(sought)


def row_of(datum: Datum) -> tuple[str, str, str]:
    """What is given, its names, its value with its unit."""
    unit, factor = printed_as(datum.unit)
    sign = shown_unit(unit)
    each = sign if unit == "deg" else ""  # every angle has its own
    scaled = [value * factor for value in datum.values]
    values = "; ".join(f"${significant(value, of_given(scaled))}${each}" for value in scaled)
    said = values if each or not sign else f"{values} {sign}"
    return datum.what, ", ".join(f"${key}$" for key in datum.keys), datum.text or said
