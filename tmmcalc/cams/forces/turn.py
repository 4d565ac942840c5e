"""The turn of the cam as the forces see it: motion, sense of the motion, technological force and weight at points.

Panels have edges at everything that is not smooth: pieces of the laws, dwells, corners of the force's table; later also
where a force changes its sign.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.forces.formulas import Mask
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.program import FLAT, TURN, Positions, levelled
from tmmcalc.cams.task import CamTask, Loads
from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.panels import Panels, panels
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.records import record

SENSES = {"rise": 1.0, "high dwell": 0.0, "return": -1.0, "low dwell": 0.0}
LIFTED = ("rise", "high dwell")  # phases of the first constant force
NEAR = 0.25  # of what a function varies by in a panel: it may pass zero between its points
WIDEST = np.pi / 12  # of a first panel: a whole period of a harmonic is then good to rounding


@record
class Points:
    """The turn at m points."""

    phi: Values  # (m,) [rad]
    motion: Values  # (4, m)
    sense: Values  # (m,) of the motion: 1 rise, -1 return, 0 dwell
    force: Values  # (m,) technological force and weight along the lift [N or N*m]
    acceleration: Values  # (m,) y'' in time over the square of the mean speed


def loads_of(task: CamTask, where: str = "cam_forces") -> Loads:
    """The loads of a task; raises `UsageError` if there are none."""
    if task.loads is None:
        raise UsageError(
            "forces need the speed of the cam", where=where, remedy="give [cam] speed and what [cam.loads] knows"
        )
    return task.loads


def weight(task: CamTask, loads: Loads) -> float:
    """Weight along the lift [N]; a rocker is balanced about its pivot."""
    return 0.0 if task.asked.kind == "oscillating" else loads.mass * loads.gravity


def at_rows(task: CamTask, loads: Loads, rows: Positions) -> Points:
    """The rows of the tables."""
    motion = task.motion if rows is task.positions else task.program.at(rows.phi, rows.piece)
    return _points(task, loads, rows.phi, rows.piece, motion)


def at_angles(task: CamTask, loads: Loads, phi: Values) -> Points:
    """Angles within panels, where nothing jumps."""
    piece = task.program.piece(phi)
    return _points(task, loads, phi, piece, task.program.at(phi, piece))


def _points(task: CamTask, loads: Loads, phi: Values, piece: Indices, motion: Values) -> Points:
    program, force = task.program, loads.force
    phase = program.places[0][piece]
    sense = np.array([SENSES[each.kind] for each in program.phases])[phase]
    for part in task.backward:
        sense[(phi > part.begin) & (phi < part.end)] *= -1
    if force.phi is not None:
        own = force.tabulated(phi)
    else:
        own = np.array([force.rise if each.kind in LIFTED else force.back for each in program.phases])[phase]
    return Points(phi, motion, sense, own + weight(task, loads), acceleration(task, loads, phi, motion))


def acceleration(task: CamTask, loads: Loads, phi: Values, motion: Values) -> Values:
    """y'' in time (m,) over the square of the mean speed, of the motion (4, m)."""
    if task.turning is None:
        return motion[2]
    return task.turning.acceleration(phi, motion) / loads.speed**2


def smooth_panels(task: CamTask, loads: Loads) -> Panels:
    """Panels of the turn with edges where motion, force or speed has a corner."""
    program, none = task.program, np.empty(0)
    corners = none if loads.force.phi is None else np.mod(loads.force.phi, TURN)
    speeds = none if task.turning is None else task.turning.edges
    turned = [angle for part in task.backward for angle in (part.begin, part.end)]
    return panels(0.0, float(program.starts[-1]), np.concatenate((program.edges, corners, speeds, turned)), WIDEST)


def divided(on: Panels, roots: Values) -> Panels:
    """The panels with more edges."""
    return panels(float(on.edges[0]), float(on.edges[-1]), np.concatenate((on.edges, roots)), TURN)


def crossings(on: Panels, values: Values) -> Values:
    """Places (m,) inside panels where a function, (K, N) at their points, passes zero; jumps stand on edges already."""
    if not _may_cross(on, values):
        return np.empty(0)
    at, found = on.turning(levelled(values))
    first = np.arange(len(at)) < len(at) - on.count  # the last are limits at upper edges, which come before a jump
    order = np.lexsort((first, at))
    at, found = at[order], np.where(np.abs(found[order]) > FLAT * np.max(np.abs(values)), found[order], 0.0)
    change = np.flatnonzero((found[1:] * found[:-1] < 0) & (at[1:] > at[:-1]))
    high = at[change + 1]

    def f(x: Values, which: Indices) -> Values:
        return np.where(x < high[which], on.at(values, x), on.at(values, x, before=True))

    return bracketed(f, at[change], high)


def _may_cross(on: Panels, values: Values) -> bool:
    """Whether a panel has both signs at its points or edges, or comes near zero against what it varies by."""
    rows = np.concatenate((values, *(limit[:, None] for limit in on.ends(values))), axis=1)
    low, high = np.min(rows, axis=1), np.max(rows, axis=1)
    return bool(np.any(np.maximum(low, -high) < NEAR * (high - low)))


def spans(edges: Values, which: Mask) -> tuple[tuple[float, float], ...]:
    """Intervals that neighbouring panels (K,) of ``which`` make up.

    >>> spans(np.array([0.0, 1.0, 2.0, 3.0]), np.array([True, True, False]))
    ((0.0, 2.0),)
    """
    padded = np.concatenate(([False], which, [False]))
    change = np.flatnonzero(padded[1:] != padded[:-1])
    return tuple((float(edges[a]), float(edges[b])) for a, b in zip(change[::2], change[1::2], strict=True))
