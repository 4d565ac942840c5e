"""The unevenness is taken as that of half the range: (omega_max - omega_mean)/omega_mean."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import SOMETIMES, Document, Mistake, Tables
from tmmcalc.spec.altered import bare


def _tables(document: Document, part: str) -> Tables:
    flywheel = deepcopy(document.get("flywheel", {}))
    delta = bare(flywheel.get("delta"))
    return {"flywheel": {**flywheel, "delta": 2 * delta}} if delta else {}


MISTAKE = Mistake(
    "the allowed unevenness is taken for half of the range of speeds",
    "Between which two speeds is the unevenness counted?",
    SOMETIMES,
    tables=_tables,
)
