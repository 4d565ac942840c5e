"""Where a document names files: the keys that the manifests tell."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.core.manifest import Entry
from tmmcalc.rooms import TABLES
from tmmcalc.spec.csvtables import CHOICE
from tmmcalc.spec.outline import Raw, subtable, tables
from tmmcalc.spec.phrases import Path

TABLE = "file"  # the key of a table in CSV; other keys name files that a room reads itself


def names_files(data: Raw) -> bool:
    """Whether a document names a file, or columns of one; what is misplaced is none."""
    return any({key, CHOICE} & {*table} for entry, steps, key in keys() for _, table in places(data, entry, steps))


def keys() -> list[tuple[Entry, list[str], str]]:
    """The keys that name files, tables in CSV first: the table of the root, the keys to what holds the key, the key."""
    split = [(entry, key.split(".")) for entry in TABLES.values() for key in entry.files]
    return sorted(((entry, steps[:-1], steps[-1]) for entry, steps in split), key=lambda each: each[2] != TABLE)


def places(data: Raw, entry: Entry, steps: list[str]) -> Iterator[tuple[Path, Raw]]:
    """Yield the tables that may hold such a key, each with its path."""
    given: list[tuple[Path, Raw]] = [((entry.name,), subtable(data, entry.name))]
    if entry.several:
        given = [((entry.name, index), table) for index, table in tables(data, entry.name)]
    for path, table in given:
        inner = table
        for step in steps:
            inner = subtable(inner, step)
        yield (*path, *steps), inner
