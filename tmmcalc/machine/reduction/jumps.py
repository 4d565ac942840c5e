"""In which positions of a reduction something jumps."""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.machine.nodes import NEAR, at_speed, nodal_tables, on_edges
from tmmcalc.machine.reduction.results import Reduction


def jumps(result: Reduction, *, loads: bool) -> list[int]:
    """Rows of the positions in which the moments of the ``loads`` jump, or those of friction."""
    wanted = [k for k, each in enumerate(result.contributions) if each.kind == ("load" if loads else "friction")]
    if not wanted:
        return []
    panels, parts = result.cycle.panels, result.parts[wanted]
    theta = on_edges(result.cycle, np.abs(result.phi - result.phi[0]))
    after, before = panels.at(parts, theta), panels.at(parts, theta, before=True)
    after[:, -1], before[:, 0] = after[:, 0], before[:, -1]  # the end of a cycle is its beginning
    apart = np.abs(after - before) > NEAR * np.max(np.abs(parts), axis=(1, 2), initial=0.0)[:, None]
    return np.flatnonzero(apart.any(axis=0)).tolist()


def nodal_jumps(result: Reduction, speed: float) -> list[int]:
    """Rows in which the textbook's methods, to which the larger load counts at a jump, take another moment."""
    taken = nodal_tables(result.cycle, len(result.phi) - 1, speed)[0]
    own = math.copysign(1.0, result.phi[-1]) * result.total
    size = float(np.max(np.abs(at_speed(result.cycle, speed))))
    return np.flatnonzero(np.abs(taken - own) > NEAR * size).tolist()
