"""How documents name the pairs of gears and their wheels, find them by name, and write their lengths and angles."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from tmmcalc.core.errors import UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.gears.involute.measure.angles import dms
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.report.numbers import number

USUAL = ("1", "2")  # names of the wheels of a pair by itself
_WHEEL = re.compile(r"\b(gear|wheel) (?:\{(\w+)\}|([12])\b)")


def titles(result: Pairs) -> list[str]:
    """One title a pair, no two alike."""
    return distinct([found.task.title for found in result.pairs])


def distinct(names: Sequence[str]) -> list[str]:
    """The same names, those that are there more than once with their number among all.

    >>> distinct(["z = 14/17", "z = 20/60", "z = 14/17"])
    ['z = 14/17, pair 1', 'z = 20/60', 'z = 14/17, pair 3']
    """
    times = Counter(names)
    return [f"{name}, pair {k}" if times[name] > 1 else name for k, name in enumerate(names, 1)]


def places(names: Sequence[str], wanted: str | None, what: str) -> list[int]:
    """Where a name stands among ``names`` (those without one are called by their number, from 1); all for None.

    Raises `UsageError` if no ``what`` is called so.

    >>> places(["1-2", "2'-3", ""], "2'-3", "pair"), places(["1-2", "2'-3", ""], "3", "pair")
    ([1], [2])
    """
    called = [name or str(k) for k, name in enumerate(names, 1)]
    found = [k for k, name in enumerate(called) if wanted in (None, name)]
    if found or wanted is None:
        return found
    raise UsageError(
        f"no {what} is called {wanted!r}", where=f"--{what}", remedy=f"{what}s: {', '.join(dict.fromkeys(called))}"
    )


def renamed(text: str, wheels: Sequence[str]) -> str:
    """A text about gears 1 and 2 of a pair with the names that its wheels have.

    >>> renamed("the tip of gear 2 cuts into the fillet of gear 1", ("2'", "3"))
    "the tip of wheel 3 cuts into the fillet of wheel 2'"
    """
    return reworded(text, lambda number, place: (f"wheel {{{place}}}", {place: wheels[number - 1]}))


def reworded(text: str, said: Callable[[int, str], tuple[str, dict[str, str]]]) -> str:
    """A text with other words for its gears 1 and 2: of each what ``said`` makes of its number and a free place."""
    template = text.template if isinstance(text, Phrase) else text
    given = dict(text.values) if isinstance(text, Phrase) else {}
    values = {name: reworded(part, said) if isinstance(part, Phrase) else part for name, part in given.items()}

    def word(found: re.Match[str]) -> str:
        number = found[3] or given[found[2]]
        if number not in ("1", "2"):
            return found[0]
        words, named = said(int(number), found[2] or ("mate" if "wheel" in values else "wheel"))
        values.update(named)
        return words

    template = _WHEEL.sub(word, template)
    return Phrase(template, **values) if values else template


def wheel_names(found: MeshPair) -> list[str]:
    """The wheels of a pair as table headers say them, one of a pinion with its rack."""
    named = zip(found.sizes, found.task.wheels, strict=False)
    return [f"wheel {name}{' (ring)' if size.kind == 'ring' else ''}" for size, name in named]


def known(values: Mapping[str, Any]) -> dict[str, Any]:
    """Values without those that do not exist: TOML has no word for them."""
    return {key: value for key, value in values.items() if value is not None}


def millimetres(*metres: float, digits: int = 7) -> str:
    """Lengths in millimetres.

    >>> millimetres(0.036234666, 0.044)
    '36.23467 and 44 mm'
    """
    peak = max(map(abs, metres))
    return f"{' and '.join(number(1e3 * value, digits, 1e3 * peak) for value in metres)} mm"


def written(angle: float) -> str:
    """An angle [rad] in radians, in degrees, and in degrees, minutes and seconds.

    >>> written(0.441837586)
    '0.4418376 rad = 25.31543 deg = 25 deg 18\\'55.54"'
    """
    turned = dms(angle).replace("°", " deg ")
    return f"{number(angle)} rad = {number(math.degrees(angle))} deg = {turned}"
