"""The root of the spec: the tables of one project."""

from typing import TYPE_CHECKING

from pydantic import Field

from tmmcalc.core.errors import UsageError
from tmmcalc.project.project_table import ProjectTable
from tmmcalc.spec.late import late
from tmmcalc.spec.table import Table

if TYPE_CHECKING:
    from tmmcalc.cams.tables.cam import CamTable
    from tmmcalc.cams.tables.indexing import IndexingTable
    from tmmcalc.extras.tables.bearing import BearingTable
    from tmmcalc.extras.tables.contact import ContactTable
    from tmmcalc.extras.tables.falling_ball import FallingBallTable
    from tmmcalc.extras.tables.reliability import ReliabilityTable
    from tmmcalc.extras.tables.tie_down import TieDownTable
    from tmmcalc.feasibility.tables.constraints import ConstraintTable, FeasibilityTable
    from tmmcalc.gears.tables.criteria import CriteriaTable
    from tmmcalc.gears.tables.gearing import GearingTable
    from tmmcalc.gears.tables.pair import PairTable
    from tmmcalc.gears.tables.strength import StrengthTable
    from tmmcalc.gears.tables.train import TrainTable
    from tmmcalc.linkage.tables.drive import DriveTable
    from tmmcalc.linkage.tables.loads import LoadTable
    from tmmcalc.linkage.tables.mechanism import MechanismTable
    from tmmcalc.linkage.tables.springs import SpringTable
    from tmmcalc.linkage.tables.synthesis import LinkSynthesisTable
    from tmmcalc.linkage.tables.unsteady import UnsteadyTable
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
    from tmmcalc.manipulators.tables.manipulator import ManipulatorTable
    from tmmcalc.vibration.tables.pendulum import PendulumTable
    from tmmcalc.vibration.tables.vibrator import VibratorTable
else:
    BalanceTable = late("machine.tables.balance", "BalanceTable")
    CamTable = late("cams.tables.cam", "CamTable")
    ConstraintTable = late("feasibility.tables.constraints", "ConstraintTable")
    CriteriaTable = late("gears.tables.criteria", "CriteriaTable")
    DriveTable = late("linkage.tables.drive", "DriveTable")
    EngineTable = late("machine.tables.engine", "EngineTable")
    FeasibilityTable = late("feasibility.tables.constraints", "FeasibilityTable")
    FallingBallTable = late("extras.tables.falling_ball", "FallingBallTable")
    BearingTable = late("extras.tables.bearing", "BearingTable")
    ContactTable = late("extras.tables.contact", "ContactTable")
    ReliabilityTable = late("extras.tables.reliability", "ReliabilityTable")
    TieDownTable = late("extras.tables.tie_down", "TieDownTable")
    FlywheelTable = late("machine.tables.flywheel", "FlywheelTable")
    GearingTable = late("gears.tables.gearing", "GearingTable")
    IndexingTable = late("cams.tables.indexing", "IndexingTable")
    LinkSynthesisTable = late("linkage.tables.synthesis", "LinkSynthesisTable")
    LoadTable = late("linkage.tables.loads", "LoadTable")
    ManipulatorTable = late("manipulators.tables.manipulator", "ManipulatorTable")
    MechanismTable = late("linkage.tables.mechanism", "MechanismTable")
    MotionTable = late("machine.tables.motion", "MotionTable")
    MotorTable = late("machine.tables.motor", "MotorTable")
    PairTable = late("gears.tables.pair", "PairTable")
    PendulumTable = late("vibration.tables.pendulum", "PendulumTable")
    ReductionTable = late("machine.tables.reduction", "ReductionTable")
    RotorTable = late("machine.tables.rotor", "RotorTable")
    ShaftTable = late("machine.tables.shafts", "ShaftTable")
    SpringTable = late("linkage.tables.springs", "SpringTable")
    StrengthTable = late("gears.tables.strength", "StrengthTable")
    TorqueTable = late("machine.tables.torque", "TorqueTable")
    TrainTable = late("gears.tables.train", "TrainTable")
    TransientTable = late("machine.tables.transients", "TransientTable")
    TransmissionTable = late("machine.tables.transmission", "TransmissionTable")
    UnsteadyTable = late("linkage.tables.unsteady", "UnsteadyTable")
    VibratorTable = late("vibration.tables.vibrator", "VibratorTable")


class Spec(Table):
    """A project spec of tmmcalc: one TOML file that holds the whole task."""

    project: ProjectTable = Field(default_factory=ProjectTable, description="What the work is called.")
    mechanism: MechanismTable | None = Field(default=None, description="The linkage.")
    synthesis: LinkSynthesisTable | None = Field(default=None, description="A linkage to be found by what it is to do.")
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
    unsteady: UnsteadyTable | None = Field(
        default=None, description="A motion of the mechanism from rest to rest by the time-optimal law."
    )
    manipulator: ManipulatorTable | None = Field(default=None, description="A manipulator: its arm and its motion.")
    flywheel: FlywheelTable | None = Field(default=None, description="The flywheel: asked for, or given.")
    balance: BalanceTable | None = Field(default=None, description="Balancing of the linkage.")
    engine: EngineTable | None = Field(default=None, description="Balance of an engine with several cranks.")
    rotor: RotorTable | None = Field(default=None, description="Static and two-plane balancing of a rotor.")
    vibrator: VibratorTable | None = Field(default=None, description="A vibratory assembly device.")
    pendulum: PendulumTable | None = Field(default=None, description="A pendulum-rotor: an elastic rod with a disc.")
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
    indexing: IndexingTable | None = Field(
        default=None, description="Two paired cams that turn a wheel of rollers step by step."
    )
    contact: ContactTable | None = Field(default=None, description="Two elastic bodies that are pressed together.")
    reliability: ReliabilityTable | None = Field(
        default=None, description="A product whose strength falls while shock loads strike it."
    )
    tie_down: TieDownTable | None = Field(default=None, description="Ties that hold a load on a vehicle.")
    falling_ball: FallingBallTable | None = Field(
        default=None, description="A ball that falls while its radius decreases."
    )
    bearing: BearingTable | None = Field(
        default=None, description="A rolling bearing and the frequencies of its defects."
    )

    constraints: list[ConstraintTable] = Field(default=[], description="What results must keep, by name.")
    feasibility: FeasibilityTable | None = Field(default=None, description="How the constraints are combined.")

    @property
    def linkage(self) -> MechanismTable:
        """The mechanism, where one is needed; raises UsageError if the spec has none."""
        if self.mechanism is None:
            raise UsageError(
                "the spec has no [mechanism]", remedy="add [mechanism], or ask for a stage that needs none"
            )
        return self.mechanism
