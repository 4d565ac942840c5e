"""The offset of the follower is left out."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables
from tmmcalc.spec.altered import bare


def _tables(document: Document, part: str) -> Tables:
    cam = deepcopy(document.get("cam", {}))
    return {"cam": {**cam, "offset": 0}} if bare(cam.get("offset")) else {}


MISTAKE = Mistake(
    "the offset of the follower is left out",
    "Does the line of the follower go through the axis of the cam?",
    OFTEN,
    tables=_tables,
)
