"""The given moment of inertia is taken as one about the pin, and m s^2 is taken away."""

from __future__ import annotations

from typing import Any

from tmmcalc.core.mistake import SELDOM, Document, Mistake, Tables
from tmmcalc.linkage.tables.altered import mechanism_with
from tmmcalc.spec.altered import bare


def _tables(document: Document, part: str) -> Tables:
    def shifted(mechanism: dict[str, Any]) -> bool:
        found = False
        for link in mechanism["links"]:
            mass, center = bare(link.get("mass")), link.get("center")
            if mass and link.get("inertia") and isinstance(center, list):
                x, y = (bare(each) or 0.0 for each in center)
                left = (bare(link["inertia"]) or 0.0) - mass * (x * x + y * y)
                if left < 0:  # whoever finds that sees that it is wrong
                    return False
                link["inertia"] = left
                found = True
        return found

    return mechanism_with(document, shifted)


MISTAKE = Mistake(
    "m s^2 is taken away from the given moment of inertia, which is about the centre of mass already",
    "About which point is the moment of inertia given?",
    SELDOM,
    tables=_tables,
)
