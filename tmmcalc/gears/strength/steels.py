"""Designations of steels: Cyrillic, in Latin transliteration, or in Latin letters that look alike.

A designation is brought to one key, in Cyrillic: 40Х is also 40Kh, 40X, "steel 40Kh"; 38ХМЮА is 38KhMYuA.
"""

from __future__ import annotations

import re
from functools import cache

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.strength.tables import ANY, BendingRow, table

# two letters first; then single ones, the sound before the look where they do not exclude each other
_PAIRS = (("KH", "Х"), ("YU", "Ю"), ("IU", "Ю"), ("JU", "Ю"))
_SINGLE = str.maketrans("NHGMVBFARPSCTXKD", "ННГМВВФАРРССТХКД")
_LATIN = {
    **dict(zip("НГМВФАРСТКД", "NGMVFARSTKD", strict=True)),
    "Х": "Kh",
    "Ю": "Yu",
}


def steel_key(designation: str) -> str:
    """The designation in Cyrillic capitals without spaces and hyphens.

    >>> steel_key("Steel 40Kh") == steel_key("40X") == "40Х"
    True
    """
    text = re.sub(r"[\s-]+", "", designation).upper()
    text = re.sub(r"^(STEEL|STAL|ST|СТАЛЬ|СТ)\.?", "", text)
    for latin, cyrillic in _PAIRS:
        text = text.replace(latin, cyrillic)
    return text.translate(_SINGLE)


def latin(designation: str) -> str:
    """The designation in Latin transliteration.

    >>> latin("18Х2Н4ВА")
    '18Kh2N4VA'
    """
    return "".join(_LATIN.get(letter, letter) for letter in designation)


@cache
def known() -> dict[str, tuple[str, ...]]:
    """Every steel of Table D.4.3 and the treatments that the table has for it by name."""
    found: dict[str, list[str]] = {}
    for row in table(BendingRow):
        for steel in row.steels if row.steels != (ANY,) else ():
            found.setdefault(steel, []).extend(t for t in row.treatments if t not in found.get(steel, ()))
    return {steel: tuple(treatments) for steel, treatments in found.items()}


def check_steel(designation: str, of: str, remedy: str) -> str:
    """The key of a steel that Table D.4.3 knows; else `UsageError` with the nearest ones; ``of`` names the wheel."""
    key = steel_key(designation)
    if key in known():
        return key
    from difflib import get_close_matches  # late: only faults need it

    close = [latin(match) for match in get_close_matches(key, known(), 3, 0.6)]
    guess = f"did you mean {' or '.join(close)}? Or {remedy}" if close else remedy
    raise UsageError(f"Table D.4.3 has no steel {designation!r}", where=of, remedy=guess)
