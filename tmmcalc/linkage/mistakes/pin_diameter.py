"""The diameter of the pins is taken for their radius in the moment of friction."""

from __future__ import annotations

from typing import Any

from tmmcalc.core.mistake import SOMETIMES, Document, Mistake, Tables
from tmmcalc.linkage.tables.altered import mechanism_with
from tmmcalc.spec.altered import changed


def _tables(document: Document, part: str) -> Tables:
    def doubled(mechanism: dict[str, Any]) -> bool:
        rubbing = [each for each in mechanism["joints"] if each.get("friction") and each.get("radius")]
        for each in rubbing:
            each["radius"] = changed(each["radius"], lambda radius: 2 * radius)
        return bool(rubbing)

    return mechanism_with(document, doubled)


MISTAKE = Mistake(
    "the diameter of the pins is taken for their radius in the friction",
    "Look at the radius of the circle of friction: what of the pin does it need?",
    SOMETIMES,
    tables=_tables,
)
