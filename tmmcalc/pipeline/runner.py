"""Run the stages of a plan in order: load what is stored and valid, compute the rest.

A result goes on to later stages only by way of its record, so a run resumed from files and one that was
not see the same numbers to the last bit. Without an output folder nothing is hashed, written or locked.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from time import perf_counter
from typing import TYPE_CHECKING, Any, Literal

from tmmcalc.core.errors import NoSolutionError, TmmError, UsageError
from tmmcalc.core.plan import Plan, known_stage, plan
from tmmcalc.core.stage import Stage, arguments, of_scene
from tmmcalc.core.stored import matches
from tmmcalc.pipeline.accuracy import check_accuracy
from tmmcalc.pipeline.outcome import Event, Outcome, Results, RunResult
from tmmcalc.pipeline.plain import plain_record
from tmmcalc.rooms import STAGES

if TYPE_CHECKING:
    from pathlib import Path

    from tmmcalc.pipeline.archive import Archive

Settings = Mapping[str, Mapping[str, Any]]


def run(
    spec: object,
    *,
    target: str | None = None,
    out: Path | None = None,
    fresh: bool = False,
    from_stage: str | None = None,
    csv: bool | None = None,
    columns: Sequence[str] = (),
    skip: Collection[str] = (),
    settings: Settings | None = None,
    tolerance: float | None = None,
    on_start: Callable[[str], None] | None = None,
    on_event: Callable[[Event], None] | None = None,
    keep_going: bool = False,
    stages: Mapping[str, Stage] = STAGES,
) -> RunResult:
    """Run every stage that ``target`` needs (None: all that the scene has) and return their results.

    With ``out`` each stage leaves its files there, and one whose files are valid is loaded, not computed.
    ``fresh`` computes all; ``from_stage`` that stage and all after it. ``csv``: True, False, or None for up
    to 2000 rows; ``columns``: names and wildcards of those that a CSV has (empty: all). ``skip``: stages that are left
    out, with all that read them. ``settings`` changes options of methods: ``{stage: {option: value}}``. ``tolerance``
    is the relative error asked of every stage: one with a choice takes the cheapest method for it. ``on_start`` is
    called with the name of a stage before it runs, ``on_event`` as soon as it is done. ``keep_going``: a stage without
    a solution ends only those that read it, and is told in ``failures``.

    Raises UsageError for an unknown stage or option, a target that the scene leaves out, and files that
    cannot be read or written; AccuracyError for a stage that does not reach ``tolerance`` by its own estimate; and
    what a stage raises, unless it is to keep going. The files of earlier stages stay
    valid.
    """
    stages = of_scene(stages, spec)
    scene = plan(spec, target, stages, skip)
    options = _options(settings or {}, stages, tolerance)
    forced = _forced(fresh, from_stage, stages)
    _check_target(scene)
    archive = _archive(out, csv, columns)
    work = _Run(spec, options, forced, archive, tolerance, on_event)
    for step in scene.steps:
        if not step.runs:
            if step.asked:
                work.tell(Event(step.stage, "left out", step.reason))
        elif not work.spoilt(stages[step.stage]):
            if on_start is not None:
                on_start(step.stage)
            work.do(stages[step.stage], keep_going)
    if columns:
        _check_columns(columns, work.outcomes)
    files = () if archive is None else archive.files(work.outcomes)
    return RunResult(work.outcomes, scene, tuple(work.events), files, work.failures)


class _Run:
    """The state of a run: what is done so far. ``forced`` says why a stage is computed whatever is stored."""

    def __init__(
        self,
        spec: object,
        options: Settings,
        forced: Mapping[str, str],
        archive: Archive | None,
        tolerance: float | None,
        on_event: Callable[[Event], None] | None,
    ) -> None:
        self.spec = spec
        self.options = options
        self.forced = forced
        self.archive = archive
        self.tolerance = tolerance
        self.on_event = on_event
        self.outcomes: dict[str, Outcome] = {}
        self.events: list[Event] = []
        self.failures: dict[str, TmmError] = {}
        self._lost: set[str] = set()

    def tell(self, event: Event) -> None:
        self.events.append(event)
        if self.archive is not None and event.kind != "left out":
            self.archive.log(event)
        if self.on_event is not None:
            self.on_event(event)

    def spoilt(self, stage: Stage) -> bool:
        """Whether a result that the stage reads could not be had; then tell so."""
        missing = [name for name in (*stage.needs, *stage.uses) if name in self._lost]
        if missing:
            self._lost.add(stage.name)
            self.tell(Event(stage.name, "left out", f"it reads {', '.join(missing)}"))
        return bool(missing)

    def do(self, stage: Stage, keep_going: bool) -> None:
        """Load a stage from its files if they are valid, else compute and store it; tell what was done."""
        began = perf_counter()
        inputs, settings, archive = stage.inputs(self.spec), self.options[stage.name], self.archive
        kind: Literal["loaded", "computed"] = "loaded"
        outcome, reason = None, "not stored"
        try:
            if archive is not None:
                outcome, reason = archive.valid(stage, inputs, settings, self.forced.get(stage.name), self.tell)
            if outcome is None:
                upstream = upstream_of(stage, Results(self.outcomes))
                result = stage.solve(*arguments(inputs), **upstream, **settings)
                record, kind = plain_record(stage.dump(result)), "computed"
                outcome = Outcome(stage, lambda: record)
                if archive is not None:
                    archive.save(outcome)
            if self.tolerance is not None:
                check_accuracy(outcome, self.tolerance)
        except TmmError as error:
            if not keep_going or error.exit_code < NoSolutionError.exit_code:
                raise
            self.failures[stage.name] = error
            self._lost.add(stage.name)
            self.tell(Event(stage.name, "failed", "no result: the error stands at the end", perf_counter() - began))
            return
        self.outcomes[stage.name] = outcome
        self.tell(Event(stage.name, kind, reason, perf_counter() - began))


def upstream_of(stage: Stage, results: Mapping[str, Any]) -> dict[str, Any]:
    """What of the results a stage reads, as its function is given it, with the pipeline if it asks for that."""
    read = {name: results[name] for name in stage.upstream(results)}
    return {**read, "another": _another} if stage.another else read


def _another(text: str, stages: Sequence[str]) -> dict[str, Any]:
    """Results of stages of the spec of a text, nothing stored."""
    from tmmcalc.project import parse_spec

    spec = parse_spec(text)
    found: dict[str, Any] = {}
    for name in stages:
        if name not in found:
            found |= run(spec, target=name).results
    return {name: found[name] for name in stages}


def _archive(out: Path | None, csv: bool | None, columns: Sequence[str]) -> Archive | None:
    if out is None:
        return None
    from tmmcalc.pipeline.archive import Archive

    return Archive(out, csv, columns)


def _check_columns(columns: Sequence[str], outcomes: Mapping[str, Outcome]) -> None:
    """Raise UsageError for a name that no table of the run has: of one stage it need not be."""
    headers = [header for outcome in outcomes.values() if outcome.table is not None for header in outcome.table.header]
    for pattern in columns:
        if not any(matches(header, pattern) for header in headers):
            from tmmcalc.core.columns import nearest

            names = list(dict.fromkeys(header.partition("[")[0] for header in headers))
            raise UsageError(
                f"no stage has a column called {pattern!r}", where="--columns", remedy=nearest(names, pattern)
            )


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
