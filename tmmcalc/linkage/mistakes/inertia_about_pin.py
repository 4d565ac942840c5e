"""The moment of inertia is taken about the origin of the axes of the link: I + m s^2 (digest 08, section 3)."""

from __future__ import annotations

from typing import Any

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables
from tmmcalc.linkage.tables.altered import mechanism_with
from tmmcalc.spec.altered import bare


def _tables(document: Document, part: str) -> Tables:
    def shifted(mechanism: dict[str, Any]) -> bool:
        found = False
        for link in mechanism["links"]:
            mass, center = bare(link.get("mass")), link.get("center")
            if mass and link.get("inertia") and isinstance(center, list):
                x, y = (bare(each) or 0.0 for each in center)
                link["inertia"] = (bare(link["inertia"]) or 0.0) + mass * (x * x + y * y)
                found = True
        return found

    return mechanism_with(document, shifted)


MISTAKE = Mistake(
    "the moment of inertia is taken about the pin of the link, as if it were given about the centre of "
    "mass (I + m s^2)",
    "About which point is the moment of inertia given, and about which one does your equation need it?",
    OFTEN,
    tables=_tables,
)
