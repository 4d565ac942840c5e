"""Weights are left out of the forces (digest 08, section 3)."""

from __future__ import annotations

from typing import Any

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables
from tmmcalc.linkage.tables.altered import mechanism_with
from tmmcalc.spec.altered import bare


def _tables(document: Document, part: str) -> Tables:
    def changed(mechanism: dict[str, Any]) -> bool:
        g = bare(mechanism.get("gravity", 9.81))
        if not g or not any(link.get("mass") for link in mechanism["links"]):
            return False
        mechanism["gravity"] = 0.0
        return True

    return mechanism_with(document, changed)


MISTAKE = Mistake(
    "the weights of the links are left out",
    "Are all given forces there, on every link that has a mass?",
    OFTEN,
    tables=_tables,
)
