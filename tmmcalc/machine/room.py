"""The manifest of the machine room: reduction, power, flywheel, motion, motions in time and balance of machines."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.manifest import Command, Room, table
from tmmcalc.core.stage import TOLERANCE, Picture, Stage

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables
    from tmmcalc.machine.tables.balance import BalanceTable
    from tmmcalc.machine.tables.engine import EngineTable
    from tmmcalc.machine.tables.flywheel import FlywheelTable
    from tmmcalc.machine.tables.motion import MotionTable
    from tmmcalc.machine.tables.motor import MotorTable
    from tmmcalc.machine.tables.reduction import ReductionTable
    from tmmcalc.machine.tables.rotor import RotorTable
    from tmmcalc.machine.tables.shafts import ShaftTable
    from tmmcalc.machine.tables.torque import TorqueTable
    from tmmcalc.machine.tables.transients import TransientTable
    from tmmcalc.machine.tables.transmission import TransmissionTable
else:
    GearTables = object

LINKS, MACHINE = ("mechanism",), ("mechanism", "torque")


class MachineTables(GearTables):
    """The tables of the room, beside those that its stages read of others."""

    torque: TorqueTable | None = table(
        "A torque diagram in place of a linkage.",
        subject=True,
        describes="a torque diagram",
        files=("table.file", "reduced_inertia.file"),
    )
    motor: MotorTable | None = table(
        "The motor.",
        belongs_to=MACHINE,
        why="there is nothing that it drives",
        read_with=("vibrator",),
        files=("catalogue", "table.file"),
        after="drive",
    )
    transmission: TransmissionTable | None = table(
        "The gears between the motor and the crank.",
        belongs_to=MACHINE,
        why="there is nothing that it drives",
        checks=(),
    )
    shafts: list[ShaftTable] = table(
        "The elastic drive from the motor to the crank.",
        belongs_to=MACHINE,
        why="there is nothing that they drive",
        named=("shaft_names", "name"),
    )
    reduction: ReductionTable | None = table(
        "How forces and masses are reduced to the crank.",
        belongs_to=LINKS,
        why="forces and masses are those of a mechanism",
        checks=(),
    )
    motion: MotionTable | None = table(
        "How the motion of the machine is found.", belongs_to=MACHINE, why="there is nothing that moves"
    )
    transients: list[TransientTable] = table(
        "Motions in time.",
        belongs_to=MACHINE,
        why="there is nothing that moves",
        named=("transient_names", "name"),
    )
    flywheel: FlywheelTable | None = table(
        "The flywheel: asked for, or given.",
        belongs_to=MACHINE,
        why="there is nothing whose speed it evens out",
        after="manipulator",
    )
    balance: BalanceTable | None = table(
        "Balancing of the linkage.", belongs_to=LINKS, why="the masses are those of a mechanism"
    )
    engine: EngineTable | None = table("Balance of an engine with several cranks.", subject=True, describes="an engine")
    rotor: RotorTable | None = table("Static and two-plane balancing of a rotor.", subject=True, describes="a rotor")


ROOM = Room(
    "machine",
    MachineTables,
    (
        Stage(
            "reduction",
            "reduced moments and inertia, work per cycle",
            uses=("kinematics",),
            wanted="reduction",
            after="cam_load",
            chapter="reduction",
            picture=Picture("reduced moments and inertia", pieces="tmmcalc.machine.pictures.pieces:of_reduction"),
            studied=True,
        ),
        Stage(
            "drive",
            "the ratio that motor and crank give the train",
            uses=("reduction",),
            reads="read_by_drive",
            chapter="reduction",
            wanted="drive",
        ),
        Stage(
            "power",
            "work per cycle, efficiency, power, the motor",
            needs=("reduction",),
            uses=("criteria", "drive"),
            reads="read_by_power",
            chapter="reduction",
            wanted="power",
            after="profile",
            studied=True,
        ),
        Stage(
            "flywheel",
            "the flywheel for the allowed unevenness, by all methods",
            needs=("reduction", "power"),
            wanted="flywheel",
            by_name={"tried": False},
            picture=Picture(
                "energy-mass curve with its tangents, all methods; constructions and what is read from them",
                pieces="tmmcalc.machine.pictures.pieces:of_flywheel",
            ),
            studied=True,
            chapter="motion",
        ),
        Stage(
            "motion",
            "steady motion of the machine: speed over the cycle",
            needs=("reduction", "power"),
            uses=("flywheel",),
            reads="read_by_motion",
            wanted="motion",
            settings=TOLERANCE,
            picture=Picture(
                "speed and moments over the cycle, the motor's characteristic",
                pieces="tmmcalc.machine.pictures.pieces:of_motion",
            ),
            studied=True,
            chapter="motion",
        ),
        Stage(
            "transient",
            "start-up, braking, run-down, load changes in time",
            needs=("reduction", "power"),
            uses=("flywheel",),
            reads="read_by_motion",
            wanted="transient",
            settings=TOLERANCE,
            picture=Picture("speeds and moments over the time"),
            studied=True,
            chapter="motion",
        ),
        Stage(
            "balance",
            "shaking forces and their balancing",
            uses=("kinematics",),
            wanted="balance",
            chapter="balance",
            after="manipulator",
            picture=Picture(
                "hodographs of the shaking force, what the schemes leave of it, an engine's force and couple",
                pieces="tmmcalc.machine.pictures.pieces:of_balance",
            ),
            studied=True,
        ),
    ),
    (
        Command("reduce", "Reduced moments and inertia, work per cycle."),
        Command("power", "Work per cycle, efficiency, power, choice of the motor."),
        Command("flywheel", "The flywheel for the allowed unevenness, by all methods."),
        Command("motion", "Steady motion of the machine over the cycle."),
        Command("transient", "Start-up, braking, run-down, load changes in time."),
        Command("balance", "Shaking forces of linkage, engine, rotor; counterweights."),
    ),
    section="Machines",
    chapters={
        "reduction": "Reduction of forces and masses",
        "motion": "Motion of the machine and flywheel",
        "balance": "Balancing",
    },
    gives=True,
)
