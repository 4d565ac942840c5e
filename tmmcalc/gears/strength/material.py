"""What a wheel is made of and how it is loaded: the arguments of the tables D.4.3 to D.4.7.

Hardness is told as drawings write it: a number and its scale, Brinell, Rockwell C or Vickers.
"""

from __future__ import annotations

import math
import re

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record

TREATMENTS = (
    "annealed",
    "normalised",
    "improved",
    "through-hardened",
    "surface-hardened",  # induction hardening, the fillet stays soft
    "fillet-hardened",  # induction hardening with the fillet
    "carburised",
    "nitrocarburised",
    "nitrided",
)
HOMOGENEOUS = TREATMENTS[:4]
STRUCTURES = ("homogeneous", "surface-strengthened")
FAILURES = ("ordinary", "severe")
BLANKS = ("forging", "rolled", "casting")
WEARS = ("none", "abrasive")
LOADS = ("one-sided", "two-sided")

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


@record
class Material:
    """The steel of a wheel and its service; raises `UsageError` for a word or number that the tables do not have."""

    treatment: str  # one of TREATMENTS
    hardness: Hardness  # of the tooth surface
    steel: str = ""  # designation; may be left out where `row` or `bending_limit` is given
    core: Hardness | None = None  # of the tooth's core, for nitrided wheels [HRC]
    protected: bool = False  # measures against decarburisation of the surface: the higher of two limits of D.4.3
    structure: str | None = None  # one of STRUCTURES; None: that of the treatment
    failure: str = "ordinary"  # consequences of a failure, one of FAILURES
    blank: str = "forging"  # one of BLANKS
    wear: str = "none"  # one of WEARS
    load: str | None = None  # one of LOADS; None: two-sided for planets of a planetary train, else one-sided
    row: str | None = None  # of D.4.3, for a steel similar to those that it names
    contact_limit: float | None = None  # sigma_Hlim in place of D.4.4 [Pa]
    bending_limit: float | None = None  # sigma_Flim^0 in place of D.4.3 [Pa]

    def __post_init__(self) -> None:
        """Refuse words that no table has, and limits that are not positive."""
        words = (
            ("treatment", TREATMENTS),
            ("structure", (*STRUCTURES, None)),
            ("failure", FAILURES),
            ("blank", BLANKS),
            ("wear", WEARS),
            ("load", (*LOADS, None)),
        )
        for field, known in words:
            value = getattr(self, field)
            if value not in known:
                said = ", ".join(word for word in known if word is not None)
                raise UsageError(f"{field} {value!r} is not known", where="material", remedy=f"{field}: {said}")
        for field in ("contact_limit", "bending_limit"):
            value = getattr(self, field)
            if value is not None and not 0 < value < math.inf:
                raise UsageError(
                    f"{field} is {value:g} Pa; it is positive", where="material", value=value, remedy="give it in Pa"
                )

    @property
    def built(self) -> str:
        """Structure of the tooth: as given, or that of the treatment."""
        return self.structure or STRUCTURES[self.treatment not in HOMOGENEOUS]
