"""Stage ``indexing``: a cam-lantern indexing drive, its limits, profiles, pressure angles and efficiency."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.indexing.results import Indexing
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.stage import Record, Table

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> IndexingTask:
    """Everything but the tolerance of exported curves."""
    from dataclasses import replace

    from tmmcalc.cams.tables.tasks.indexing import to_indexing

    return replace(to_indexing(spec), tolerance=0.0)


def solve(given: IndexingTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Indexing:
    """Limits, lambda, both flanks at all rows, roller, efficiency."""
    from tmmcalc.cams.indexing.solve import solve_indexing

    return solve_indexing(given)


def dump(result: Indexing) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, result.error)


def load(record: Record) -> Indexing:
    """Build the result from its record."""
    result: Indexing = from_record(Indexing, record)
    return result


def table(result: Indexing) -> Table:
    """One row a part of the step."""
    from tmmcalc.cams.indexing.columns import indexing_columns

    columns = indexing_columns(result)
    return Table(list(columns), list(columns.values()))
