"""The manifest of the feasibility room: named constraints on results, and the rule that combines them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.manifest import Room, table
from tmmcalc.core.stage import EVERY, Picture, Stage

if TYPE_CHECKING:
    from tmmcalc.feasibility.tables.constraints import ConstraintTable
    from tmmcalc.feasibility.tables.feasibility import FeasibilityTable
    from tmmcalc.spec.project import Titled
else:
    Titled = object


class FeasibilityTables(Titled):
    """The tables of the room."""

    constraints: list[ConstraintTable] = table(
        "What results or given values must keep, by name.", subject=True, describes="constraints on given values"
    )
    feasibility: FeasibilityTable | None = table("How the constraints are combined.")


ROOM = Room(
    "feasibility",
    FeasibilityTables,
    (
        Stage(
            "feasibility",
            "whether results and given values keep the named constraints",
            uses=EVERY,
            reads="asked_about",
            asked=("constraints", "nothing is to be kept"),
            another=True,
            every=True,
            picture=Picture("the margin of every constraint, and the rule"),
            chapter="constraints",
        ),
    ),
    chapters={"constraints": "Constraints"},
)
