"""Which names of columns no result can have, told from what is declared, before anything is computed.

A stage that says where all names of its columns are declared (``declares`` of a stage) has names of these forms alone:
``R_{joint}``, and for a joint the words that the scene has (``words`` of a stage), for other places any word. So a name
that is of no form of any stage is a slip. One that is of a form may still name nothing, ``F_fr_A3`` without friction in
A3; and a stage that does not say it may have any: such names are told when all is computed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from fnmatch import fnmatchcase
from functools import cache
from importlib import import_module
from inspect import getmodule
from itertools import product
from string import Formatter
from typing import Any, NamedTuple

from tmmcalc.core.errors import UsageError
from tmmcalc.core.quantity import Quantity, given_out, given_over_rows, standing_in
from tmmcalc.core.stage import Stage, resolve
from tmmcalc.naming.language import WILD, near
from tmmcalc.naming.meanings import AXES

PACKAGE = "tmmcalc."  # modules begin with it
LABELS = "i"  # the column that rows begin with


class Form(NamedTuple):
    """The name of a column with places in braces, and the words that may stand in some of them."""

    name: str
    words: Mapping[str, Sequence[str]]
    fact: bool = False  # it may be the name of a fact alone

    @property
    def parts(self) -> list[tuple[str, str | None]]:
        """Literal text, each with the place that follows it."""
        return [(text, place) for text, place, *_ in Formatter().parse(self.name)]

    def may_be(self, pattern: str) -> bool:
        """Whether a name, or a pattern with wildcards, may be of this form.

        >>> form = Form("R_{joint}_x", {"joint": ("A", "B")})
        >>> form.may_be("R_A_x"), form.may_be("R_C_x"), form.may_be("*_x"), form.may_be("x_*")
        (True, False, True, False)
        """
        bare, bracket, _ = pattern.partition("[")
        if not WILD.isdisjoint(bare) or bracket:
            return any(_meet(pattern, name) for name in self.names()) or bool(bracket and self.may_be(bare))
        words = "".join(re.escape(text) + self._any(place) for text, place in self.parts)
        return re.fullmatch(words, bare) is not None

    def _any(self, place: str | None) -> str:
        """The regular expression of a place; without a word nothing is of it."""
        if place is None:
            return ""
        words = self.words.get(place)
        return ".+" if words is None else f"(?:{'|'.join(map(re.escape, words)) or '(?!)'})"

    def names(self) -> Iterator[str]:
        """The names of this form; where the scene has no words for a place with ``*`` there."""
        places = list(dict.fromkeys(place for _, place in self.parts if place))
        for words in product(*(self.words.get(place, ("*",)) for place in places)):
            yield self.name.format(**dict(zip(places, words, strict=True)))


def check_columns(names: Sequence[str], stages: Sequence[Stage], spec: Any) -> None:
    """Raise UsageError with all names that no column of these stages can have, each with the nearest that may be."""
    forms = [Form(LABELS, {})]
    for stage in stages:
        own = forms_of(stage, spec)
        if own is None:
            return
        forms += own
    missed = [name for name in names if not any(form.may_be(name) for form in forms)]
    if missed:
        known = [name for form in forms if not form.fact for name in form.names() if WILD.isdisjoint(name)]
        told = [f"{f'{name}: ' if len(missed) > 1 else ''}{near(name, known, 'columns')}" for name in missed]
        which = "no column is called" if len(stages) == 1 else "no stage has a column called"
        quoted = " or ".join(map(repr, missed))
        raise UsageError(f"{which} {quoted}", where="--columns", remedy="\n     ".join(told))


def forms_of(stage: Stage, spec: Any) -> list[Form] | None:
    """The forms of all names that columns of a stage may have in a scene; None where it does not say them."""
    if stage.part("columns") is None and stage.part("table") is None:
        return []
    if stage.part("declares") is None:
        return None
    own = stage.part("words")
    words = {"axis": AXES, **(own(spec) if own else {})}
    modules = [getmodule(made) for made in map(stage.part, ("columns", "table")) if made is not None]
    own = [place for place in stage.part("declares") if not place.startswith(PACKAGE)]
    for place in stage.part("declares"):
        if ":" in place:
            own.append(resolve(place).name)
        elif place.startswith(PACKAGE):
            modules.append(import_module(place))
    rows = [each for kind in stage.kinds for each in given_over_rows(kind)]
    rows += [each for module in modules for each in standing_in(module, over_rows=True)]
    every = [each for kind in stage.kinds for each in given_out(kind)]
    every += [each for module in modules for each in standing_in(module)]
    names = [*own, *_names(rows)]
    return [Form(name, words, name not in names) for name in dict.fromkeys([*names, *_names(every)]) if _literal(name)]


def _names(every: Sequence[Quantity]) -> list[str]:
    """What may head their columns."""
    return [word for each in every for word in (each.heading.partition("[")[0], each.name)]


def _literal(name: str) -> bool:
    """Whether a name has more than places: of no other one is told what it is."""
    return any(text for text, *_ in Formatter().parse(name))


@cache
def _meet(one: str, other: str) -> bool:
    """Whether some word is of both patterns; of the second one only ``*`` is a wildcard.

    >>> _meet("R_*", "*_x"), _meet("R_?", "*_x"), _meet("R_[AB]", "R_C"), _meet("x_*", "R_*")
    (True, True, False, False)
    """
    if "*" not in other:
        return fnmatchcase(other, one)
    if "[" in one:
        one = re.sub(r"\[[^\]]*\]?", "?", one)  # one letter of several
    if one[:1] == "*":
        return _meet(one[1:], other) or (bool(other) and _meet(one, other[1:]))
    if other[:1] == "*":
        return _meet(one, other[1:]) or (bool(one) and _meet(one[1:], other))
    if not one or not other:
        return not one and not other
    return one[0] in ("?", other[0]) and _meet(one[1:], other[1:])
