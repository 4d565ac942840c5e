"""From the tables of a spec to what acts on its linkage: the plain values that the forces and the reduction read.

A link with mass and no centre has it in the origin of its axes; a link without mass has no body. Loads and springs
without a name get one here.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from tmmcalc.linkage.loading import Body, Coupling, GearDrive, Load, Loading, Pair, Spring, Window
from tmmcalc.linkage.loadlaws import laws
from tmmcalc.linkage.loadlaws.law import Kind, Law
from tmmcalc.linkage.tables.joints import RevoluteTable
from tmmcalc.linkage.tables.names import load_names, spring_names
from tmmcalc.linkage.tables.tasks.mechanism import Points, link_points, place
from tmmcalc.spec.units import unit_direction

if TYPE_CHECKING:
    from tmmcalc.linkage.room import LinkageTables
    from tmmcalc.linkage.tables.drive import DriveTable
    from tmmcalc.linkage.tables.joints import JointTable
    from tmmcalc.linkage.tables.links import LinkTable
    from tmmcalc.linkage.tables.loads import LoadTable
    from tmmcalc.linkage.tables.springs import SpringTable

USUAL_ANGLE = math.pi / 9  # pressure angle of standard teeth


def to_loading(spec: LinkageTables) -> Loading:
    """Return what acts on the linkage of a checked spec: SI, points and directions complex."""
    mechanism = spec.linkage
    points = link_points(mechanism)
    names = load_names([load.name for load in spec.loads], [load.link for load in spec.loads])
    return Loading(
        bodies=tuple(_body(link) for link in mechanism.links if link.mass is not None),
        gravity=mechanism.gravity * unit_direction(mechanism.gravity_direction),
        loads=tuple(_load(table, name, points) for table, name in zip(spec.loads, names, strict=True)),
        springs=tuple(
            _spring(table, name, points)
            for table, name in zip(spec.springs, spring_names([s.name for s in spec.springs]), strict=True)
        ),
        pairs=tuple(_pair(joint) for joint in mechanism.joints if _is_sized(joint)),
        drive=_drive(spec.drive),
    )


def _body(link: LinkTable) -> Body:
    x, y = link.center or (0.0, 0.0)
    return Body(link.id, link.mass or 0.0, link.inertia or 0.0, complex(x, y))


def _load(table: LoadTable, name: str, points: Points) -> Load:
    kind, law = _law(table)
    return Load(
        name=name,
        link=table.link,
        kind=kind,
        law=law,
        point=0j if table.point is None else place(table.point, points[table.link]),
        direction=unit_direction(table.direction),
        follows=table.axes,
        window=_window(table),
        factor=table.factor,
        role=table.role,
        against=table.against,
        repeats=1 if table.period is None else round(table.period / (2 * math.pi)),
    )


def _law(table: LoadTable) -> tuple[Kind, Law]:
    """The one law of a load, and whether it is a force."""
    key, law = next((key, law) for key, law in laws().items() if getattr(table, key) is not None)
    return law.from_table(table, key)


def _window(table: LoadTable) -> Window | None:
    if table.stroke is not None:
        return Window(stroke=table.stroke, output=table.output)
    if table.between is not None:
        return Window(angles=(table.between[0], table.between[1]))
    if table.positions is not None:
        return Window(positions=(table.positions[0], table.positions[1]))
    return None


def _spring(table: SpringTable, name: str, points: Points) -> Spring:
    first, second = table.links
    ends = [place(p, points[k]) for p, k in zip(table.points, table.links, strict=True)] if table.points else [0j, 0j]
    free = table.free_length if table.kind == "linear" else table.free_angle
    return Spring(
        name=name,
        kind=table.kind,
        links=(first, second),
        points=(ends[0], ends[1]),
        stiffness=table.stiffness,
        free=free or 0.0,
        damping=table.damping,
    )


def _is_sized(joint: JointTable) -> bool:
    return bool({"friction", "radius", "length"} & joint.model_fields_set)


def _pair(joint: JointTable) -> Pair:
    if isinstance(joint, RevoluteTable):
        return Pair(joint.name, joint.friction, radius=joint.radius)
    return Pair(joint.name, joint.friction, length=joint.length)


def _drive(table: DriveTable | None) -> Coupling | GearDrive:
    """A gear that has its radius and the place of its pinion; the checks see to both."""
    if table is None or table.radius is None or table.pinion is None:
        return Coupling()
    angle = USUAL_ANGLE if table.mesh_angle is None else table.mesh_angle
    return GearDrive(table.radius, angle, table.pinion, bool(table.internal), table._open)
