"""A larger cam where the pressure angle alone would leave it too small for its roller or its shaft.

    rho2 >= r2 + r_m         the profile keeps a radius that can be made
    rho1 >= r2 + r_m         so does the second wall of a groove, in the concave parts of the pitch curve
    R0 >= r1 + r2            the roller clears the shaft

and, where concave parts are not allowed, no curvature below zero. A roller that is to be chosen needs at least a
millimetre of it, and beside the shaft the 0.4 R0 of the rule of practice.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.synthesis.roller import NEAR, OF_BASE, STEP, bends
from tmmcalc.cams.task import CamTask
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.roots import bracketed

DOUBLINGS = 40


def enlarged(task: CamTask, place: Callable[[float], Follower], first: float = 1.0) -> tuple[Follower, str]:
    """The first follower of the family ``place(x)``, x >= 0, that leaves room, and what asked for it.

    ``first`` is the first x above zero that is tried. Raises `NoSolutionError` if none does.
    """

    def room(x: float) -> tuple[float, str]:
        return room_of(task, place(x))

    if room(0.0)[0] >= 0:
        return place(0.0), ""
    high = first
    for _ in range(DOUBLINGS):
        if room(high)[0] >= 0:
            break
        high *= 2
    else:
        raise NoSolutionError(
            "no size of the cam within the limits has room for its roller and its shaft",
            where="cam_synthesis",
            remedy="a smaller roller_radius, shaft_radius or convex_radius, or give rocker_length in place of others",
        )

    def margin(x: Values, which: Indices) -> Values:
        return np.array([room(each)[0] for each in x.tolist()])

    x = float(bracketed(margin, np.zeros(1), np.array([high]))[0])
    return place(x), room(x * (1 - 1e-6))[1]


def has_room(task: CamTask, follower: Follower) -> bool:
    """Whether roller, shaft and radii have room, but for rounding."""
    return room_of(task, follower)[0] >= -NEAR


def room_of(task: CamTask, follower: Follower) -> tuple[float, str]:
    """How much there is beyond what is needed, in parts of it, and the name of what is scarcest."""
    r2 = STEP if task.asked.roller is None else task.asked.roller
    shaft, least = task.limits.shaft, r2 + task.limits.convex
    beside = shaft / (1 - OF_BASE) if task.asked.roller is None else shaft + r2
    found = []
    if shaft > 0:
        found.append((follower.base / beside - 1, "shaft"))
    low, high = bends(task, follower)
    if least > 0:
        found.append((1 - least * high.value, "curvature"))
    if least > 0 and task.asked.closure == "groove":
        found.append((1 + least * low.value, "second wall"))
    if not task.limits.allow_concave:
        found.append((follower.base * low.value, "no concave parts"))
    return min(found, default=(0.0, ""))
