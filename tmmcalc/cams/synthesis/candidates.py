"""What every constraint alone asks of the size of the cam, where on the cam, and which of them decides.

The size is that of the base circle R0, of a stem also S0. A stem keeps its offset e; the axis of a cam under a rocker
moves away from the rocker's middle position, as where the synthesis enlarges it, with the length that is given kept.
What a constraint asks for is the size from which on it is kept, at all larger ones as well.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import replace
from math import inf
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.pivot import pivot_room
from tmmcalc.cams.pressure.angle import check_reach, reached
from tmmcalc.cams.synthesis.oscillatingsizes import Triangle, lowered
from tmmcalc.cams.synthesis.roller import OF_BASE, STEP, bends
from tmmcalc.cams.task import CamTask
from tmmcalc.core.errors import SingularityError
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables
    from tmmcalc.cams.synthesis.results import Synthesis

GRID = 97  # sizes at which all constraints are looked at
RANGE = 1e-2, 30.0  # of these sizes, of the one taken
BINDS = 1e-6  # of the size taken: a constraint that asks for it decides
TITLES = {
    "pressure_rise": "pressure angle of the rise",
    "pressure_return": "pressure angle of the return",
    "curvature": "radius of convex parts",
    "second_wall": "radius of the second wall",
    "concave": "no concave parts",
    "roller": "roller up to 0.4 R0, a rule of practice",
    "shaft": "room for the shaft",
    "pivot": "room at the pivot",
    "convexity": "convex profile",
}


@record
class SizeCandidate:
    """The least size by one constraint."""

    constraint: str = quantity("constraint", "what asks for the size, in words")
    base: float | None = quantity(  # None: kept by none of the sizes that were looked at
        "R0_needed[m]", "least base circle that keeps the constraint; 0: any does", symbol="R_0"
    )
    start: float | None = quantity("S0_needed[m]", "least start distance that keeps the constraint", symbol="S_0")
    phi: float | None = quantity("phi[rad]", "angle of the cam where it is just kept")  # None: all around the cam
    binds: bool = quantity("binds", "the size taken is the one that this constraint asks for")


ANGLES, BENDS = ("pressure_rise", "pressure_return"), ("curvature", "second_wall", "concave")  # found together

Held = tuple[float, float | None]  # how much there is beyond what is needed, and where it is scarcest


def size_candidates(spec: CamTables, results: Mapping[str, Any]) -> Mapping[str, SizeCandidate]:
    """The candidates of a scene whose stage ``cam_synthesis`` is done."""
    from tmmcalc.cams.tables.tasks.cam import to_cam

    return candidates(to_cam(spec), results["cam_synthesis"])


def candidates(task: CamTask, result: Synthesis) -> Mapping[str, SizeCandidate]:
    """The candidates by the short names of the constraints that a task has, in the order of `TITLES`."""
    if result.convexity is not None:
        needed = result.convexity
        sizes = {"convexity": (max(needed.needed, 0.0), needed.least.phi), "shaft": (task.limits.shaft, None)}
        asked = {name: (size, size, phi) for name, (size, phi) in sizes.items() if name != "shaft" or size}
        return _named(asked, result.follower.start)
    return _named(dict(_found(task, result.follower)), result.follower.base)


def _named(
    asked: Mapping[str, tuple[float | None, float | None, float | None]], taken: float
) -> Mapping[str, SizeCandidate]:
    return {
        name: SizeCandidate(
            TITLES[name], base, start, phi, binds=base is not None and abs(base - taken) <= BINDS * taken
        )
        for name, (base, start, phi) in sorted(asked.items(), key=lambda each: list(TITLES).index(each[0]))
    }


def _found(task: CamTask, taken: Follower) -> Iterator[tuple[str, tuple[float | None, float | None, float | None]]]:
    """R0, S0 and phi of every constraint by its short name."""
    place = _family(task, taken)
    grid = (taken.start if taken.kind == "translating" else taken.base) * np.geomspace(*RANGE, GRID)
    highest = _held(task, place(float(grid[-1])))
    broken = _broken(task, place, grid, highest)
    for name in highest:
        if name not in broken:
            yield name, (0.0, 0.0 if taken.kind == "translating" else None, None)
            continue
        k = broken[name]
        if k == GRID - 1:
            yield name, (None, None, None)
            continue
        size = _passed(task, place, name, float(grid[k]), float(grid[k + 1]))
        follower = place(size)
        phi = _held(task, follower, {name}).get(name, (0.0, None))[1]
        yield name, (follower.base, follower.start if taken.kind == "translating" else None, phi)


def _broken(
    task: CamTask, place: Callable[[float], Follower], grid: Values, highest: Mapping[str, Held]
) -> dict[str, int]:
    """The largest size, by its number, at which each constraint is broken; without those that never are.

    From above, so that what is broken at a size is not looked at any more below.
    """
    found = {name: GRID - 1 for name, (room, _) in highest.items() if room < 0}
    for k in range(GRID - 2, -1, -1):
        left = highest.keys() - found.keys()
        if not left:
            break
        held = _held(task, place(float(grid[k])), left)
        found |= {name: k for name in left if held.get(name, (-inf, None))[0] < 0}
    return found


def _passed(task: CamTask, place: Callable[[float], Follower], name: str, low: float, high: float) -> float:
    """The size between two at which a constraint begins to be kept."""

    def beyond(size: Values, which: Indices) -> Values:
        return np.array([_held(task, place(each), {name}).get(name, (-1.0, None))[0] for each in size.tolist()])

    return float(bracketed(beyond, np.array([low]), np.array([high]))[0])


def _family(task: CamTask, taken: Follower) -> Callable[[float], Follower]:
    """Followers by their size: S0 of a stem, R0 of a rocker as far as its axis can come near."""
    if taken.kind == "translating":
        return lambda size: replace(taken, start=size)
    asked = replace(task.asked, base=None, start=None, rocker=taken.rocker, centres=None)
    if task.asked.rocker is None and task.asked.centres is not None:
        asked = replace(asked, rocker=None, centres=task.asked.centres)
    middle, own = np.exp(0.5j * task.program.stroke), Triangle(taken.centres, taken.rocker, taken.start, "")
    foot = float(((1 - own.axis) * np.conj(-1j * middle)).real)  # from here on R0 grows
    nearest = abs(own.axis - 1j * foot * middle - 1)

    def rocker(size: float) -> Follower:
        along = foot + float(np.sqrt(max((size / taken.base * abs(own.axis - 1)) ** 2 - nearest**2, 0.0)))
        found = lowered(own, task.program.stroke, along, asked)
        return replace(taken, start=found.start, centres=found.centres, rocker=found.rocker)

    return rocker


def _held(task: CamTask, follower: Follower, wanted: Collection[str] = tuple(TITLES)) -> dict[str, Held]:
    """What every constraint that is ``wanted`` leaves, in parts of what it needs; without those without a value."""
    limits, found = task.limits, dict[str, Held]()
    try:
        if not set(ANGLES) & set(wanted):
            check_reach(task.program, follower)
        else:
            for name, on in zip(
                ("pressure_rise", "pressure_return"), reached(task, follower, intervals=False), strict=True
            ):
                if on.limit is not None:
                    found[name] = (1 - abs(on.worst.value) / on.limit, on.worst.phi)
    except SingularityError:
        return found
    r2 = STEP if task.asked.roller is None else task.asked.roller
    least = r2 + limits.convex
    if set(BENDS) & set(wanted):
        low, high = bends(task, follower)
        if least > 0:
            found["curvature"] = (1 - least * high.value, high.phi)
        if least > 0 and task.asked.closure == "groove":
            found["second_wall"] = (1 + least * low.value, low.phi)
        if not limits.allow_concave:
            found["concave"] = (follower.base * low.value, low.phi)
    if task.asked.roller:
        found["roller"] = (OF_BASE * follower.base / task.asked.roller - 1, None)
    if limits.shaft > 0:
        found["shaft"] = (follower.base / (limits.shaft + follower.roller) - 1, None)
    room = pivot_room(task, follower)
    if room is not None and not room.beside:
        found["pivot"] = (room.clearance / follower.centres, room.phi)
    return found
