"""Climbing the ladders of a scene: every rung is run, beside an equivalent scene, and told stage by stage."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from tmmcalc.errors import TmmError, UsageError
from tmmcalc.pipeline.accuracy import estimates
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.plan import known_stage
from tmmcalc.pipeline.runner import run
from tmmcalc.pipeline.stage import resolve
from tmmcalc.pipeline.stages import STAGES
from tmmcalc.stress.compare import Alignment, difference, not_finite
from tmmcalc.stress.ladders import LADDERS
from tmmcalc.stress.results import ERROR, FAULT, OK, WARNING, Ladder, Met, Rung, Stress
from tmmcalc.stress.scales import TWIN, twin
from tmmcalc.stress.scene import Climb, Scene, Step

if TYPE_CHECKING:
    from tmmcalc.spec.loader import Variants

Told = Callable[[str, str], None]  # ladder, rung
LONG = ("transient", "pendulum", "cam_optimum")  # stages that take seconds
STRIDE = 4  # of the rungs of a scene with such a stage, unless the ladder is named
FLOOR = 2.0**-53  # nearer than that two numbers cannot be told apart


def solve_stress(
    variants: Variants, ladders: Sequence[str] = (), stage: str | None = None, on_rung: Told | None = None
) -> Stress:
    """Climb the named ladders of a scene (all that it has), up to ``stage``; ``on_rung`` is called before every rung.

    A scene with a motion in time, a search or a group beyond dyads takes seconds a rung: of its ladders every fourth
    rung is climbed, unless they are named.

    Raises UsageError for a ladder or stage that there is not, and for one named that the scene has not; and what the
    scene itself raises as it stands.
    """
    for name in ladders:
        if name not in LADDERS:
            raise UsageError(f"no ladder is called {name!r}", where="--ladder", remedy=f"ladders: {', '.join(LADDERS)}")
    if stage is not None:
        known_stage(stage, STAGES)
    base = run(variants.spec(), target=stage, keep_going=True)
    scene = Scene(variants.data, variants.of, base, stage)
    stride = STRIDE if not ladders and _long(base) else 1
    found: list[Ladder] = []
    without: list[tuple[str, str]] = []
    for name in ladders or LADDERS:
        try:
            if on_rung is not None:
                on_rung(name, "the way to its edge is sought")
            climb: Climb = resolve(LADDERS[name])(scene)
            found.append(_climbed(name, climb, scene, stride, on_rung))
        except UsageError as error:
            if ladders:
                raise
            without.append((name, error.message))
    return Stress(tuple(found), tuple(without))


def _long(base: RunResult) -> bool:
    """Whether a scene takes seconds a run, near its edges if not elsewhere."""
    groups = "structure" in base.outcomes and not base.results["structure"].dyads_only
    return groups or any(stage in base.outcomes for stage in LONG)


def _climbed(name: str, climb: Climb, scene: Scene, stride: int, on_rung: Told | None) -> Ladder:
    rungs = []
    for step in _every(stride, climb.steps):
        if on_rung is not None:
            on_rung(name, step.setting)
        rungs.append(climbed_rung(scene, step))
    return Ladder(name, climb.title, climb.condition, climb.against, tuple(rungs))


def _every(stride: int, steps: Iterable[Step]) -> list[Step]:
    """The first of every ``stride`` steps, and the last, where the edge is."""
    every = list(steps)
    chosen = every[::stride]
    return chosen if chosen[-1:] == every[-1:] else [*chosen, every[-1]]


def climbed_rung(scene: Scene, step: Step, known: RunResult | None = None) -> Rung:
    """What becomes of every stage on a rung; ``known`` is its run, if there is one already."""
    result = known or _guarded(scene, step.document)
    if not isinstance(result, RunResult):
        return Rung(step.setting, step.size, None, (result,))
    other, alignment = _beside(scene, step)
    met = tuple(_met(result, other, alignment))
    condition = step.condition(result)
    return Rung(step.setting, step.size, condition, met)


def _guarded(scene: Scene, document: Mapping[str, Any]) -> RunResult | Met:
    """The run of a document, or the error that it ends with: on the way to an extreme nothing may escape."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of numpy: what is not finite is looked for in the results
            return scene.run(document)
    except TmmError as error:
        return Met(error.where or "spec", ERROR, error.exit_code, _line(error))
    except Exception as error:  # a fault of the program, which is what a stress test looks for
        return Met("program", FAULT, 1, f"{type(error).__name__}: {error}")


def _beside(scene: Scene, step: Step) -> tuple[RunResult | None, Alignment]:
    """What the rung is compared with: the scene as it is, or the twin of the rung in other units."""
    if step.alignment is not None:
        return step.beside or scene.base, step.alignment
    try:
        document = twin(step.document)
    except UsageError:
        return None, Alignment()
    found = _guarded(scene, document)
    return (found if isinstance(found, RunResult) else None), Alignment(TWIN)


def _met(result: RunResult, other: RunResult | None, alignment: Alignment) -> Iterator[Met]:
    for name in STAGES:
        if name in result.failures:
            error = result.failures[name]
            yield Met(name, ERROR, error.exit_code, _line(error))
        elif name in result.outcomes:
            yield _of_stage(result, other, name, alignment)


def _of_stage(result: RunResult, other: RunResult | None, name: str, alignment: Alignment) -> Met:
    broken = next(not_finite(result, name), None)
    if broken is not None:
        return Met(name, FAULT, 1, f"{broken} is no finite number")
    observed, quantity = _observed(result, other, name, alignment)
    own = [size for _, size in estimates(result.record(name).error)]
    warning = next(iter(_warnings(result, name)), "")
    return Met(name, WARNING if warning else OK, 0, warning, observed, quantity, max(own, default=None))


def _observed(result: RunResult, other: RunResult | None, name: str, alignment: Alignment) -> tuple[float | None, str]:
    """How far a stage's result is from that of the scene beside it, and of which quantity."""
    if other is None or name not in other.outcomes:
        return None, ""
    # the twin is the rung in other units; any other scene is the one that the rung is made from
    pair = (result, other) if alignment.factors is TWIN else (other, result)
    found = difference(name, *pair, alignment)
    return (None, "") if found is None else (max(found[0], FLOOR), found[1])


def _warnings(result: RunResult, name: str) -> list[str]:
    from tmmcalc.report.summary import SUMMARIES

    document = resolve(SUMMARIES[name])(result.results[name], name)
    notes = [note for part in (document, *document.parts) for note in part.notes]
    return [note for note in notes if note.startswith("warning")]


def _line(error: TmmError) -> str:
    return " ".join(f"{error.where}: {error.message}".removeprefix(": ").split())
