"""Stage ``blocking``: the blocking contours of all external pairs, and where the chosen shifts stand."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import largest
from tmmcalc.gears.meshing.contours import Blocking

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables


def inputs(spec: GearTables) -> None:
    """Nothing beside the pairs."""


def solve(given: None, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Blocking:
    """The contours of every external pair."""
    from tmmcalc.gears.meshing.blocking import solve_blocking

    return solve_blocking(upstream["pair"])


def errors(result: Blocking) -> dict[str, Any]:
    """Estimates of its errors."""
    return largest([area.error for pair in result.pairs for area in (pair.strict, pair.tolerated)])


def columns(result: Blocking) -> Mapping[str, Any]:
    """The boundary of every contour, one point a row."""
    from tmmcalc.gears.meshing.blocking import blocking_columns

    return blocking_columns(result)
