"""Where on the turn the search looks: Gauss points and ends of panels in which motion and 1/P are smooth.

P, the force that presses the follower on the cam, does not depend on the sizes. Where it is small, 1/P and with it the
slip function has a sharp peak, for which the panels are halved.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.forces.formulas import resultant
from tmmcalc.cams.forces.results import SpringFound
from tmmcalc.cams.forces.turn import Points, at_angles
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.optimum.peaks import ended
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

    In a dwell in which nothing varies one panel stands for it.
    """
    program, force = task.program, loads.force
    on = _panels(task, loads, spring, widest)
    middle = (on.edges[:-1] + on.edges[1:]) / 2
    piece = np.clip(np.searchsorted(program.edges, middle) - 1, 0, len(program.edges) - 2)
    phase = program.places[0][piece]
    kinds = np.array([each.kind for each in program.phases])[phase]
    moves = (kinds == "rise") | (kinds == "return")
    first = np.append(True, phase[1:] != phase[:-1])
    varies = force.phi is not None or task.turning is not None
    rows = np.flatnonzero(kinds == "rise" if rise else moves | first | varies)
    points = ended(on.order).points
    phi = on.edges[rows, None] + on.width[rows, None] * points
    phi[:, -1] = on.edges[rows + 1]
    return phi.ravel(), np.repeat(piece[rows], len(points))


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
