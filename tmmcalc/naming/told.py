"""What a stage tells, by name: its facts, and what names ask of the columns of its table."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.facts import labelled, named
from tmmcalc.core.records import record
from tmmcalc.core.stage import STAGES
from tmmcalc.naming.anew import Anew
from tmmcalc.naming.language import Name, like, near
from tmmcalc.naming.meanings import described
from tmmcalc.naming.rows import asked_of
from tmmcalc.naming.table import Table, columns_of, table_of

MEANT = {"at_max": "where it is largest", "at_min": "where it is smallest", "at_size": "where its magnitude is largest"}


@record
class Told:
    """One quantity of a stage."""

    stage: str
    quantity: str  # its name without stage and unit
    value: float
    unit: str
    how: str  # the value was found; empty: it stands in the result
    meaning: str = ""
    symbol: str = ""

    @property
    def key(self) -> str:
        """``stage.quantity[unit]``."""
        return f"{self.stage}.{self.quantity}{f'[{self.unit}]' if self.unit else ''}"


@record
class Extent:
    """One column of a stage's table."""

    stage: str
    quantity: str  # its name without stage and unit
    unit: str
    least: float
    greatest: float
    rows: int
    meaning: str = ""
    symbol: str = ""


def told(stage: str, result: Any, names: Sequence[Name], anew: Anew | None = None) -> Iterator[Told]:
    """What a stage tells under these names, all its facts without names; each once.

    Raises `UsageError` for a place that the rows do not have.
    """
    met: dict[str, Told] = {}
    asked = [name for name in names if name.fact and name.may_be_of(stage)]
    if asked or not names:
        for each in _facts(stage, result):
            own = Name(stage, "", each.quantity, unit=each.unit)
            if not names or any(name.fits(own) for name in asked):
                met.setdefault(each.key, each)
    rows = [name for name in names if not name.fact and name.may_be_of(stage)]
    if rows and (table := table_of(stage, result)) is not None:
        for name in rows:
            for each in _of_table(stage, result, table, name, anew):
                met.setdefault(each.key, each)
    yield from met.values()


def one(name: Name, results: Mapping[str, Any], anew: Anew | None = None) -> Told:
    """The one quantity of a name among the results by stage.

    Raises `UsageError` with the nearest names if none has it, with the stages if several have it.
    """
    if name.stage and not name.wild and name.stage not in results:
        raise UsageError(f"this scene has no {name.stage}", remedy="tmmcalc plan says why a stage is left out")
    if name.wild:
        raise UsageError(f"{name.text} may name several quantities", remedy="write one name, without * and ?")
    stages = [name.stage] if name.stage else [*results]
    found = [each for stage in stages for each in told(stage, results[stage], [name], anew)]
    if not found:
        raise unknown(name, {stage: results[stage] for stage in stages})
    if len(found) > 1:
        several = ", ".join(each.stage for each in found)
        raise UsageError(
            f"{name.text} is told by several stages: {several}",
            remedy=f"name one: {', '.join(f'{each.stage}.{each.quantity}' for each in found)}",
        )
    return found[0]


def unknown(name: Name, results: Mapping[str, Any]) -> UsageError:
    """The error of a name that names nothing in these results, with the nearest of what there is."""
    alone = name.stage if name.stage in results else ""
    columns = [header for stage, result in results.items() for header in columns_of(stage, result)]
    if name.fact:
        every = [f"{stage}.{each.quantity}" for stage, result in results.items() for each in _facts(stage, result)]
        if any(column.partition(".")[2] == name.what for column in columns):
            return UsageError(
                f"{name.text} is a column: it has a value at every row",
                remedy=f"say what is asked of it, such as max({name.what}), or where, such as {name.what}@0",
            )
    else:
        every = columns
    kind = "facts" if name.fact else "columns"
    if alone:
        remedy = near(name.what, (each.partition(".")[2] for each in every), f"its {kind} are")
        return UsageError(f"{alone} tells no {name.what!r}", remedy=remedy)
    return UsageError(f"no quantity is called {name.text!r}", remedy=near(name.what, every, kind))


def listed(stage: str, result: Any) -> Iterator[Told | Extent]:
    """All that a stage tells: its facts, then its columns."""
    yield from _facts(stage, result)
    table, known = table_of(stage, result), described(stage, column=True)
    made = STAGES[stage].part("columns")
    own = made(result) if made else ()
    declared = {} if isinstance(own, Mapping) else {each.name: (each.meaning, each.symbol) for each in own}
    for at, header in enumerate(table.headers if table else ()):
        if table is not None and np.asarray(table.make(at)).dtype.kind in "fi":
            (column, unit), values = named(header), table.column(header)
            meant = declared.get(column) or known(column, unit)
            least, greatest = float(np.min(values)), float(np.max(values))
            yield Extent(stage, column, unit, least, greatest, len(values), *meant)


def _facts(stage: str, result: Any) -> Iterator[Told]:
    """Its facts, each once: of a name that stands in several parts of the summary the last."""
    known, found = described(stage, column=False), dict[str, Told]()
    for name, (value, unit), label in labelled(stage, result):
        meaning, symbol = known(name.rpartition(".")[2], unit)
        found[f"{name}[{unit}]"] = Told(stage, name, value, unit, "", meaning or label, symbol)
    yield from found.values()


def _of_table(stage: str, result: Any, table: Table, name: Name, anew: Anew | None) -> Iterator[Told]:
    """What is asked of every column of numbers that the name may mean."""
    known = described(stage, column=True)
    for at, header in enumerate(table.headers):
        column, unit = named(header)
        if not like(column, name.what) or np.asarray(table.make(at)).dtype.kind not in "fi":
            continue
        own = name._replace(stage=stage, what=column)
        value, told_in, how = asked_of(own, result, table, header, anew)
        meaning, symbol = known(column, unit)
        meant = MEANT.get(name.of, name.of)
        meaning = f"{meaning}: {meant}" if meaning and meant else meaning
        if name.unit in (None, told_in):
            yield Told(stage, own.quantity, value, told_in, how, meaning, symbol)
