"""A rocker whose cam passes its pivot, where the pressure angle alone would let the cam sweep over it.

The place of the axis that is best by its objective is looked for on the border (`border`), with two sizes given on
their curve as far as the cam passes. A roller that is to be found is the largest in whole millimetres that the rules
leave the cam which it makes: a larger roller makes a smaller cam.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import floor

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.pivot import PivotRoom, highest, pivot_fault, pivot_room
from tmmcalc.cams.synthesis import oscillatingsizes, roller
from tmmcalc.cams.synthesis.curves import TOUCH, best_on
from tmmcalc.cams.synthesis.enlargement import enlarged
from tmmcalc.cams.synthesis.halfplanes import families, outside
from tmmcalc.cams.synthesis.objectives import Distance, Ratio
from tmmcalc.cams.synthesis.oscillatingsizes import Triangle
from tmmcalc.cams.synthesis.pivotborder import Passage, border
from tmmcalc.cams.task import Asked, CamTask
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.roots import bracketed

FIRST = 2.0**-6  # part of the way along the border that is tried first
HALVINGS = 60
FAR = 1.0  # beyond, where no place is left
NEAR = 1e-9
PASSES = "just passes the pivot"


Make = Callable[[Triangle], Follower]
Found = tuple[Follower, str]  # the follower, and how its sizes were found


def passing(task: CamTask, bare: Follower, make: Make) -> Found | None:
    """The follower of the best place of the axis from which the cam passes the pivot, and how it was found.

    None if ``bare`` passes already. Raises `NoSolutionError` if there is no such place.
    """
    room = chosen_room(task, bare)
    if not room.swept:
        return None

    def place(r2: float) -> Found:
        return _placed(task, r2, make)

    try:
        if task.asked.roller is not None:
            return place(task.asked.roller)
        return _with_largest(task, place, roller.choose(task, bare).radius)
    except NoSolutionError:
        raise _forbidden(task, bare, room) from None


def chosen_room(task: CamTask, bare: Follower) -> PivotRoom:
    """The room at the pivot with the roller that the rules choose."""
    room = pivot_room(task, replace(bare, roller=roller.choose(task, bare).radius))
    assert room is not None
    return room


def _with_largest(task: CamTask, place: Callable[[float], Found], first: float) -> Found:
    """The place for the largest roller that the cam which it makes is left by the rules."""

    def chosen(found: Found) -> float:
        return roller.choose(task, found[0]).radius

    kept = place(first)
    while chosen(kept) < first * (1 - NEAR):
        first = chosen(kept)
        kept = place(first)
    low, top = _whole(first), _whole(chosen(kept))
    while low < top:
        middle = (low + top + 1) // 2
        other = place(middle * roller.STEP)
        if _whole(chosen(other)) >= middle:
            low, kept = middle, other
        else:
            top = middle - 1
    return kept


def _whole(radius: float) -> int:
    """In whole steps."""
    return floor(radius / roller.STEP * (1 + NEAR))


def _placed(task: CamTask, r2: float, make: Make) -> Found:
    """The best place for a roller."""
    asked = task.asked
    passage = _passage(task, asked, r2)
    if len(_lengths(asked)) + (asked.start is not None) > 1:
        triangle = oscillatingsizes.on_curve(asked, families(task), passage.over)
        return make(triangle), f"{triangle.how}, the cam {PASSES}"
    if asked.rocker is None and asked.centres is None:
        asked = replace(asked, rocker=_longest(task, r2))
        passage = _passage(task, asked, r2)
    return _on_border(task, asked, passage, make)


def _passage(task: CamTask, asked: Asked, r2: float) -> Passage:
    pivot = 0.0 if task.loads is None else task.loads.pivot_radius
    return Passage(asked, complex(np.exp(1j * highest(task.program)[0])), r2 - pivot)


def _on_border(task: CamTask, asked: Asked, passage: Passage, make: Make) -> Found:
    """The best place on the border, moved along it while roller or shaft have no room."""
    every = families(task)
    aim = Ratio() if asked.centres is not None else Distance(1.0)
    line = border(passage, aim)
    if line is None:
        raise NoSolutionError("no place of the cam's axis lets the cam pass the pivot", where="cam_synthesis")
    curve = line.curve
    begin = line.at(best_on(every, curve, lambda o: float(aim.of(np.array(o)))))

    def place(t: float) -> Follower:
        point = complex(curve.at(np.array([begin + (curve.high - begin) * t / (1 + t)]))[0])
        if t and outside(every, point)[0] > TOUCH * (1 + abs(point)):
            raise NoSolutionError("the border leaves the region of the pressure angle", where="cam_synthesis")
        return make(oscillatingsizes.scaled(asked, point, PASSES))

    found, governs = enlarged(task, place, FIRST)
    rule = "least base circle" if task.asked.base is None else "longest rocker"
    return found, f"{governs}, where the cam {PASSES}" if governs else f"{rule} with which the cam {PASSES}"


def _longest(task: CamTask, r2: float) -> float:
    """The rocker [m] whose least base circle with the pivot passed is the one given."""
    base, every, aim = task.asked.base or 0.0, families(task), Distance(1.0)
    least = oscillatingsizes.least_triangle(task)

    def beyond(rocker: float) -> float:
        passage = _passage(task, replace(task.asked, base=None, rocker=rocker), r2)
        if passage.over(np.array(least.axis)) <= 0:
            return rocker / least.rocker - 1
        line = border(passage, aim)
        try:
            distance = np.inf if line is None else abs(best_on(every, line.curve, lambda o: abs(o - 1)) - 1)
        except NoSolutionError:
            return FAR
        return float(min(rocker * distance / base - 1, FAR))

    def margin(x: Values, which: Indices) -> Values:
        return np.array([beyond(each) for each in x.tolist()])

    low = least.rocker
    for _ in range(HALVINGS):
        if beyond(low) <= 0:
            return float(bracketed(margin, np.array([low]), np.array([least.rocker]))[0])
        low /= 2
    raise NoSolutionError("no rocker lets the cam pass the pivot", where="cam_synthesis")


def _lengths(asked: Asked) -> list[str]:
    """The keys of the lengths that are given."""
    given = {"rocker_length": asked.rocker, "centre_distance": asked.centres, "base_radius": asked.base}
    return [name for name, size in given.items() if size is not None]


def _forbidden(task: CamTask, bare: Follower, room: PivotRoom) -> NoSolutionError:
    """What is given leaves no place from which the cam passes; the numbers are those of the best place without."""
    given = [*_lengths(task.asked), *(["start_angle"] if task.asked.start is not None else [])]
    with_given = f" with the given {' and '.join(given)}" if len(given) > 1 else ""
    ways = [f"leave {given[-1]} out"] if len(given) > 1 else []
    needed = task.asked.roller
    if needed is not None:
        needed -= room.clearance
        fits = needed <= roller.choose(replace(task, asked=replace(task.asked, roller=None)), bare).radius
        ways += [f"a roller_radius of {np.ceil(1e6 * needed) / 1e3:g} mm"] if fits else []
    ways += ["a larger pressure_angle", "a smaller stroke", "longer phases"]
    if room.pivot:
        ways.append("a smaller pivot_radius")
    return NoSolutionError(
        f"{pivot_fault(room)}; no other place of the cam's axis{with_given} keeps the pressure angle and passes it",
        where="cam_synthesis",
        value=room.radius,
        limit=room.limit,
        remedy=", ".join(ways),
    )
