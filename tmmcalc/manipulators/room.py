"""The manifest of the manipulator room: arms, their paths, joints, singular places and obstacles."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.manifest import Command, Room, table
from tmmcalc.core.stage import Picture, Stage

if TYPE_CHECKING:
    from tmmcalc.manipulators.tables.manipulator import ManipulatorTable


class ManipulatorTables:
    """The tables of the room."""

    manipulator: ManipulatorTable | None = table(
        "A manipulator: its arm and its motion.",
        subject=True,
        describes="an arm",
        checks=("manipulator", "path", "joints", "zones"),
    )


ROOM = Room(
    "manipulators",
    ManipulatorTables,
    (
        Stage(
            "manipulator",
            "gripper and joints of a manipulator over the time",
            asked=("manipulator", "no arm is asked for"),
            picture=Picture("the path with points equally spaced in time, the arm, obstacles, the joints"),
            chapter="manipulator",
            tells_data=True,
            moves=True,
        ),
    ),
    (Command("manipulator", "Arms: gripper, joints, singular places, obstacles."),),
    section="Linkages",
    chapters={"manipulator": "Manipulator"},
)
