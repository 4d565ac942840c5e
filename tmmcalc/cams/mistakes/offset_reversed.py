"""The offset of the follower is on the other side of the axis (textbook 5.3)."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables
from tmmcalc.spec.altered import bare


def _tables(document: Document, part: str) -> Tables:
    cam = deepcopy(document.get("cam", {}))
    offset = bare(cam.get("offset"))
    return {"cam": {**cam, "offset": -offset}} if offset else {}


MISTAKE = Mistake(
    "the offset of the follower is on the other side",
    "On which side of the axis of the cam does the follower move?",
    OFTEN,
    tables=_tables,
)
