"""A cycle at the nodes of equal steps, for the textbook's methods: moment, inertia, work by the trapezoid rule."""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.machine.cycle import Cycle

NEAR = 1e-9  # of the period: an angle so near to the edge of a panel, where a load may jump, lies on it
LEVEL = 1e-9  # of the largest load: a smaller difference is no jump


def nodal_tables(cycle: Cycle, n: int, speed: float) -> tuple[Values, Values]:
    """Moment [N*m] at the ``speed`` [rad/s] and inertia [kg*m^2] of a cycle, (n + 1,) each, at ``n`` equal steps.

    Where the load jumps at a node the larger load counts, as the textbook counts it at both ends of its action.
    """
    theta = np.linspace(0.0, cycle.period, n + 1)
    (after, inertia), (before, _) = both_sides(cycle, np.stack((at_speed(cycle, speed), cycle.inertia)), theta)
    return np.where(np.abs(after) >= np.abs(before), after, before), inertia


def both_sides(cycle: Cycle, values: Values, theta: Values) -> tuple[Values, Values]:
    """Functions (..., K, N) just after and just before the angles (n,), which differ where they jump.

    Before the beginning of the cycle is its end, and after its end the beginning.
    """
    panels, at = cycle.panels, on_edges(cycle.panels.edges, theta, NEAR * cycle.period)
    begin, end = panels.edges[[0, -1]]
    after = panels.at(values, np.where(at == end, begin, at))
    return after, panels.at(values, np.where(at == begin, end, at), before=True)


def on_edges(edges: Values, theta: Values, near: float) -> Values:
    """The angles (n,), those that are on an edge but for rounding, so ``near``, exactly there."""
    nearest = edges[np.minimum(np.searchsorted(edges, theta - near), len(edges) - 1)]
    return np.where(np.abs(nearest - theta) <= near, nearest, theta)


def at_speed(cycle: Cycle, speed: float) -> Values:
    """The moment (K, N) of a cycle at a constant speed [rad/s]."""
    return cycle.moment + (cycle.viscous + cycle.quadratic * speed) * speed


def nodal_work(moment: Values, period: float = 2 * math.pi) -> tuple[Values, float]:
    """Work A (n + 1,) by the trapezoid rule of the nodal ``moment`` (n + 1,) [N*m], and the drive that closes it.

    The constant driving moment that makes the work of the cycle zero (3.45) is added to the moments first (3.47).
    """
    moment = np.asarray(moment, float)
    step = period / (len(moment) - 1)
    done = np.append(0.0, np.cumsum((moment[1:] + moment[:-1]) / 2 * step))
    drive = -float(done[-1]) / period
    return done + drive * step * np.arange(len(moment)), drive
