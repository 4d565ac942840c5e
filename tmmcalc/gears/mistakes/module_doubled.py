"""The module is doubled: the radius is m z in place of m z/2."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables
from tmmcalc.spec.altered import bare


def _tables(document: Document, part: str) -> Tables:
    pair = deepcopy(document.get("pair", {}))
    module = bare(pair.get("module"))
    return {"pair": {**pair, "module": 2 * module}} if module else {}


MISTAKE = Mistake(
    "the module is doubled: m z is taken for the radius",
    "What has m z for its size, the radius or the diameter?",
    OFTEN,
    tables=_tables,
)
