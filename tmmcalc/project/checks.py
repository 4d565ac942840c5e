"""Checks that reach across the tables of a spec: what it is about, what belongs to what, and those of each table.

Each check is a function from the outline of the raw document to its findings; those of a table stand in the ``CHECKS``
of its module. They never raise: what is not of the right type is left to the tables' own types.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from importlib import import_module
from typing import TYPE_CHECKING

from tmmcalc.rooms import ROOMS, TABLES
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw
from tmmcalc.spec.phrases import Path, either

if TYPE_CHECKING:
    from tmmcalc.spec.outline import Rows

Check = Callable[[Outline], Iterator[Finding]]

SUBJECTS = tuple(entry.name for room in ROOMS for entry in room.tables if entry.subject)
MAIN = SUBJECTS[0]  # that of most specs


def check(data: Raw, line_of: Callable[[Path], int | None], rows: Mapping[Path, Rows]) -> list[Finding]:
    """Return the findings of all checks on the raw document.

    ``line_of`` gives the line of a place, ``rows`` what was read from the CSV files of tables.
    """
    outline = Outline(data, line_of, rows)
    return [finding for rule in (check_subject, check_needs, *_of_tables(data)) for finding in rule(outline)]


def _of_tables(data: Raw) -> Iterator[Check]:
    """Yield the checks of the tables that are there; without the main subject one fault of what needs it is enough."""
    for entry in TABLES.values():
        if entry.name in data and (MAIN in data or entry.belongs_to != (MAIN,)):
            for module in entry.checks:
                yield from import_module(f"{entry.home}.tables.checks.{module}").CHECKS


def check_subject(outline: Outline) -> Iterator[Finding]:
    """A spec has a subject."""
    if {*SUBJECTS} & {*outline.document}:
        return
    from tmmcalc.project.words import words_of  # late: only faults need it

    first, *others = dict.fromkeys(TABLES[name].describes for name in SUBJECTS if TABLES[name].describes)
    headers = [TABLES[name].header for name in SUBJECTS[1:]]
    yield Finding(
        (MAIN,),
        f"missing key: a spec describes {first}, or else {either(others)}",
        f"add {words_of(MAIN).begin}; {either(headers)}",
    )


def check_needs(outline: Outline) -> Iterator[Finding]:
    """Tables that belong to others have one of them."""
    document = outline.document
    there = {*document, *(entry.gives for entry in TABLES.values() if entry.name in document)}
    lost = not {*SUBJECTS} & {*document}  # without any subject that is the fault
    for entry in TABLES.values():
        homes = {*entry.belongs_to, *entry.read_with}
        if entry.name not in document or not homes or homes & there or (lost and MAIN in homes):
            continue
        tables = " or ".join(f"[{name}]" for name in entry.belongs_to)
        rule = f"{entry.header} without {tables}: {entry.why}"
        yield Finding((entry.name,), rule, f"add {tables}, or remove it")
