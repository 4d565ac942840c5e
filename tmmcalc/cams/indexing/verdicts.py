"""Graded remarks on an indexing drive: a limit that is not kept is a warning, a rule of thumb a note."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees, pi

from tmmcalc.cams.indexing.choice import EQUAL, NEAR, ROLLERS
from tmmcalc.cams.indexing.results import Cam, Indexing, PressureReached
from tmmcalc.cams.indexing.rollers import USUAL


def remarks(found: Indexing) -> Iterator[str]:
    """What a designer has to know, each with its place and size."""
    limits = found.bounds
    if found.rollers not in ROLLERS:
        yield f"warning: {found.rollers // 2} pairs of rollers, usual are 3 to 7 (z2 from 6 to 14)"
    if limits.ratio_max is not None and found.ratio > limits.ratio_max * (1 + EQUAL):
        yield (
            f"warning: lambda = {found.ratio:.6g} is above lambda_max = {limits.ratio_max:.6g}: the step begins with a "
            f"pressure angle of {_deg(found.start_pressure)} deg"
        )
    if found.ratio <= limits.ratio_min * (1 + EQUAL):
        yield "warning: lambda = lambda_min: the pitch curve of the groove ends in a point, where no roller works"
    elif found.ratio < NEAR * limits.ratio_min:
        yield (
            f"warning: lambda is only {100 * (found.ratio / limits.ratio_min - 1):.3g} % above lambda_min: the bottom "
            "of the groove is sharp"
        )
    if found.dwells is not None:
        shortest, least = min(found.dwells), 2 * found.start_angle
        if shortest < least * (1 - EQUAL):
            yield f"warning: the dwell of {_deg(shortest)} deg is below the recommended 2 delta_0 = {_deg(least)} deg"
    elif limits.step_max is not None and found.step > limits.step_max * (1 + EQUAL):
        yield (
            f"warning: the step of {_deg(found.step)} deg is above the recommended {_deg(limits.step_max)} deg, "
            f"{_deg(pi - found.step)} deg are left for each dwell"
        )
    if found.cam is not None:
        yield from _cam_remarks(found, found.cam)


def _cam_remarks(found: Indexing, cam: Cam) -> Iterator[str]:
    yield from _pressure_remarks("run-up", "warning", cam.run_up)
    yield from _pressure_remarks("run-out", "note", cam.run_out)
    if cam.working_angle > found.limit * (1 + EQUAL):
        yield (
            f"note: the working profile of A ends at k = {cam.working_part:.4g}, where B takes over with a pressure "
            f"angle of {_deg(cam.working_angle)} deg"
        )
    second = found.second
    if second is not None and second.roller != found.roller and second.working_angle > found.limit * (1 + EQUAL):
        yield (
            f"note: the working profile of A of the second cam ends at k = {second.working_part:.4g}, where B takes "
            f"over with a pressure angle of {_deg(second.working_angle)} deg"
        )
    reach = cam.working_tip if second is None else max(cam.working_tip, second.working_tip)
    if reach >= found.centres:
        yield (
            f"note: the lobe reaches {1e3 * reach:.6g} mm from O1 and sweeps over O2 at "
            f"{1e3 * found.centres:.6g} mm: no shaft of the wheel can pass through the planes of the cams"
        )
    yield from _roller_remarks(found, cam)
    table = cam.efficiency
    for name, share in (("against", table.against_share), ("along", table.aiding_share)):
        if share > EQUAL:
            yield (
                f"note: with the load {name} the motion the efficiency is cut off at 0 or 1 over {100 * share:.3g} % "
                "of the step: self-locking, or the formula does not hold"
            )


def _pressure_remarks(name: str, grade: str, reached: PressureReached) -> Iterator[str]:
    if reached.exceeded:
        yield (
            f"{grade}: {name} on {reached.flank}: the pressure angle reaches {_deg(reached.largest)} deg at "
            f"k = {reached.part:.4g}, the limit is {_deg(reached.limit)} deg"
        )


def _roller_remarks(found: Indexing, cam: Cam) -> Iterator[str]:
    radius = max(found.roller or 0.0, found.second.roller if found.second is not None else 0.0)
    for limit in cam.roller_limits[:2]:
        if limit.radius is not None and radius > USUAL[1] * limit.radius * (1 + EQUAL):
            yield (
                f"note: the roller of {1e3 * radius:.6g} mm is above {USUAL[1]:g} of the least radius on {limit.name}, "
                f"{1e3 * limit.radius:.6g} mm, the usual rule"
            )


def _deg(value: float) -> str:
    return f"{degrees(value):.6g}"
