"""Rows that a table does not have: of stages whose rows are places of the scene, solved anew with one row more."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.core.stage import STAGES, arguments
from tmmcalc.naming.language import Name, Place
from tmmcalc.naming.table import Table, table_of
from tmmcalc.spec.units import UnitError

PLACED = "phi"  # the column whose values are places that `placed` of a stage takes


@record
class Again:
    """What stages read of the scene with one row more at a place, in their order: plain values."""

    place: Place
    inputs: tuple[tuple[str, Any], ...]


class Anew:
    """The tables of stages solved anew, each once, with a row at a place; ``results`` are those of the scene."""

    def __init__(self, again: Sequence[Again], results: Mapping[str, Any]) -> None:
        self._inputs = {each.place: each.inputs for each in again}
        self._results = results
        self._found: dict[Place, dict[str, Any]] = {}

    def table(self, stage: str, place: Place) -> Table | None:
        """The table with the row at a place; None where the stage has no such rows."""
        inputs = self._inputs.get(place, ())
        if stage not in dict(inputs):
            return None
        found = self._found.setdefault(place, {})
        for name, given in inputs:
            if name not in found:
                own = STAGES[name]
                read = own.given({**self._results, **found})
                found[name] = own.solve(*arguments(given), **read, **own.settings)
            if name == stage:
                break
        return table_of(stage, found[stage])


def again_of(spec: Any, names: Iterable[Name]) -> tuple[Again, ...]:
    """What is read anew for names of places between the rows: of stages whose rows are places of the scene."""
    found: dict[Place, Again] = {}
    for name in names:
        for place in _single(name.place):
            if place not in found and (inputs := _inputs(spec, place)):
                found[place] = Again(place, inputs)
    return tuple(found.values())


def _single(place: Place | None) -> Iterator[Place]:
    """The places, one by one, of one that goes by the values of a column."""
    if place is not None and place.column:
        yield place._replace(last="")
        if place.last:
            yield Place(place.column, place.last)


def _inputs(spec: Any, place: Place) -> tuple[tuple[str, Any], ...]:
    """What every stage reads that has rows at places, if the scene has it and this is the column that they run over."""
    found, placed = [], dict[Any, Any]()
    for name, stage in STAGES.items():
        put = stage.part("placed") if stage.unwanted(spec) is None and place.column == PLACED else None
        if put is not None:
            try:
                if put not in placed:
                    placed[put] = put(spec, place.first)
            except (UnitError, UsageError):
                continue  # told where the rows are known; or there is no mechanism
            found.append((name, stage.inputs(placed[put])))
    return tuple(found)
