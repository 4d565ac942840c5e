"""Graded remarks on an indexing drive: a limit that is not kept is a warning, a rule of thumb a note."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees, pi
from typing import Any

from tmmcalc.cams.indexing.choice import EQUAL, NEAR, ROLLERS
from tmmcalc.cams.indexing.results import Cam, Indexing, PressureReached
from tmmcalc.cams.indexing.rollers import USUAL
from tmmcalc.core.notes import Phrase, Said, held


def remarks(found: Indexing) -> Iterator[Said]:
    """What a designer has to know, each with its place and size."""
    limits = found.bounds
    if found.rollers not in ROLLERS:
        few, many = ROLLERS[0], ROLLERS[-1]
        text = "{value:g} pairs of rollers, usual are {low} to {high} (z2 from {few} to {many})"
        words: dict[str, Any] = {"low": few // 2, "high": many // 2, "few": few, "many": many}
        usual = (many if found.rollers > many else few) // 2
        yield held("warning", text, found.rollers // 2, usual, name="pairs of rollers", **words)
    if limits.ratio_max is not None and found.ratio > limits.ratio_max * (1 + EQUAL):
        text = (
            "lambda = {value:.6g} is above lambda_max = {limit:.6g}: the step begins with a "
            "pressure angle of {start} deg"
        )
        yield held("warning", text, found.ratio, limits.ratio_max, name="lambda", start=_deg(found.start_pressure))
    if found.ratio <= limits.ratio_min * (1 + EQUAL):
        text = "lambda = lambda_min: the pitch curve of the groove ends in a point, where no roller works"
        yield held("warning", text, found.ratio, limits.ratio_min, name="lambda")
    elif found.ratio < NEAR * limits.ratio_min:
        text = "lambda is only {above:.3g} % above lambda_min: the bottom of the groove is sharp"
        above = 100 * (found.ratio / limits.ratio_min - 1)
        yield held("warning", text, found.ratio, limits.ratio_min, name="lambda", above=above)
    if found.dwells is not None:
        shortest, least = min(found.dwells), 2 * found.start_angle
        if shortest < least * (1 - EQUAL):
            text = "the dwell of {value:.6g} deg is below the recommended 2 delta_0 = {limit:.6g} deg"
            yield held("warning", text, degrees(shortest), degrees(least), "deg", name="dwell")
    elif limits.step_max is not None and found.step > limits.step_max * (1 + EQUAL):
        text = (
            "the step of {value:.6g} deg is above the recommended {limit:.6g} deg, {left} deg are left for each dwell"
        )
        numbers = degrees(found.step), degrees(limits.step_max), "deg"
        yield held("warning", text, *numbers, name="step", left=_deg(pi - found.step))
    if found.cam is not None:
        yield from _cam_remarks(found, found.cam)


def _cam_remarks(found: Indexing, cam: Cam) -> Iterator[Said]:
    yield from _pressure_remarks("run-up", "warning", cam.run_up)
    yield from _pressure_remarks("run-out", "note", cam.run_out)
    if cam.working_angle > found.limit * (1 + EQUAL):
        yield (
            Phrase(
                "note: the working profile of A ends at k = {working_part:.4g}, where B takes over with a "
                "pressure angle of {working_angle} deg",
                working_part=cam.working_part,
                working_angle=_deg(cam.working_angle),
            )
        )
    second = found.second
    if second is not None and second.roller != found.roller and second.working_angle > found.limit * (1 + EQUAL):
        yield (
            Phrase(
                "note: the working profile of A of the second cam ends at k = {working_part:.4g}, where B takes "
                "over with a pressure angle of {working_angle} deg",
                working_part=second.working_part,
                working_angle=_deg(second.working_angle),
            )
        )
    reach = cam.working_tip if second is None else max(cam.working_tip, second.working_tip)
    if reach >= found.centres:
        text = (
            "the lobe reaches {value:.6g} mm from O1 and sweeps over O2 at {limit:.6g} mm: no shaft of the wheel can "
            "pass through the planes of the cams"
        )
        yield held("note", text, reach, found.centres, "m", shown="mm", name="reach of the lobe")
    yield from _roller_remarks(found, cam)
    table = cam.efficiency
    for name, share in (("against", table.against_share), ("along", table.aiding_share)):
        if share > EQUAL:
            yield (
                Phrase(
                    "note: with the load {name} the motion the efficiency is cut off at 0 or 1 over {share:.3g} % "
                    "of the step: self-locking, or the formula does not hold",
                    name=name,
                    share=100 * share,
                )
            )


def _pressure_remarks(name: str, grade: str, reached: PressureReached) -> Iterator[Said]:
    if reached.exceeded:
        text = "the pressure angle reaches {value:.6g} deg at k = {part:.4g}, the limit is {limit:.6g} deg"
        numbers, place = (
            (degrees(reached.largest), degrees(reached.limit), "deg"),
            Phrase("{name} on {flank}", name=name, flank=reached.flank),
        )
        yield held(grade, text, *numbers, name="theta", place=place, part=reached.part)


def _roller_remarks(found: Indexing, cam: Cam) -> Iterator[Said]:
    radius = max(found.roller or 0.0, found.second.roller if found.second is not None else 0.0)
    for limit in cam.roller_limits[:2]:
        if limit.radius is not None and radius > USUAL[1] * limit.radius * (1 + EQUAL):
            text = (
                "the roller of {value:.6g} mm is above {part:g} of the least radius on {flank}, {radius:.6g} mm, the "
                "usual rule"
            )
            words: dict[str, Any] = {"flank": limit.name, "radius": 1e3 * limit.radius, "part": USUAL[1]}
            yield held("note", text, radius, USUAL[1] * limit.radius, "m", shown="mm", name="r2", **words)


def _deg(value: float) -> str:
    return f"{degrees(value):.6g}"
