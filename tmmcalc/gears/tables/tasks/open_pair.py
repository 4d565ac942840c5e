"""From the table ``[open_pair]`` to what it is to the drive, and to what its teeth are checked for."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.gears.openload import OpenTask
    from tmmcalc.gears.openpair import OpenPair
    from tmmcalc.gears.room import GearTables
    from tmmcalc.gears.tables.open_pair import OpenPairTable
    from tmmcalc.gears.tables.strength import MaterialTable

USUAL, BY_FRICTION, GIVEN = "the general value of a mesh", "by the friction of its teeth", "as given"


def to_open_pair(spec: GearTables) -> OpenPair | None:
    """The open pair of the spec, None if it has none."""
    table = spec.open_pair
    if table is None:
        return None
    from tmmcalc.gears.losses import efficiency_of_mesh  # late: most specs have none
    from tmmcalc.gears.openpair import OpenPair
    from tmmcalc.gears.tables.tasks.pair import open_task

    pair = open_task(table)
    efficiency = efficiency_of_mesh(*pair.teeth, pair.kind == "internal", table.efficiency, table.friction)
    origin = GIVEN if table.efficiency is not None else USUAL if table.friction is None else BY_FRICTION
    return OpenPair(pair, efficiency, origin, table.inertia)


def to_open_task(spec: GearTables) -> OpenTask:
    """The open pair with its materials, the moment that is given, and whether its force enters the crank's bearing.

    Materials that it has not are those of ``[strength]``. Raises `UsageError` for a spec without an open pair.
    """
    from tmmcalc.gears.openload import OpenTask
    from tmmcalc.gears.tables.tasks.strength import to_material

    pair, table = to_open_pair(spec), spec.open_pair
    if pair is None or table is None:
        raise UsageError("the spec has no [open_pair]", remedy="add [open_pair] with teeth, module and face_width")
    strength = spec.strength
    pinion, gear = _materials(spec, table)
    return OpenTask(
        pair,
        pinion=to_material(pinion),
        gear=to_material(gear),
        row=table.arrangement,
        moment=None if strength is None or strength.moment is None else abs(strength.moment),
        in_bearing=None if spec.mechanism is None else spec.drive is not None and spec.drive.kind == "gear",
    )


def _materials(spec: GearTables, table: OpenPairTable) -> tuple[MaterialTable | None, MaterialTable | None]:
    """Tables of pinion and gear, the gear's None where it is as the pinion's."""
    own, usual = table.pinion or table.material, spec.strength
    if own is not None or usual is None:
        return own, table.gear
    return usual.pinion or usual.material, usual.wheel
