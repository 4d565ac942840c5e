"""The manifest of the vibration room: the vibratory assembly device and the pendulum-rotor."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.manifest import Command, Room, table
from tmmcalc.core.stage import Picture, Stage

if TYPE_CHECKING:
    from tmmcalc.machine.room import MachineTables
    from tmmcalc.vibration.tables.pendulum import PendulumTable
    from tmmcalc.vibration.tables.vibrator import VibratorTable
else:
    MachineTables = object


class VibrationTables(MachineTables):
    """The tables of the room, beside those that its stages read of others."""

    vibrator: VibratorTable | None = table(
        "A vibratory assembly device.", subject=True, describes="a vibratory device", after="rotor"
    )
    pendulum: PendulumTable | None = table(
        "A pendulum-rotor: an elastic rod with a disc.", subject=True, describes="a pendulum-rotor"
    )


ROOM = Room(
    "vibration",
    VibrationTables,
    (
        Stage(
            "vibrator",
            "vibratory device: natural frequencies, steady vibration, starts",
            asked=("vibrator", "no vibratory device is asked for"),
            after="indexing",
            moves=True,
            picture=Picture("modes, resonance curve, starts, paths of points"),
            chapter="vibration",
            tells_data=True,
            studied=True,
        ),
        Stage(
            "pendulum",
            "pendulum-rotor: whirl, critical speeds, torsion, motion in time",
            asked=("pendulum", "no pendulum-rotor is asked for"),
            moves=True,
            picture=Picture("mode shapes, Campbell diagram, path of the end"),
            chapter="vibration",
            tells_data=True,
            studied=True,
        ),
    ),
    (
        Command("vibrator", "Vibratory device: frequencies, resonance curve, start-up."),
        Command("pendulum", "Pendulum-rotor: whirl, critical speeds, swing in time."),
    ),
    section="Machines",
    chapters={"vibration": "Vibration"},
)
