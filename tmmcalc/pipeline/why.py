"""Why a plan is as it is: what every stage was decided by, what would bring it in, who reads it, what it leaves out.

Everything is asked of the functions that decide: they are called on a spec that notes what they look at.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from tmmcalc.core.errors import TmmError
from tmmcalc.core.plan import Plan, Step
from tmmcalc.core.records import record
from tmmcalc.core.stage import Stage, of_scene
from tmmcalc.pipeline.watch import BarredError, Seen, watched
from tmmcalc.project.tables import is_list
from tmmcalc.rooms import STAGES


@record
class Why:
    """A step of the plan with its reasons. Keys of the spec are dotted, those of all entries of a list under one."""

    step: Step
    decided: tuple[str, ...]  # keys that the decision looked at
    brings: tuple[str, ...]  # of a stage that is left out: absent keys, any of which may bring it in
    change: str | None  # of a stage that no absent key bars: the key whose value does
    after: str | None  # the stage that has to come in first
    tables: tuple[str, ...] | None  # tables of the spec that a stage that runs reads; None: one of them is found first
    reads: tuple[str, ...]  # stages whose results it reads
    readers: tuple[str, ...]  # stages that read its result
    omits: tuple[str, ...]  # what a stage that runs leaves out within itself
    packages: tuple[str, ...]  # heavy packages that it imports


def explain(
    spec: object, scene: Plan, stages: Mapping[str, Stage] = STAGES, supposed: Collection[str] = ()
) -> tuple[Why, ...]:
    """The reasons of every step of a plan, in its order; nothing is computed.

    ``supposed`` are tables of an `outlook`: they bring stages in, and the other tables need not fit them.
    """
    own = of_scene(stages, spec)
    running = set(scene.running)
    return tuple(_why(spec, step, stages[step.stage], own, running, supposed) for step in scene.steps)


def packages(reasons: tuple[Why, ...]) -> tuple[str, ...]:
    """Heavy packages of all stages that run, each once."""
    return tuple(sorted({name for why in reasons for name in why.packages}))


def _why(
    spec: object,
    step: Step,
    declared: Stage,
    own: Mapping[str, Stage],
    running: set[str],
    supposed: Collection[str],
) -> Why:
    stage = own[step.stage]
    reason, seen = watched(stage.unwanted, spec)
    _, read = watched(declared.used, spec) if step.runs else (None, ())
    barred = step.asked and not step.runs
    absent = tuple(_missed(spec, stage, reason, seen)) if barred and reason else ()
    return Why(
        step=step,
        decided=tuple(dict.fromkeys(key.key for key in (*seen, *read))),
        brings=absent,
        change=seen[-1].key if barred and reason and not absent and seen else None,
        after=None if not barred or reason else next((n for n in stage.needs if n not in running), None),
        tables=_tables(spec, stage, supposed) if step.runs else (),
        reads=tuple(name for name in stage.upstream(running) if name in running),
        readers=tuple(name for name in own if name in running and step.stage in own[name].upstream(running)),
        omits=(*_spared(declared, stage, running), *_omits(spec, stage, supposed)) if step.runs else (),
        packages=stage.packages(spec) if step.runs else (),
    )


def _missed(spec: object, stage: Stage, reason: str, seen: tuple[Seen, ...]) -> Iterator[str]:
    """The absent keys that matter: supposed to be given, each changes what the decision says."""
    for key in seen:
        if not key.there and watched(stage.unwanted, spec, key.key)[0] != reason:
            yield key.key


def _tables(spec: object, stage: Stage, supposed: Collection[str]) -> tuple[str, ...] | None:
    """Tables of the spec that the inputs of a stage come from; none if they are not fit to be read.

    None if one of them is only ``supposed``: the inputs are made of what it holds, and that is to be found.
    """
    try:
        _, seen = watched(stage.inputs, spec, barred=supposed)
    except BarredError:
        return None
    except TmmError:
        return ()
    return tuple(dict.fromkeys(_table(key) for key in seen if key.there))


def _omits(spec: object, stage: Stage, supposed: Collection[str]) -> tuple[str, ...]:
    """What a stage leaves out within itself, as far as that is told without what is only ``supposed``."""
    try:
        told: tuple[str, ...] = watched(stage.omits, spec, barred=supposed)[0]
    except BarredError:
        return ()
    return told


def _table(seen: Seen) -> str:
    """The table that a key stands in, to the second level."""
    parts = seen.key.split(".")
    return ".".join(parts[: min(len(parts) - 1, 2)]) or parts[0]


def _spared(declared: Stage, stage: Stage, running: set[str]) -> tuple[str, ...]:
    """The results that the scene has, and other scenes would read for this stage."""
    spared = (name for name in declared.uses if name in running and name not in stage.uses)
    return tuple(f"the result of {name} is not read: the spec gives it" for name in spared)


def in_toml(key: str, spec: object) -> str:
    """A key as it stands in TOML: ``[flywheel]``, ``[[transients]]``, ``delta in [flywheel]``.

    >>> from tmmcalc.project import Spec
    >>> in_toml("transients", Spec()), in_toml("flywheel.delta", Spec())
    ('[[transients]]', 'delta in [flywheel]')
    """
    table, _, name = key.rpartition(".")
    if not table:
        return f"[[{key}]]" if isinstance(getattr(spec, key, None), list) else f"[{key}]"
    top = table.partition(".")[0]
    several = isinstance(getattr(spec, top, None), list) or is_list(table)
    return f"{name} in [[{table}]]" if several else f"{name} in [{table}]"
