"""The unevenness that is read off is that of half the range."""

from __future__ import annotations

from math import nan

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.naming.language import parse


def _reads(asked: Asked) -> float:
    name = parse(asked.name)
    return asked.value / 2 if name.what.startswith("delta") and name.stage in ("motion", "flywheel") else nan


MISTAKE = Mistake(
    "the unevenness is that of half the range of speeds",
    "Between which two speeds is the unevenness counted?",
    SOMETIMES,
    reads=_reads,
)
