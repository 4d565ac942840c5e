"""Which item and which student a text names; capital letters, spaces and Cyrillic twins make no difference."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from difflib import get_close_matches

from tmmcalc.classroom.answers.measures import fits
from tmmcalc.classroom.model import Item, Key
from tmmcalc.core.records import record
from tmmcalc.spec.cyrillic import alike

_GREEK = {
    "α": "alpha",
    "β": "beta",
    "γ": "gamma",
    "δ": "delta",
    "ε": "epsilon",
    "ϵ": "epsilon",
    "ζ": "zeta",
    "η": "eta",
    "θ": "theta",
    "ϑ": "theta",
    "λ": "lambda",
    "μ": "mu",
    "µ": "mu",
    "ν": "nu",
    "ξ": "xi",
    "ρ": "rho",
    "σ": "sigma",
    "τ": "tau",
    "φ": "phi",
    "ϕ": "phi",
    "ψ": "psi",
    "ω": "omega",
}
_SPELLED = {
    "eps": "epsilon",
    "fi": "phi",
    "альфа": "alpha",
    "бета": "beta",
    "гама": "gamma",
    "гамма": "gamma",
    "дельта": "delta",
    "епсилон": "epsilon",
    "епсілон": "epsilon",
    "эпсилон": "epsilon",
    "ета": "eta",
    "лямбда": "lambda",
    "мю": "mu",
    "омега": "omega",
    "псі": "psi",
    "сигма": "sigma",
    "тау": "tau",
    "тета": "theta",
    "фи": "phi",
    "фі": "phi",
}
_LOWERED = str.maketrans("₀₁₂₃₄₅₆₇₈₉⁰¹²³⁴⁵⁶⁷⁸⁹", "01234567890123456789")
_UNIT = re.compile(r"(?P<name>.+?)\s*(?:\[(?P<a>[^\[\]]*)\]|\((?P<b>[^()]*)\)|,\s*(?P<c>[^,;()]+))\s*", re.DOTALL)
_PLACE = re.compile(
    r"(?P<what>.+?)\s*(?:@\s*(?P<label>\d+'*)|\[\s*phi\s*=\s*(?P<angle>[-+\d.]+)\s*(?P<unit>deg|rad)?\s*\])"
)
DATE = re.compile(r"(\d{4})[-_.](\d{1,2})[-_.](\d{1,2})|(\d{1,2})[-_.](\d{1,2})[-_.](\d{4})")
_LEADING = re.compile(r"[\W_]*(\d{1,6})(?![.,]?\d)")
_AFTER_A_WORD = re.compile(r"(?:(?<![^\W\d_])(?:variant|var|v|варіант|вар|в)|№|#)[\s._:№-]*(\d{1,6})(?!\d)")
NEARLY = 0.8  # likeness of a misspelled name to the name
SHORTEST = 3  # letters of a name by which a student is found in the name of a file


def folded(text: str) -> str:
    """A name as it is compared.

    >>> folded("ω₂ "), folded("Омега 2"), folded("eps_3"), folded("\u0420 max") == folded("p MAX")
    ('omega2', 'omega2', 'epsilon_3', True)
    """
    letters = "".join(_GREEK.get(sign, sign) for sign in text.casefold().translate(_LOWERED))
    spelled = re.sub(r"[^\W\d_]+", lambda word: _SPELLED.get(word[0], word[0]), letters)
    return re.sub(r"\s+", "", alike(spelled)).casefold()


def _loose(text: str) -> str:
    """A name without its signs, but for the primes of a derivative or of a position, which make it another.

    >>> _loose("R_1,2"), _loose("s′"), _loose("«s'»")
    ('r12', "s'", 's')
    """
    bare = folded(text)
    primes = re.search(r"(?<=\w)['\u2019\u2032\u2033]+$", bare)
    count = len(primes[0].replace("\u2033", "''")) if primes and bare[0] not in "'\u2018\u2019" else 0
    return re.sub(r"[\W_]", "", bare) + "'" * count


@record
class Place:
    """An item that is a column of a table over positions, at one of them."""

    item: int
    label: str  # of the position; empty: by its angle
    angle: float  # [deg] of the input link; NaN: by its label


class Names:
    """The items by all their names."""

    def __init__(self, items: Sequence[Item]) -> None:
        self._units = [item.unit for item in items]
        own = [(name, k) for k, item in enumerate(items) for name in (item.name, *item.also)]
        known = [(name, k) for k, item in enumerate(items) for name in _names(item)]
        self._tiers = [
            (spelled, _unique((spelled(name), k) for name, k in some))
            for some in (own, known)
            for spelled in (folded, _loose)
        ]
        self._columns = [
            (spelled, _columns(some, items, spelled)) for some in (own, known) for spelled in (folded, _loose)
        ]

    def item(self, text: str) -> int | None:
        """The item that a text names, None: none, or more than one.

        What an item is called goes before the name of its result, which may be what another is called.
        """
        return next((tier[name] for spelled, tier in self._tiers if (name := spelled(text)) in tier), None)

    def headed(self, text: str) -> tuple[int | None, str]:
        """The item of a header, and the unit that stands behind its name."""
        if (found := self.item(text)) is not None:
            return found, ""
        name, unit = parted(text)
        return self.item(name), unit

    def has_unit(self, item: int, unit: str) -> bool:
        """Whether a unit that stands over several items may be that of this one."""
        return fits(unit, self._units[item])

    def column(self, text: str) -> tuple[frozenset[Place], str]:
        """The items of a column of a table over positions, and the unit of its header."""
        if found := self._places(text):
            return found, ""
        name, unit = parted(text)
        return self._places(name), unit

    def _places(self, name: str) -> frozenset[Place]:
        """The items of a column by its name, one a place."""
        found = next((tier[bare] for spelled, tier in self._columns if (bare := spelled(name)) in tier), ())
        claims = Counter((place.label, str(place.angle)) for place in found)
        return frozenset(place for place in found if claims[place.label, str(place.angle)] == 1)


def parted(header: str) -> tuple[str, str]:
    """The name and the unit of a header; without a unit the header and nothing.

    >>> parted("H, мм"), parted("F max [кН]"), parted("K")
    (('H', 'мм'), ('F max', 'кН'), ('K', ''))
    """
    if (match := _UNIT.fullmatch(header.strip())) is None:
        return header.strip(), ""
    return match["name"].strip(), (match["a"] or match["b"] or match["c"] or "").strip()


def _names(item: Item) -> Iterator[str]:
    """All that an item may be called: of its result the name with its stage and without."""
    yield from (item.name, *item.also, item.result)
    bare = item.result.partition(".")[2]
    if bare:
        yield bare


def _columns(
    known: Iterable[tuple[str, int]], items: Sequence[Item], spelled: Callable[[str], str]
) -> dict[str, set[Place]]:
    """Items by their names without their places."""
    found: dict[str, set[Place]] = {}
    for name, k in known:
        for what, place in _placed(name, items[k], k):
            found.setdefault(spelled(what), set()).add(place)
    return found


def _placed(name: str, item: Item, k: int) -> Iterator[tuple[str, Place]]:
    """The name without its place, and the place that it or the result of the item has."""
    own, of_result = _PLACE.fullmatch(name), _PLACE.fullmatch(item.result)
    match = own or of_result
    if match is None:
        return
    what = own["what"] if own else name
    if match["label"]:
        yield what, Place(k, match["label"], math.nan)
    else:
        angle = float(match["angle"])
        yield what, Place(k, "", math.degrees(angle) if match["unit"] == "rad" else angle)


def _unique(known: Iterable[tuple[str, int]]) -> dict[str, int]:
    """Names of one item alone."""
    found: dict[str, set[int]] = {}
    for name, k in known:
        if name:
            found.setdefault(name, set()).add(k)
    return {name: next(iter(items)) for name, items in found.items() if len(items) == 1}


class Roster:
    """The students by number and by name."""

    def __init__(self, keys: Sequence[Key]) -> None:
        self._numbers = {key.number for key in keys}
        self._words = {key.number: _words(key.student) for key in keys if key.student}
        self._names = _unique((folded(key.student), key.number) for key in keys if key.student)

    def student(self, text: str) -> int | None:
        """The number of the variant of whom a text names, "5", "№ 5", "variant 5", or by name; None: nobody."""
        if (named := self._names.get(folded(text))) is not None:
            return named
        if (named := self.named(text)) is not None:
            return named
        return self._numbered(text)

    def _numbered(self, text: str) -> int | None:
        """The number of a variant in a text that names nobody.

        Where the roster has names it leads, or stands behind a word for it: any other may be of a group or a task. It
        does not count beside the name of another student, or one that is nearly so.
        """
        numbers = {int(found) for found in re.findall(r"(?<!\d)\d{1,6}(?!\d)", text)} & self._numbers
        words = _words(text)
        if said := {int(found) for found in _AFTER_A_WORD.findall(text.casefold())}:
            numbers &= said
        elif self._words and words and numbers:
            leading = _LEADING.match(text)
            numbers &= {int(leading[1])} if leading else set()
        if len(numbers) != 1:
            return None
        (number,) = numbers
        others = {word for other, own in self._words.items() if other != number for word in own}
        others -= self._words.get(number, frozenset())
        return None if any(get_close_matches(word, others, 1, NEARLY) for word in words) else number

    def named(self, text: str) -> int | None:
        """The student whose name stands in a text among other words; None: none or more than one."""
        words = _words(text)
        whole = {number for number, own in self._words.items() if own and own <= words}
        if not whole:  # the family name alone, where it is the name of one student
            longest = {number: max(own, key=len, default="") for number, own in self._words.items()}
            whole = {number for number, word in longest.items() if len(word) >= SHORTEST and word in words}
        if len(whole) > 1:  # "Bondar Ivan" within "Bondar Ivan Petrovych": who has more words in common
            most = max(len(self._words[number]) for number in whole)
            whole = {number for number in whole if len(self._words[number]) == most}
        return whole.pop() if len(whole) == 1 else None

    def of_file(self, parts: Sequence[str]) -> int | None:
        """The student of a file by the names of its folders and its own, without its suffix, the last of ``parts``.

        Names go before numbers. Numbers of folders say which time it was handed in, so a folder tells the student by
        name alone.
        """
        stem = DATE.sub(" ", parts[-1])
        named = [self.named(part) for part in (stem, *reversed(parts[:-1]))]
        return next((number for number in named if number is not None), self.student(stem))


def _words(text: str) -> frozenset[str]:
    return frozenset(folded(word) for word in re.findall(r"[^\W\d_]+", text) if len(word) > 1)
