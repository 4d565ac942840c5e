"""The angles of rise and return are swapped."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import SOMETIMES, Document, Mistake, Tables


def _tables(document: Document, part: str) -> Tables:
    cam = deepcopy(document.get("cam", {}))
    if not cam or cam.get("rise") == cam.get("return_angle"):
        return {}
    return {"cam": {**cam, "rise": cam["return_angle"], "return_angle": cam["rise"]}}


MISTAKE = Mistake(
    "the angles of rise and return are swapped",
    "Which phase comes first, and how long is each?",
    SOMETIMES,
    tables=_tables,
)
