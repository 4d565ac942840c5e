"""The synthesis of an oscillating roller follower: l0, l2, psi0, R0 and the designs beside them."""

from __future__ import annotations

from dataclasses import replace

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.synthesis import oscillatingsizes
from tmmcalc.cams.synthesis.completion import (
    ANGLE,
    GIVEN,
    LEAST,
    NEAR,
    PIVOT_ROOM,
    WHOLE,
    WHOLE_NAME,
    completed,
    judged,
    size_of,
    up,
)
from tmmcalc.cams.synthesis.enlargement import enlarged, has_room
from tmmcalc.cams.synthesis.oscillatingsizes import Triangle
from tmmcalc.cams.synthesis.pivotclearance import chosen_room, passing
from tmmcalc.cams.synthesis.results import Design, Synthesis
from tmmcalc.cams.task import CamTask
from tmmcalc.core.errors import NoSolutionError

MOST = 5  # whole millimetres above l0 that are tried


def rocker(task: CamTask) -> Synthesis:
    """Find the sizes of a rocker with a roller that are not given; raises as `solve_synthesis` does."""
    asked = task.asked
    found = oscillatingsizes.least_triangle(task)
    lengths = [size for size in (asked.rocker, asked.centres, asked.base) if size is not None]
    free = len(lengths) == 1 and asked.start is None

    def place(x: float) -> Follower:
        by = oscillatingsizes.lowered(found, task.program.stroke, x, asked) if x else found
        return _rocker(task, by)

    bare, governs = enlarged(task, place) if free else (place(0.0), "" if found.how != GIVEN else GIVEN)
    how = f"{governs}, away from the rocker's middle position" if free and governs else found.how
    if governs != GIVEN:
        bare, governs, how = _clear_of_pivot(task, bare, governs, how)
    closing = "from the triangle of l0, l2, R0, psi0"
    sizes = (
        size_of("l0", bare.centres, asked.centres is not None, how if governs != GIVEN else closing),
        size_of("l2", bare.rocker, asked.rocker is not None, how if governs != GIVEN else closing),
        size_of("psi0", bare.start, asked.start is not None, how if governs != GIVEN else closing),
        size_of("R0", bare.base, asked.base is not None, closing),
    )
    taken = Triangle(bare.centres, bare.rocker, bare.start, how)
    region = oscillatingsizes.region_of(task, taken)
    designs = _designs_rk(task, bare) if region is not None else ()
    rounded = _rounded_rk(task, bare) if free and not governs and asked.rocker is not None else None
    return completed(task, bare, sizes, governs or ANGLE, designs, rounded, region)


def _clear_of_pivot(task: CamTask, bare: Follower, governs: str, how: str) -> tuple[Follower, str, str]:
    """The follower, what governs it and how, with the axis where the cam passes the rocker's pivot."""
    try:
        found = passing(task, bare, lambda each: _rocker(task, each))
    except NoSolutionError:
        if not task.asked.report_faults:
            raise
        return bare, governs, how
    return (bare, governs, how) if found is None else (found[0], PIVOT_ROOM, found[1])


def _designs_rk(task: CamTask, taken: Follower) -> tuple[Design, ...]:
    """For the same rocker: the least base circle, the least distance of the centres, the textbook's."""
    asked = replace(task.asked, rocker=taken.rocker, centres=None, base=None, start=None)
    alone = replace(task, asked=asked)
    book = oscillatingsizes.textbook(task, taken.rocker)
    near, close = oscillatingsizes.least_triangle(alone), oscillatingsizes.least_centres(alone)
    found = [(LEAST, near), ("least centre distance", close)]
    if abs(near.centres - close.centres) <= NEAR * close.centres:
        found = [(f"{LEAST} and l0", near)]
    if book is not None:
        found.append((book.how, book))
    return tuple(design for name, each in found for design in judged(task, name, _rocker(task, each)))


def _rounded_rk(task: CamTask, found: Follower) -> Design | None:
    """l0 up to the next whole millimetre with which the least base circle has room for all; None if none is near."""
    if found.centres < WHOLE:
        return None
    for more in range(MOST):
        asked = replace(task.asked, rocker=found.rocker, centres=up(found.centres) + more / 1e3, base=None, start=None)
        try:
            follower = _rocker(task, oscillatingsizes.least_triangle(replace(task, asked=asked)))
            if has_room(task, follower) and not chosen_room(task, follower).swept:
                return next(iter(judged(task, WHOLE_NAME, follower)), None)
        except NoSolutionError:
            continue
    return None


def _rocker(task: CamTask, found: Triangle) -> Follower:
    asked = task.asked
    return Follower(
        "oscillating",
        found.start,
        roller=asked.roller or 0.0,
        centres=found.centres,
        rocker=found.rocker,
        assembly=asked.assembly,
        sense=asked.sense,
    )
