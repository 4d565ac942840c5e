"""The shifts of an external pair, and where they stand in its blocking contour."""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.core.errors import AccuracyError, NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase, listed
from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.margins import margins
from tmmcalc.gears.involute.contour.task import LINES, Task
from tmmcalc.gears.involute.pair import sum_of_shifts
from tmmcalc.gears.involute.quality.verdicts import Check, worst
from tmmcalc.gears.involute.shifts import ROUNDING, Choice, choose
from tmmcalc.gears.meshing.distances import nearest_distance
from tmmcalc.gears.meshing.geometry import wheel_of
from tmmcalc.gears.meshing.refusal import place, require_distance
from tmmcalc.gears.meshing.task import PairTask

SAME = 5e-4  # by which x1 + x2 as given may miss the sum that a centre distance asks for


@record
class Standing:
    """Shifts in the plane of the blocking contour."""

    broken: tuple[str, ...]  # conditions that they do not meet, in words
    nearest: tuple[float, float] | None  # admissible ones nearest to them, if any is broken


def contour_task(task: PairTask) -> Task:
    """The pair and its limits as the blocking contour takes them."""
    least = task.limits.tip_thickness
    return Task(wheel_of(task, 1), wheel_of(task, 2), task.limits.contact_ratio, (least, least), task.fillet)


def choose_shifts(task: PairTask) -> tuple[tuple[float, float], str]:
    """x1, x2 by the strategy of the task, and what it could not give.

    Where no shifts without undercut exist but undercut is tolerated, the choice is made among those with it. Raises
    `NoSolutionError` where nothing is admissible; but a pair that is only to be told about divides a sum equally.
    """
    total = sum_asked(task)
    known = known_shifts(task, total)
    if known is not None:
        return known, ""
    try:
        chosen, note = _tolerant(task)
    except NoSolutionError as error:
        if task.refuse or total is None:
            raise
        return (total / 2, total / 2), Phrase("{message}; x1 + x2 is divided equally", message=error.message)
    return (chosen.x1, chosen.x2), note


def sum_asked(task: PairTask) -> float | None:
    """x1 + x2, where the strategy fixes it; raises as `require_distance` does."""
    if task.strategy != "given_aw":
        return 0.0 if task.strategy == "equal_shift" else None
    first, second = wheel_of(task, 1), wheel_of(task, 2)
    distance = require_distance(task, first.base + second.base, "sum", lambda: nearest_distance(task))
    return float(sum_of_shifts(first, second, distance)[0])


def fixed(task: PairTask) -> bool:
    """Whether the user gave the shifts, so that they are judged and not chosen."""
    return task.strategy in ("given", "zero") or task.shifts != (None, None)


def strictly(task: PairTask) -> bool:
    """Whether undercut counts against the shifts: those that the user fixed may have it if it is tolerated."""
    return not task.limits.undercut or (task.strict and not fixed(task))


def sound(task: PairTask, checks: Sequence[Check]) -> bool:
    """Whether the checks alone tell that the shifts meet every condition, which holds for tips by the rule only."""
    cut = strictly(task) and any(check.name == "undercut" and check.verdict != "ok" for check in checks)
    return task.tips == (None, None) and not cut and worst(tuple(checks)) != "fail"


def standing(task: PairTask, shifts: tuple[float, float], checks: Sequence[Check]) -> Standing:
    """Where the shifts stand; the contour has no other conditions than the checks."""
    if sound(task, checks):
        return Standing((), None)
    strict = strictly(task)
    plane = contour_task(task)
    found = margins(plane, *shifts)
    if float(found.least(strict)) >= -ROUNDING:
        return Standing((), None)
    broken = tuple(LINES[key][1] for key in found.broken(strict))
    try:
        return Standing(broken, choose(plane, "given", strict=strict, x1=shifts[0], x2=shifts[1]).nearest)
    except (NoSolutionError, AccuracyError):
        return Standing(broken, None)


def known_shifts(task: PairTask, total: float | None) -> tuple[float, float] | None:
    """The shifts, if there is nothing to choose; ``total`` is x1 + x2 where the strategy fixes it."""
    x1, x2 = task.shifts
    if task.strategy == "zero":
        return 0.0, 0.0
    if task.strategy == "given":
        if x1 is None or x2 is None:
            raise UsageError("the strategy given needs both shifts", where=place(task), remedy="give x1 and x2")
        return float(x1), float(x2)
    if total is None or (x1 is None and x2 is None):
        return None
    if x1 is not None and x2 is not None and abs(x1 + x2 - total) > SAME:
        raise NoSolutionError(
            f"x1 + x2 = {x1 + x2:.6g}, but the strategy {task.strategy} asks for {total:.6g}",
            where=place(task),
            value=x1 + x2,
            limit=total,
            remedy="leave one of the shifts out",
        )
    if x1 is None:
        return total - float(x2 or 0.0), float(x2 or 0.0)
    return float(x1), total - x1


def _tolerant(task: PairTask) -> tuple[Choice, str]:
    """The choice without undercut if that is wanted and possible, else with what is tolerated."""
    try:
        found = _choice(task, task.strict)
    except NoSolutionError as error:
        if not (task.strict and task.limits.undercut):
            raise
        try:
            found = _choice(task, strict=False)
        except NoSolutionError:
            raise error from None
        said = [text for text in ("no shifts are without undercut: it is tolerated", found.note) if text]
        return found, listed(said, "; ")
    return found, found.note


def _choice(task: PairTask, strict: bool) -> Choice:
    distance = None if task.distance is None else task.distance / task.module
    return choose(
        contour_task(task),
        task.strategy,
        strict=strict,
        distance=distance,
        split=task.split,
        desired=task.desired,
    )
