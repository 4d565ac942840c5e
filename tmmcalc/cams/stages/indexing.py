"""Stage ``indexing``: a cam-lantern indexing drive, its limits, profiles, pressure angles and efficiency."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.cams.indexing.results import Indexing
from tmmcalc.cams.indexing.task import IndexingTask

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables

solve = "tmmcalc.cams.indexing.solve:solve_indexing"
kind = Indexing
columns = "tmmcalc.cams.indexing.columns:indexing_columns"
dense = "tmmcalc.cams.tables.tasks.placed:with_parts"
declares = ()


def inputs(spec: CamTables) -> IndexingTask:
    """Everything but the tolerance of exported curves."""
    from dataclasses import replace

    from tmmcalc.cams.tables.tasks.indexing import to_indexing

    return replace(to_indexing(spec), tolerance=0.0)
