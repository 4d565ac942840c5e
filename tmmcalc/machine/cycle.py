"""The machine as one rotating mass: reduced moment and reduced inertia over one cycle of the input shaft.

``theta`` is the angle of the input shaft counted from position 0 along its motion, from 0 to ``period``; the speed
omega = dtheta/dt is positive, and a positive moment drives. All functions are held on the points of panels (K, N).
"""

from __future__ import annotations

import math
from functools import cached_property

from tmmcalc.core.numerics.panels import Panels, Values
from tmmcalc.core.records import record


@record
class Cycle:
    """Reduced quantities of one cycle, without motor and constant inertia.

    The moment at the speed omega is ``moment + viscous omega + quadratic omega^2`` (textbook 3.34); the kinetic
    energy is (constant + ``inertia``) omega^2 / 2 (3.39).
    """

    panels: Panels  # of [0, period]
    inertia: Values  # J(theta) of the links [kg*m^2], (K, N), not negative
    slope: Values  # dJ/dtheta [kg*m^2/rad], (K, N)
    moment: Values  # M(theta) [N*m], (K, N): loads, weights, springs, friction
    viscous: Values  # [N*m*s/rad], (K, N), zero where nothing is viscous
    quadratic: Values  # [N*m*s^2/rad^2], (K, N)
    speed: float  # mean speed asked for, > 0 [rad/s]
    error: float = 0.0  # estimated relative error of the functions [-]
    balancing: float = 0.0  # constant part of ``moment`` that was added to close the work of a cycle [N*m]

    @property
    def period(self) -> float:
        """Angle of one cycle [rad]: 2 pi, of a four-stroke engine 4 pi."""
        return float(self.panels.edges[-1] - self.panels.edges[0])

    @cached_property
    def finer(self) -> list[Cycle]:
        """The same on further panels, at most once: on those that were asked for last, which many motions share."""
        return []


def place(theta: float, sense: float) -> str:
    """An angle of the cycle as messages tell it: the coordinate of the input from position 0.

    >>> place(math.pi / 2, -1.0)
    '-90 deg'
    """
    return f"{round(math.degrees(sense * theta), 9) + 0.0:.6g} deg"  # a billionth of a degree is rounding
