"""The cam turns the other way (textbook 5.3)."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables


def _tables(document: Document, part: str) -> Tables:
    cam = deepcopy(document.get("cam", {}))
    other = {"clockwise": "counter-clockwise", "counter-clockwise": "clockwise"}
    return {"cam": {**cam, "rotation": other[cam.get("rotation", "clockwise")]}} if cam else {}


MISTAKE = Mistake(
    "the cam turns the other way",
    "Look at the arrow at the cam: which way does it turn?",
    OFTEN,
    tables=_tables,
)
