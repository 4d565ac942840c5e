"""Stage ``pair``: geometry, checks and measures of pairs of gears, written out or those of the chosen train."""

from __future__ import annotations

from typing import Any

from tmmcalc.core.conversion import largest
from tmmcalc.gears.meshing.results import Pairs
from tmmcalc.gears.tables.tasks.pair import to_pairs

inputs = to_pairs
solve = "tmmcalc.gears.meshing.solve:solve_pairs"
kind = Pairs
columns = "tmmcalc.gears.meshing.columns:pair_columns"
declares = ("pair", "tmmcalc.gears.meshing.further")
details = "tmmcalc.gears.details:of_pair"
further = "tmmcalc.gears.meshing.further:further_columns"


def errors(result: Pairs) -> dict[str, Any]:
    """Estimates of its errors."""
    return largest([pair.error for pair in result.pairs])
