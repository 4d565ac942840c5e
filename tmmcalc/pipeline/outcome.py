"""What a run gives back: results by stage, made when asked for; the plan; events; files."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import field
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

from tmmcalc.core.plan import Plan
from tmmcalc.core.records import record
from tmmcalc.core.stage import Stage
from tmmcalc.core.stored import Record, Table

if TYPE_CHECKING:
    from pathlib import Path

    from tmmcalc.core.errors import TmmError


@record
class Event:
    """What became of a stage."""

    stage: str
    kind: Literal["loaded", "computed", "left out", "damaged", "failed"]
    message: str
    seconds: float = 0.0  # run time of the stage, files included


class Outcome:
    """The record of a stage and what is made of it, each at first use."""

    def __init__(self, stage: Stage, source: Callable[[], Record]) -> None:
        self.stage = stage
        self._source = source

    @cached_property
    def record(self) -> Record:
        """The stored form."""
        return self._source()

    @cached_property
    def result(self) -> Any:
        """The result, always by way of the record: computed or read from files, it is the same."""
        return self.stage.load(self.record)

    @cached_property
    def table(self) -> Table | None:
        """The table for people, None if the stage has none."""
        return self.stage.table(self.result)


class Results(Mapping[str, Any]):
    """Results by stage name, each loaded when first asked for."""

    def __init__(self, outcomes: Mapping[str, Outcome]) -> None:
        self._outcomes = outcomes

    def __getitem__(self, stage: str) -> Any:
        return self._outcomes[stage].result

    def __iter__(self) -> Iterator[str]:
        return iter(self._outcomes)

    def __len__(self) -> int:
        return len(self._outcomes)


@record
class RunResult:
    """One run of the pipeline. ``files`` is empty if nothing was stored."""

    outcomes: Mapping[str, Outcome]  # of the stages that ran, in order
    plan: Plan
    events: tuple[Event, ...]
    files: tuple[Path, ...]
    failures: Mapping[str, TmmError] = field(default_factory=dict)  # of stages without a result, if it kept going

    @property
    def results(self) -> Results:
        """Results by stage name."""
        return Results(self.outcomes)

    def record(self, stage: str) -> Record:
        """Return the stored form of a stage's result: scalars, arrays, error estimate, counters."""
        return self.outcomes[stage].record

    def table(self, stage: str) -> Table | None:
        """Return the table of a stage, None if it has none."""
        return self.outcomes[stage].table
