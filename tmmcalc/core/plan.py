"""Which stages run for a scene and a target, which are left out, and why."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.core.stage import STAGES, Stage, of_scene

SKIP = "--skip"
SKIPPED = f"left out by {SKIP}"


@record
class Step:
    """One stage of the plan: whether it runs, and the reason."""

    stage: str
    title: str
    runs: bool
    reason: str  # "asked for", "needed by forces", "no [motor]: speed is constant", ...
    asked: bool = True  # False: left out only because the target does not need it


@record
class Plan:
    """All stages in the order of the pipeline."""

    target: str | None  # None: several, or everything that the scene has
    steps: tuple[Step, ...]

    @property
    def running(self) -> tuple[str, ...]:
        """Names of the stages that run, in order."""
        return tuple(step.stage for step in self.steps if step.runs)

    def step(self, name: str) -> Step:
        """Return the step of this stage."""
        return next(step for step in self.steps if step.stage == name)


def plan(
    spec: object,
    target: str | Sequence[str] | None = None,
    stages: Mapping[str, Stage] = STAGES,
    skip: Collection[str] = (),
) -> Plan:
    """Return the plan that leads to ``target``, one or several, or to every stage that the scene wants.

    A stage is left out if the scene does not want it, if it needs one that is left out, if the target does not need
    it, or if it is one of ``skip`` or would read the result of one. Raises UsageError for an unknown stage.
    """
    targets = () if target is None else (target,) if isinstance(target, str) else tuple(target)
    for name in (*skip, *targets):
        known_stage(name, stages)
    stages = of_scene(stages, spec)
    asked = set(stages) if target is None else {name for each in targets for name in _upstream(each, stages)}
    barred = _barred(spec, asked, stages, skip)
    if targets and all(each in barred for each in targets):
        only = f"only {', '.join(targets)} needs it, which is left out"
        barred = {name: barred.get(name, only) for name in asked}
    running = asked - set(barred)
    steps = tuple(_step(stage, targets, asked, barred, running, stages) for stage in stages.values())
    return Plan(target if isinstance(target, str) else None, steps)


def known_stage(name: str, stages: Mapping[str, Stage]) -> Stage:
    """Return the stage with this name; raises UsageError with a suggestion if there is none."""
    if name in stages:
        return stages[name]
    from difflib import get_close_matches

    close = get_close_matches(name, stages, 1)
    hint = f"did you mean {close[0]}? " if close else ""
    raise UsageError(f"no stage is called {name!r}", remedy=f"{hint}stages: {', '.join(stages)}")


def _upstream(target: str, stages: Mapping[str, Stage]) -> set[str]:
    """Return the target and every stage that it needs or uses, directly or not."""
    found = {target}
    for need in stages[target].upstream(stages):
        found |= _upstream(need, stages)
    return found


def _barred(spec: object, asked: set[str], stages: Mapping[str, Stage], skip: Collection[str]) -> dict[str, str]:
    """Return the asked stages that cannot run, with the reason."""
    barred: dict[str, str] = {}
    lost: set[str] = set()  # stages that the scene has, of which --skip takes the result away
    for name, stage in stages.items():
        if name not in asked:
            continue
        lacking = next((need for need in stage.needs if need in barred), None)
        # the scene's own reason tells more than the chain that leads there
        reason = _unwanted(spec, stage)
        if reason is None and (taken := _taken(stage, lost, skip)) is not None:
            lost.add(name)
            reason = taken
        if reason is not None:
            barred[name] = reason
        elif lacking:
            barred[name] = f"needs {lacking}, which is left out"
    return barred


def _taken(stage: Stage, lost: Collection[str], skip: Collection[str]) -> str | None:
    """Whether ``skip`` takes a stage out, by itself or by what it reads: without that it would give other numbers."""
    if stage.name in skip:
        return SKIPPED
    read = next((name for name in (*stage.needs, *stage.uses) if name in lost), None)
    return f"reads {read}, which {SKIP} leaves out" if read else None


def _unwanted(spec: object, stage: Stage) -> str | None:
    """Return why the scene leaves this stage out, None if it wants it."""
    return stage.unwanted(spec)


def _step(
    stage: Stage,
    targets: tuple[str, ...],
    asked: set[str],
    barred: dict[str, str],
    running: set[str],
    stages: Mapping[str, Stage],
) -> Step:
    name, title = stage.name, stage.title
    if name not in asked:
        return Step(name, title, False, f"not needed by {', '.join(targets)}", asked=False)
    if name in barred:
        return Step(name, title, False, barred[name])
    users = [u for u in stages if u in running and name in stages[u].upstream(stages)]
    reason = "asked for" if name in targets or not users else f"needed by {', '.join(users)}"
    return Step(name, title, True, reason)
