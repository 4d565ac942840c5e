"""What all syntheses of roller followers end with: the roller is chosen, the angles are judged, sizes are named."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import ceil

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.pivot import PivotRoom, pivot_fault, pivot_room
from tmmcalc.cams.pressure.angle import Reached, reached, remarks
from tmmcalc.cams.synthesis import roller
from tmmcalc.cams.synthesis.errors import size_errors
from tmmcalc.cams.synthesis.results import Design, Region, Size, Synthesis
from tmmcalc.cams.task import CamTask
from tmmcalc.core.errors import SingularityError
from tmmcalc.core.notes import Phrase

GIVEN, ANGLE = "given", "pressure angle"
PIVOT_ROOM = "room at the pivot"
LEAST, TEXTBOOK = "least base circle", "textbook"
WHOLE_NAME = "whole millimetres"
WHOLE = 5e-3  # [m] sizes below it are not rounded to millimetres
NEAR = 1e-9


def completed(
    task: CamTask,
    bare: Follower,
    sizes: tuple[Size, ...],
    governs: str,
    designs: tuple[Design, ...],
    rounded: Design | None,
    region: Region | None,
) -> Synthesis:
    """Choose the roller, judge the angles."""
    choice = roller.choose(task, bare)
    follower = replace(bare, roller=choice.radius)
    rise, back = reached(task, follower)
    how = f"{choice.governs}, {'rounded down' if choice.radius >= roller.STEP else 'as it is'}"
    sizes = (*sizes, size_of("r2", choice.radius, task.asked.roller is not None, how))
    room = pivot_room(task, follower)
    swept = tuple(_pivot_remarks(room, governs))
    notes = (
        *task.remarks,
        *swept,
        *remarks("rise", rise),
        *remarks("return", back),
        *roller.remarks(task, follower, choice),
    )
    residual = abs(max(_excesses(rise, back))) if governs == ANGLE else 0.0
    return Synthesis(
        bare.kind,
        follower,
        sizes,
        governs,
        designs,
        rounded,
        rise,
        back,
        region,
        None,
        choice,
        residual,
        notes,
        size_errors(task, follower, (rise, back), choice, room),
        room,
    )


def _pivot_remarks(room: PivotRoom | None, governs: str) -> Iterator[str]:
    if room is not None and room.swept:
        yield Phrase("warning: {fault}", fault=pivot_fault(room))
    elif room is not None and room.passed:
        yield Phrase("note: {fault}", fault=pivot_fault(room))
    elif room is not None and governs == PIVOT_ROOM and not room.pivot:
        yield "note: the cam passes the centre of the rocker's pivot; pivot_radius in [cam.loads] gives the pivot room"


def judged(task: CamTask, name: str, follower: Follower) -> list[Design]:
    """A follower with the angles that it reaches; nothing if it comes to the cam's axis."""
    try:
        rise, back = reached(task, follower, intervals=False)
    except SingularityError:
        return []
    ends = [(on.least.value, on.largest.value) for on in (rise, back)]
    excess = max(_excesses(rise, back))
    sizes = (follower.base, follower.start, follower.offset, follower.centres, follower.rocker)
    return [Design(name, *sizes, ends[0], ends[1], excess)]


def _excesses(rise: Reached, back: Reached) -> list[float]:
    return [on.excess for on in (rise, back) if on.limit is not None]


def size_of(symbol: str, value: float, given: bool, how: str) -> Size:
    """A size with the rule that found it, unless it was given."""
    return Size(symbol, float(value), given, GIVEN if given else how)


def up(size: float) -> float:
    """The next whole millimetre above."""
    return ceil(size * 1e3 * (1 - NEAR)) / 1e3
