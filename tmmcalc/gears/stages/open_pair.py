"""Stage ``open_pair``: what the open pair on the crank is to the drive, and what loads its teeth."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.stage import said
from tmmcalc.gears.openload import OpenLoad
from tmmcalc.gears.tables.tasks.open_pair import to_open_task

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables

inputs = to_open_task
solve = "tmmcalc.gears.openload:solve_open"
kind = OpenLoad
details = "tmmcalc.gears.details:of_open_pair"


def omits(spec: GearTables) -> tuple[str, ...]:
    """What is not checked."""
    return said((to_open_task(spec).pinion is None, "no material: no stresses of the open pair"))
