"""Derivatives of columns in every row of their tables: where over the cycle a number matters."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Unpack

import numpy as np

from tmmcalc.batch.points import run_of
from tmmcalc.batch.reading import frame_of
from tmmcalc.core.errors import UsageError
from tmmcalc.core.facts import named
from tmmcalc.core.records import record
from tmmcalc.design.sensitivity import Partial, Sensitivity, Ways, sensitivity
from tmmcalc.naming.keys import chosen
from tmmcalc.naming.language import like, near, parse
from tmmcalc.naming.rows import run_of as run_along
from tmmcalc.naming.table import Table, table_of
from tmmcalc.project.loader import Variants, read_text


@record
class Course:
    """The derivatives of one column by all keys, row by row."""

    column: str  # ``stage.column[unit]``
    labels: tuple[str, ...]  # (n,) of the rows
    over: str  # header of what the rows run over; empty: of nothing
    x: tuple[float, ...]  # (n,) their places there, else their numbers
    values: tuple[float, ...]  # (n,)
    partials: tuple[tuple[Partial, ...], ...]  # by key, of every row, the key that matters most first

    @property
    def telling(self) -> list[tuple[Partial, ...]]:
        """Those of keys of which one per cent does something, and has a meaning."""
        return [own for own in self.partials if largest(own) > 0]


def largest(own: Sequence[Partial]) -> float:
    """The largest change of a column for the whole of a key, over its rows; 0 of a key that is 0."""
    return max((abs(each.slope.value * each.value) for each in own if np.isfinite(each.slope.value)), default=0.0)


def courses(
    file: Path,
    columns: Sequence[str],
    to: Sequence[str] = (),
    fixed: Sequence[str] = (),
    **ways: Unpack[Ways],
) -> tuple[list[Course], Sensitivity]:
    """Derivatives of columns (names with wildcards, without a place) in all rows, and all of them by name.

    The rest is as for `sensitivity`. Raises UsageError too for a name that is none of a column.
    """
    data = Variants(read_text(file), str(file), file.parent, fixed).data
    frame = frame_of(file, fixed, chosen(data, to)[:1], columns)
    run = run_of(frame, frame.variants().spec())
    if run.failures:
        raise next(iter(run.failures.values()))
    tables = {stage: table for stage, result in run.results.items() if (table := table_of(stage, result)) is not None}
    asked = list(dict.fromkeys(each for pattern in columns for each in _columns(pattern, tables)))
    names = [f"{stage}.{named(header)[0]}@{label}" for stage, header in asked for label in tables[stage].labels]
    told = sensitivity(file, names, to, fixed, **ways)
    return [_course(stage, header, tables[stage], told) for stage, header in asked], told


def _columns(pattern: str, tables: Mapping[str, Table]) -> Iterator[tuple[str, str]]:
    """Stage and header of the columns of numbers that a name stands for."""
    name, found = parse(pattern), False
    for stage, table in tables.items() if name.fact else ():
        for at, header in enumerate(table.headers if name.may_be_of(stage) else ()):
            if like(named(header)[0], name.what) and np.asarray(table.make(at)).dtype.kind in "fi":
                found = True
                yield stage, header
    if not found:
        every = [f"{stage}.{named(header)[0]}" for stage, table in tables.items() for header in table.headers]
        remedy = near(pattern, every, "columns")
        raise UsageError(f"no column is called {pattern!r}", where="--curve", remedy=remedy)


def _course(stage: str, header: str, table: Table, told: Sensitivity) -> Course:
    column, unit = named(header)
    own = {f"{stage}.{column}@{label}" for label in table.labels}
    by_key: dict[str, list[Partial]] = {}
    for each in told.partials:
        if each.name.removesuffix(f"[{unit}]") in own:
            by_key.setdefault(each.key, []).append(each)
    along = run_along(table)
    x = table.column(along) if along else np.arange(len(table.labels), dtype=float)
    return Course(
        column=f"{stage}.{column}[{unit}]" if unit else f"{stage}.{column}",
        labels=tuple(table.labels),
        over=along or "",
        x=tuple(x.tolist()),
        values=tuple(table.column(header).tolist()),
        partials=tuple(sorted(map(tuple, by_key.values()), key=lambda each: -largest(each))),
    )
