"""What the closed forms share: the speed of the crank, the demands that the post-check must meet, the ready specs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.notes import Phrase, Said
from tmmcalc.core.records import record
from tmmcalc.linkage.model import Grid, Mechanism, Output
from tmmcalc.linkage.synthesis.builders import Operation
from tmmcalc.linkage.synthesis.ready import ready_spec
from tmmcalc.linkage.synthesis.results import Check, Design, Size, Synthesis
from tmmcalc.linkage.synthesis.simulation import Simulation
from tmmcalc.linkage.synthesis.strokes import crank_speed, stroke_times
from tmmcalc.linkage.synthesis.task import SynthesisTask

CLOSED = 1e-9  # largest residual of a closed form
SPEED = 1.0  # of a crank of which nothing is said [rad/s]


@record
class ClosedForm:
    """A design of a closed form before it is written: what was found, and the simulation of it."""

    name: str
    sizes: tuple[Size, ...]
    checks: tuple[Check, ...]
    merits: dict[str, float]
    mechanism: Mechanism
    simulation: Simulation
    notes: tuple[Said, ...] = ()
    defects: tuple[str, ...] = ()


def scene_of(task: SynthesisTask, stroke: float, ratio: float, output: Output) -> Operation:
    """Motion of a mechanism that is checked: from the dead centre before the working stroke of its output.

    The crank's speed is given, or by the mean speed of the working stroke, or 1 rad/s.
    """
    speed = SPEED if task.crank_speed is None else task.crank_speed
    if task.working_speed is not None:
        speed = crank_speed(stroke, ratio, task.working_speed)
    return Operation(speed, None, Grid(task.positions, extremes=True), (output,))


def closed_form(task: SynthesisTask, kind: str, rule: str, found: Sequence[ClosedForm]) -> Synthesis:
    """The designs with their times and ready specs; raises `AccuracyError` if a simulation misses a target."""
    designs = tuple(_design(task, closed) for closed in found[: task.solutions])
    residual = max((largest_residual(design) for design in designs), default=0.0)
    if residual > CLOSED:
        raise AccuracyError(
            f"the simulated mechanism misses a target by {residual:.3g}",
            where=f"synthesis.{kind}, post-check",
            value=residual,
            limit=CLOSED,
            remedy="keep clear of sizes at which the mechanism only just turns, and of links that differ a millionfold",
        )
    notes = [note for closed in found[: task.solutions] for note in closed.notes]
    if task.crank_speed is None and task.working_speed is None:
        notes.append(Phrase("note: no speed is given: the ready spec turns its crank at {speed:g} rad/s", speed=SPEED))
    return Synthesis(kind, rule, designs, residual, tuple(dict.fromkeys(notes)), {"designs": len(found)})


def largest_residual(design: Design) -> float:
    """The largest residual of a design against its targets."""
    return max((check.residual for check in design.checks if check.residual is not None), default=0.0)


def _design(task: SynthesisTask, closed: ClosedForm) -> Design:
    found = closed.simulation
    unit = "m" if closed.mechanism.outputs[0].link is None else "rad"
    times = stroke_times(found.stroke, found.time_ratio, abs(found.result.speed), unit)
    title = task.title or closed.name
    text = ready_spec(closed.mechanism, title, tuple(remarks(closed.sizes)))
    return Design(closed.name, closed.sizes, closed.checks, closed.merits, closed.defects, text, times)


def remarks(sizes: Sequence[Size]) -> list[str]:
    """The sizes of a design in one or more lines."""
    shown: list[Any] = [f"{size.symbol} = {_shown(size)}" for size in sizes]
    return [", ".join(shown[k : k + 4]) for k in range(0, len(shown), 4)]


def _shown(size: Size) -> str:
    if size.unit == "rad":
        return f"{math.degrees(size.value):.6g} deg"
    return f"{1e3 * size.value:.6g} mm" if size.unit == "m" else f"{size.value:.6g}"
