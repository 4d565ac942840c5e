"""The root of the spec: the tables of one project, as the rooms declare them."""

from __future__ import annotations

from operator import attrgetter
from pathlib import Path as FilePath
from types import GenericAlias
from typing import TYPE_CHECKING

from pydantic import Field, PrivateAttr

from tmmcalc.rooms import ROOMS, TABLES
from tmmcalc.spec.deferred import deferred
from tmmcalc.spec.outline import Raw
from tmmcalc.spec.phrases import Path
from tmmcalc.spec.project import ProjectTable
from tmmcalc.spec.table import Table


def _gathered() -> dict[str, object]:
    """The body of the root: a field for every table, built when a spec has it, and what rooms compute of theirs."""
    body: dict[str, object] = {
        "__doc__": "A project spec of tmmcalc: one TOML file that holds the whole task.",
        "__module__": __name__,
        "_written": PrivateAttr(default=None),
        "project": Field(default_factory=ProjectTable, description="What the work is called."),
    }
    annotations: dict[str, object] = {"project": ProjectTable}
    for name, entry in TABLES.items():
        table = deferred(f"{entry.home}.tables.{entry.module}", entry.table)
        annotations[name] = GenericAlias(list, (table,)) if entry.several else table | None
        body[name] = Field(default=[] if entry.several else None, description=entry.description)
        if entry.module != name:
            body[entry.module] = property(attrgetter(name))
    for room in ROOMS:
        body |= room.properties
    return {"__annotations__": annotations, **body}


class Written:
    """The text that a spec was read from, and its document with overrides and with what its files hold.

    ``changed`` are the paths that do not stand in the text. Two specs of the same values are equal, wherever they come
    from, so any two of these are.
    """

    def __init__(self, document: Raw, text: str, file: str, changed: tuple[Path, ...], folder: FilePath) -> None:
        self.document, self.text, self.file, self.changed, self.folder = document, text, file, changed, folder

    def __eq__(self, other: object) -> bool:
        return other is None or isinstance(other, Written)

    def __hash__(self) -> int:
        return 0


if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables
    from tmmcalc.extras.room import ExtraTables
    from tmmcalc.manipulators.room import ManipulatorTables
    from tmmcalc.rooms import Asked, Shared, Taught
    from tmmcalc.vibration.room import VibrationTables

    class Spec(CamTables, VibrationTables, ManipulatorTables, ExtraTables, Shared, Asked, Taught, Table):
        """The root as type checkers see it."""

        project: ProjectTable
        _written: Written | None
else:
    Spec = type(Table)("Spec", (Table,), _gathered())
