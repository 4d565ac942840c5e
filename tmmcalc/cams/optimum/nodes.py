"""Where on the turn the search looks: Gauss points and ends of panels in which motion and 1/P are smooth.

P, the force that presses the follower on the cam, does not depend on the sizes. Where it is small, 1/P and with it the
slip function has a sharp peak, for which the panels are halved.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmmcalc.cams.forces.formulas import resultant
from tmmcalc.cams.forces.results import SpringFound
from tmmcalc.cams.forces.turn import Points, at_angles, at_rows
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.optimum.peaks import RISE, ended
from tmmcalc.cams.program import Positions
from tmmcalc.cams.task import CamTask, Loads
from tmmcalc.core.numerics.panels import Panels, panels, resolved

TOLERANCE = 1e-10  # of 1/P on a panel
LEAST = 1e-9  # of the largest P: what is less counts as this


def pressing(loads: Loads, spring: SpringFound, at: Points) -> Values:
    """P [N] (m,), at the speed of the machine if it is known; not positive where the follower leaves the cam."""
    inertia = loads.mass * loads.speed**2
    return -resultant(at.motion, inertia, spring.stiffness, spring.preload, at.force, at.acceleration)


def nodes(task: CamTask, loads: Loads, spring: SpringFound, rise: bool, widest: float) -> tuple[Values, Indices]:
    """phi (M,) and piece of the program of every node, of the ``rise`` alone or of the turn, panel by panel.

    Of a dwell its first panel stands, and those in which what varies may be extreme.
    """
    program = task.program
    on = _panels(task, loads, spring, widest)
    middle = (on.edges[:-1] + on.edges[1:]) / 2
    piece = np.clip(np.searchsorted(program.edges, middle) - 1, 0, len(program.edges) - 2)
    phase = program.places[0][piece]
    kinds = np.array([each.kind for each in program.phases])[phase]
    points = ended(on.order).points
    phi = on.edges[:-1, None] + on.width[:, None] * points
    phi[:, -1] = on.edges[1:]
    chosen = kinds == "rise"
    if not rise:
        chosen |= kinds == "return"
        dwell = np.where(chosen, -1, phase)
        chosen |= np.append(True, phase[1:] != phase[:-1])
        if loads.force.phi is not None or task.turning is not None:
            chosen |= _extreme(task, loads, spring, phi, piece, dwell)
    return phi[chosen].ravel(), np.repeat(piece[chosen], len(points))


def _extreme(
    task: CamTask, loads: Loads, spring: SpringFound, phi: Values, piece: Indices, dwell: Indices
) -> NDArray[np.bool_]:
    """Panels (K,) of every ``dwell`` (K,), -1: none, in which P or eps/P may be largest or least.

    All that the constraints limit goes one way with P or with eps/P where the follower rests.
    """
    at = at_rows(task, loads, Positions(phi.ravel(), np.repeat(piece, phi.shape[1]), ()))
    force = pressing(loads, spring, at)
    varying = [force]
    if task.turning is not None:
        varying.append(task.turning.at(at.phi)[1] / np.maximum(force, LEAST * np.max(force)))
    found = np.zeros(len(phi), bool)
    for each in set(dwell[dwell >= 0].tolist()):
        rows = np.flatnonzero(dwell == each)
        for values in varying:
            held = values.reshape(phi.shape)[rows]
            low, high = held.min(axis=1), held.max(axis=1)
            room = RISE * (high - low)
            if high.max() > low.min():
                found[rows] |= (low - room <= low.min()) | (high + room >= high.max())
    return found


def _panels(task: CamTask, loads: Loads, spring: SpringFound, widest: float) -> Panels:
    """Panels of the turn with edges at the corners of motion, force and speed, and where the follower turns back."""
    program, end = task.program, float(task.program.starts[-1])
    breaks = [] if loads.force.phi is None else np.mod(loads.force.phi, end).tolist()
    breaks += [angle for part in task.backward for angle in (part.begin, part.end)]
    breaks += [] if task.turning is None else task.turning.edges.tolist()
    first = panels(0.0, end, [*program.panels.edges.tolist(), *breaks], widest)

    def inverse(phi: Values) -> Values:
        force = pressing(loads, spring, at_angles(task, loads, phi))
        return (1 / np.maximum(force, LEAST * largest))[None]

    largest = float(np.max(pressing(loads, spring, at_angles(task, loads, first.x.ravel()))))
    return first if largest <= 0 else resolved(inverse, first, TOLERANCE)[0]
