"""The fact of the room between a turning cam and the pivot of its rocker, of profile and synthesis."""

from __future__ import annotations

from math import degrees

from tmmcalc.cams.pivot import PivotRoom
from tmmcalc.report.document import Fact
from tmmcalc.report.gearsizes import quantity
from tmmcalc.report.numbers import angle


def pivot_fact(room: PivotRoom) -> Fact:
    """Clearance, and the largest radius of the cam."""
    left, to = room.clearance, "surface" if room.pivot else "centre"
    said = f"{quantity(left, 'm')} left to its {to}" if left > 0 else f"swept over, {quantity(-left, 'm')} deep"
    text = f"{said}\n(the cam reaches {quantity(room.radius, 'm')} at phi = {angle(degrees(room.phi))} deg)"
    values = {
        "pivot_clearance[m]": left,
        "pivot_radius[m]": room.pivot,
        "r_max[m]": room.radius,
        "r_max_at_phi[deg]": degrees(room.phi),
    }
    return Fact("rocker's pivot", text, values)
