"""What is said about the forces: loss of contact, impacts, nearness to jamming, a spring that falls short."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.forces.coils import INDEX
from tmmcalc.cams.forces.results import Reserve, SpringFound
from tmmcalc.cams.speed import TURN
from tmmcalc.cams.task import CamTask
from tmmcalc.core.notes import Phrase, Said, held

if TYPE_CHECKING:
    from tmmcalc.machine.motion import Motion

EATEN, MUCH = 0.5, 0.8  # parts of the useful component that friction takes: a note, a warning


def force_notes(
    task: CamTask,
    spring: SpringFound,
    lost: tuple[tuple[float, float], ...],
    reversals: tuple[float, ...],
    reserve: Reserve,
) -> Iterator[Said]:
    """Notes and warnings in the order of their weight."""
    if lost:
        where = [Phrase("{low:.6g} to {high:.6g} deg", low=degrees(a), high=degrees(b)) for a, b in lost]
        yield (
            Phrase(
                "warning: nothing presses the follower on the cam for phi from {where}; figures there hold for a "
                "follower that is held: a stiffer spring, more preload, or closure = 'groove'",
                where=where,
            )
        )
    if reversals:
        text = "note: the roller goes to the other wall of the groove at phi = {where} deg, with an impact"
        yield Phrase(text, where=[f"{degrees(phi):.6g}" for phi in reversals])
    if reserve.eaten > EATEN:
        grade = "warning" if reserve.eaten > MUCH else "note"
        text = (
            "friction takes {value:.4g} % of the useful component of R at phi = {phi:.6g} deg; "
            "at {limit:g} % the follower jams"
        )
        yield held(grade, text, 100 * reserve.eaten, 100.0, "%", name="friction", phi=degrees(reserve.phi))
    yield from _spring_notes(task, spring)
    if task.turning is not None and task.loads is not None:
        slow, fast = float(task.turning.omega.min()), float(task.turning.omega.max())
        yield (
            Phrase(
                "note: the cam turns with the crank at {slow:.6g} to {fast:.6g} rad/s, as the stage motion found; "
                "inertia is y'' omega^2 + y' eps",
                slow=slow,
                fast=fast,
            )
        )
    if task.loads is None or not task.loads.mass:
        yield "note: the follower has no mass: give mass or inertia in [cam.loads]"


def several_turns(task: CamTask, motion: Motion | None) -> Iterator[Said]:
    """A machine whose speed repeats after several turns of the cam gives it no speed over one."""
    if motion is None or task.turning is not None:
        return
    times = float(motion.regime.panels.edges[-1]) * task.ratio / TURN
    yield (
        Phrase(
            "note: the speed of the machine repeats after {times:.6g} turns of the cam, no two of which are "
            "alike: its forces are those of the mean speed",
            times=times,
        )
    )


def _spring_notes(task: CamTask, spring: SpringFound) -> Iterator[Said]:
    def shown(stiffness: float) -> str:
        return (
            Phrase("{stiffness:.7g} N*m/rad", stiffness=stiffness)
            if task.asked.kind == "oscillating"
            else Phrase("{stiffness:.7g} N/mm", stiffness=1e-3 * stiffness)
        )

    if spring.method == "safety" and spring.lifting is None:
        yield "note: nothing lifts the follower off, so the spring is none"
    if spring.governing is not None:
        yield (
            Phrase(
                "note: the {phase} asks for the stiffness, for it lifts lower down: the textbook's rule, by the "
                "largest force alone, gives c = {shown} (5.57), which falls short there",
                phase=spring.governing.phase,
                shown=shown(spring.governing.rule),
            )
        )
    if spring.reached is not None and spring.asked is not None and spring.reached < spring.asked * (1 - 1e-9):
        grade = "warning" if spring.reached < 1 else "note"
        cure = "no c keeps it with this preload; exact = true finds a larger one"
        if spring.exact is not None:
            cure = Phrase("c = {shown} would keep it (exact = true)", shown=shown(spring.exact))
        text = "the spring reaches {value:.6g} of the asked K1 = {limit:.6g} at phi = {phi:.6g} deg; {cure}"
        words: dict[str, Any] = {"phi": degrees(spring.reached_phi or 0.0), "cure": cure}
        yield held(grade, text, spring.reached, spring.asked, name="K1", **words)
    wire = spring.wire
    if wire is not None and not INDEX[0] <= wire.index <= INDEX[1]:
        text = "D/d = {value:.4g} of the spring is outside the usual {low} to {high}"
        yield held("note", text, wire.index, INDEX[wire.index > INDEX[1]], name="D/d", low=INDEX[0], high=INDEX[1])
    asked = task.loads.spring if task.loads else None
    if asked and asked.wire and task.asked.kind == "oscillating":
        yield "note: coils and stress are found for compression springs, not for a spring about the pivot"
