"""The document that a command prints: titled facts, notes, one table; or several such parts.

A fact has a text for people and values for programs, so that ``--format json`` loses no digit.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from typing import Any

from tmmcalc.core.quantity import in_degrees, quantities
from tmmcalc.core.records import record
from tmmcalc.report.numbers import number

Value = float | int | str | bool | None


@record
class Fact:
    """One line of a summary: a label and a text for people, named values for programs."""

    label: str
    text: str
    values: Mapping[str, Any] = field(default_factory=dict)
    meaning: str = ""  # of its values, where no quantity declares it and the label alone says too little


@record
class View:
    """A table: headers such as ``phi[deg]`` and columns of equal length, numbers or strings.

    ``peaks`` are the largest magnitudes of the columns that these rows were chosen from: what is noise against
    them is printed as 0. ``scientific`` names the headers of columns of many magnitudes, such as errors, which
    are printed in powers of ten. Of many rows one in ``every`` is there.
    """

    headers: Sequence[str]
    columns: Sequence[Sequence[Any]]
    peaks: Sequence[float] = ()
    scientific: Sequence[str] = ()
    every: int = 1


def said_of_rows(view: View | None) -> str:
    """What stands under a table of which not all rows are shown; nothing under another."""
    if view is None or view.every == 1:
        return ""
    return f"one position in {view.every}: --positions names others, --csv writes all of them to a file"


@record
class Document:
    """A titled summary with notes and a table, or the documents of several stages as ``parts``."""

    title: str
    facts: tuple[Fact, ...] = ()
    notes: tuple[str, ...] = ()
    table: View | None = None
    wide: bool = False  # the table may be cut to the width of the terminal
    more: str = ""  # said under a table that was cut
    parts: tuple[Document, ...] = ()  # each under its own title; programs find them by it
    name: str = ""  # what names of its facts begin with where other parts tell the same; empty: its title


def angles_in_degrees(document: Document) -> Document:
    """The document with the angles of its facts and its table in deg for programs too."""
    facts = tuple(replace(fact, values=in_degrees(fact.values)) for fact in document.facts)
    table = document.table
    if table is not None:
        columns = in_degrees(dict(zip(table.headers, table.columns, strict=True)))
        table = replace(table, headers=[*columns], columns=[*columns.values()])
    return replace(document, facts=facts, table=table, parts=tuple(map(angles_in_degrees, document.parts)))


def untold(facts: Iterable[Fact], of: Any, but: Collection[str] = ()) -> Iterator[Fact]:
    """A fact for every number that a record gives out and no fact tells; ``but`` are fields that need none.

    So a number that is declared on a record is told without being named again.
    """
    told = {key for fact in facts for key in fact.values}
    for name, each in quantities(type(of)).items():
        if name in but or each.key in told:
            continue
        value = getattr(of, name)
        if isinstance(value, int | float):
            yield Fact(each.meaning, f"{number(value)} {each.unit}".rstrip(), each.value(value))
