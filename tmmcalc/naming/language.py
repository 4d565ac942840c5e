"""The names of results: one small language for whatever asks for a number of a scene.

    name   = [stage "."] what [place] ["[" unit "]"]
    what   = fact                                      a number of the stage's summary, `motion.delta`
           | column                                    of the stage's table, with a place: `kinematics.S_D@12`
           | of "(" column ")"                         of its rows, all or those of a place: `forces.max(R_A)@2..12`
    of     = "max" | "min" | "range" | "mean" | "rms" | "size" | "first" | "last" | "integral"
           | "at_max" | "at_min" | "at_size"           where: the value of what the rows run over, `phi` or `t`
           | "chosen"                                  of rows that are sets to choose from: that of the chosen one
    place  = "@" label [".." label]                    a row by its label, `@6'`; or the rows from one to another
           | "[" column "=" value [".." value] "]"     where a column has this value, `[phi=45 deg]`, `[t=0.2 s]`
    value  = number [unit]                             a number alone is in the unit of the column

Without a stage a name is that of the one stage that tells it. The unit at the end is the one in which the quantity is
told; it may be left out. Where several quantities may be named, stage, fact and column may have the wildcards ``*`` and
``?``. Keys of nested facts are joined by dots. `tmmcalc.naming.told` finds what a name stands for.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fnmatch import fnmatchcase
from functools import lru_cache
from typing import NamedTuple

from tmmcalc.core.errors import UsageError
from tmmcalc.core.stage import STAGES
from tmmcalc.spec.phrases import nearest, show

OF = (
    "max",
    "min",
    "range",
    "mean",
    "size",
    "first",
    "last",
    "rms",
    "integral",
    "at_max",
    "at_min",
    "at_size",
    "chosen",
)
ROWS = ("train", "criteria")  # stages whose rows are sets to choose from: one of them is chosen
ANY = "*"  # in place of a stage: that of the one that tells it
WILD = frozenset("*?")
LONGEST = 200  # characters; names have some forty
SOME = 20  # of what there is are told where nothing is near
EXAMPLES = "names are like motion.delta, forces.max(R_A), kinematics.S_D@12, kinematics.vS_D[phi=45 deg]"


class Place(NamedTuple):
    """Of a table one row, or the rows from one to another: by their labels, or by the values of a column."""

    column: str  # empty: by labels
    first: str
    last: str = ""  # empty: one row

    @property
    def text(self) -> str:
        """As it stands in a name."""
        ends = f"{self.first}..{self.last}" if self.last else self.first
        return f"[{self.column}={ends}]" if self.column else f"@{ends}"


class Name(NamedTuple):
    """The name of a quantity, taken apart."""

    stage: str  # empty: that of the one stage that tells it
    of: str  # empty: a fact, or a column at one place
    what: str  # the fact or the column
    place: Place | None = None
    unit: str | None = None

    @property
    def quantity(self) -> str:
        """The name without its stage and its unit."""
        what = f"{self.of}({self.what})" if self.of else self.what
        return what + (self.place.text if self.place else "")

    @property
    def text(self) -> str:
        """The name without its unit."""
        return f"{self.stage}.{self.quantity}" if self.stage else self.quantity

    @property
    def fact(self) -> bool:
        """Whether it names a fact."""
        return not self.of and self.place is None

    @property
    def wild(self) -> bool:
        """Whether it may name several quantities."""
        return not WILD.isdisjoint(self.stage + self.what)

    def may_be_of(self, stage: str) -> bool:
        """Whether a stage may tell it."""
        wild = self.fact and not WILD.isdisjoint(self.stage)  # it may be part of a nested fact
        return not self.stage or wild or like(stage, self.stage)

    def fits(self, told: Name) -> bool:
        """Whether it names a quantity that is told, with its stage and all that belongs to it."""
        if (self.of, self.place) != (told.of, told.place) or self.unit not in (None, told.unit or ""):
            return False
        if self.fact:
            return any(like(form, self.text) for form in (told.text, told.what))
        return (not self.stage or like(told.stage, self.stage)) and like(told.what, self.what)


@lru_cache(maxsize=4096)  # a sweep has the same few names at every point
def parse(text: str) -> Name:
    """Take a name apart; raises `UsageError` for what is no name.

    >>> import tmmcalc.rooms
    >>> parse("forces.max(R_A)@2..12")
    Name(stage='forces', of='max', what='R_A', place=Place(column='', first='2', last='12'), unit=None)
    >>> parse("kinematics.vS_D[phi=45 deg][m/s]").place.text
    '[phi=45 deg]'
    """
    if len(text) > LONGEST:
        raise UsageError(f"{show(text)} is longer than {LONGEST} characters", value=len(text), limit=LONGEST)
    rest, unit, place = text.strip(), None, None
    while rest.endswith("]") and place is None and "[" in rest:
        rest, _, inner = rest[:-1].rpartition("[")
        if "=" in inner:
            place = _between(inner, text)
        elif unit is None:
            unit = inner.strip()
        else:
            raise _fault(text, "it has two units")
    if "@" in rest:
        if place is not None:
            raise _fault(text, "it has two places")
        rest, _, label = rest.partition("@")
        place = _ends("", label, text)
    return _named(rest.strip(), place, unit, text)


def _between(inner: str, text: str) -> Place:
    column, _, value = inner.partition("=")
    if not column.strip():
        raise _fault(text, "a place is a column and its value, [phi=45 deg]")
    return _ends(column.strip(), value, text)


def _ends(column: str, written: str, text: str) -> Place:
    first, dots, last = (part.strip() for part in written.partition(".."))
    if not first or (dots and not last) or ".." in last:
        raise _fault(text, "a place is one value, or two with .. between them: @6, @2..12, [phi=45 deg]")
    return Place(column, first, last)


def _named(rest: str, place: Place | None, unit: str | None, text: str) -> Name:
    """What is left without place and unit: stage, function and column, or fact."""
    head, bracket, column = rest.partition("(")
    stage, of = _staged(head.strip())
    if bracket and of not in OF and (guess := nearest(of, OF)):
        raise _fault(text, f"{show(of)} is asked of no column, did you mean {guess}?", listed=True)
    if of not in OF or not bracket:  # keys of facts may have brackets of their own
        stage, what = _staged(rest)
        if not what or what.count("(") != what.count(")"):
            raise _fault(text, "a bracket is not closed, or was not opened" if what else "a quantity is missing")
        if place is not None and place.last:
            raise _fault(text, f"of several rows it has to say what is asked, such as max({what}){place.text}")
        return Name(stage, "", what, place, unit)
    column, closed, after = (part.strip() for part in column.partition(")"))
    if not column or not closed or after or "(" in column:
        raise _fault(text, "what is asked of a column is max(R_A), then its place")
    return Name(stage, of, column, place, unit)


def _staged(words: str) -> tuple[str, str]:
    """The stage before the first dot, if it is one; another word there is part of a nested fact."""
    stage, dot, what = words.partition(".")
    return (stage, what.strip()) if dot and (stage in STAGES or not WILD.isdisjoint(stage)) else ("", words)


def _fault(text: str, why: str, listed: bool = False) -> UsageError:
    remedy = f"of a column are asked: {', '.join(OF)}" if listed else EXAMPLES
    return UsageError(f"{show(text)} is no name of a result: {why}", remedy=remedy)


def like(word: str, pattern: str) -> bool:
    """Whether a word is of a pattern with ``*`` and ``?``; brackets stand for themselves.

    >>> like("R_A", "R_*"), like("k", "[k]")
    (True, False)
    """
    return fnmatchcase(word, pattern.replace("[", "[[]"))


def is_name(value: object) -> bool:
    """Whether a value that is a quantity or a name is meant as a name: neither a number nor one with a unit.

    >>> is_name("motion.delta"), is_name("35 deg"), is_name("35")
    (True, False, False)
    """
    return isinstance(value, str) and bool(value.strip()) and value.strip()[0] not in "+-.0123456789"


def rank(told: str, patterns: Sequence[str]) -> int | None:
    """Which of the patterns names a quantity, the first; None if none does.

    >>> import tmmcalc.rooms
    >>> rank("kinematics.stroke_D[m]", ["motion.*", "stroke_*"])
    1
    """
    name = parse(told)
    return next((at for at, pattern in enumerate(patterns) if parse(pattern).fits(name)), None)


def stages_of(patterns: Iterable[str], known: Iterable[str]) -> tuple[str, ...]:
    """The stages that the patterns ask about, none if one of them may be of any stage."""
    named, stages = [parse(pattern).stage for pattern in patterns], list(known)
    return tuple(stage for stage in stages if stage in named) if all(name in stages for name in named) else ()


def near(text: str, names: Iterable[str], what: str) -> str:
    """The names that are nearest to one that names nothing, or some of all, for the remedy of the error."""
    from difflib import get_close_matches  # late: only faults need it

    every, text = list(dict.fromkeys(names)), "".join(letter for letter in text if letter not in WILD)
    bare = {name.partition(".")[2]: name for name in every}  # the stage may be left out
    close = get_close_matches(text, every, 3, 0.5) or [bare[each] for each in get_close_matches(text, bare, 3, 0.5)]
    if close:
        return f"did you mean {', '.join(close)}?"
    rest = f" and {len(every) - SOME} more, see tmmcalc names" if len(every) > SOME + 1 else ""
    return f"{what}: {', '.join(every[:SOME] if rest else every) or 'none'}{rest}"
