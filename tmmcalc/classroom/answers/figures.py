"""A number as a person writes it, with the figures that stand there.

``1 250,5``, ``1.2e3``, ``1,2·10³``, ``−0,05 рад/с`` and ``20° 38′ 15″`` are numbers. A decimal comma is one wherever a
single comma stands. Figures are counted on the text: as a binary float 0.1667·10⁴ would have 1666 before its point.
"""

from __future__ import annotations

import re
from fractions import Fraction

from tmmcalc.core.notes import Phrase
from tmmcalc.core.records import record

LONGEST = 60  # characters of a number with its unit
LARGEST = 60  # of an exponent of ten

_SPACE = "[ \\t\\u00a0\\u2000-\\u200a\\u202f\\u205f]"
_MINUS = re.compile("[\\u2212\\u2010-\\u2015\\ufe63\\uff0d]")
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+")
_MANTISSA = rf"(?P<whole>\d{{1,3}}(?:{_SPACE}\d{{3}})+|\d*)(?P<rest>(?:[.,]\d+)*[.,]?)"
_TIMES = rf"{_SPACE}*[·⋅∙•*×xXхХ]{_SPACE}*10{_SPACE}*"
_POWER = r"(?:(?:\^|\*\*)\s*[({]?(?P<plain>[+-]?\d{1,4})[)}]?|(?P<raised>[⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,4}))"
_NUMBER = re.compile(
    rf"(?P<sign>[+-]?){_SPACE}*(?:{_MANTISSA}(?:[eEеЕ](?P<e>[+-]?\d{{1,4}})|{_TIMES}{_POWER})?){_SPACE}*(?P<unit>.*)",
    re.DOTALL,
)
_UNIT = re.compile(r"[^\W\d_]|[°º%\[(]|1\s*/\s*[^\W\d_]")
_MINUTES = rf"{_SPACE}*(?P<minutes>\d{{1,2}}(?:[.,]\d+)?){_SPACE}*(?:['\u2018\u2019\u2032\u02b9\u00b4`])"
_SECONDS = rf"{_SPACE}*(?P<seconds>\d{{1,2}}(?:[.,]\d+)?){_SPACE}*(?:[\"\u201c\u201d\u2033\u02ba]|['\u2019\u2032]{{2}})"
_SEXAGESIMAL = re.compile(rf"(?P<sign>[+-]?){_SPACE}*(?P<degrees>\d{{1,6}}){_SPACE}*[°º˚]{_MINUTES}(?:{_SECONDS})?")


@record
class Written:
    """A number as it is written."""

    value: Fraction
    step: Fraction  # one of its last figure
    figures: int  # significant ones; zeros at the end count
    unit: str  # what stands behind it


class NoNumberError(ValueError):
    """What stands there is no number; the text says what it is."""


def read_number(text: str) -> Written:
    """Take a cell apart; raise `NoNumberError` for what is no number.

    >>> read_number("1,20·10³ мм")
    Written(value=Fraction(1200, 1), step=Fraction(10, 1), figures=3, unit='мм')
    """
    bare = _MINUS.sub("-", text.strip().strip("\u00a0\u202f").lstrip("≈~").strip())
    if bare.startswith(("=", "@")) or re.match(r"[+-][A-Za-z(]", bare):
        raise NoNumberError(Phrase("a formula; write the number"))
    if len(bare) > LONGEST:
        raise NoNumberError(Phrase("a long text"))
    if (angle := _SEXAGESIMAL.fullmatch(bare)) is not None:
        return _in_degrees(angle)
    match = _NUMBER.fullmatch(bare)
    if match is None or not (match["whole"] + match["rest"]).strip(".,"):
        raise NoNumberError(Phrase("no number"))
    if match["unit"] and not _UNIT.match(match["unit"]):
        several = re.search(r"\d", match["unit"])
        raise NoNumberError(Phrase("more than one number") if several else Phrase("no number"))
    return _made(match)


def _in_degrees(match: re.Match[str]) -> Written:
    """An angle in degrees, minutes and seconds; only the last of them may have decimals.

    Its figures are those of the number of its last part: 20° 38′ is 1238′ and has four.
    """
    degrees, minutes, seconds = match["degrees"], match["minutes"].replace(",", "."), match["seconds"]
    last = (seconds or minutes).replace(",", ".")
    whole = int(degrees) + Fraction(minutes) / 60 + Fraction(last if seconds else 0) / 3600
    if max(Fraction(minutes), Fraction(last)) >= 60 or (seconds and "." in minutes):
        raise NoNumberError(Phrase("more than one number"))
    step = Fraction(1, (3600 if seconds else 60) * 10 ** len(last.partition(".")[2]))
    figures = len(str(int(whole / step)).lstrip("0"))
    return Written(-whole if match["sign"] == "-" else whole, step, figures, "deg")


def _made(match: re.Match[str]) -> Written:
    whole, part = _split(re.sub(r"\s", "", match["whole"]), match["rest"])
    power = int(match["e"] or match["plain"] or (match["raised"] or "0").translate(_RAISED))
    if abs(power) > LARGEST:
        raise NoNumberError(Phrase("a number beyond all measure"))
    scale = Fraction(10) ** (power - len(part))
    value = int(whole + part or "0") * scale
    figures = len((whole + part).lstrip("0"))
    return Written(-value if match["sign"] == "-" else value, scale, figures, match["unit"].strip())


def _split(whole: str, rest: str) -> tuple[str, str]:
    """The digits before and behind the decimal sign: the last sign, but for one that parts thousands."""
    parts = re.split(r"[.,]", rest)[1:]
    signs = re.findall(r"[.,]", rest)
    if len(signs) < 2:
        return whole, parts[0] if parts else ""
    same = len({*signs}) == 1
    groups = parts if same else parts[:-1]
    if len({*signs[:-1]}) > 1 or not (0 < len(whole) <= 3) or any(len(group) != 3 for group in groups):
        raise NoNumberError(Phrase("more than one decimal sign"))
    return whole + "".join(groups), "" if same else parts[-1]
