"""The rooms of the house, as they stand in lists of their contents; and the tables and stages of all of them."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tmmcalc.cams.room import ROOM as CAMS
from tmmcalc.core.manifest import TABLES, entries, merged, table
from tmmcalc.core.stage import EVERY, STAGES
from tmmcalc.extras.room import ROOM as EXTRAS
from tmmcalc.feasibility.room import ROOM as FEASIBILITY
from tmmcalc.gears.room import ROOM as GEARS
from tmmcalc.linkage.room import ROOM as LINKAGE
from tmmcalc.machine.room import ROOM as MACHINE
from tmmcalc.manipulators.room import ROOM as MANIPULATORS
from tmmcalc.vibration.room import ROOM as VIBRATION

if TYPE_CHECKING:
    from tmmcalc.classroom.tables.class_ import ClassTable
    from tmmcalc.design.tables.optimize import OptimizeTable
    from tmmcalc.design.tables.tolerances import ToleranceTable
    from tmmcalc.report.tables.note import NoteTable
    from tmmcalc.report.tables.sheets import SheetsTable

__all__ = ["CHAPTERS", "ROOMS", "STAGES", "TABLES", "Asked", "Shared", "Taught"]

ROOMS = (LINKAGE, MACHINE, GEARS, CAMS, VIBRATION, MANIPULATORS, EXTRAS, FEASIBILITY)


class Shared:
    """The tables that belong to no room."""

    sheets: SheetsTable | None = table("The drawings that are handed in.")
    note: NoteTable | None = table("The explanatory note that is handed in.")


class Asked:
    """The tables of what is asked of a design as a whole."""

    tolerances: list[ToleranceTable] = table(
        "How far dimensions may be from what the spec says, and the play of pairs.", files=("measurements",)
    )
    optimize: OptimizeTable | None = table("What is sought, and what may be changed for it.")


class Taught:
    """The table of a spec that many get, each with numbers of their own."""

    class_: ClassTable | None = table("What a class is given, and what it is asked.")


TABLES |= merged(
    [
        *(room.tables for room in ROOMS),
        entries("tmmcalc.report", Shared),
        entries("tmmcalc.design", Asked),
        entries("tmmcalc.classroom", Taught),
    ]
)
CHAPTERS = {name: title for room in ROOMS for name, title in room.chapters.items()}  # of the note
STAGES |= merged([room.stages for room in ROOMS])
STAGES |= {
    name: replace(stage, uses=tuple(each for each in STAGES if each != name))
    for name, stage in STAGES.items()
    if stage.uses == EVERY
}
