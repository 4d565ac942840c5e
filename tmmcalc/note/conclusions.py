"""The conclusions of the note: main results with their limits, then each warning of the program as a sentence."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from tmmcalc.core.notes import Note, graded
from tmmcalc.note.assembled import shown_unit
from tmmcalc.report.formula.digits import RESULT, significant
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Chapter, Paragraph, Result, Table
from tmmcalc.report.printing import printed_as
from tmmcalc.report.telling import points

SENSES = {"<=": "≤", ">=": "≥"}


def conclusions(chapters: Iterable[Chapter], warnings: Sequence[str], own: Sequence[Block]) -> Chapter:
    """What the person wrote, the table of main results, and what the program warns of."""
    results = [block for chapter in chapters for block in chapter.blocks if isinstance(block, Result)]
    return Chapter("conclusions", tr("Conclusions"), (*own, *_blocks(results, warnings)), number="")


def _blocks(results: Sequence[Result], warnings: Sequence[str]) -> Iterator[Block]:
    if results:
        yield Paragraph(tr("The main results are listed in table {tab:results}."))
        head = (tr("Quantity"), tr("Designation"), tr("Value"), tr("Limit"), tr("Kept"))
        yield Table(tr("Main results"), head, tuple(map(_row, results)), key="results")
    known = {(each.value, each.limit) for each in warnings if isinstance(each, Note)}
    failing = [each for each in results if _kept(each) is False and (each.given.value, each.limit) not in known]
    if failing:
        yield Paragraph(tr("Limits that are not kept:"))
        yield points([_sentence(each) for each in failing])
    if warnings:
        yield Paragraph(tr("To be borne in mind:"))
        yield points([tr_name(graded(each)[1]) for each in warnings])


def _row(result: Result) -> tuple[str, ...]:
    kept = _kept(result)
    limit = "" if result.limit is None else f"{SENSES[result.sense]} {_value(result, result.limit)}"
    what = f"{result.given.meaning}, {result.place}" if result.place else result.given.meaning
    return (
        what,
        f"${result.key}$" if result.key else "",
        _value(result),
        limit,
        "" if kept is None else tr("yes") if kept else tr("no"),
    )


def _value(result: Result, value: float | None = None) -> str:
    unit, factor = printed_as(result.given.unit)
    found = result.given.value if value is None else value
    assert isinstance(found, float)
    digits = f"${significant(found * factor, RESULT)}$"
    return digits + (shown_unit(unit) if unit == "deg" else f" {shown_unit(unit)}" if unit else "")


def _kept(result: Result) -> bool | None:
    """Whether the limit is kept; None without one."""
    if result.limit is None:
        return None
    assert isinstance(result.given.value, float)
    return result.given.value <= result.limit if result.sense == "<=" else result.given.value >= result.limit


def _sentence(result: Result) -> str:
    value, limit = _value(result), _value(result, result.limit)
    what = f"{result.given.meaning} ${result.key}$" if result.key else result.given.meaning
    values = {"what": what, "value": value, "limit": limit}
    if result.sense == "<=":
        return tr("{what} = {value} is above {limit}", **values)
    return tr("{what} = {value} is below {limit}", **values)
