"""The diameter of the roller is taken for its radius."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import SOMETIMES, Document, Mistake, Tables
from tmmcalc.spec.altered import bare


def _tables(document: Document, part: str) -> Tables:
    cam = deepcopy(document.get("cam", {}))
    radius = bare(cam.get("roller_radius"))
    return {"cam": {**cam, "roller_radius": 2 * radius}} if radius else {}


MISTAKE = Mistake(
    "the diameter of the roller is taken for its radius",
    "Is the radius of the roller given or its diameter?",
    SOMETIMES,
    tables=_tables,
)
