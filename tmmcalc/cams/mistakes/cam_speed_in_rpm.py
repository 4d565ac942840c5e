"""The number of revolutions a minute of the cam is taken for radians a second."""

from __future__ import annotations

from copy import deepcopy
from math import pi

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables
from tmmcalc.spec.altered import bare
from tmmcalc.spec.units import unit_of


def _tables(document: Document, part: str) -> Tables:
    cam = deepcopy(document.get("cam", {}))
    speed = bare(cam.get("speed"))
    return {"cam": {**cam, "speed": speed * 30 / pi}} if speed and unit_of(cam["speed"]) == "rpm" else {}


MISTAKE = Mistake(
    "the speed of the cam in rpm is taken for rad/s",
    "Look at the unit of the speed of the cam before you put it into a formula.",
    OFTEN,
    tables=_tables,
)
