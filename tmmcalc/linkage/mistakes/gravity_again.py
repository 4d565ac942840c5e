"""What is a weight already is multiplied by g (g twice)."""

from __future__ import annotations

from typing import Any

from tmmcalc.core.mistake import SOMETIMES, Document, Mistake, Tables
from tmmcalc.linkage.tables.altered import mechanism_with
from tmmcalc.spec.altered import bare


def _tables(document: Document, part: str) -> Tables:
    def changed(mechanism: dict[str, Any]) -> bool:
        g = bare(mechanism.get("gravity", 9.81))
        if not g or not any(link.get("mass") for link in mechanism["links"]):
            return False
        mechanism["gravity"] = g * g
        return True

    return mechanism_with(document, changed)


MISTAKE = Mistake(
    "the weight is multiplied by g once more",
    "Mass and weight of a link have different units: which of them is given?",
    SOMETIMES,
    tables=_tables,
)
