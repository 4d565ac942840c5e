"""The conclusions of the note: main results with their limits, then each warning of the program as a sentence."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from math import isclose

from tmmcalc.core.notes import Note, graded
from tmmcalc.note.assembled import shown_unit
from tmmcalc.report.formula.digits import RESULT, significant
from tmmcalc.report.formula.symbols import with_letters
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Chapter, Paragraph, Result, Table
from tmmcalc.report.printing import printed_as
from tmmcalc.report.telling import LATIN, points

GREEK = "".join(LATIN)
SYMBOL = re.compile(rf"\b(?:[{GREEK}]|[A-Za-z{GREEK}]_[A-Za-z0-9{GREEK}]+)\b")
DEGREES = re.compile(r"(?<=\d) deg\b")
SAME = 1e-9  # relative
SENSES = {"<=": "≤", ">=": "≥"}


def conclusions(chapters: Iterable[Chapter], warnings: Sequence[str], own: Sequence[Block]) -> Chapter:
    """What the person wrote, the table of main results, and what the program warns of."""
    results = [block for chapter in chapters for block in chapter.blocks if isinstance(block, Result)]
    return Chapter("conclusions", tr("Conclusions"), (*own, *_blocks(results, warnings)), number="")


def _blocks(results: Sequence[Result], warnings: Sequence[str]) -> Iterator[Block]:
    kept = [each for each in map(_kept, results) if each is not None]
    if results:
        held = f" {tr('All limits in the table are kept.')}" if kept and all(kept) else ""
        yield Paragraph(tr("The main results are listed in table {tab:results}.") + held)
        head = (tr("Quantity"), tr("Designation"), tr("Value"), tr("Limit"), tr("Kept"))
        columns = len(head) if any(each.limit is not None for each in results) else len(head) - 2
        rows = tuple(_row(each)[:columns] for each in results)
        yield Table(tr("Main results"), head[:columns], rows, key="results")
    told = list(_once(warnings))
    parts = [each.value / each.limit for each in told if isinstance(each, Note) and each.value and each.limit]
    failing = [each for each in results if _kept(each) is False and not _warned(each, parts)]
    if failing:
        yield Paragraph(tr("Limits that are not kept:"))
        yield points([_sentence(each) for each in failing])
    if told:
        yield Paragraph(tr("To be borne in mind:"))
        yield points([_lettered(tr_name(graded(each)[1])) for each in told])


def _once(warnings: Sequence[str]) -> Iterator[str]:
    """The warnings without those of a number and a limit that an earlier one is about."""
    known: set[tuple[float, float]] = set()
    for each in warnings:
        if isinstance(each, Note) and each.value and each.limit:
            about = each.value, each.limit
            if about in known:
                continue
            known.add(about)
        yield each


def _lettered(text: str) -> str:
    """A sentence of the program with its Greek letters and indices as formulas, and the sign of degrees.

    >>> _lettered("|theta| reaches 47.3 deg at φ = 25.4 deg, r_i = 75 mm")
    '|$theta$| reaches 47.3° at $phi$ = 25.4°, $r_i$ = 75 mm'
    """
    found = SYMBOL.sub(lambda symbol: f"${''.join(LATIN.get(each, each) for each in symbol[0])}$", with_letters(text))
    return DEGREES.sub("°", found)


def _warned(result: Result, parts: Sequence[float]) -> bool:
    """Whether a warning is about a result: its value in parts of its limit, in whatever unit."""
    assert isinstance(result.given.value, float)
    if not result.limit:
        return False
    own = result.given.value / result.limit
    return any(isclose(own, part, rel_tol=SAME) for part in parts)


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
