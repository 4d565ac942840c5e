"""What is said about the lowest mechanism: what was not judged, where its offset comes from, its pressure angles."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

from tmmcalc.cams.optimum.results import Choice
from tmmcalc.cams.optimum.scene import Scene
from tmmcalc.cams.pressure.angle import Reached
from tmmcalc.cams.task import CamTask
from tmmcalc.core.notes import Phrase, Said, held

SAME = 1e-9  # of a size: it stands at the end of a range


def optimum_notes(
    task: CamTask, scene: Scene, chosen: Choice, least: Choice, theta: tuple[Reached, ...]
) -> Iterator[Said]:
    """Notes and warnings of the lowest mechanism in whole steps and of any sizes; ``theta`` are those of the former."""
    if task.turning is not None:
        slow, fast = float(task.turning.omega.min()), float(task.turning.omega.max())
        yield Phrase(
            "note: the cam turns with the crank at {slow:.6g} to {fast:.6g} rad/s, as the stage motion found",
            slow=slow,
            fast=fast,
        )
    if scene.follower.kind == "translating" and task.asked.offset is None:
        offset = 1e3 * scene.follower.sense * scene.follower.offset
        yield Phrase(
            "note: the offset e = {offset:.6g} mm is that of the synthesis; give offset in [cam], or 0, to set it",
            offset=offset,
        )
    missing = [
        Phrase("{number} {check}", number=each.number, check=each.name)
        for each in least.checks
        if not each.judged and each.number > 1
    ]
    if missing:
        yield Phrase(
            "note: not judged, for want of data in [cam.requirements] or [cam.guide]: {missing}",
            missing=missing,
        )
    closed = least.checks[0]
    if closed.judged and closed.margin < 0 and closed.value is not None and closed.limit is not None:
        text = "the spring reaches {value:.5g} of the safety {limit:.5g} that it was sized for"
        yield held("note", text, closed.value, closed.limit, name="safety of the spring")
    top = task.guide.top
    if top is not None and top < least.height:
        text = (
            "the height of [cam.guide] top, {value:.5g} mm, is below the least possible {limit:.6g} mm: "
            "no sizes keep all constraints at it"
        )
        yield held("warning", text, top, least.height, "m", shown="mm", name="height")
    if scene.follower.kind == "translating" and task.guide.gap == 0:
        yield "note: the guide begins where the roller ends at its highest: [cam.guide] gap is 0"
    if scene.follower.kind == "oscillating":
        yield from _between(chosen, task)
        return
    yield from _pressed(chosen, theta)


def _pressed(chosen: Choice, theta: tuple[Reached, ...]) -> Iterator[Said]:
    """Pressure angles beyond the limits of [cam.limits], which the constraints do not know."""
    for phase, on in zip(("rise", "return"), theta, strict=False):
        if on.exceeded and on.limit is not None:
            text = (
                "at S0 = {start:.6g} mm the pressure angle of the {phase} reaches {value:.5g} deg, beyond the "
                "{limit:.5g} deg of [cam.limits]: it is none of the constraints, which judge what it does to guide, "
                "stem and roller"
            )
            numbers = degrees(abs(on.worst.value)), degrees(on.limit), "deg"
            yield held("note", text, *numbers, name="theta", start=1e3 * chosen.start, phase=phase)


def _between(chosen: Choice, task: CamTask) -> Iterator[Said]:
    """Where a range that is asked for, and none of the constraints, holds a size of a rocker."""
    asked = task.optimum
    for key, size, ends in (
        ("rocker_lengths", chosen.length, asked and asked.rocker_lengths),
        ("centre_distances", chosen.height, asked and asked.centre_distances),
    ):
        if ends and min(abs(size - end) for end in ends) < SAME * size:
            yield Phrase(
                "note: [cam.optimum] {key} holds the size of {size:.6g} mm: it is at the end of its range",
                key=key,
                size=1e3 * size,
            )
