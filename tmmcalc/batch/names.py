"""What a scene can tell, by name: the list of its facts and columns, or what names and patterns ask for."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isnan, nan
from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError
from tmmcalc.naming.language import Name, parse
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import CHOICE, Extent, Told, chosen, listed, offered, told, unknown
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult

HEADERS = ("name", "symbol", "unit", "value", "min", "max", "how", "meaning")


def names_document(run: RunResult, patterns: Sequence[str], title: str, people: bool = True) -> Document:
    """A row a quantity: stages in the order of the pipeline, of each its facts, then its columns with their extremes.

    For people a quantity is a line, else a row of a table. What is by choice is listed without its values unless it is
    asked for by name. Raises UsageError for a pattern that names nothing, with the nearest names.
    """
    names = [parse(pattern) for pattern in patterns]
    scene = Scene(run.spec, run.results)
    found = list(_asked(run, names, scene) if names else _every(run, scene))
    for name in names:
        if not any(name.fits(_name(each)) for each in found):
            raise _nothing(name, run, scene)
    choice = sum(_by_choice(each) for each in found)
    facts = sum(isinstance(each, Told) and not _by_choice(each) for each in found)
    values = {"quantities": len(found), "facts": facts, "columns": len(found) - facts - choice, "by_choice": choice}
    text = f"{len(found)}: {facts} values, {values['columns']} columns of tables"
    count = Fact("quantities", f"{text}, {choice} by choice" if choice else text, values)
    if people:
        return Document(title, (count, *map(_fact, found)))
    return Document(title, (count,), table=View(HEADERS, list(zip(*map(_row, found), strict=True))))


def _every(run: RunResult, scene: Scene) -> Iterator[Told | Extent]:
    """All that the stages tell, of each what stands in its documents and tables, then what is by choice."""
    for stage in run.outcomes:
        own = [*listed(stage, run.results[stage])]
        yield from own
        facts, columns = ({each.quantity for each in own if isinstance(each, kind)} for kind in (Told, Extent))
        for each in offered(stage, scene):
            if each.quantity not in (facts if isinstance(each, Told) else columns):
                yield each


def _asked(run: RunResult, names: Sequence[Name], scene: Scene) -> Iterator[Told | Extent]:
    """What the names ask for: a name without a function and a place is that of facts and of columns."""
    found: dict[str, list[Told | Extent]] = {stage: [] for stage in run.outcomes}
    whole = [name for name in names if name.fact]
    for stage, own in found.items():
        if any(name.may_be_of(stage) for name in whole):
            every = listed(stage, run.results[stage])
            own += [each for each in every if any(name.fits(_name(each)) for name in whole)]
    met = [_name(each) for own in found.values() for each in own]
    missed = [name for name in whole if not any(name.fits(each) for each in met)]
    for stage, own in found.items():
        own += chosen(stage, missed, scene)
    if places := [name for name in names if not name.fact]:
        for told_there in told(run.results, places, scene):
            found[told_there.stage].append(told_there)
    for own in found.values():
        yield from own


def _by_choice(each: Told | Extent) -> bool:
    return each.how == CHOICE if isinstance(each, Told) else each.choice


def _name(each: Told | Extent) -> Name:
    asked = isinstance(each, Told) and each.how not in ("", CHOICE)
    name = parse(f"{each.stage}.{each.quantity}") if asked else Name(each.stage, "", each.quantity)
    return name._replace(unit=each.unit)


def _nothing(name: Name, run: RunResult, scene: Scene) -> UsageError:
    error = unknown(name, {stage: run.results[stage] for stage in run.outcomes}, scene)
    return UsageError(error.message, where="names", remedy=error.remedy)


def _how(each: Told | Extent) -> str:
    """How a value was found, or of how many rows the extremes are; what is by choice says so."""
    if isinstance(each, Told):
        return each.how
    rows = f"{each.rows} rows" if each.rows else ""
    return f"{rows}, {CHOICE}".removeprefix(", ") if each.choice else rows


def _row(each: Told | Extent) -> tuple[str | float, ...]:
    """Cells of a quantity; of a column the extremes of its rows in place of a value."""
    values = (each.value, nan, nan) if isinstance(each, Told) else (nan, each.least, each.greatest)
    cells = ("" if isnan(value) else value for value in values)
    return f"{each.stage}.{each.quantity}", each.symbol, each.unit, *cells, _how(each), each.meaning


def _fact(each: Told | Extent) -> Fact:
    """The same for people: value and unit, how it was found, what it is."""
    if isinstance(each, Told):
        value, how = "" if isnan(each.value) else number(each.value), each.how
    else:
        value = "" if isnan(each.least) else f"{number(each.least)} .. {number(each.greatest)}"
        how = CHOICE if each.choice else ""
    meaning = f"{each.symbol}, {each.meaning}" if each.symbol and each.meaning else each.meaning
    told = (f"{value} {each.unit}".rstrip(" -").lstrip(), f"({how})" if how else "", meaning)
    return Fact(f"{each.stage}.{each.quantity}", "  ".join(part for part in told if part))
