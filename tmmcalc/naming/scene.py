"""A scene beyond the tables of its results: rows at other places, columns and facts by choice, each found once."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from types import MappingProxyType
from typing import Any

from tmmcalc.core.columns import Column
from tmmcalc.core.errors import UsageError
from tmmcalc.core.stage import STAGES, arguments
from tmmcalc.naming.language import Place
from tmmcalc.naming.meanings import worded
from tmmcalc.naming.table import Table, table_of
from tmmcalc.spec.units import UnitError

PLACED = "phi"  # the column whose values are places that `placed` of a stage takes


class Whole(Mapping[str, Any]):
    """A whole spec as a plain value: what an input is hashed by is all that stands in its tables."""

    def __init__(self, spec: Any) -> None:
        self.spec = spec

    @cached_property
    def _tables(self) -> dict[str, Any]:
        found: dict[str, Any] = self.spec.model_dump(warnings=False)  # of laws by their names
        return found

    def __getitem__(self, table: str) -> Any:
        return self._tables[table]

    def __iter__(self) -> Iterator[str]:
        return iter(self._tables)

    def __len__(self) -> int:
        return len(self._tables)


class Scene:
    """A spec with the results of its stages, of which names may ask more than stands in these.

    Without a spec (None) there is no more than what stages know of their own computation. ``instead`` are the functions
    by which stages were solved, where these are not their own.
    """

    def __init__(
        self, spec: Any, results: Mapping[str, Any], instead: Mapping[str, Callable[..., Any]] = MappingProxyType({})
    ) -> None:
        self.spec, self.results, self.instead = spec, results, instead
        self._further: dict[str, Sequence[Column]] = {}
        self._details: dict[str, Mapping[str, Any]] = {}
        self._beside: dict[Place, dict[str, Scene]] = {}

    def further(self, stage: str) -> Sequence[Column]:
        """The columns by choice of a stage."""
        if stage not in self._further:
            made = () if self.spec is None else STAGES[stage].further(self.spec, self.results)
            self._further[stage] = [each._replace(meaning=worded(each.meaning)) for each in made]
        return self._further[stage]

    def details(self, stage: str) -> Mapping[str, Any]:
        """The records of a stage's facts by choice, by the word that stands before them."""
        if stage not in self._details:
            self._details[stage] = {} if self.spec is None else STAGES[stage].details(self.spec, self.results)
        return self._details[stage]

    def table(self, stage: str) -> Table | None:
        """The table of a stage with its columns by choice behind the others; None where it has no rows."""
        own = table_of(stage, self.results[stage])
        return own and own.with_columns(self.further(stage))

    def beside(self, stage: str, place: Place) -> Scene | None:
        """The scene with one row more at a place, solved up to a stage; None where the stage has no such rows."""
        if self.spec is None or place.column != PLACED or stage not in self._placing:
            return None
        found = self._beside.setdefault(place, {})
        results = dict(self.results)
        for name in self._placing:
            if name not in found:
                own = STAGES[name]
                try:
                    spec = own.part("placed")(self.spec, place.first)
                except (UnitError, UsageError):
                    continue  # told where the rows are known; or there is no mechanism
                solve = self.instead.get(name, own.solved)
                results[name] = solve(*arguments(own.inputs(spec)), **own.given(results), **own.settings)
                found[name] = Scene(spec, dict(results), self.instead)
            results[name] = found[name].results[name]
            if name == stage:
                break
        return found.get(stage)

    @cached_property
    def _placing(self) -> tuple[str, ...]:
        """The stages of the scene whose rows are places that can be asked for."""
        return tuple(
            name
            for name, each in STAGES.items()
            if name in self.results and each.unwanted(self.spec) is None and each.part("placed") is not None
        )
