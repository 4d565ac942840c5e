"""Friction of the follower in its guide is left out."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables
from tmmcalc.spec.altered import bare


def _tables(document: Document, part: str) -> Tables:
    cam = deepcopy(document.get("cam", {}))
    loads = cam.get("loads", {})
    return {"cam": {**cam, "loads": {**loads, "friction": 0}}} if bare(loads.get("friction")) else {}


MISTAKE = Mistake(
    "friction of the follower in its guide is left out",
    "Where does the follower rub?",
    OFTEN,
    tables=_tables,
)
