"""The synthesis of a translating roller follower: S0, e, R0 and the designs beside them."""

from __future__ import annotations

from dataclasses import replace

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.synthesis import translatingsizes
from tmmcalc.cams.synthesis.completion import (
    ANGLE,
    GIVEN,
    LEAST,
    NEAR,
    TEXTBOOK,
    WHOLE,
    WHOLE_NAME,
    completed,
    judged,
    size_of,
    up,
)
from tmmcalc.cams.synthesis.enlargement import enlarged, has_room
from tmmcalc.cams.synthesis.results import Design, Synthesis
from tmmcalc.cams.synthesis.translatingsizes import Lines, Point
from tmmcalc.cams.task import CamTask
from tmmcalc.core.errors import UsageError

LOWEST = "least start distance"
MOST = 20  # whole millimetres above the first that are tried


def stem(task: CamTask) -> Synthesis:
    """Find the sizes of a stem with a roller that are not given; raises as `solve_synthesis` does."""
    asked, lines = task.asked, translatingsizes.lines_of(task)
    given = None if asked.offset is None else asked.sense * asked.offset + 0.0  # no negative zero
    point, how = _place(task, lines, given)
    e, start = translatingsizes.clean(point)
    free = asked.start is None and asked.base is None

    def place(x: float) -> Follower:
        return Follower("translating", start * (1 + x), e, asked.roller or 0.0, sense=asked.sense)

    bare, governs = enlarged(task, place) if free else (place(0.0), GIVEN)
    if free and governs:
        how = f"{governs}, at this e"
    closing = asked.start is not None and asked.base is not None
    to_e = how if free or closing else "smallest that keeps the limits"
    sizes = (
        size_of("S0", bare.start, asked.start is not None, how),
        size_of("e", asked.sense * e + 0.0, asked.offset is not None, to_e),
        size_of("R0", bare.base, asked.base is not None, "R0^2 = S0^2 + e^2"),
    )
    designs = _designs_rt(task, lines, given)
    rounded = _rounded_rt(task, lines, bare, asked.offset is None) if free else None
    region = translatingsizes.region_of(lines, (e, bare.start))
    return completed(task, bare, sizes, governs or ANGLE, designs, rounded, region)


def _place(task: CamTask, lines: Lines, given: float | None) -> tuple[Point, str]:
    """e (canonical), S0 and the rule that found them."""
    asked = task.asked
    if asked.start is not None and asked.base is not None:
        e = translatingsizes.offset_of(lines, asked.base, asked.start)
        if given is not None and abs(abs(e) - abs(given)) > NEAR * asked.base:
            raise UsageError(
                f"R0 and S0 make e = {1e3 * e:.6g} mm, not {1e3 * given:.6g} mm",
                where="cam",
                value=abs(given),
                limit=abs(e),
                remedy="leave base_radius, start_distance or offset out",
            )
        return (e if given is None else given, asked.start), "R0^2 = S0^2 + e^2"
    if asked.start is not None:
        e = translatingsizes.offset_at_start(lines, asked.start) if given is None else given
        return (e, asked.start), "smallest that keeps the limits"
    if asked.base is not None:
        e = translatingsizes.offset_on_base(lines, asked.base) if given is None else given
        return (e, translatingsizes.start_on_base(asked.base, e)), "R0^2 = S0^2 + e^2"
    if given is None:
        return translatingsizes.nearest(lines), f"{LEAST} within the limits"
    return (given, translatingsizes.least_start(lines, given)), "least within the limits at this e"


def _designs_rt(task: CamTask, lines: Lines, given: float | None) -> tuple[Design, ...]:
    """The exact optima, free and at the given or no offset, each beside the textbook's."""
    at = given or 0.0
    mark = f"e = {1e3 * task.asked.sense * at + 0.0:.6g} mm"
    near, low = translatingsizes.nearest(lines), translatingsizes.lowest(lines)
    points = [
        (LEAST, near),
        (LOWEST, low),
        (f"{TEXTBOOK} (5.44)", translatingsizes.textbook(task, None)),
        (f"{LOWEST}, {mark}", (at, translatingsizes.least_start(lines, at))),
        (f"{TEXTBOOK}, {mark}", translatingsizes.textbook(task, at)),
    ]
    if abs(near[1] - low[1]) <= NEAR * low[1]:
        points[:2] = [(f"{LEAST} and S0", near)]
    followers = ((name, Follower("translating", start, e)) for name, (e, start) in points)
    return tuple(design for name, follower in followers for design in judged(task, name, follower))


def _rounded_rt(task: CamTask, lines: Lines, found: Follower, free: bool) -> Design | None:
    """e to the nearest whole millimetre, if it is free, and S0 to the next above with which that has room."""
    if found.start < WHOLE:
        return None
    e = round(found.offset * 1e3) / 1e3 if free else found.offset
    start = up(max(found.start, translatingsizes.least_start(lines, e)))
    tried = (replace(found, start=start + more / 1e3, offset=e) for more in range(MOST))
    fits = next((each for each in tried if has_room(task, each)), None)
    return None if fits is None else next(iter(judged(task, WHOLE_NAME, fits)), None)
