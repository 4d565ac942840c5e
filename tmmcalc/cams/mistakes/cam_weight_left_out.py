"""The weight of the follower is left out."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import SOMETIMES, Document, Mistake, Tables
from tmmcalc.spec.altered import bare


def _tables(document: Document, part: str) -> Tables:
    cam = deepcopy(document.get("cam", {}))
    loads = cam.get("loads", {})
    return {"cam": {**cam, "loads": {**loads, "gravity": 0}}} if bare(loads.get("gravity")) else {}


MISTAKE = Mistake(
    "the weight of the follower is left out",
    "Are all forces on the follower there?",
    SOMETIMES,
    tables=_tables,
)
