"""What a stage is: a pure function of plain inputs and upstream results.

The pipeline knows a stage by its declaration alone. Its functions are looked up when they are used, so a stage that
does not run is never imported.

    spec --inputs--> plain values --solve--> result --dump--> Record --load--> result
                                             result --table--> Table

What a stage does is a function of the theory; the module of the stage says which, so that the pipeline calls it without
a step between, as ``solve(*inputs, **results of the stages that it reads, **settings)``, or of a task that is made of
both.

``load(dump(result))`` must give back everything that a later stage or a renderer reads, because this is
the only form in which a result is handed on, whether it has just been computed or comes from a file.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping, Sequence
from dataclasses import field, replace
from importlib import import_module
from typing import TYPE_CHECKING, Any

from tmmcalc.core.records import record
from tmmcalc.core.stored import DeferredColumns, Record, Table

if TYPE_CHECKING:
    from tmmcalc.core.columns import Column


Another = Callable[[str, Sequence[str]], Mapping[str, Any]]  # (text of a spec, stages) -> their results

EVERY = ("*",)  # in ``uses``: all other stages
CSV_ROWS = 2000  # at more rows a CSV costs a hundred times the computation
TOLERANCE = {"tolerance": 0.0}  # relative error asked for; 0: that of the method


@record
class Picture:
    """What the picture of a stage shows, and which flags of ``tmmcalc plot`` it has of its own."""

    shows: str
    flags: tuple[str, ...] = ()
    figure: str = ""  # "module:function", (order) -> what draws it; empty: ``figure`` in the module of its stage
    beside: str = ""  # a later stage whose result it shows as well, if the scene has it
    pieces: str = ""  # "module:function", (order) -> what of it stands on sheets, see `tmmcalc.report.sheets.piece`


@record
class Stage:
    """One stage of the pipeline. Its parts are found in its module when they are first used.

    ``inputs(spec)``      plain value that it reads, a tuple of them, or None: exactly these are hashed
    ``solve``             the function of the inputs, one argument each, and of keywords: the results that it reads by
                          stage, and its settings
    ``solver(*inputs)``   in place of ``solve`` where what is given decides which function it is: its name
    ``task``              where ``solve`` is asked in the words of its theory: the function of these inputs and results
                          that gives its arguments, a tuple or a single one; the settings stay keywords of ``solve``
    ``takes``             by stage: the field of its result that ``solve`` takes in place of the result, by its name
    ``kind``              class of the result
    ``errors(result)``    estimates of its errors; without it those of ``result.error``
    ``columns(result)``   its table for people: arrays by header, or columns of the rows of ``result.labels``; without
                          it the stage has none
    ``series``            by the labels of the first column of its table, where it has several courses: what the label
                          means, and the name of the column that the rows of the course go along
    ``omits(spec)``       sentences on what it leaves out within itself, because the scene has it not
    ``packages(spec)``    heavy packages that it imports for this scene
    ``found(spec, result, choose)``  what it found as keys of the spec, see `tmmcalc.spec.rewrite.Found`; of several
                          solutions number ``choose``, from 1, None: the best
    ``chosen(spec, result, another)``  of a stage that settles the spec the number of the solution that is taken if the
                          spec names none, None: the best; ``another`` as ``solve`` has it
    ``placed(spec, value)``  the spec with one row more, where the first of its columns has this value (a number with a
                          unit or without): of stages whose rows are places that can be asked for, for `tmmcalc.naming`
    ``dense(spec, count)``   the spec with so many equal steps of its rows: of the same stages, for what moves smoothly
    ``derivatives(inputs, results, slopes, asked)``  derivatives of its result along K directions of the numbers that
                          it reads, (K, L) in the order of `core.numerics.alike.numbers` of its inputs, as
                          `core.derivatives`; None where none are known. On no other number of the spec may its
                          result depend, not by the results that it reads either. Of facts those ``asked`` do
    ``unfit(spec, plan)``  an error of what it is asked about stages that the plan leaves out, raised before any runs;
                          None if there is none
    ``further(spec, results)``  columns by choice of the rows of its table, a sequence of `Column`: they stand in no
                          table and no file unless they are asked for by name; ``results`` are those of all stages that
                          ran in the scene, or at least those that it reads itself, by stage; nothing is computed
                          before a column is made. The ``document`` of the stage takes them as ``further``
    ``details(spec, results)``  facts by choice: a record whose declared quantities are told by name alone, never in a
                          document or a file that did not ask for them; or several such records by the word before them.
                          What its annotation says that it returns is listed without computing it
    ``declares``          of a stage all names of whose columns are declared: where, beside its result and the module of
                          its ``columns``: modules, ``module:NAME`` of one quantity, or names as they are. A name of no
                          such form is told before anything is computed, see `tmmcalc.naming.declared`
    ``words(spec)``       by place in braces of these names the words that the scene has for it; without it any word
    ``outlook()``         of a stage that settles the spec tables like those that it will find, by which a plan is made

    A part that is heavy to import is given by its name, ``"module:function"``: a stored result is loaded without the
    theory. A result that is no record of plain values and arrays has ``dump(result)`` and ``load(record)``; one whose
    parts are imported apart names their classes as ``kinds``; a table of another form has ``table(result)``. ``wanted``
    and ``reads`` are called while planning, also for scenes that leave the stage out: their module must import little.
    """

    name: str
    title: str  # one line for the plan
    home: str = ""  # "module" or "module:object" with its parts; empty: the module of its name in its room
    asked: tuple[str, str] = ("", "")  # the table that asks for it, and the sense of a spec without it
    wanted: str = ""  # "module:function", (spec) -> None, or the reason why the scene leaves it out
    needs: tuple[str, ...] = ()  # the stages whose results it reads
    uses: tuple[str, ...] = ()  # the stages whose results it reads if the scene has them
    reads: str = ""  # "module:function", (spec) -> those of ``uses`` that it reads in this scene; empty: all
    feeds: tuple[str, ...] = ()  # stages of rooms below that read its result, without knowing it, if the scene has it
    after: str = ""  # a stage of another room that comes before it, though it reads nothing of it
    settings: Mapping[str, Any] = field(default_factory=dict)  # options of the method and their defaults
    by_name: Mapping[str, Any] = field(default_factory=dict)  # keywords that leave out what no name can ask for
    settles: bool = False  # whether what it found takes its place in the spec for the stages that come after it
    another: bool = False  # whether it is given the pipeline for specs that results hold, as ``another(text, stages)``
    every: bool = False  # whether it is given ``every`` result so far, to take what the stages that it reads have read
    facts: str = ""  # module with ``summary(result, title)``, and ``document`` with its table where it has one
    picture: Picture | None = None
    chapter: str = ""  # of the note in which it is told of, by the function ``blocks`` of ``note``; empty: in none
    note: str = ""  # module with ``blocks(order)``: what the note tells of it, see `tmmcalc.report.manuscript`
    # whether that module has ``data(order)`` too, what is given, which stands in the chapter and not in the task
    tells_data: bool = False
    moves: bool = False  # whether a page shows it moving
    # module with ``views(order)``, what moves (`tmmcalc.report.moving`), or ``trials(order)``, what is tried by hand
    # (`tmmcalc.report.exploring`)
    view: str = ""
    studied: bool = False  # whether it has several methods, which are studied
    studies: str = ""  # "module:function", (scene) -> the studies of its methods

    @property
    def room(self) -> str:
        """The room that it stands in."""
        return self.home.split(".")[1]

    def upstream(self, done: Container[str]) -> list[str]:
        """The stages whose results it reads, of those that are done."""
        return [*self.needs, *(name for name in self.uses if name in done)]

    def given(self, results: Mapping[str, Any]) -> dict[str, Any]:
        """What of the results by stage its function is given, by the names of its arguments."""
        takes, read = self.takes, {}
        for name in self.upstream(results):
            field = takes.get(name)
            read[field or name] = getattr(results[name], field) if field else results[name]
        return read

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
        return self.part("inputs")(spec)

    @property
    def kinds(self) -> tuple[type, ...]:
        """Classes of what it gives out."""
        return tuple(map(resolve, self.part("kinds") or ())) or (self.part("kind"),)

    def called(self, *inputs: Any, **read: Any) -> tuple[Callable[..., Any], tuple[Any, ...], dict[str, Any]]:
        """The function that finds the result of the inputs, and of results and settings by name; with its arguments."""
        solver, task = self.part("solver"), self.part("task")
        solve = resolve(solver(*inputs)) if solver else self.part("solve")
        if task is None:
            return solve, inputs, read
        settings = {name: read.pop(name) for name in (*self.settings, *self.by_name) if name in read}
        return solve, arguments(task(*inputs, **read)), settings

    def solved(self, *inputs: Any, **read: Any) -> Any:
        """The result, of the inputs, and of the results and settings by name."""
        solve, given, keywords = self.called(*inputs, **read)
        return solve(*given, **keywords)

    @property
    def takes(self) -> Mapping[str, str]:
        """The fields that it takes of results in place of the results, by stage."""
        return self.part("takes") or {}

    def dump(self, result: Any) -> Record:
        """The stored form of a result, in the one form in which a record is handed on."""
        from tmmcalc.core.sentences import parted

        if own := self.part("dump"):
            from tmmcalc.core.plain import plain_record

            return plain_record(parted(own(result)))
        from tmmcalc.core.conversion import plain, to_record

        errors = self.part("errors")
        return parted(to_record(result, plain(result.error) if errors is None else errors(result)))

    def load(self, record: Record) -> Any:
        """The result that was stored."""
        from tmmcalc.core.sentences import rejoined

        record = rejoined(record)
        if own := self.part("load"):
            return own(record)
        from tmmcalc.core.conversion import from_record

        return from_record(self.part("kind"), record)

    def table(self, result: Any) -> Table | None:
        """The table for people; None if the stage has none."""
        if own := self.part("table"):
            table: Table | None = own(result)
            return table
        columns = self.part("columns")
        return None if columns is None else tabulated(columns(result), result)

    def further(self, spec: Any, results: Mapping[str, Any]) -> Sequence[Column]:
        """Its columns by choice in a scene, none of them made."""
        made = self.part("further")
        found: Sequence[Column] = made(spec, results) if made else ()
        return found

    def details(self, spec: Any, results: Mapping[str, Any]) -> Mapping[str, Any]:
        """The records of its facts by choice in a scene, by the word that stands before them; empty: none does."""
        made = self.part("details")
        found = made(spec, results) if made else {}
        return found if isinstance(found, Mapping) else {"": found}

    def summary(self, result: Any, title: str) -> Any:
        """The document of what is told of a result in a few facts."""
        return resolve(f"{self.facts}:summary")(result, title)

    def document(self, result: Any, title: str, **chosen: Any) -> Any:
        """What the command of the stage prints: the summary with a table of what is ``chosen``, if it has one."""
        facts = import_module(self.facts)
        return (facts.document if hasattr(facts, "document") else facts.summary)(result, title, **chosen)

    def omits(self, spec: object) -> tuple[str, ...]:
        """What the stage leaves out within itself in this scene."""
        own = self.part("omits")
        return own(spec) if own else ()

    def packages(self, spec: object) -> tuple[str, ...]:
        """Heavy packages that the stage imports for this scene."""
        own = self.part("packages")
        return own(spec) if own else ()

    def part(self, name: str) -> Any:
        """A part of the stage; None if its module has none of this name."""
        module, _, inner = self.home.partition(":")
        found = import_module(module)
        part = getattr(getattr(found, inner) if inner else found, name, None)
        return resolve(part) if isinstance(part, str) else part


STAGES: dict[str, Stage] = {}  # those of all rooms, in the order of the pipeline; `tmmcalc.rooms` enters them


def arguments(inputs: Any) -> tuple[Any, ...]:
    """What a stage reads of the spec as arguments of its function: a plain tuple is one each, None is none.

    >>> arguments((1, "a")), arguments(2.0), arguments(None)
    ((1, 'a'), (2.0,), ())
    """
    if inputs is None:
        return ()
    return inputs if type(inputs) is tuple else (inputs,)


def of_scene(stages: Mapping[str, Stage], spec: object) -> dict[str, Stage]:
    """The stages as this scene has them: with those of ``uses`` alone that each reads, and those that feed it."""
    feeding = [stage for stage in stages.values() if stage.feeds and stage.unwanted(spec) is None]
    return {name: _of_scene(stage, feeding, spec) for name, stage in stages.items()}


def _of_scene(stage: Stage, feeding: Sequence[Stage], spec: object) -> Stage:
    uses = stage.used(spec) if stage.reads else stage.uses
    uses = (*uses, *(each.name for each in feeding if stage.name in each.feeds))
    return stage if uses == stage.uses else replace(stage, uses=uses)


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
        DeferredColumns([np.array(result.labels), *(column.make for column in columns)]),
    )


def resolve(reference: str) -> Any:
    """Return the function that ``"module:function"`` names, importing its module.

    >>> resolve("math:hypot")(3.0, 4.0)
    5.0
    """
    module, _, name = reference.partition(":")
    return getattr(import_module(module), name)
