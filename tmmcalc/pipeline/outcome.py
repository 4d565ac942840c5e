"""What a run gives back: results by stage, made when asked for; the plan; events; files."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import field
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

from tmmcalc.core.errors import UsageError
from tmmcalc.core.plan import Plan
from tmmcalc.core.records import record
from tmmcalc.core.stage import Stage
from tmmcalc.core.stored import Record, Table

if TYPE_CHECKING:
    from pathlib import Path
    from types import TracebackType

    from tmmcalc.core.errors import TmmError


@record
class Event:
    """What became of a stage."""

    stage: str
    # lost: what it reads has failed
    kind: Literal["loaded", "computed", "left out", "lost", "damaged", "failed", "waiting", "removed"]
    message: str
    seconds: float = 0.0  # run time of the stage, files included


class Watch:
    """Who is told of a run, which goes on within this context: ``start`` and ``event`` by stage, and its end."""

    def __init__(
        self,
        start: Callable[[str], object] = lambda stage: None,
        event: Callable[[Event], object] = lambda event: None,
    ) -> None:
        self.start = start  # of a stage, by its name
        self.event = event  # as soon as it is known what became of it

    def __enter__(self) -> Watch:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        """Nothing is held."""

    def end(self, spec: Any, result: RunResult) -> RunResult:
        """What the run of a spec gives in the end, outside of the context."""
        return result


_BREAKS = (ArithmeticError, AssertionError, AttributeError, LookupError, TypeError, ValueError)


class UnfitError(UsageError):
    """Stored files are whole, but what they hold does not make a result: somebody has written them."""


def believed(outcomes: Iterable[Outcome]) -> AbstractContextManager[None]:
    """Work inside the block with these outcomes; raises `UnfitError` if it breaks and some of them were loaded."""
    loaded = [outcome for outcome in outcomes if outcome.folder is not None]
    return _believed(loaded) if loaded else nullcontext()


@contextmanager
def _believed(loaded: Sequence[Outcome]) -> Iterator[None]:
    try:
        yield
    except _BREAKS as error:
        names = ", ".join(outcome.stage.name for outcome in loaded)
        raise UnfitError(
            f"what is stored of {names} does not fit together ({type(error).__name__}: {error})",
            where=str(loaded[0].folder),
            remedy="compute it again by --fresh",
        ) from error


class Outcome:
    """The record of a stage and what is made of it, each at first use; ``folder`` has it stored, if it was loaded.

    Raises `UnfitError` where the stored files hold no such thing.
    """

    def __init__(self, stage: Stage, source: Callable[[], Record], folder: Path | None = None) -> None:
        self.stage = stage
        self.folder = folder
        self._source = source

    @cached_property
    def record(self) -> Record:
        """The stored form."""
        with believed((self,)):
            return self._source()

    @cached_property
    def result(self) -> Any:
        """The result, always by way of the record: computed or read from files, it is the same."""
        with believed((self,)):
            return self.stage.load(self.record)

    @cached_property
    def table(self) -> Table | None:
        """The table for people, None if the stage has none."""
        with believed((self,)):
            return self.stage.table(self.result)


class Results(Mapping[str, Any]):
    """Results by stage name, each loaded when first asked for; ``others`` stand in the place of theirs."""

    def __init__(self, outcomes: Mapping[str, Outcome], others: Mapping[str, Any] | None = None) -> None:
        self._outcomes = outcomes
        self._others = others or {}

    def __getitem__(self, stage: str) -> Any:
        return self._others[stage] if stage in self._others else self._outcomes[stage].result

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
    spec: Any = None  # that the stages read: where one settles it, with what that found
    told: tuple[str, ...] = ()  # which of several solutions the stages after it took
    alone: Mapping[str, Any] = field(default_factory=dict)  # the results of such stages with that solution

    def believed(self) -> AbstractContextManager[None]:
        """`believed` of all stages that were loaded."""
        return believed(self.outcomes.values())

    @property
    def results(self) -> Results:
        """Results by stage name; of one that settled the spec that with the solution that was taken."""
        return Results(self.outcomes, self.alone)

    def record(self, stage: str) -> Record:
        """Return the stored form of a stage's result: scalars, arrays, error estimate, counters."""
        return self.outcomes[stage].record

    def table(self, stage: str) -> Table | None:
        """Return the table of a stage, None if it has none."""
        return self.outcomes[stage].table
