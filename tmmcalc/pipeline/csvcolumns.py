"""Which columns the CSV files of a run have, where names are given: those of the tables, and those by choice."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

from tmmcalc.core.columns import Column, nearest
from tmmcalc.core.errors import UsageError
from tmmcalc.core.stored import DeferredColumns, Table, matches
from tmmcalc.naming.scene import Scene

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import Outcome


def by_choice(names: Sequence[str], outcomes: Mapping[str, Outcome], scene: Scene) -> dict[str, list[Column]]:
    """Of every stage the columns by choice of those names that no table has: a wildcard means the tables first.

    Raises UsageError for a name that no stage of the run has, with the nearest.
    """
    tables = {stage: outcome.table for stage, outcome in outcomes.items()}
    headers = [header for table in tables.values() if table is not None for header in table.header]
    missed = [name for name in names if not any(matches(header, name) for header in headers)]
    further = {stage: scene.further(stage) for stage, table in tables.items() if table is not None and missed}
    for name in missed:
        if not any(matches(column.header, name) for columns in further.values() for column in columns):
            every = [header.partition("[")[0] for header in headers]
            every += [column.name for columns in further.values() for column in columns]
            remedy = nearest(list(dict.fromkeys(every)), name)
            raise UsageError(f"no stage has a column called {name!r}", where="--columns", remedy=remedy)
    chosen = {
        stage: [column for column in columns if any(matches(column.header, name) for name in missed)]
        for stage, columns in further.items()
    }
    return {stage: columns for stage, columns in chosen.items() if columns}


def with_columns(table: Table, further: Sequence[Column]) -> Table:
    """The table with columns by choice behind its own; NaN is where they have no value."""
    own = [partial(table.columns.__getitem__, k) for k in range(len(table.header))]
    header = [*table.header, *(each.header for each in further)]
    return Table(header, DeferredColumns([*own, *(each.make for each in further)]))
