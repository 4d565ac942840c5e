"""The root of the spec: the tables of one project."""

from typing import TYPE_CHECKING

from pydantic import Field

from .late import late
from .mechanism import MechanismTable
from .project import ProjectTable
from .table import Table

if TYPE_CHECKING:
    from .drive import DriveTable
    from .flywheel import FlywheelTable
    from .loads import LoadTable
    from .motion import MotionTable
    from .motor import MotorTable
    from .reduction import ReductionTable
    from .springs import SpringTable
    from .transmission import TransmissionTable
else:
    DriveTable = late("drive", "DriveTable")
    FlywheelTable = late("flywheel", "FlywheelTable")
    LoadTable = late("loads", "LoadTable")
    MotionTable = late("motion", "MotionTable")
    MotorTable = late("motor", "MotorTable")
    ReductionTable = late("reduction", "ReductionTable")
    SpringTable = late("springs", "SpringTable")
    TransmissionTable = late("transmission", "TransmissionTable")


class Spec(Table):
    """A project spec of tmmcalc: one TOML file that holds the whole task."""

    project: ProjectTable = Field(default_factory=ProjectTable, description="What the work is called.")
    mechanism: MechanismTable = Field(description="The linkage.")
    loads: list[LoadTable] = Field(default=[], description="Technological forces and moments on the links.")
    springs: list[SpringTable] = Field(default=[], description="Springs and dampers between links.")
    drive: DriveTable | None = Field(default=None, description="How the drive acts on the crank.")
    motor: MotorTable | None = Field(default=None, description="The motor.")
    transmission: TransmissionTable | None = Field(
        default=None, description="The gears between the motor and the crank."
    )
    reduction: ReductionTable | None = Field(
        default=None, description="How forces and masses are reduced to the crank."
    )
    motion: MotionTable | None = Field(default=None, description="How the motion of the machine is found.")
    flywheel: FlywheelTable | None = Field(default=None, description="The flywheel: asked for, or given.")
