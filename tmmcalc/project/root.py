"""The root of the spec: the tables of one project, as the rooms declare them."""

from __future__ import annotations

from types import GenericAlias
from typing import TYPE_CHECKING

from pydantic import Field

from tmmcalc.rooms import ROOMS, TABLES
from tmmcalc.spec.deferred import deferred
from tmmcalc.spec.project import ProjectTable
from tmmcalc.spec.table import Table


def _gathered() -> dict[str, object]:
    """The body of the root: a field for every table, built when a spec has it, and what rooms compute of theirs."""
    body: dict[str, object] = {
        "__doc__": "A project spec of tmmcalc: one TOML file that holds the whole task.",
        "__module__": __name__,
        "project": Field(default_factory=ProjectTable, description="What the work is called."),
    }
    annotations: dict[str, object] = {"project": ProjectTable}
    for name, entry in TABLES.items():
        table = deferred(f"{entry.home}.tables.{name}", entry.table)
        annotations[name] = GenericAlias(list, (table,)) if entry.several else table | None
        body[name] = Field(default=[] if entry.several else None, description=entry.description)
    for room in ROOMS:
        body |= room.properties
    return {"__annotations__": annotations, **body}


if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables
    from tmmcalc.extras.room import ExtraTables
    from tmmcalc.manipulators.room import ManipulatorTables
    from tmmcalc.vibration.room import VibrationTables

    class Spec(CamTables, VibrationTables, ManipulatorTables, ExtraTables, Table):
        """The root as type checkers see it."""

        project: ProjectTable
else:
    Spec = type(Table)("Spec", (Table,), _gathered())
