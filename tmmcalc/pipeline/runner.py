"""Run the stages of a plan in order: load what is stored and valid, compute the rest.

A result goes on to later stages only by way of its record, so a run resumed from files and one that was
not see the same numbers to the last bit. Without an output folder nothing is hashed, written or locked.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from time import perf_counter
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from tmmcalc.core.errors import NoSolutionError, TmmError, UsageError
from tmmcalc.core.plan import Plan, Step, known_stage, plan
from tmmcalc.core.stage import Stage, arguments, of_scene
from tmmcalc.pipeline.accuracy import check_accuracy
from tmmcalc.pipeline.outcome import Event, Outcome, Results, RunResult, UnfitError, Watch, believed
from tmmcalc.pipeline.settling import planned, settled, settling
from tmmcalc.rooms import STAGES

if TYPE_CHECKING:
    from pathlib import Path

    from tmmcalc.core.stored import Record
    from tmmcalc.pipeline.archive import Archive

Settings = Mapping[str, Mapping[str, Any]]
Target = str | Sequence[str] | None


def run(
    spec: Any,
    target: Target = None,
    *,
    scene: Plan | None = None,
    out: Path | None = None,
    fresh: bool = False,
    from_stage: str | None = None,
    csv: bool | None = None,
    columns: Sequence[str] = (),
    skip: Collection[str] = (),
    settings: Settings | None = None,
    tolerance: float | None = None,
    watch: Watch | None = None,
    keep_going: bool = False,
    wait: float | None = None,
    by_name: bool = False,
    stages: Mapping[str, Stage] = STAGES,
) -> RunResult:
    """Run every stage that ``target`` needs (None: all that the scene has) and return their results.

    ``scene`` is the plan of ``target`` and ``skip`` where it is made already; of several targets none need be there.
    With ``out`` each stage leaves its files there, and one whose files are valid is loaded, not computed.
    ``fresh`` computes all; ``from_stage`` that stage and all after it. ``csv``: True, False, or None for up
    to 2000 rows; ``columns``: names and wildcards of those that a CSV has, those by choice among them (empty: all);
    then the CSV files are written last, and not at all if a name means nothing; nothing is computed if a name is of no
    form that is declared. ``skip``: stages that are left out,
    with all that read them. ``settings`` changes options of methods: ``{stage: {option: value}}``. ``tolerance``
    is the relative error asked of every stage: one with a choice takes the cheapest method for it. ``watch``
    is told of every stage and of the end, and the run goes on within it. ``keep_going``: a stage without
    a solution ends only those that read it, and is told in ``failures``. ``wait``: seconds that a folder is waited for
    while another process works in it. ``by_name``: the results are asked by name alone, neither stored nor shown, so
    stages leave out what no name can ask for.

    Stored files that are whole but do not make a result are told as damaged, and all is computed afresh. Without a
    ``target`` the files that an earlier run left of stages that the scene has no more are removed.

    Raises UsageError for an unknown stage or option, a target that the scene leaves out, and files that
    cannot be read or written; AccuracyError for a stage that does not reach ``tolerance`` by its own estimate; and
    what a stage raises, unless it is to keep going. The files of earlier stages stay valid.
    """
    watch = watch or Watch()
    with watch:
        first = settling(spec, target, stages, skip)
        asked = scene or plan(spec, target, stages, skip)
        if first is None:
            _check_target(asked)
            if columns:
                from tmmcalc.naming.declared import check_columns

                check_columns(columns, [stages[name] for name in asked.running], spec)
        options, forced = _options(settings or {}, stages, tolerance), _forced(fresh, from_stage, stages)
        work = _Run(spec, stages, options, tolerance, keep_going, watch, by_name)
        archive = work.archive = _archive(out, csv, columns, wait, work.wait)

        for reasons in (forced, afresh := dict.fromkeys(stages, "stored files do not fit")):
            try:
                for each in work.missing(first, asked, target, skip, reasons):
                    with work.failing(each), believed(each.reads):
                        work.computed(each, each.stage.dump(each.solve(*each.given, **each.keywords)))
                break
            except UnfitError as error:
                if reasons is afresh:
                    raise
                work.begin_afresh(spec, error)
        if columns:
            from tmmcalc.naming.scene import Scene
            from tmmcalc.pipeline.csvcolumns import by_choice

            further = by_choice(columns, work.outcomes, Scene(work.spec, Results(work.outcomes, work.alone)))
            if archive is not None:
                archive.write_tables(work.outcomes, further)
        if archive is not None and target is None:
            archive.clear(plan(work.spec, None, stages).running if skip else work.scene.running, work.tell)
        files = () if archive is None else archive.files(work.outcomes)
        found = RunResult(
            work.outcomes, work.scene, tuple(work.events), files, work.failures, work.spec, work.told, work.alone
        )
    return watch.end(spec, found)


class Missing(NamedTuple):
    """A stage that has to be computed."""

    stage: Stage
    solve: Callable[..., Any]  # the function that finds its result
    given: tuple[Any, ...]  # its arguments
    keywords: Mapping[str, Any]
    reads: Sequence[Outcome]  # those of the stages that it reads
    reason: str  # why it is not loaded
    began: float  # on the clock of the run [s]


class _Run:
    """How a run works, and what it has done so far."""

    def __init__(
        self,
        spec: object,
        stages: Mapping[str, Stage],
        options: Settings,
        tolerance: float | None,
        keep_going: bool,
        watch: Watch,
        by_name: bool,
    ) -> None:
        self.spec = spec
        self.stages = stages
        self.options = options
        self.tolerance = tolerance
        self.keep_going = keep_going
        self.watch = watch
        self.by_name = by_name
        self.archive: Archive | None = None
        self.scene = Plan(None, ())  # the plan of all that runs
        self.outcomes: dict[str, Outcome] = {}
        self.events: list[Event] = []
        self.failures: dict[str, TmmError] = {}
        self.told: tuple[str, ...] = ()
        self.alone: dict[str, Any] = {}  # of stages that settled the spec the result with the one that was taken
        self._lost: set[str] = set()

    def missing(
        self, first: Stage | None, asked: Plan, target: Target, skip: Collection[str], forced: Mapping[str, str]
    ) -> Iterator[Missing]:
        """The stages that have to be computed, each with what it reads; those whose files are valid are loaded.

        What the ``first`` one found goes into the spec before the others are planned. ``forced`` says why some are
        computed whatever is stored.
        """
        self.scene = asked
        if first is not None:
            step = Step(first.name, first.title, True, "settles the spec")
            yield from self._missing(Plan(None, (step,)), forced)
            if first.name in self.outcomes:
                self.settle(first)
                self.scene = planned(self.spec, target, self.stages, skip, first)
                _check_target(self.scene)
        yield from self._missing(self.scene, forced)

    def _missing(self, scene: Plan, forced: Mapping[str, str]) -> Iterator[Missing]:
        own, archive = of_scene(self.stages, self.spec), self.archive
        for name in scene.running:
            if (unfit := own[name].part("unfit")) and (fault := unfit(self.spec, scene)) is not None:
                raise fault
        for step in scene.steps:
            stage = own[step.stage]
            if stage.name in self.known or self.leaves_out(step, stage):
                continue
            self.watch.start(stage.name)
            began = perf_counter()
            inputs, chosen = stage.inputs(self.spec), self.options[stage.name]
            outcome, reason = None, "not stored"
            try:
                if archive is not None:
                    outcome, reason = archive.valid(stage, inputs, chosen, forced.get(stage.name), self.tell)
                if outcome is not None:
                    self.note(outcome, "loaded", reason, began)
                    continue
                read = upstream_of(stage, Results(self.outcomes, self.alone))
                outcomes = [self.outcomes[name] for name in read if name in self.outcomes]
                less = stage.by_name if self.by_name else {}
                with believed(outcomes):
                    solve, given, keywords = stage.called(*arguments(inputs), **read, **chosen, **less)
            except TmmError as error:
                self.failed(stage, error, began)
                continue
            yield Missing(stage, solve, given, keywords, outcomes, reason, began)

    def computed(self, each: Missing, record: Record) -> None:
        """What goes on of a result, stored where there is an archive: its record."""
        outcome = Outcome(each.stage, lambda: record)
        if self.archive is not None:
            self.archive.save(outcome)
        self.note(outcome, "computed", each.reason, each.began)

    def note(self, outcome: Outcome, how: Literal["loaded", "computed"], reason: str, began: float) -> None:
        """Keep the outcome of a stage, if it is as exact as is asked for, and tell so."""
        if self.tolerance is not None:
            check_accuracy(outcome, self.tolerance)
        self.outcomes[outcome.stage.name] = outcome
        self.tell(Event(outcome.stage.name, how, reason, perf_counter() - began))

    @property
    def known(self) -> set[str]:
        """The stages of which it is known what became of them."""
        return {*self.outcomes, *self.failures}

    def settle(self, stage: Stage) -> None:
        """Put what a stage found into the spec."""
        result, chosen = self.outcomes[stage.name].result, stage.part("chosen")
        number = None if chosen is None else chosen(self.spec, result, _another)
        found = stage.part("found")(self.spec, result, number)
        self.spec = settled(self.spec, found)
        self.alone[stage.name] = found.alone
        key = f"{stage.asked[0]}.choose"
        self.told = (*self.told, f"note: the mechanism is {found.of}; --set {key}=N takes another")

    def begin_afresh(self, spec: object, error: UnfitError) -> None:
        """Forget what was loaded."""
        stage = next(reversed(self.outcomes), next(iter(self.stages)))
        self.tell(Event(stage, "damaged", f"{error.message}: all is computed again"))
        self.outcomes, self.events, self.failures = {}, self.events[-1:], {}
        self.spec, self.told, self.alone, self._lost = spec, (), {}, set()

    def wait(self, seconds: float) -> None:
        """Tell that another process works in the folder."""
        self.tell(Event("", "waiting", f"another process works in the output folder; waiting up to {seconds:g} s"))

    def tell(self, event: Event) -> None:
        self.events.append(event)
        if self.archive is not None and event.kind not in ("left out", "lost", "waiting"):
            self.archive.log(event)
        self.watch.event(event)

    def leaves_out(self, step: Step, stage: Stage) -> bool:
        """Whether the scene has no such stage, or a result that it reads could not be had; then tell so."""
        if not step.runs:
            if step.asked:
                self.tell(Event(stage.name, "left out", step.reason))
            return True
        missing = [name for name in (*stage.needs, *stage.uses) if name in self._lost]
        if missing:
            self._lost.add(stage.name)
            self.tell(Event(stage.name, "lost", f"it reads {', '.join(missing)}"))
        return bool(missing)

    @contextmanager
    def failing(self, each: Missing) -> Iterator[None]:
        """Work out a stage inside the block, which may have no result."""
        try:
            yield
        except TmmError as error:
            self.failed(each.stage, error, each.began)

    def failed(self, stage: Stage, error: TmmError, began: float) -> None:
        """Keep the error of a stage without a result for the end, and tell so; raises it unless the run goes on."""
        if not self.keep_going or error.exit_code < NoSolutionError.exit_code:
            raise error
        self.failures[stage.name] = error
        self._lost.add(stage.name)
        self.tell(Event(stage.name, "failed", "no result: the error stands at the end", perf_counter() - began))


def upstream_of(stage: Stage, results: Mapping[str, Any]) -> dict[str, Any]:
    """What of the results a stage reads, as its function is given it, with what it asks for besides."""
    read = stage.given(results)
    if stage.another:
        read["another"] = _another
    if stage.every:
        read["every"] = results
    return read


def _another(text: str, stages: Sequence[str]) -> dict[str, Any]:
    """Results of stages of the spec of a text, nothing stored."""
    from tmmcalc.project import parse_spec

    spec = parse_spec(text)
    found: dict[str, Any] = {}
    for name in stages:
        if name not in found:
            found |= run(spec, target=name).results
    return {name: found[name] for name in stages}


def _archive(
    out: Path | None,
    csv: bool | None,
    columns: Sequence[str],
    wait: float | None,
    waiting: Callable[[float], None],
) -> Archive | None:
    if out is None:
        return None
    from tmmcalc.pipeline.archive import Archive
    from tmmcalc.pipeline.lock import WAIT

    return Archive(out, csv, columns, WAIT if wait is None else wait, waiting)


def _check_target(scene: Plan) -> None:
    if scene.target is not None and scene.target not in scene.running:
        raise UsageError(
            scene.step(scene.target).reason,
            where=scene.target,
            remedy="complete the spec, or ask for a stage that this scene has",
        )


def _forced(fresh: bool, from_stage: str | None, stages: Mapping[str, Stage]) -> dict[str, str]:
    """Return the stages to compute whatever is stored, with the reason."""
    names = list(stages)
    if fresh:
        return dict.fromkeys(names, "asked for afresh")
    if from_stage is None:
        return {}
    first = names.index(known_stage(from_stage, stages).name)
    return dict.fromkeys(names[first:], f"forced from {from_stage}")


def _options(
    changes: Settings, stages: Mapping[str, Stage], tolerance: float | None = None
) -> dict[str, dict[str, Any]]:
    """Return the settings of every stage: its defaults with the changes that were asked for."""
    for name, change in changes.items():
        known = known_stage(name, stages).settings
        unknown = [option for option in change if option not in known]
        if unknown:
            raise UsageError(
                f"has no option {unknown[0]!r}", where=name, remedy=f"options: {', '.join(known) or 'none'}"
            )
    asked = {} if tolerance is None else {"tolerance": tolerance}
    return {
        name: {**stage.settings, **{key: asked[key] for key in asked if key in stage.settings}, **changes.get(name, {})}
        for name, stage in stages.items()
    }
