"""From the tables of a spec to the plain values that the linkage room reads.

Joints get their points as constants in the axes of their links, lines get unit directions, and a centre of
mass becomes the point ``S<id>``. Masses and gravity stay behind, for kinematics does not read them: see ``loading``.
"""

from __future__ import annotations

from tmmcalc.linkage.model import FRAME, Assembly, Grid, Input, Joint, Link, Mechanism, Output
from tmmcalc.linkage.tables.assembly import AssemblyTable
from tmmcalc.linkage.tables.grid import GridTable
from tmmcalc.linkage.tables.input import InputTable
from tmmcalc.linkage.tables.joints import PrismaticTable, RevoluteTable
from tmmcalc.linkage.tables.links import LinkTable
from tmmcalc.linkage.tables.mechanism import MechanismTable
from tmmcalc.linkage.tables.outputs import OutputTable
from tmmcalc.spec.units import unit_direction

Points = dict[int, dict[str, complex]]


def to_linkage(mechanism: MechanismTable) -> Mechanism:
    """Return the linkage of a checked spec: lengths in m, angles in rad, points and directions complex."""
    frame = Link(FRAME, _points(mechanism.fixed), "frame")
    links = tuple(_link(table) for table in mechanism.links)
    points = {link.id: link.points for link in (frame, *links)}
    return Mechanism(
        frame=frame,
        links=links,
        joints=tuple(_joint(table, points) for table in mechanism.joints),
        input=_input(mechanism.input),
        outputs=tuple(_output(table) for table in mechanism.outputs),
        grid=_grid(mechanism.grid),
        assembly=_assembly(mechanism.assembly),
    )


def link_points(mechanism: MechanismTable) -> Points:
    """Return the points of every link by their names, those of the frame under 0 [m]."""
    return {FRAME: _points(mechanism.fixed), **{link.id: _link(link).points for link in mechanism.links}}


def place(written: str | list[float], points: dict[str, complex]) -> complex:
    """Return the point of this name, or of these coordinates [m]."""
    return points[written] if isinstance(written, str) else _complex(written)


def _complex(point: list[float]) -> complex:
    return complex(point[0], point[1])


def _points(points: dict[str, list[float]]) -> dict[str, complex]:
    return {name: _complex(point) for name, point in points.items()}


def _link(table: LinkTable) -> Link:
    points = _points(table.points)
    if table.center is not None:
        points[f"S{table.id}"] = _complex(table.center)
    return Link(table.id, points, table.name)


def _joint(table: RevoluteTable | PrismaticTable, points: Points) -> Joint:
    first, second = table.links
    if isinstance(table, RevoluteTable):
        a, b = table.points or [table.point or table.name] * 2
        return Joint(table.name, "revolute", (first, second), (points[first][a], points[second][b]))
    lines = ((table.slider, points[first]), (table.guide, points[second]))
    through_slider, through_guide = (place(line.through, own) for line, own in lines)
    directions = (unit_direction(table.slider.angle), unit_direction(table.guide.angle))
    return Joint(table.name, "prismatic", (first, second), (through_slider, through_guide), directions)


def _input(table: InputTable) -> Input:
    start = None if isinstance(table.start, str) else table.start
    return Input(table.joint, table.speed, table.acceleration, start, "speed" in table.model_fields_set)


def _output(table: OutputTable) -> Output:
    return Output(table.point, table.direction, table.link, table.joint, table.resistance, table.name)


def _grid(table: GridTable) -> Grid:
    return Grid(table.positions, table.working, table.idle, table.span, tuple(table.extra), table.extremes)


def _assembly(table: AssemblyTable) -> Assembly:
    variants = {tuple(int(link) for link in key.split("-")): number for key, number in table.variants.items()}
    return Assembly(_points(table.sketch), variants, table.at)
