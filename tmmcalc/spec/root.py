"""The root of the spec: the tables of one project."""

from typing import TYPE_CHECKING

from pydantic import Field

from tmmcalc.errors import UsageError

from .late import late
from .project import ProjectTable
from .table import Table

if TYPE_CHECKING:
    from .balance import BalanceTable
    from .cam import CamTable
    from .constraints import ConstraintTable, FeasibilityTable
    from .criteria import CriteriaTable
    from .drive import DriveTable
    from .engine import EngineTable
    from .extraball import FallingBallTable
    from .extrabearing import BearingTable
    from .extracontact import ContactTable
    from .extrareliability import ReliabilityTable
    from .extratiedown import TieDownTable
    from .flywheel import FlywheelTable
    from .gearing import GearingTable
    from .indexing import IndexingTable
    from .linksynthesis import LinkSynthesisTable
    from .loads import LoadTable
    from .manipulator import ManipulatorTable
    from .mechanism import MechanismTable
    from .motion import MotionTable
    from .motor import MotorTable
    from .pair import PairTable
    from .pendulum import PendulumTable
    from .reduction import ReductionTable
    from .rotor import RotorTable
    from .shafts import ShaftTable
    from .springs import SpringTable
    from .strength import StrengthTable
    from .torque import TorqueTable
    from .train import TrainTable
    from .transients import TransientTable
    from .transmission import TransmissionTable
    from .unsteady import UnsteadyTable
    from .vibrator import VibratorTable
else:
    BalanceTable = late("balance", "BalanceTable")
    CamTable = late("cam", "CamTable")
    ConstraintTable = late("constraints", "ConstraintTable")
    CriteriaTable = late("criteria", "CriteriaTable")
    DriveTable = late("drive", "DriveTable")
    EngineTable = late("engine", "EngineTable")
    FeasibilityTable = late("constraints", "FeasibilityTable")
    FallingBallTable = late("extraball", "FallingBallTable")
    BearingTable = late("extrabearing", "BearingTable")
    ContactTable = late("extracontact", "ContactTable")
    ReliabilityTable = late("extrareliability", "ReliabilityTable")
    TieDownTable = late("extratiedown", "TieDownTable")
    FlywheelTable = late("flywheel", "FlywheelTable")
    GearingTable = late("gearing", "GearingTable")
    IndexingTable = late("indexing", "IndexingTable")
    LinkSynthesisTable = late("linksynthesis", "LinkSynthesisTable")
    LoadTable = late("loads", "LoadTable")
    ManipulatorTable = late("manipulator", "ManipulatorTable")
    MechanismTable = late("mechanism", "MechanismTable")
    MotionTable = late("motion", "MotionTable")
    MotorTable = late("motor", "MotorTable")
    PairTable = late("pair", "PairTable")
    PendulumTable = late("pendulum", "PendulumTable")
    ReductionTable = late("reduction", "ReductionTable")
    RotorTable = late("rotor", "RotorTable")
    ShaftTable = late("shafts", "ShaftTable")
    SpringTable = late("springs", "SpringTable")
    StrengthTable = late("strength", "StrengthTable")
    TorqueTable = late("torque", "TorqueTable")
    TrainTable = late("train", "TrainTable")
    TransientTable = late("transients", "TransientTable")
    TransmissionTable = late("transmission", "TransmissionTable")
    UnsteadyTable = late("unsteady", "UnsteadyTable")
    VibratorTable = late("vibrator", "VibratorTable")


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
