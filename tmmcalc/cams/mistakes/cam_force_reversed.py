"""The working force acts on the follower in the wrong sense."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import SOMETIMES, Document, Mistake, Tables
from tmmcalc.spec.altered import bare


def _tables(document: Document, part: str) -> Tables:
    cam = deepcopy(document.get("cam", {}))
    loads = cam.get("loads", {})
    force = bare(loads.get("force"))
    return {"cam": {**cam, "loads": {**loads, "force": -force}}} if force else {}


MISTAKE = Mistake(
    "the working force acts on the follower in the wrong sense",
    "Does the working force press the follower on the cam, or lift it?",
    SOMETIMES,
    tables=_tables,
)
