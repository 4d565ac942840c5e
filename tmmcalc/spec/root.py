"""The root of the spec: the tables of one project."""

from typing import TYPE_CHECKING

from pydantic import Field

from tmmcalc.errors import UsageError

from .late import late
from .mechanism import MechanismTable
from .project import ProjectTable
from .table import Table

if TYPE_CHECKING:
    from .balance import BalanceTable
    from .cam import CamTable
    from .criteria import CriteriaTable
    from .drive import DriveTable
    from .engine import EngineTable
    from .flywheel import FlywheelTable
    from .gearing import GearingTable
    from .loads import LoadTable
    from .motion import MotionTable
    from .motor import MotorTable
    from .pair import PairTable
    from .reduction import ReductionTable
    from .rotor import RotorTable
    from .shafts import ShaftTable
    from .springs import SpringTable
    from .strength import StrengthTable
    from .torque import TorqueTable
    from .train import TrainTable
    from .transients import TransientTable
    from .transmission import TransmissionTable
else:
    BalanceTable = late("balance", "BalanceTable")
    CamTable = late("cam", "CamTable")
    CriteriaTable = late("criteria", "CriteriaTable")
    DriveTable = late("drive", "DriveTable")
    EngineTable = late("engine", "EngineTable")
    FlywheelTable = late("flywheel", "FlywheelTable")
    GearingTable = late("gearing", "GearingTable")
    LoadTable = late("loads", "LoadTable")
    MotionTable = late("motion", "MotionTable")
    MotorTable = late("motor", "MotorTable")
    PairTable = late("pair", "PairTable")
    ReductionTable = late("reduction", "ReductionTable")
    RotorTable = late("rotor", "RotorTable")
    ShaftTable = late("shafts", "ShaftTable")
    SpringTable = late("springs", "SpringTable")
    StrengthTable = late("strength", "StrengthTable")
    TorqueTable = late("torque", "TorqueTable")
    TrainTable = late("train", "TrainTable")
    TransientTable = late("transients", "TransientTable")
    TransmissionTable = late("transmission", "TransmissionTable")


class Spec(Table):
    """A project spec of tmmcalc: one TOML file that holds the whole task."""

    project: ProjectTable = Field(default_factory=ProjectTable, description="What the work is called.")
    mechanism: MechanismTable | None = Field(default=None, description="The linkage.")
    torque: TorqueTable | None = Field(default=None, description="A torque diagram in place of a linkage.")
    loads: list[LoadTable] = Field(default=[], description="Technological forces and moments on the links.")
    springs: list[SpringTable] = Field(default=[], description="Springs and dampers between links.")
    drive: DriveTable | None = Field(default=None, description="How the drive acts on the crank.")
    motor: MotorTable | None = Field(default=None, description="The motor.")
    transmission: TransmissionTable | None = Field(
        default=None, description="The gears between the motor and the crank."
    )
    shafts: list[ShaftTable] = Field(default=[], description="The elastic drive from the motor to the crank.")
    reduction: ReductionTable | None = Field(
        default=None, description="How forces and masses are reduced to the crank."
    )
    motion: MotionTable | None = Field(default=None, description="How the motion of the machine is found.")
    transients: list[TransientTable] = Field(default=[], description="Motions in time.")
    flywheel: FlywheelTable | None = Field(default=None, description="The flywheel: asked for, or given.")
    balance: BalanceTable | None = Field(default=None, description="Balancing of the linkage.")
    engine: EngineTable | None = Field(default=None, description="Balance of an engine with several cranks.")
    rotor: RotorTable | None = Field(default=None, description="Static and two-plane balancing of a rotor.")
    train: TrainTable | None = Field(default=None, description="The gear train: layout, ratio, tooth numbers.")
    gearing: GearingTable | None = Field(
        default=None, description="A train of gears that is written out: its meshes, known speeds and torques."
    )
    strength: StrengthTable | None = Field(
        default=None, description="Strength of the train: torque, materials, modules and face widths."
    )
    criteria: CriteriaTable | None = Field(default=None, description="By what the best train is chosen.")
    pair: PairTable | None = Field(
        default=None, description="Pairs of gears: written out, or those of the train that is chosen."
    )
    cam: CamTable | None = Field(default=None, description="A disk cam and its follower.")

    @property
    def linkage(self) -> MechanismTable:
        """The mechanism, where one is needed; raises UsageError if the spec has none."""
        if self.mechanism is None:
            raise UsageError(
                "the spec has no [mechanism]", remedy="add [mechanism], or ask for a stage that needs none"
            )
        return self.mechanism
