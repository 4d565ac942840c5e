"""The inertia of the follower is left out; its weight is there, as a force."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import SOMETIMES, Document, Mistake, Tables
from tmmcalc.spec.altered import bare

FORCES = ("force", "force_return")


def _tables(document: Document, part: str) -> Tables:
    cam = deepcopy(document.get("cam", {}))
    loads = cam.get("loads", {})
    mass = bare(loads.get("mass"))
    if not mass or "force_table" in loads:
        return {}
    weight = mass * (bare(loads.get("gravity")) or 0.0)
    forces = {key: (bare(loads.get(key)) or 0.0) + weight for key in FORCES}
    others = {key: value for key, value in loads.items() if key not in ("mass", "gravity")}
    return {"cam": {**cam, "loads": {**others, **forces}}}


MISTAKE = Mistake(
    "the inertia of the follower is left out",
    "The follower is accelerated: what does that add to the forces on it?",
    SOMETIMES,
    tables=_tables,
)
