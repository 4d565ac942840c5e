"""The helix angle is left out: the normal module is taken for the transverse one."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import SOMETIMES, Document, Mistake, Tables


def _tables(document: Document, part: str) -> Tables:
    pair = deepcopy(document.get("pair", {}))
    return {"pair": {**pair, "helix_angle": 0}} if pair.get("helix_angle") else {}


MISTAKE = Mistake(
    "the helix angle is left out: the normal module is taken for the transverse one",
    "In which section is the module given, and in which one do you need it?",
    SOMETIMES,
    tables=_tables,
)
