"""Climbing the ladders of a scene: every rung is run, beside an equivalent scene, and told stage by stage."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, TypeVar

from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.core.plan import known_stage
from tmmcalc.core.records import record
from tmmcalc.core.stage import resolve
from tmmcalc.core.stored import estimates, last_digits
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run
from tmmcalc.rooms import STAGES
from tmmcalc.stress.compare import Alignment, Difference, difference, not_finite
from tmmcalc.stress.ladders import LADDERS
from tmmcalc.stress.results import DISPUTED, ERROR, FAULT, OK, WARNING, Ladder, Met, Rung, Stress
from tmmcalc.stress.scales import TWIN, twin
from tmmcalc.stress.scene import Climb, Scene, Step

if TYPE_CHECKING:
    from tmmcalc.project.loader import Variants

T = TypeVar("T")
Told = Callable[[str, str], None]  # ladder, rung
TWIN_OF = "twin"  # stands for a stage where the twin has no result at all
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
    for name in dict.fromkeys(ladders or LADDERS):
        try:
            if on_rung is not None:
                on_rung(name, "the way to its edge is sought")
            climb: Climb = resolve(LADDERS[name])(scene)
            found.append(_climbed(name, climb, scene, stride, on_rung))
        except TmmError as error:
            if ladders:
                raise
            without.append((name, error.message))
        except Exception as error:
            way = Rung("the way to its edge", 0.0, None, (fault("program", error),))
            found.append(Ladder(name, "its edge is not found", "", "nothing", (way,)))
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
    found = caught("program", lambda: _rung(scene, step, known or scene.run(step.document)))
    return found if isinstance(found, Rung) else Rung(step.setting, step.size, None, (found,))


def caught(stage: str, of: Callable[[], T]) -> T | Met:
    """What a call gives, or the error that it ends with: on the way to an extreme nothing may escape."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of numpy: what is not finite is looked for in the results
            return of()
    except TmmError as error:
        return Met(error.where or stage, ERROR, error.exit_code, _line(error))
    except Exception as error:
        return fault(stage, error)


def fault(stage: str, error: Exception) -> Met:
    """An exception without a name of the program: what a stress test looks for."""
    return Met(stage, FAULT, 1, f"{type(error).__name__}: {error}")


@record
class Equivalent:
    """What a rung is compared with."""

    run: RunResult | None
    alignment: Alignment = Alignment()
    note: str = ""  # why there is nothing
    ended: tuple[Met, ...] = ()  # the error that it ended with as a whole

    @property
    def called(self) -> str:
        """The place of its results, in words."""
        return "in other units" if self.alignment.twin else "in the scene beside it"


def _rung(scene: Scene, step: Step, result: RunResult) -> Rung:
    beside = _equivalent(scene, step)
    met = tuple(each for name in STAGES for each in _met(result, beside, name))
    return Rung(step.setting, step.size, step.condition(result), (*met, *beside.ended), beside.note)


def _equivalent(scene: Scene, step: Step) -> Equivalent:
    """The scene as it is, or the twin of the rung in other units."""
    if step.alignment is not None:
        return Equivalent(step.beside or scene.base, step.alignment)
    alignment = Alignment(TWIN, twin=True)
    document = caught(TWIN_OF, lambda: twin(step.document))
    if isinstance(document, Met) and document.status == ERROR:
        return Equivalent(None, alignment, f"nothing beside it: {document.message}")
    other = document if isinstance(document, Met) else caught(TWIN_OF, lambda: scene.run(document))
    if isinstance(other, RunResult):
        return Equivalent(other, alignment)
    status = FAULT if other.status == FAULT else DISPUTED
    told = replace(other, stage=TWIN_OF, status=status, message=f"in other units: {other.message}")
    return Equivalent(None, alignment, ended=(told,))


def _met(result: RunResult, beside: Equivalent, name: str) -> Iterator[Met]:
    if name in result.failures:
        error = result.failures[name]
        solved = beside.run is not None and name in beside.run.outcomes
        text = f"{_line(error)}; {beside.called} it has a result" if solved else _line(error)
        yield Met(name, ERROR, error.exit_code, text)
    elif name in result.outcomes:
        yield caught(name, lambda: _of_stage(result, beside, name))


def _of_stage(result: RunResult, beside: Equivalent, name: str) -> Met:
    broken = next(not_finite(result, name), None) or _broken_beside(beside, name)
    if broken is not None:
        return Met(name, FAULT, 1, f"{broken} is no finite number")
    found = _difference(result, beside, name)
    observed = None if found.size is None else max(found.size, FLOOR)
    record = result.record(name).error
    own, digits = ([size for _, size in told_of(record)] for told_of in (estimates, last_digits))
    told = next(iter(_warnings(result, name)), "")
    refused = _refused_beside(beside, name)
    status = WARNING if told else DISPUTED if refused else OK
    message = "; ".join(filter(None, (told, refused)))
    errors = max(own, default=None), max(digits, default=None)
    return Met(name, status, 0, message, observed, found.quantity, *errors, found.skipped)


def _broken_beside(beside: Equivalent, name: str) -> str | None:
    """A place in the result of the twin that holds no finite number."""
    if not beside.alignment.twin or beside.run is None or name not in beside.run.outcomes:
        return None
    broken = next(not_finite(beside.run, name), None)
    return None if broken is None else f"{beside.called} {broken}"


def _refused_beside(beside: Equivalent, name: str) -> str:
    """The error of a stage that has a result on the rung, and none in the scene beside it."""
    if beside.run is None or name not in beside.run.failures:
        return ""
    return f"{beside.called}: {_line(beside.run.failures[name])}"


def _difference(result: RunResult, beside: Equivalent, name: str) -> Difference:
    """How far a stage's result is from that of the scene beside it, and of which quantity."""
    if beside.run is None:
        return Difference()
    if name not in beside.run.outcomes:
        return Difference(skipped=(f"all ({beside.called} it has no result)",))
    pair = (result, beside.run) if beside.alignment.twin else (beside.run, result)
    return difference(name, *pair, beside.alignment)


def _warnings(result: RunResult, name: str) -> list[str]:

    document = STAGES[name].summary(result.results[name], name)
    notes = [note for part in (document, *document.parts) for note in part.notes]
    return [note for note in notes if note.startswith("warning")]


def _line(error: TmmError) -> str:
    return " ".join(f"{error.where}: {error.message}".removeprefix(": ").split())
