"""Units as people write them: of any language and spelling, told by the dimension that is asked for."""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction

from tmmcalc.core.notes import Phrase
from tmmcalc.spec.cyrillic import latin_units
from tmmcalc.spec.dimensions import DIMENSIONS, UNITS
from tmmcalc.spec.phrases import show
from tmmcalc.spec.units import conversion, kind_of, unit_of

LONGEST = 30  # characters of a unit
PERCENT = "%"
_NONE = frozenset({"", "-", "—", "–", "1", "none", "б/р", "безрозм", "безрозмірна", "dimensionless"})
_WORDS = {
    "градус": "deg",
    "градуси": "deg",
    "градусів": "deg",
    "градуса": "deg",
    "degree": "deg",
    "degrees": "deg",
    "radian": "rad",
    "radians": "rad",
    "радіан": "rad",
    "радіани": "rad",
    "радіанів": "rad",
    "revs": "rev",
    "r": "rev",
    "оберт": "rev",
    "обертів": "rev",
    "секунд": "s",
    "sec": "s",
    "c": "s",  # of a Latin keyboard
    "nm": "N*m",
    "Nm": "N*m",
    "kNm": "kN*m",
    "Nmm": "N*mm",
    "гр": "deg",
    "мин": "min",
}


_TWINS = str.maketrans("aceikmopxyABCEHIKMOPTX", "асеікморхуАВСЕНІКМОРТХ")


class UnitOfAnswerError(ValueError):
    """A unit that is not known, or of another dimension; the text says so."""


def factor_to(written: str, asked: str) -> float:
    """What a number in the written unit is multiplied by to be in the asked one, which may be empty.

    Raises `UnitOfAnswerError`.

    >>> factor_to("с⁻¹", "rad/s"), factor_to("см", "mm"), factor_to("%", "")
    (1.0, 10.0, 0.01)
    """
    bare = written.strip().strip("[]()").strip()
    dimension = kind_of(asked)
    if bare.casefold() in _NONE or bare == asked:
        return 1.0
    if dimension is None:
        return _plain(bare)
    for spelled in _spellings(bare):
        if spelled in UNITS[dimension]:
            return conversion(spelled, asked)
    if is_unit(bare):
        noun = DIMENSIONS[dimension].noun
        raise UnitOfAnswerError(Phrase("{unit} is no unit of {quantity}", unit=show(bare), quantity=noun))
    raise UnitOfAnswerError(Phrase("{unit} is no unit that is known", unit=show(bare)))


def is_unit(text: str) -> bool:
    """Whether a text is a unit of any dimension, or says that there is none."""
    bare = text.strip().strip("[]()").strip()
    return bool(bare) and (bare in _NONE or bare == PERCENT or any(kind_of(each) for each in _spellings(bare)))


def is_none(text: str) -> bool:
    """Whether a text says that there is no unit."""
    return text.strip().strip("[]()").strip().casefold() in _NONE


def fits(written: str, asked: str) -> bool:
    """Whether a number in the written unit can be told in the asked one."""
    try:
        factor_to(written, asked)
    except UnitOfAnswerError:
        return False
    return True


def _plain(bare: str) -> float:
    """Of an answer that has no unit: per cent count, other units are a fault, other words say nothing."""
    if bare == PERCENT:
        return 0.01
    if any(kind_of(each) for each in _spellings(bare)) and unit_of(f"1 {bare}") not in ("rad", "1/s"):
        raise UnitOfAnswerError(Phrase("{unit}: this answer has no unit", unit=show(bare)))
    return 1.0


def _spellings(text: str) -> Iterator[str]:
    """What the unit may be in the table, the likeliest first."""
    if len(text) > LONGEST:
        return
    dotted = re.sub(r"\.(?=\s*(/|$))", "", text)  # об./хв.
    powered = re.sub(r"(?<=[^\W\d_])(-?\d)", r"^\1", re.sub(r"(?<=[^\W\d_])[.](?=[^\W\d_])", "·", dotted))
    for each in (dotted, powered):
        words = re.sub(r"[^\W\d_]+", lambda found: _WORDS.get(found[0], found[0]), each)
        joined = re.sub(r"(?<=[^\W\d_])\s+(?=[^\W\d_])", "·", words)
        # Latin letters for Cyrillic ones that look the same come last: H of a keyboard is newton, as is the one of kH
        for latin in (latin_units(joined), latin_units(joined.translate(_TWINS))):
            if unit := unit_of(f"1 {latin}"):
                yield unit
            yield from (unit for unit in _FOLDED.get(re.sub(r"\s", "", latin).casefold(), ()))


def _folded() -> dict[str, tuple[str, ...]]:
    """Units by their spelling in small letters, in which MW is mW too: those of one sense alone."""
    found: dict[str, tuple[str, ...]] = {}
    for units in UNITS.values():
        for unit in units:
            found[unit.casefold()] = (*found.get(unit.casefold(), ()), unit)
    return found


_FOLDED = _folded()


def in_unit(number: Fraction, factor: float) -> float:
    """A written number times the factor of its unit, rounded once where the factor is a ratio of powers of ten."""
    ratio = Fraction(factor).limit_denominator(10**12)
    return float(number * ratio) if abs(float(ratio) - factor) <= 1e-15 * factor else float(number) * factor
