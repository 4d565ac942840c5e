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

    gravity: Gravity = Field(
        default=9.81,
        description="Magnitude of the acceleration of free fall; 0 for a mechanism in a horizontal plane, without "
        "weights.",
    )
    gravity_direction: Angle = Field(default=-math.pi / 2, description="Direction of the weights, from the x axis.")
    grid: GridTable = Field(default_factory=GridTable, description="Positions of the input.")
    input: InputTable = Field(description="The input link, by its joint, and its motion.")
    outputs: list[OutputTable] = Field(
        default=[], description="What the project asks for: coordinates of points, links or sliders."
    )
    fixed: dict[PointName, Point] = Field(
        default={}, description='Points `[x, y]` of the frame, link 0, under `[mechanism.fixed]`: `O = [0, "620 mm"]`.'
    )
    links: list[LinkTable] = Field(min_length=1, description="The moving links.")
    joints: list[JointTable] = Field(min_length=1, description="The joints between the links.")
    assembly: AssemblyTable = Field(
        default_factory=AssemblyTable, description="Which of the assembly variants is meant."
    )
