"""The fact of the room between a turning cam and the pivot of its rocker, of profile and synthesis."""

from __future__ import annotations

from math import degrees

from tmmcalc.cams.pivot import NEAR, PivotRoom
from tmmcalc.core.quantity import keyed
from tmmcalc.report.document import Fact
from tmmcalc.report.numbers import angle
from tmmcalc.report.sizes import quantity


def pivot_fact(room: PivotRoom) -> Fact:
    """Clearance, and the largest radius of the cam."""
    left, to = room.clearance, "surface" if room.pivot else "centre"
    some = quantity(left, "m") if left > NEAR * room.limit else "nothing"  # rounding is none
    said = f"swept over, {quantity(-left, 'm')} deep" if room.swept else f"{some} left to its {to}"
    said = f"beside the disc, which reaches {quantity(-left, 'm')} beyond its {to}" if room.passed else said
    what = "second wall" if room.beside else "cam"
    text = f"{said}\n(the {what} reaches {quantity(room.radius, 'm')} at phi = {angle(degrees(room.phi))} deg)"
    return Fact("rocker's pivot", text, keyed(room, "clearance", "pivot", "radius", "phi[deg]"))
