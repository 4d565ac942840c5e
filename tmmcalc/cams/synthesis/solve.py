"""The whole synthesis: sizes, the designs beside them, region, roller; by the kind of the follower."""

from __future__ import annotations

from math import pi

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.synthesis import flatface
from tmmcalc.cams.synthesis.completion import GIVEN, WHOLE, size_of, up
from tmmcalc.cams.synthesis.errors import flat_errors
from tmmcalc.cams.synthesis.oscillating import rocker
from tmmcalc.cams.synthesis.results import Design, Synthesis
from tmmcalc.cams.synthesis.translating import stem
from tmmcalc.cams.task import CamTask
from tmmcalc.core.errors import NoSolutionError, UsageError


def solve_synthesis(task: CamTask) -> Synthesis:
    """Find every size of the follower that is not given, within the limits of the task.

    Raises `NoSolutionError` if no size keeps the limits, `UsageError` if what is given contradicts itself or says too
    little, `SingularityError` if a given size brings the follower to the cam's axis.
    """
    _check_limits(task)
    if task.asked.kind == "flat":
        return _flat(task)
    return stem(task) if task.asked.kind == "translating" else rocker(task)


def _flat(task: CamTask) -> Synthesis:
    start, governs, convexity = flatface.flat_sizes(task)
    if start <= 0:
        raise NoSolutionError(
            f"S0 = {1e3 * start:g} mm: the profile is convex for every S0 and nothing else asks for a size",
            where="cam_synthesis",
            value=start,
            limit=0.0,
            remedy="give start_distance, or shaft_radius or convex_radius in [cam.limits]",
        )
    how = {"convexity": "r_m - F_min (5.97)", "shaft": "radius of the shaft", GIVEN: GIVEN}[governs]
    follower = Follower("flat", start, sense=task.asked.sense)
    notes = tuple(flatface.remarks(convexity, start, task.limits.shaft))
    rounded = None
    if governs != GIVEN and start >= WHOLE:
        whole = up(start)
        rounded = Design("whole millimetres", whole, whole, 0.0, 0.0, 0.0, (0.0, 0.0), (0.0, 0.0), 0.0)
    sizes = (size_of("S0", start, governs == GIVEN, how),)
    return Synthesis(
        "flat", follower, sizes, governs, (), rounded, None, None, None, convexity, None, 0.0, (*task.remarks, *notes),
        flat_errors(task, convexity, start),
    )  # fmt: skip


def _check_limits(task: CamTask) -> None:
    """Refuse limits that no angle can have."""
    if task.asked.kind == "flat":
        return
    for name, limit in (("pressure_angle", task.limits.rise), ("pressure_angle_return", task.limits.back)):
        if limit is not None and not 0 < limit < pi / 2:
            raise UsageError(
                f"{name} = {np.degrees(limit):g} deg is no limit of a pressure angle",
                where="cam.limits",
                value=limit,
                limit=pi / 2,
                remedy="more than 0, less than 90 deg; 30 deg is usual for a translating follower, 45 deg for a rocker",
            )
