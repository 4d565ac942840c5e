"""Stage ``blocking``: the blocking contours of all external pairs, and where the chosen shifts stand."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmmcalc.core.conversion import largest
from tmmcalc.gears.meshing.contours import Blocking

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables

solve = "tmmcalc.gears.meshing.blocking:solve_blocking"
kind = Blocking
columns = "tmmcalc.gears.meshing.blocking:blocking_columns"
declares = ("contour", "line", "pair")


def inputs(spec: GearTables) -> None:
    """Nothing beside the pairs."""


def errors(result: Blocking) -> dict[str, Any]:
    """Estimates of its errors."""
    return largest([area.error for pair in result.pairs for area in (pair.strict, pair.tolerated)])
