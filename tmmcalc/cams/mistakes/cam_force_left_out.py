"""The working force on the follower is left out."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import SOMETIMES, Document, Mistake, Tables
from tmmcalc.spec.altered import bare


def _tables(document: Document, part: str) -> Tables:
    cam = deepcopy(document.get("cam", {}))
    loads = cam.get("loads", {})
    return {"cam": {**cam, "loads": {**loads, "force": 0}}} if bare(loads.get("force")) else {}


MISTAKE = Mistake(
    "the working force on the follower is left out",
    "Are all forces on the follower there?",
    SOMETIMES,
    tables=_tables,
)
