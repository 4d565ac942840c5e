"""What a wheel is made of and how it is loaded: the arguments of the tables D.4.3 to D.4.7."""

from __future__ import annotations

import math

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.strength.hardness import Hardness

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
