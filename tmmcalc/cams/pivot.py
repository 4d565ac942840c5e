"""Whether a cam passes the pivot of its rocker: it turns about O, the pivot A stands at l0 and has a radius.

    r_max = |OC|_max - r2 <= l0 - r_A,     |OC|^2 = l0^2 + l2^2 - 2 l0 l2 cos psi

|OC| grows with psi: the largest radius of the working profile is that of the highest rocker. The second wall of a
groove reaches |OC|_max + r2; its roller goes into the disc from the side, so that the rocker is beside the disc, and
where the groove reaches beyond its pivot the pivot has to be there as well.
"""

from __future__ import annotations

from math import cos, degrees, hypot, sin

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.program import SAME, Program
from tmmcalc.cams.task import CamTask
from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record

NEAR = 1e-12  # of l0: so little beyond the pivot is rounding


@record
class PivotRoom:
    """What is left between the turning cam and the pivot of its rocker."""

    radius: float = quantity("r_max[m]", "largest radius of the working profile, of a groove that of its second wall")
    phi: float = quantity("r_max_at_phi[rad]", "angle of the cam where its largest radius meets the pivot")
    limit: float  # l0 - r_A [m]
    pivot: float = quantity("pivot_radius[m]", "radius of the rocker's pivot; 0: not known", symbol="r_A")
    beside: bool = False  # a groove: the rocker is beside its disc, which may reach beyond the pivot

    @derived("pivot_clearance[m]", "clearance of cam and pivot; negative: the cam sweeps over it")
    def clearance(self) -> float:
        """What the largest radius leaves of its limit."""
        return self.limit - self.radius

    @property
    def swept(self) -> bool:
        """Whether the cam sweeps over the pivot by more than rounding."""
        return not self.beside and self._reached

    @property
    def passed(self) -> bool:
        """Whether the disc of a groove reaches beyond the pivot, which then is beside it."""
        return self.beside and self._reached

    @property
    def _reached(self) -> bool:
        return self.clearance < -NEAR * (self.limit + self.pivot)


def highest(program: Program) -> tuple[float, float]:
    """The largest y over the turn and the first angle at which it is reached.

    >>> from tmmcalc.cams.program import Phase
    >>> highest(Program((Phase("low dwell", 6.28, 0.0, 0.0),)))
    (0.0, 0.0)
    """
    on = program.panels
    at, value = program.turned
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
    groove = task.asked.closure == "groove"
    reach = top + follower.roller if groove else top - follower.roller
    return PivotRoom(reach, phi, follower.centres - pivot, pivot, groove)


def pivot_fault(room: PivotRoom) -> str:
    """What is wrong where the cam sweeps over the pivot, or what its disc asks of it."""
    text = "the cam sweeps over the rocker's pivot: it reaches {radius:.6g} mm from its axis at phi = {phi:.6g} deg"
    if room.passed:
        text = (
            "the second wall reaches beyond the rocker's pivot: it reaches {radius:.6g} mm from its axis at "
            "phi = {phi:.6g} deg"
        )
    reaches = Phrase(text, radius=1e3 * room.radius, phi=degrees(room.phi))
    values = {"reaches": reaches, "limit": 1e3 * (room.limit + room.pivot), "pivot": 1e3 * room.pivot}
    said = Phrase("{reaches}, the pivot stands {limit:.6g} mm from it", **values)
    if room.pivot:
        said = Phrase("{reaches}, the pivot stands {limit:.6g} mm from it less its radius of {pivot:.6g} mm", **values)
    if room.passed:
        return Phrase("{said}: the pivot has to be beside the disc, in the plane of the rocker", said=said)
    return said
