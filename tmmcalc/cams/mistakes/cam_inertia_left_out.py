"""The mass of the follower is left out, its inertia and its weight."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import SOMETIMES, Document, Mistake, Tables
from tmmcalc.spec.altered import bare


def _tables(document: Document, part: str) -> Tables:
    cam = deepcopy(document.get("cam", {}))
    loads = cam.get("loads", {})
    return {"cam": {**cam, "loads": {**loads, "mass": 0}}} if bare(loads.get("mass")) else {}


MISTAKE = Mistake(
    "the inertia of the follower is left out",
    "The follower is accelerated: what does that add to the forces on it?",
    SOMETIMES,
    tables=_tables,
)
