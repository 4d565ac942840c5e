"""What a scene can tell, by name: the list of its facts and columns, or what names and patterns ask for."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError
from tmmcalc.naming.anew import Anew, again_of
from tmmcalc.naming.language import Name, parse
from tmmcalc.naming.told import Extent, Told, listed, told, unknown
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult

HEADERS = ("name", "symbol", "unit", "value", "min", "max", "how", "meaning")


def names_document(run: RunResult, patterns: Sequence[str], title: str, people: bool = True) -> Document:
    """A row a quantity: stages in the order of the pipeline, of each its facts, then its columns with their extremes.

    For people a quantity is a line, else a row of a table. Raises UsageError for a pattern that names nothing, with
    the nearest names.
    """
    names = [parse(pattern) for pattern in patterns]
    found = list(_asked(run, names))
    for name in names:
        if not any(name.fits(_name(each)) for each in found):
            raise _nothing(name, run)
    facts = sum(isinstance(each, Told) for each in found)
    values = {"quantities": len(found), "facts": facts, "columns": len(found) - facts}
    text = f"{len(found)}: {facts} values, {len(found) - facts} columns of tables"
    count = Fact("quantities", text, values)
    if people:
        return Document(title, (count, *map(_fact, found)))
    return Document(title, (count,), table=View(HEADERS, list(zip(*map(_row, found), strict=True))))


def _asked(run: RunResult, names: Sequence[Name]) -> Iterator[Told | Extent]:
    """What the names ask for: a name without a function and a place is that of facts and of columns."""
    places = [name for name in names if not name.fact]
    anew = Anew(again_of(run.spec, places), run.results)
    for stage in run.outcomes:
        result = run.results[stage]
        if not names or any(name.fact and name.may_be_of(stage) for name in names):
            for each in listed(stage, result):
                if not names or any(name.fact and name.fits(_name(each)) for name in names):
                    yield each
        if places:
            yield from told(stage, result, places, anew)


def _name(each: Told | Extent) -> Name:
    name = parse(f"{each.stage}.{each.quantity}") if isinstance(each, Told) and each.how else None
    return (name or Name(each.stage, "", each.quantity))._replace(unit=each.unit)


def _nothing(name: Name, run: RunResult) -> UsageError:
    error = unknown(name, {stage: run.results[stage] for stage in run.outcomes})
    return UsageError(error.message, where="names", remedy=error.remedy)


def _row(each: Told | Extent) -> tuple[str | float, ...]:
    """Cells of a quantity; of a column the extremes of its rows in place of a value."""
    name = f"{each.stage}.{each.quantity}"
    if isinstance(each, Told):
        return name, each.symbol, each.unit, each.value, "", "", each.how, each.meaning
    return name, each.symbol, each.unit, "", each.least, each.greatest, f"{each.rows} rows", each.meaning


def _fact(each: Told | Extent) -> Fact:
    """The same for people: value and unit, how it was found, what it is."""
    if isinstance(each, Told):
        value, how = number(each.value), each.how
    else:
        value, how = f"{number(each.least)} .. {number(each.greatest)}", ""
    meaning = f"{each.symbol}, {each.meaning}" if each.symbol and each.meaning else each.meaning
    told = (f"{value} {each.unit}".rstrip(" -"), f"({how})" if how else "", meaning)
    return Fact(f"{each.stage}.{each.quantity}", "  ".join(part for part in told if part))
