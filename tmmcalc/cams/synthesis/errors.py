"""By how much the sizes found may be off: what the conditions that hold them miss, over how they change with the sizes.

The sizes p are S0 and e, or l0, l2 and psi0. A condition that holds them, a pressure angle at its limit or a room that
is none, misses zero by r in extended precision. With its slopes g, those of what is given, and the least change that
closes all of them,

    g dp = r,    (given) dp = 0

dp is the error of first order. A place with one condition alone is held by the base circle, whose level line touches
the border there: by how much their directions differ, the place may be off along the border.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from math import pi

import numpy as np

from tmmcalc.cams.follower import Follower, contact_path, curvature
from tmmcalc.cams.pivot import PivotRoom
from tmmcalc.cams.pressure.angle import Extreme, Reached, pressure_angle
from tmmcalc.cams.pressure.errors import reached_errors
from tmmcalc.cams.program import Positions, Program
from tmmcalc.cams.rounding import FLOOR, MARGIN, Errors, nearer, sides
from tmmcalc.cams.synthesis.results import Convexity, RollerChoice
from tmmcalc.cams.synthesis.roller import OF_BASE, STEP
from tmmcalc.cams.task import CamTask
from tmmcalc.cams.wide import wide

HELD = 1e-9  # a condition this near to its limit holds the sizes
APART = 1e-6  # of the sizes, for slopes in extended precision
NAMES = {"translating": ("start", "offset"), "oscillating": ("centres", "rocker", "start")}

Condition = Callable[[Follower], float]  # zero where it is just met; in extended precision


def size_errors(
    task: CamTask, found: Follower, ends: tuple[Reached, Reached], choice: RollerChoice, room: PivotRoom | None
) -> Errors:
    """Estimates of the sizes of a roller follower, the angles that they reach, and the radii of the pitch curve."""
    program, follower = task.program, wide(found)
    conditions = [c for c in _conditions(task, follower, ends, choice, room) if abs(c(follower)) < HELD]
    radii = [choice.convex] if choice.concave is None else [choice.convex, choice.concave]
    exact = 1 / _bend(program, follower, [each.phi for each in radii])
    missed = _sizes(task, follower, conditions) + _along(task, follower, ends, conditions)
    return {
        "sizes": max(MARGIN * missed, FLOOR),
        "angles": reached_errors(program, found, ends)["extremes"],
        "radii": max(nearer([each.value], np.abs(exact.reshape(2, -1)[:, k])) for k, each in enumerate(radii)),
    }


def flat_errors(task: CamTask, convexity: Convexity, start: float) -> Errors:
    """Estimates of S0 and of the least radius of the profile under a flat face."""
    rows = sides(task.program, np.array([convexity.least.phi]))
    motion = task.program.wider.at(wide(rows.phi), rows.piece)
    size = max(abs(start), abs(convexity.least.value))
    missed = nearer([convexity.least.value], motion[0] + motion[2], size)
    return {"sizes": missed, "radii": missed * size / max(abs(convexity.radius), FLOOR * size)}


def _conditions(
    task: CamTask, found: Follower, ends: tuple[Reached, Reached], choice: RollerChoice, room: PivotRoom | None
) -> Iterator[Condition]:
    program, limits = task.program, task.limits
    for on in ends:
        for extreme in (on.least, on.largest):
            if on.limit is not None and abs(abs(extreme.value) - on.limit) < HELD:
                yield _angle(program, extreme, on.limit)
    least = (STEP if task.asked.roller is None else task.asked.roller) + limits.convex
    yield lambda f: float(np.max(_bend(program, f, [choice.convex.phi])) * wide(least)) - 1
    if choice.concave is not None and task.asked.closure == "groove":
        place = choice.concave.phi
        yield lambda f: float(np.min(_bend(program, f, [place])) * wide(least)) + 1
    if limits.shaft > 0:
        yield lambda f: float(_base(f) / (wide(limits.shaft) + f.roller)) - 1
        yield lambda f: float(_base(f) * (1 - wide(OF_BASE)) / wide(limits.shaft)) - 1
    if room is not None:
        yield lambda f: _clearance(program, f, room)


def _angle(program: Program, extreme: Extreme, limit: float) -> Condition:
    rows = sides(program, np.array([extreme.phi]))
    phi = wide(rows.phi)
    motion = program.wider.at(phi, rows.piece)
    side = 1 if extreme.value > 0 else -1
    return lambda f: float(np.max(side * pressure_angle(f, phi, motion)) - np.longdouble(limit))


def _clearance(program: Program, f: Follower, room: PivotRoom) -> float:
    rows = sides(program, np.array([room.phi]))
    psi = f.start + program.wider.at(wide(rows.phi), rows.piece)[0, 0]
    top = np.abs(f.centres - f.rocker * np.exp(1j * psi))
    reach = top + f.roller if room.beside else top - f.roller
    return float((reach - (f.centres - wide(room.pivot))) / f.centres)


def _bend(program: Program, f: Follower, phi: list[float]) -> np.ndarray:
    rows: Positions = sides(program, np.array(phi))
    at = wide(rows.phi)
    return curvature(contact_path(f, at, program.wider.at(at, rows.piece)))


def _base(f: Follower) -> np.longdouble:
    """R0 in extended precision."""
    if f.kind == "translating":
        return np.hypot(wide(f.start), f.offset)
    return np.sqrt(f.centres**2 + f.rocker**2 - 2 * f.centres * f.rocker * np.cos(f.start))


def _units(f: Follower) -> np.ndarray:
    """What a change of each size is measured by: R0, of an angle 1 rad."""
    return np.array([1.0 if f.kind == "oscillating" and name == "start" else float(_base(f)) for name in NAMES[f.kind]])


def _slopes(condition: Condition, f: Follower) -> np.ndarray:
    """How a condition changes with each size, in its unit."""
    found = []
    for name, unit in zip(NAMES[f.kind], _units(f), strict=True):
        low, high = (replace(f, **{name: getattr(f, name) + side * APART * unit}) for side in (-1, 1))
        found.append((condition(high) - condition(low)) / (2 * APART))
    return np.array(found)


def _sizes(task: CamTask, f: Follower, conditions: list[Condition]) -> float:
    """The largest change of a size that closes what the conditions miss."""
    asked, names = task.asked, NAMES[f.kind]
    given = [np.eye(len(names))[k] for k, name in enumerate(names) if getattr(asked, name) is not None]
    missed = [0.0] * len(given)
    if asked.base is not None:
        unit = float(_base(f))
        given.append(_slopes(lambda each: float(_base(each)) / unit, f))
        missed.append(float(_base(f) / wide(asked.base)) - 1)
    rows = np.array([*given, *(_slopes(each, f) for each in conditions)])
    if not len(rows):
        return 0.0
    change, *_ = np.linalg.lstsq(rows, np.array([*missed, *(each(f) for each in conditions)]), rcond=1e-9)
    return float(np.max(np.abs(change)))


def _along(task: CamTask, f: Follower, ends: tuple[Reached, Reached], conditions: list[Condition]) -> float:
    """How far a rocker's axis may be off along the border, where one pressure angle alone holds it; 0 elsewhere."""
    lengths = [size for size in (task.asked.rocker, task.asked.centres, task.asked.base) if size is not None]
    if f.kind != "oscillating" or len(conditions) != 1 or len(lengths) != 1 or task.asked.start is not None:
        return 0.0
    held = [
        (each, on.limit)
        for on in ends
        for each in (on.least, on.largest)
        if on.limit is not None and abs(abs(each.value) - on.limit) < HELD
    ]
    if len(held) != 1:
        return 0.0
    extreme, limit = held[0]
    rows = sides(task.program, np.array([extreme.phi]))
    y = task.program.wider.at(wide(rows.phi), rows.piece)[0, 0]
    normal = np.exp(1j * (y + (pi - limit if extreme.value > 0 else limit)))
    axis = f.centres / f.rocker * np.exp(-1j * f.start)
    towards = (axis - 1) / abs(axis - 1) ** 2 - (axis / abs(axis) ** 2 if task.asked.centres is not None else 0)
    return abs(float(np.sin(np.angle(towards / normal))))
