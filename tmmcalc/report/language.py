"""The language that drawings and notes are in: English, or a translation of it.

A text stands in the program in English, ``tr("in position {label}", label="7")``. Files ``uk.toml`` beside what says it
hold its translation, "English" = "Ukrainian", in which the same values stand; ``[names]`` texts that theory, manifests
and specs say, ``[units]`` in one of them the units, ``[counts]`` words that follow a number, in the forms for 1, for 2
to 4 and for 5, ``[plurals]`` words with which meanings begin, ``[genitives]`` those of which there are projections.
``with speaking("uk"):`` holds for all that is drawn within.
A text without a translation stays English; `tests/report/test_language.py` finds it.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from decimal import Decimal
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from tmmcalc.core.errors import UsageError
from tmmcalc.core.notes import Phrase

LANGUAGES = {"en": "English", "uk": "Українська"}  # as each calls itself
PLACE = re.compile(r"\{(\w+)\}")
HEAD = re.compile(r"[\w' -]+?(?= (?:of|at|on|in|for|to|from|by|that|where|with|over|between|about)\b|,|$)")
INERTIA = "moment of inertia"  # one in each of two planes is no vector
UNIT = re.compile(r"[A-Za-z°%]+")
POINT = re.compile(r"(?<=\d)\.(?=\d)")
NUMBER = re.compile(r"([-+−]?\d+(?:[.,]\d+)?(?:e[-+]?\d{1,2})?)(?: (%|°|[A-Za-z][\w*/^²³·]*))?")  # and its unit

_spoken: ContextVar[str] = ContextVar("language", default="en")


class Catalogue(NamedTuple):
    """The words of a language by the English ones."""

    texts: Mapping[str, str]
    names: Mapping[str, str]
    units: Mapping[str, str]
    counts: Mapping[str, tuple[str, str, str]]
    plurals: Mapping[str, str]
    genitives: Mapping[str, str]


@contextmanager
def speaking(language: str) -> Iterator[None]:
    """All texts within are in this language; raises `UsageError` for one that is not there."""
    if language not in LANGUAGES:
        known = ", ".join(LANGUAGES)
        raise UsageError(f"there is no language {language!r}", where="--language", remedy=f"languages: {known}")
    token = _spoken.set(language)
    try:
        yield
    finally:
        _spoken.reset(token)


def spoken() -> str:
    """The language in force."""
    return _spoken.get()


def tr(text: str, **values: Any) -> str:
    """A text in the language in force; ``{name}`` is replaced by the value of this name, other braces stay.

    >>> tr("{count} of $R_{21}$", count=7)
    '7 of $R_{21}$'
    >>> with speaking("uk"):
    ...     tr("in position {label}", label=7)
    'у положенні 7'
    """
    language = _spoken.get()
    found = text if language == "en" else catalogue(language).texts.get(text, text)
    return PLACE.sub(lambda name: str(values.get(name[1], name[0])), found) if values else found


def tr_name(text: str) -> str:
    """A text that the theory, a manifest or the spec says, as the name of a law or a link; itself without another.

    The values of a `Phrase` are translated too.

    >>> with speaking("uk"):
    ...     tr_name("slider-crank"), tr_name("Q5")
    ('кривошипно-повзунний механізм', 'Q5')
    """
    language = _spoken.get()
    if language == "en":
        return text
    if isinstance(text, Phrase):
        return tr_name(text.template).format_map({name: _value(name, each) for name, each in text.values.items()})
    words = catalogue(language)
    return words.names.get(text) or words.texts.get(text, text)


def _value(name: str, value: str | Sequence[str]) -> str:
    """A value of a phrase: a word or a phrase, a number, alone or with its unit, or several of them."""
    if not isinstance(value, str):
        parts = [_value(name, each) for each in value]
        return ("; " if any("," in part for part in parts) else ", ").join(parts)
    if name == "unit":
        return tr_unit(value)
    if (found := tr_name(value)) != value or isinstance(value, Phrase):
        return found
    if (number := NUMBER.fullmatch(value)) is None:
        return tr_number(value)
    return tr_measured(*number.groups(default=""))


def tr_measured(digits: str, unit: str = "") -> str:
    """A written number with its unit: a true minus and no exponent, an angle with the sign of degrees.

    >>> tr_measured("-1.2e-05", "N*m"), tr_measured("30", "deg"), tr_measured("+4")
    ('−0.000012 N·m', '30°', '+4')
    >>> with speaking("uk"):
    ...     tr_measured("2.5", "mm")
    '2,5 мм'
    """
    said = tr_number(f"{Decimal(digits.replace(',', '.').replace('−', '-')):f}").replace("-", "−")
    sign = "+" if digits.startswith("+") else ""
    return f"{sign}{said}°" if unit == "deg" else f"{sign}{said} {tr_unit(unit)}" if unit else sign + said


def tr_unit(unit: str) -> str:
    """A unit, written with ``*`` or ``·``, ``^2`` or ``²``.

    >>> tr_unit("kg*m^2"), tr_unit("(m/s²)/mm")
    ('kg·m²', '(m/s²)/mm')
    >>> with speaking("uk"):
    ...     tr_unit("kg*m^2"), tr_unit("rpm"), tr_unit("N/mm")
    ('кг·м²', 'об/хв', 'Н/мм')
    """
    written = unit.replace("*", "·").replace("^2", "²").replace("^3", "³").replace("^4", "⁴")
    language = _spoken.get()
    if language == "en":
        return written
    units = catalogue(language).units
    return UNIT.sub(lambda name: units.get(name[0], name[0]), written)


def tr_count(count: int, one: str, many: str) -> str:
    """A whole number with what it counts.

    >>> tr_count(1, "tooth", "teeth"), tr_count(3, "tooth", "teeth")
    ('1 tooth', '3 teeth')
    >>> with speaking("uk"):
    ...     [tr_count(n, "tooth", "teeth") for n in (1, 3, 5, 11, 22)]
    ['1 зубець', '3 зубці', '5 зубців', '11 зубців', '22 зубці']
    """
    language = _spoken.get()
    forms = (one, many, many) if language == "en" else catalogue(language).counts.get(one, (one, many, many))
    if language == "en":
        return f"{count} {one if count == 1 else many}"
    tens, ones = count % 100 // 10, count % 10
    form = 2 if tens == 1 or not 1 <= ones <= 4 else 0 if ones == 1 else 1
    return f"{count} {forms[form]}"


def several(meaning: str) -> str:
    """What several letters mean that have one meaning: its first noun in the plural, where that is known.

    >>> several("number of teeth"), several("shift coefficient"), several("reference radius, left")
    ('numbers of teeth', 'shift coefficients', 'reference radii, left')
    >>> with speaking("uk"):
    ...     several("число зубців"), several("маса колеса")
    ('числа зубців', 'маси колеса')
    """
    language = _spoken.get()
    if language != "en":
        return _begun(meaning, catalogue(language).plurals) or meaning
    noun, rest = _headed(meaning)
    if noun.endswith("radius"):
        return noun.removesuffix("us") + "i" + rest
    return meaning if noun.endswith("s") else noun + "s" + rest


def possessive(meaning: str) -> str:
    """What a vector means as it stands after "of the"; nothing for a meaning of several things, or of no vector.

    >>> possessive("weight of link 2"), possessive("coordinates of point A"), possessive("moment of inertia of link 2")
    ('weight of link 2', '', '')
    >>> with speaking("uk"):
    ...     possessive("сила ваги ланки 2"), possessive("прискорення ролика"), possessive("координати точки A")
    ('сили ваги ланки 2', 'прискорення ролика', '')
    """
    language = _spoken.get()
    if language != "en":
        return _begun(meaning, catalogue(language).genitives)
    noun, _ = _headed(meaning)
    return "" if noun.endswith("s") or meaning.startswith(INERTIA) else meaning


def _headed(meaning: str) -> tuple[str, str]:
    """The noun of an English meaning with what is before it, and the rest."""
    head = HEAD.match(meaning)
    return (head[0], meaning[head.end() :]) if head else (meaning, "")


def _begun(meaning: str, forms: Mapping[str, str]) -> str:
    """The meaning with the most of its first words that have another form in that one; nothing if they have none."""
    words = meaning.split(" ")
    for count in range(len(words), 0, -1):
        first = " ".join(words[:count])
        if (found := forms.get(bare := first.rstrip(","))) is not None:
            return " ".join((found + first[len(bare) :], *words[count:]))
    return ""


def tr_number(text: str) -> str:
    """A written number with the decimal sign of the language in force.

    >>> with speaking("uk"):
    ...     tr_number("-0.25")
    '-0,25'
    """
    return text if _spoken.get() == "en" else POINT.sub(",", text)


@cache
def catalogue(language: str) -> Catalogue:
    """All words of a language, from the files of the program that hold some."""
    texts: dict[str, str] = {}
    names: dict[str, str] = {}
    units: dict[str, str] = {}
    counts: dict[str, tuple[str, str, str]] = {}
    plurals: dict[str, str] = {}
    genitives: dict[str, str] = {}
    for file in files_of(language):
        words = tomllib.loads(file.read_text(encoding="utf-8"))
        names |= words.pop("names", {})
        units |= words.pop("units", {})
        counts |= {one: tuple(forms) for one, forms in words.pop("counts", {}).items()}
        plurals |= words.pop("plurals", {})
        genitives |= words.pop("genitives", {})
        texts |= words
    return Catalogue(texts, names, units, counts, plurals, genitives)


def files_of(language: str) -> list[Path]:
    """The files that hold words of a language."""
    return sorted(Path(__file__).parent.parent.rglob(f"{language}.toml"))
