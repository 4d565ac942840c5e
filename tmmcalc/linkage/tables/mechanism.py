"""``[mechanism]``: the whole linkage."""

import math

from pydantic import Field

from tmmcalc.linkage.tables.assembly import AssemblyTable
from tmmcalc.linkage.tables.grid import GridTable
from tmmcalc.linkage.tables.input import InputTable
from tmmcalc.linkage.tables.joints import JointTable
from tmmcalc.linkage.tables.links import LinkTable
from tmmcalc.linkage.tables.outputs import OutputTable
from tmmcalc.spec.identifiers import PointName
from tmmcalc.spec.quantities import Angle, Gravity, Point
from tmmcalc.spec.table import Table


class MechanismTable(Table):
    """A planar linkage of one input: its frame, links, joints and positions."""

    gravity: Gravity = Field(default=9.81, description="Acceleration of free fall; 0 leaves the weights out.")
    gravity_direction: Angle = Field(default=-math.pi / 2, description="Direction of gravity, from the x axis.")
    grid: GridTable = Field(default_factory=GridTable, description="Positions of the input.")
    input: InputTable = Field(description="The joint of the input link with the frame, and its motion.")
    outputs: list[OutputTable] = Field(default=[], description="Output coordinates of the mechanism.")
    fixed: dict[PointName, Point] = Field(default={}, description="Points [x, y] of the frame, which is link 0.")
    links: list[LinkTable] = Field(min_length=1, description="The moving links.")
    joints: list[JointTable] = Field(min_length=1, description="The joints between the links.")
    assembly: AssemblyTable = Field(
        default_factory=AssemblyTable, description="Which of the assembly variants is meant."
    )
