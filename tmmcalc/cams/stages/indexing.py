"""Stage ``indexing``: a cam-lantern indexing drive, its limits, profiles, pressure angles and efficiency."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.indexing.results import Indexing
from tmmcalc.cams.indexing.task import IndexingTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables


def inputs(spec: CamTables) -> IndexingTask:
    """Everything but the tolerance of exported curves."""
    from dataclasses import replace

    from tmmcalc.cams.tables.tasks.indexing import to_indexing

    return replace(to_indexing(spec), tolerance=0.0)


def solve(given: IndexingTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Indexing:
    """Limits, lambda, both flanks at all rows, roller, efficiency."""
    from tmmcalc.cams.indexing.solve import solve_indexing

    return solve_indexing(given)


def columns(result: Indexing) -> Mapping[str, Any]:
    """One row a part of the step."""
    from tmmcalc.cams.indexing.columns import indexing_columns

    return indexing_columns(result)
