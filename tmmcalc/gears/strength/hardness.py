"""Hardness of a steel as drawings write it: a number and its scale, Brinell, Rockwell C or Vickers."""

from __future__ import annotations

import re

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record

SCALES = {"HB": (80.0, 650.0), "HRC": (10.0, 70.0), "HV": (80.0, 1200.0)}  # and what can be measured with each
SOFT = {"HB": 350.0, "HRC": 38.0, "HV": 370.0}  # HB 350 and what it is on the other scales

_NUMBER = r"(?P<number>\d+(?:\.\d+)?)"
_SCALE = r"(?P<scale>HB|HRC|HV)[A-Z]?"
_FORMS = (rf"{_NUMBER}\s*{_SCALE}", rf"{_SCALE}\s*{_NUMBER}")
_REMEDY = 'write "300 HB", "52 HRC" or "750 HV"'


@record
class Hardness:
    """A measured hardness; raises `UsageError` for one that its scale does not have."""

    value: float
    scale: str  # HB, HRC or HV

    def __post_init__(self) -> None:
        """Refuse a scale that the tables do not know and a number that it does not have."""
        if self.scale not in SCALES:
            raise UsageError(f"there is no scale of hardness {self.scale!r}", where="hardness", remedy=_REMEDY)
        low, high = SCALES[self.scale]
        if not low <= self.value <= high:
            raise UsageError(
                f"a hardness of {self.value:g} {self.scale} cannot be: {self.scale} goes from {low:g} to {high:g}",
                where="hardness",
                value=self.value,
                limit=low if self.value < low else high,
                remedy=_REMEDY,
            )

    def __str__(self) -> str:
        return f"{self.value:g} {self.scale}"

    @property
    def soft(self) -> bool:
        """Whether it is at most HB 350."""
        return self.value <= SOFT[self.scale]


def parse_hardness(text: str) -> Hardness:
    """The hardness that a text writes; raises `UsageError` if it writes none.

    >>> str(parse_hardness("HRC 52"))
    '52 HRC'
    """
    for form in _FORMS:
        match = re.fullmatch(form, text.strip().upper().replace("НВ", "HB"), re.ASCII)
        if match:
            return Hardness(float(match["number"]), match["scale"])
    raise UsageError(f"{text!r} is not a hardness", where="hardness", remedy=_REMEDY)
