"""Stage ``blocking``: the blocking contours of all external pairs, and where the chosen shifts stand."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import from_record, largest, to_record
from tmmcalc.core.stage import Record, Table
from tmmcalc.gears.meshing.contours import Blocking

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> None:
    """Nothing beside the pairs."""


def solve(given: None, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Blocking:
    """The contours of every external pair."""
    from tmmcalc.gears.meshing.blocking import solve_blocking

    return solve_blocking(upstream["pair"])


def dump(result: Blocking) -> Record:
    """Arrays by the names of the fields: ``pairs.0.strict.main.x1``, ..."""
    return to_record(result, largest([area.error for pair in result.pairs for area in (pair.strict, pair.tolerated)]))


def load(record: Record) -> Blocking:
    """Build the result from its record."""
    result: Blocking = from_record(Blocking, record)
    return result


def table(result: Blocking) -> Table:
    """The boundary of every contour, one point a row."""
    from tmmcalc.gears.meshing.blocking import blocking_columns

    columns = blocking_columns(result)
    return Table(list(columns), list(columns.values()))
