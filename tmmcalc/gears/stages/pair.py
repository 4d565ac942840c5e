"""Stage ``pair``: geometry, checks and measures of pairs of gears, written out or those of the chosen train."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import from_record, largest, to_record
from tmmcalc.core.stage import Record, Table
from tmmcalc.gears.meshing.results import Pairs
from tmmcalc.gears.meshing.task import PairsTask

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> PairsTask:
    """Teeth, racks, the choice of shifts, limits, what is measured."""
    from tmmcalc.gears.tables.tasks.pair import to_pairs

    return to_pairs(spec)


def solve(given: PairsTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Pairs:
    """Every pair."""
    from tmmcalc.gears.meshing.solve import solve_pairs

    return solve_pairs(given, upstream.get("criteria"))


def dump(result: Pairs) -> Record:
    """Arrays by the names of the fields: those of the first pair under ``pairs.0.``."""
    return to_record(result, largest([pair.error for pair in result.pairs]))


def load(record: Record) -> Pairs:
    """Build the result from its record."""
    result: Pairs = from_record(Pairs, record)
    return result


def table(result: Pairs) -> Table:
    """Sliding and pressure along the line of action, one pair after the other."""
    from tmmcalc.gears.meshing.columns import pair_columns

    columns = pair_columns(result)
    return Table(list(columns), list(columns.values()))
