"""The useful resistance acts on the idle stroke too."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables


def _tables(document: Document, part: str) -> Tables:
    loads = deepcopy(document.get("loads", []))
    windowed = [load for load in loads if "stroke" in load]
    for load in windowed:
        del load["stroke"]
        load.pop("output", None)
    return {"loads": loads} if windowed else {}


MISTAKE = Mistake(
    "the useful resistance acts on the idle stroke too",
    "On which stroke does the useful resistance act, and is this position on it?",
    OFTEN,
    tables=_tables,
)
