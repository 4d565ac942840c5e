"""The extreme scenes that come with the program, each as it stands: one rung a scene."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from tmmcalc.core.errors import TmmError
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run
from tmmcalc.project import templates
from tmmcalc.project.loader import Variants
from tmmcalc.stress.expected import Expected, disagreements, expected
from tmmcalc.stress.results import ERROR, FAULT, Ladder, Met, Rung, Stress
from tmmcalc.stress.run import caught, climbed_rung
from tmmcalc.stress.scene import OWN_TWIN, Scene, Step, by_regularity

FOLDER = "extreme/"
MISSED = "missed"


def scenes() -> list[str]:
    """Names of the extreme scenes."""
    return [name for name in templates.names() if name.startswith(FOLDER)]


def end_of(variants: Variants, wanted: Expected) -> RunResult | TmmError:
    """The run of a scene as far as it is told, or the error of its spec."""
    try:
        return run(variants.spec(), target=wanted.target, keep_going=True)
    except TmmError as error:
        return error


def solve_shipped(on_rung: Callable[[str, str], None] | None = None) -> Stress:
    """Run every extreme scene, beside its twin in other units, and compare it with what its table expects."""
    rungs = []
    for k, name in enumerate(scenes()):
        if on_rung is not None:
            on_rung("shipped", name.removeprefix(FOLDER))
        rungs.append(_rung(k, name))
    title = "extreme scenes as they stand, with their known answers"
    return Stress((Ladder("shipped", title, "1/regularity", OWN_TWIN, tuple(rungs)),), ())


def _rung(k: int, name: str) -> Rung:
    file = templates.path(name)
    text = file.read_text(encoding="utf-8")
    variants, wanted, told = Variants(text, str(file), file.parent), expected(text), name.removeprefix(FOLDER)
    end = caught("program", lambda: end_of(variants, wanted))
    if isinstance(end, Met):
        return Rung(told, float(k), None, (end,), answer=MISSED)
    gaps = tuple(_gaps(end, wanted))
    if isinstance(end, TmmError):
        ended = Met(end.where or "spec", ERROR, end.exit_code, " ".join(str(end).split()))
        return Rung(told, float(k), None, (*((ended,) if not gaps else ()), *gaps), answer=_answer(wanted, gaps))
    scene = Scene(variants.data, variants.of, end, wanted.target)
    rung = climbed_rung(scene, Step(told, float(k), variants.data, by_regularity), end)
    return replace(rung, met=(*rung.met, *gaps), answer=_answer(wanted, gaps))


def _answer(wanted: Expected, gaps: tuple[Met, ...]) -> str:
    """What of the end was compared, in short."""
    if gaps:
        return MISSED
    numbers = len(wanted.values)
    parts = [f"exit {wanted.code}"] if wanted.code else []
    parts += [f"{numbers} number{'s' if numbers > 1 else ''}"] if numbers else []
    return " and ".join(parts) + " as known"


def _gaps(end: RunResult | TmmError, wanted: Expected) -> Iterator[Met]:
    """Where the end is not the known one: a fault of the program."""
    for gap in disagreements(end, wanted):
        yield Met("known answer", FAULT, 1, gap)
