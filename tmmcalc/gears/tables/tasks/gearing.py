"""From the table ``[gearing]`` to the train that the gear room solves."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tmmcalc.core.notes import Phrase
from tmmcalc.gears.gearingtask import GearingTask, layout_task
from tmmcalc.gears.losses import efficiency_of_mesh, layout_efficiencies, usual_efficiencies
from tmmcalc.gears.network.model import EXTERNAL, INTERNAL, Body, Mesh, Network

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables
    from tmmcalc.gears.tables.gearing import GearingTable, MeshTable


def to_gearing(spec: GearTables) -> GearingTask | None:
    """The train of the spec, None if it has none; raises `UsageError` for members that no train can have."""
    return None if spec.gearing is None else gearing_task(spec.gearing)


def gearing_task(table: GearingTable) -> GearingTask:
    """The train of a table."""
    task = _by_layout(table) if table.layout is not None else GearingTask(_network(table), dict(table.speeds))
    return replace(
        task,
        torques=dict(table.torques),
        loads=dict(table.load),
        powers=dict(table.powers),
        locked=tuple((first, second) for first, second in table.locked),
        input=table.input,
        outputs=tuple(table.output) if table.output is not None else task.outputs,
        remarks=(*task.remarks, *_remarks(table)),
    )


def _by_layout(table: GearingTable) -> GearingTask:
    layout, teeth = table.layout or "", table.teeth or []
    return layout_task(
        layout,
        teeth,
        table.planets or 1,
        table.speeds,
        efficiency=layout_efficiencies(layout, teeth, table.efficiency, table.friction),
        sharing=table.sharing or 1.0,
    )


def _network(table: GearingTable) -> Network:
    tilted = {member.name for member in table.members if member.tilted}
    bodies = tuple(Body(m.name, m.carrier, m.count, m.tilted, m.sharing) for m in table.members)
    return Network(tuple(_mesh(mesh, table, tilted) for mesh in table.meshes), bodies)


def _mesh(mesh: MeshTable, table: GearingTable, tilted: set[str]) -> Mesh:
    """A mesh with its sign: of the wheels that a bevel planet has on either side those opposite turn the other way."""
    bevel = bool({mesh.first, mesh.second} & tilted)
    same = not mesh.opposite if bevel else mesh.internal
    general = table.efficiency if isinstance(table.efficiency, float) else None
    own = general if mesh.efficiency is None else mesh.efficiency
    eta = efficiency_of_mesh(mesh.first_teeth, mesh.second_teeth, mesh.internal, own, table.friction)
    sign = INTERNAL if same else EXTERNAL
    return Mesh(mesh.first, mesh.first_teeth, mesh.second, mesh.second_teeth, sign, eta)


def _remarks(table: GearingTable) -> list[str]:
    """What is taken for want of data."""
    own = bool(table.meshes) and all(mesh.efficiency is not None for mesh in table.meshes)
    if own or table.efficiency is not None or table.friction is not None:
        return []
    return [Phrase("{usual}; efficiency or friction gives others", usual=usual_efficiencies())]
