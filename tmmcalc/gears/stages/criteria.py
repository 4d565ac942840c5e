"""Stage ``criteria``: mass, inertia, size and efficiency of all strong trains, and the best of them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import from_record, largest, to_record
from tmmcalc.core.stage import Record, Table
from tmmcalc.gears.selection.results import Selection
from tmmcalc.gears.selection.task import SelectionTask

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> SelectionTask:
    """Objectives, weights, the way of choosing, efficiencies of meshes."""
    from tmmcalc.gears.tables.tasks.sizing import to_selection

    return to_selection(spec)


def solve(given: SelectionTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Selection:
    """Weigh every train that is strong enough, and choose."""
    from tmmcalc.gears.selection.solve import solve_selection

    return solve_selection(upstream["train"], upstream["strength"], given)


def dump(result: Selection) -> Record:
    """Arrays by the names of the fields, those of the first variant under ``variants.0.``."""
    return to_record(result, largest([variant.error for variant in result.variants]))


def load(record: Record) -> Selection:
    """Build the result from its record."""
    result: Selection = from_record(Selection, record)
    return result


def table(result: Selection) -> Table:
    """All trains, one a row, one variant after the other."""
    from tmmcalc.gears.selection.columns import chosen_columns

    columns = chosen_columns(result)
    return Table(list(columns), list(columns.values()))
