"""The variants of a sweep for a page: the keys that lead the rows of its CSV, as overrides of the spec."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from tmmcalc.batch.table import key_and_unit
from tmmcalc.core.errors import UsageError
from tmmcalc.core.stage import STAGES
from tmmcalc.project.loader import read_text

MOST = 24  # variants that a page has: of more, so many in equal steps


class Swept(NamedTuple):
    """Swept keys, and of each variant its name and the overrides that make it."""

    key: str
    variants: tuple[tuple[str, tuple[str, ...]], ...]


def swept(file: Path) -> Swept:
    """The variants of a CSV of ``tmmcalc sweep`` that were solved; raises `UsageError` if it is none."""
    rows = list(csv.reader(read_text(file).splitlines()))
    head = rows[0] if rows else []
    keys = _keys(head)
    if not keys or "status" not in head:
        raise UsageError(
            f"{file} is no table of a sweep: its first column is no swept key, or it has no column status",
            where="--sweep",
            remedy="write one by tmmcalc sweep SPEC --set KEY=RANGE -o FILE",
        )
    status = head.index("status")
    solved = [row for row in rows[1:] if len(row) == len(head) and row[status] == "ok"]
    if not solved:
        raise UsageError(
            f"no variant of {file} is solved", where="--sweep", remedy="see the reasons in its last column"
        )
    step = max(1, -(-len(solved) // MOST))
    parts = [*map(key_and_unit, keys)]
    variants = []
    for row in solved[::step]:
        written = [f"{value} {unit}".strip() for value, (_, unit) in zip(row, parts, strict=False)]
        overrides = tuple(_override(key, each) for (key, _), each in zip(parts, written, strict=True))
        variants.append((", ".join(written), overrides))
    return Swept(", ".join(key for key, _ in parts), tuple(variants))


def _keys(head: Sequence[str]) -> list[str]:
    """The headers that lead the table and are keys of a spec: behind the first a stage begins the results."""
    found: list[str] = []
    for header in head:
        first, dot, _ = header.partition(".")
        if header in ("status", "reason") or not dot or (found and first in STAGES):
            break
        found.append(header)
    return found


def _override(key: str, written: str) -> str:
    """A value of a key as an override; one with a unit is a text."""
    return f'{key}="{written}"' if " " in written else f"{key}={written}"
