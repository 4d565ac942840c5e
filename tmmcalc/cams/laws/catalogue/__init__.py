"""The laws of motion by name, a module each: those of the textbook's table 5.1, and what is usual beside them.

A module is called as its law is in a spec, and has ``LAW`` and ``TITLE``, the words that people are told of it: a law
is a new module. Names are those of the files, and a law is made when it is asked for: to read a spec takes none.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.cams.laws.law import Law

# as table 5.1 has them, then two that are usual; all others follow by their names
ORDER = (
    *("sine", "cosine", "linear", "parab2", "const", "shun", "poly5", "poly4567"),
    *("modified_trapezoid", "modified_sine"),
)


def _names() -> tuple[str, ...]:
    found = {file.stem for file in Path(__file__).parent.glob("*.py")}
    others = sorted(found - {"__init__", *ORDER})
    return (*(name for name in ORDER if name in found), *others)


NAMES = _names()


class Catalogue(Mapping[str, "Law"]):
    """The laws by their names."""

    def __getitem__(self, name: str) -> Law:
        if name not in NAMES:
            raise KeyError(name)
        law: Law = import_module(f"{__name__}.{name}").LAW
        return law

    def __iter__(self) -> Iterator[str]:
        return iter(NAMES)

    def __len__(self) -> int:
        return len(NAMES)


LAWS = Catalogue()


def title_of(name: str) -> str:
    """What people are told of the law of this name.

    >>> title_of("shun")
    '3-4-5 polynomial'
    """
    title: str = import_module(f"{__name__}.{name}").TITLE
    return title


def law_of(name: str) -> Law:
    """The law of this name; raises `UsageError` with the known ones."""
    if name in LAWS:
        return LAWS[name]
    raise UsageError(f"no law of motion is called {name!r}", where="law", remedy=f"laws: {', '.join(LAWS)}")
