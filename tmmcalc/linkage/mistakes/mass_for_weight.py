"""The mass in kilograms is taken for the weight in newtons."""

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
        mechanism["gravity"] = 1.0
        return True

    return mechanism_with(document, changed)


MISTAKE = Mistake(
    "the number of the mass is taken for the weight, in newtons",
    "Mass and weight of a link have different units: look at how one follows from the other.",
    SOMETIMES,
    tables=_tables,
)
