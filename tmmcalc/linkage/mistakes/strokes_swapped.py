"""Working and idle stroke are swapped."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import SOMETIMES, Document, Mistake, Tables

OTHER = {"working": "idle", "idle": "working"}


def _tables(document: Document, part: str) -> Tables:
    loads = deepcopy(document.get("loads", []))
    windowed = [load for load in loads if load.get("stroke") in OTHER]
    for load in windowed:
        load["stroke"] = OTHER[load["stroke"]]
    return {"loads": loads} if windowed else {}


MISTAKE = Mistake(
    "working and idle stroke are swapped: the useful resistance acts on the wrong one",
    "Which of the two strokes is the working one, and is this position on it?",
    SOMETIMES,
    tables=_tables,
)
