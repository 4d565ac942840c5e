"""Keys and units in Cyrillic letters: which Latin ones are meant. Loaded only when a spec has faults.

A key or a unit of a spec is in Latin letters. A keyboard that was left in Cyrillic writes letters that cannot be told
from Latin ones by eye, and people write the units of their textbooks: ``об/хв``, ``кг``, ``кВт``.
"""

from __future__ import annotations

import re

LETTERS = "\u0400-\u04ff"
_WORD = re.compile(f"[{LETTERS}]+")

_ALIKE = str.maketrans("авеикмнорстухіјѕАВЕКМНОРСТУХІЈЅ", "abeukmhopctyxijsABEKMHOPCTYXIJS")
_UNITS = {
    "мкм": "um",
    "мм": "mm",
    "см": "cm",
    "м": "m",
    "км": "km",
    "кг": "kg",
    "г": "g",
    "т": "t",
    "кгс": "kgf",
    "мс": "ms",
    "с": "s",
    "сек": "s",
    "мин": "min",
    "хв": "min",
    "ч": "h",
    "год": "h",
    "рад": "rad",
    "град": "deg",
    "об": "rev",
    "Н": "N",
    "кН": "kN",
    "МН": "MN",
    "Нм": "N*m",
    "кНм": "kN*m",
    "Нмм": "N*mm",
    "Вт": "W",
    "кВт": "kW",
    "МВт": "MW",
    "Дж": "J",
    "кДж": "kJ",
    "Па": "Pa",
    "кПа": "kPa",
    "МПа": "MPa",
    "бар": "bar",
    "В": "V",
    "кВ": "kV",
    "Ом": "ohm",
    "Гц": "Hz",
}
_FOLDED = {word.casefold(): unit for word, unit in _UNITS.items()} | {"мпа": "MPa", "мн": "MN"}
_KEYS = {
    "маса": "mass",
    "масса": "mass",
    "довжина": "length",
    "длина": "length",
    "кут": "angle",
    "угол": "angle",
    "швидкість": "speed",
    "скорость": "speed",
    "сила": "force",
    "момент": "moment",
    "інерція": "inertia",
    "инерция": "inertia",
    "точки": "points",
    "ланки": "links",
    "звенья": "links",
    "назва": "name",
    "имя": "name",
    "положення": "positions",
    "положения": "positions",
    "модуль": "module",
    "потужність": "power",
    "мощность": "power",
}


def latin_units(text: str) -> str:
    """The text with every unit that is written in Cyrillic in its Latin form; what is none stays.

    >>> latin_units("500 об/хв"), latin_units("2.5 кН·м"), latin_units("4 кг·м²"), latin_units("7 шт")
    ('500 rpm', '2.5 kN·m', '4 kg·m²', '7 шт')
    """
    return _WORD.sub(lambda match: _unit(match.group()), text).replace("rev/min", "rpm")


def _unit(word: str) -> str:
    return _UNITS.get(word) or _FOLDED.get(word.casefold()) or _alike(word) or word


def _alike(word: str) -> str:
    """The Latin word that looks the same, such as mm; empty where a letter has no Latin twin."""
    latin = alike(word)
    return latin if latin.isascii() else ""


def alike(text: str) -> str:
    """The text with a Latin letter for each Cyrillic one that cannot be told from it by eye.

    >>> alike("\u0421\u0410")
    'CA'
    """
    return text.translate(_ALIKE)


def latin_key(key: str) -> str:
    """The Latin key that a Cyrillic or mixed one was meant to be; the key itself where that cannot be told.

    >>> latin_key("\u043cass"), latin_key("маса"), latin_key("шатун")
    ('mass', 'mass', 'шатун')
    """
    latin = alike(key)
    mixed = latin.isascii() and any(sign.isascii() and sign.isalpha() for sign in key)
    return _KEYS.get(key.casefold(), latin if mixed else key)


def stranger(text: str) -> str:
    """Name the first letter that is not Latin, which cannot be told from a Latin one by eye; empty if all are.

    >>> stranger("\u043cass"), stranger("mass")
    (': it holds Cyrillic small letter em', '')
    """
    from unicodedata import name

    for character in text:
        if character.isalpha() and not character.isascii():
            return f": it holds {name(character, 'a letter').capitalize()}"
    return ""
