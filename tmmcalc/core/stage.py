"""What a stage is: a pure function of plain inputs and upstream results.

The pipeline knows a stage by its declaration alone. Its functions are looked up when they are used, so a stage that
does not run is never imported.

    spec --inputs--> plain values --solve--> result --dump--> Record --load--> result
                                             result --table--> Table

``load(dump(result))`` must give back everything that a later stage or a renderer reads, because this is
the only form in which a result is handed on, whether it has just been computed or comes from a file.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping, Sequence
from dataclasses import field, replace
from importlib import import_module
from typing import TYPE_CHECKING, Any

from tmmcalc.core.records import record
from tmmcalc.core.stored import Late, Record, Table

if TYPE_CHECKING:
    from tmmcalc.core.columns import Column


EVERY = ("*",)  # in ``uses``: all other stages
CSV_ROWS = 2000  # at more rows a CSV costs a hundred times the computation
TOLERANCE = {"tolerance": 0.0}  # relative error asked for; 0: that of the method


@record
class Picture:
    """What the picture of a stage shows, and which flags of ``tmmcalc plot`` it has of its own."""

    shows: str
    flags: tuple[str, ...] = ()
    figure: str = ""  # "module:function", (order) -> what draws it; empty: ``figure`` in the module of its stage


@record
class Stage:
    """One stage of the pipeline. Its functions are found in its module by their names, when they are first used.

    ``inputs(spec)``                       plain values that it reads: exactly these are hashed
    ``solve(inputs, upstream, settings)``  the result; ``upstream`` holds the results that it reads, by stage
    ``errors(result)``                     estimates of its errors; without it those of ``result.error``
    ``columns(result)``                    its table for people: arrays by header, or columns of the rows of
                                           ``result.labels``; without it the stage has none
    ``omits(spec)``                        sentences on what it leaves out within itself, because the scene has it not
    ``packages(spec)``                     heavy packages that it imports for this scene

    A result that is no record of plain values and arrays has ``dump(result)`` and ``load(record)``, a table of another
    form ``table(result)``. ``wanted`` and ``reads`` are called while planning, also for scenes that leave the stage
    out: their module must import little.
    """

    name: str
    title: str  # one line for the plan
    home: str = ""  # "module" or "module:object" with the functions; empty: the module of its name in its room
    asked: tuple[str, str] = ("", "")  # the table that asks for it, and the sense of a spec without it
    wanted: str = ""  # "module:function", (spec) -> None, or the reason why the scene leaves it out
    needs: tuple[str, ...] = ()  # the stages whose results it reads
    uses: tuple[str, ...] = ()  # the stages whose results it reads if the scene has them
    reads: str = ""  # "module:function", (spec) -> those of ``uses`` that it reads in this scene; empty: all
    after: str = ""  # a stage of another room that comes before it, though it reads nothing of it
    settings: Mapping[str, Any] = field(default_factory=dict)  # options of the method and their defaults
    facts: str = ""  # module with ``summary(result, title)``, and ``document`` with its table where it has one
    picture: Picture | None = None
    studied: bool = False  # whether it has several methods, which are studied
    studies: str = ""  # "module:function", (scene) -> the studies of its methods

    def upstream(self, done: Container[str]) -> list[str]:
        """The stages whose results it reads, of those that are done."""
        return [*self.needs, *(name for name in self.uses if name in done)]

    def unwanted(self, spec: Any) -> str | None:
        """Why the scene leaves the stage out; None if it wants it."""
        table, lacking = self.asked
        if table and not getattr(spec, table):
            header = f"[[{table}]]" if isinstance(getattr(spec, table), list) else f"[{table}]"
            return f"no {header}: {lacking}"
        reason: str | None = resolve(self.wanted)(spec) if self.wanted else None
        return reason

    def used(self, spec: object) -> tuple[str, ...]:
        """Those of ``uses`` that the stage reads in this scene; the others it does without."""
        read = resolve(self.reads)(spec) if self.reads else self.uses
        return tuple(name for name in self.uses if name in read)

    def inputs(self, spec: object) -> Any:
        """What the stage reads of the spec."""
        return self._part("inputs")(spec)

    def solve(self, inputs: Any, upstream: Upstream, settings: Mapping[str, Any]) -> Any:
        """The result."""
        return self._part("solve")(inputs, upstream, settings)

    def dump(self, result: Any) -> Record:
        """The stored form of a result."""
        if own := self._own("dump"):
            record: Record = own(result)
            return record
        from tmmcalc.core.conversion import plain, to_record

        errors = self._own("errors")
        return to_record(result, plain(result.error) if errors is None else errors(result))

    def load(self, record: Record) -> Any:
        """The result that was stored."""
        if own := self._own("load"):
            return own(record)
        from tmmcalc.core.conversion import from_record

        return from_record(returned(self._part("solve")), record)

    def table(self, result: Any) -> Table | None:
        """The table for people; None if the stage has none."""
        if own := self._own("table"):
            table: Table | None = own(result)
            return table
        columns = self._own("columns")
        return None if columns is None else tabulated(columns(result), result)

    def summary(self, result: Any, title: str) -> Any:
        """The document of what is told of a result in a few facts."""
        return resolve(f"{self.facts}:summary")(result, title)

    def document(self, result: Any, title: str, **chosen: Any) -> Any:
        """What the command of the stage prints: the summary with a table of what is ``chosen``, if it has one."""
        facts = import_module(self.facts)
        return (facts.document if hasattr(facts, "document") else facts.summary)(result, title, **chosen)

    def omits(self, spec: object) -> tuple[str, ...]:
        """What the stage leaves out within itself in this scene."""
        own = self._own("omits")
        return own(spec) if own else ()

    def packages(self, spec: object) -> tuple[str, ...]:
        """Heavy packages that the stage imports for this scene."""
        own = self._own("packages")
        return own(spec) if own else ()

    def _part(self, name: str) -> Callable[..., Any]:
        """A function that every stage has."""
        part: Callable[..., Any] = getattr(self._functions, name)
        return part

    def _own(self, name: str) -> Callable[..., Any] | None:
        """A function that not every stage has."""
        return getattr(self._functions, name, None)

    @property
    def _functions(self) -> Any:
        module, _, inner = self.home.partition(":")
        found = import_module(module)
        return getattr(found, inner) if inner else found


STAGES: dict[str, Stage] = {}  # those of all rooms, in the order of the pipeline; `tmmcalc.rooms` enters them


class Upstream(dict[str, Any]):
    """Results by stage, as a stage is given them, with the pipeline for specs that a result holds."""

    def __init__(self, results: Mapping[str, Any], another: Callable[[str, Sequence[str]], Mapping[str, Any]]) -> None:
        super().__init__(results)
        self.another = another  # (text of a spec, stages) -> their results


def of_scene(stages: Mapping[str, Stage], spec: object) -> dict[str, Stage]:
    """The stages as this scene has them: with those of ``uses`` alone that each reads."""
    return {name: replace(stage, uses=stage.used(spec)) if stage.reads else stage for name, stage in stages.items()}


def said(*sentences: tuple[object, str]) -> tuple[str, ...]:
    """The sentences whose conditions hold."""
    return tuple(sentence for holds, sentence in sentences if holds)


def tabulated(columns: Mapping[str, Any] | Sequence[Column], result: Any) -> Table:
    """The table of columns by header, or of columns of the rows that ``result.labels`` names."""
    import numpy as np

    if isinstance(columns, Mapping):
        return Table(list(columns), [np.asarray(column) for column in columns.values()])
    return Table(
        ["i", *(column.header for column in columns)],
        Late([np.array(result.labels), *(column.make for column in columns)]),
    )


def returned(function: Callable[..., Any]) -> Any:
    """The class that a function of a module with late annotations says it returns."""
    said = function.__annotations__["return"]
    return eval(said, function.__globals__) if isinstance(said, str) else said


def resolve(reference: str) -> Callable[..., Any]:
    """Return the function that ``"module:function"`` names, importing its module.

    >>> resolve("math:hypot")(3.0, 4.0)
    5.0
    """
    module, _, name = reference.partition(":")
    function: Callable[..., Any] = getattr(import_module(module), name)
    return function
