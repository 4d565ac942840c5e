"""Whether a cam passes the pivot of its rocker: it turns about O, the pivot A stands at l0 and has a radius.

    r_max = |OC|_max - r2 < l0 - r_A,     |OC|^2 = l0^2 + l2^2 - 2 l0 l2 cos psi

|OC| grows with psi: the largest radius of the working profile is that of the highest rocker.
"""

from __future__ import annotations

from math import cos, degrees, hypot, sin

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.program import SAME, Program
from tmmcalc.cams.task import CamTask
from tmmcalc.records import record


@record
class PivotRoom:
    """What is left between the turning cam and the pivot of its rocker."""

    radius: float  # r_max [m] of the working profile
    phi: float  # [rad] where
    limit: float  # l0 - r_A [m]
    pivot: float  # r_A [m]; 0: not known

    @property
    def clearance(self) -> float:
        """Between cam and pivot [m]; negative: the cam sweeps over it."""
        return self.limit - self.radius


def highest(program: Program) -> tuple[float, float]:
    """The largest y over the turn and the first angle at which it is reached.

    >>> from tmmcalc.cams.program import Phase
    >>> highest(Program((Phase("low dwell", 6.28, 0.0, 0.0),)))
    (0.0, 0.0)
    """
    on = program.panels
    at, value = on.turning(program.sampled[0])
    largest = float(value.max())
    level = at[value >= largest - SAME * max(program.stroke, abs(largest))]
    ends = level[np.isin(level, on.edges)]  # where a law runs out flat its last stationary place is not exact
    return largest, float((ends if ends.size else level).min())


def pivot_room(task: CamTask, follower: Follower) -> PivotRoom | None:
    """The room at the pivot; None unless the follower is a rocker."""
    if follower.kind != "oscillating":
        return None
    y, phi = highest(task.program)
    psi = follower.start + y
    top = hypot(follower.centres - follower.rocker * cos(psi), follower.rocker * sin(psi))
    pivot = 0.0 if task.loads is None else task.loads.pivot_radius
    return PivotRoom(top - follower.roller, phi, follower.centres - pivot, pivot)


def told(room: PivotRoom) -> str:
    """What is wrong where the cam sweeps over the pivot."""
    beside = f" less its radius of {1e3 * room.pivot:.6g} mm" if room.pivot else ""
    return (
        f"the cam sweeps over the rocker's pivot: it reaches {1e3 * room.radius:.6g} mm from its axis at "
        f"phi = {degrees(room.phi):.6g} deg, the pivot stands {1e3 * (room.limit + room.pivot):.6g} mm from it{beside}"
    )
