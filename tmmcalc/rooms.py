"""The rooms of the house, as they stand in lists of their contents; and the tables and stages of all of them."""

from __future__ import annotations

from dataclasses import replace

from tmmcalc.cams.room import ROOM as CAMS
from tmmcalc.core.manifest import TABLES, merged
from tmmcalc.core.stage import EVERY, STAGES
from tmmcalc.extras.room import ROOM as EXTRAS
from tmmcalc.feasibility.room import ROOM as FEASIBILITY
from tmmcalc.gears.room import ROOM as GEARS
from tmmcalc.linkage.room import ROOM as LINKAGE
from tmmcalc.machine.room import ROOM as MACHINE
from tmmcalc.manipulators.room import ROOM as MANIPULATORS
from tmmcalc.vibration.room import ROOM as VIBRATION

__all__ = ["ROOMS", "STAGES", "TABLES"]

ROOMS = (LINKAGE, MACHINE, GEARS, CAMS, VIBRATION, MANIPULATORS, EXTRAS, FEASIBILITY)

TABLES |= merged([room.tables for room in ROOMS])
STAGES |= merged([room.stages for room in ROOMS])
STAGES |= {
    name: replace(stage, uses=tuple(each for each in STAGES if each != name))
    for name, stage in STAGES.items()
    if stage.uses == EVERY
}
