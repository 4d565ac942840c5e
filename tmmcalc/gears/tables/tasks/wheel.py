"""From the table ``[wheel]`` to the wheel that the gear room solves."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.meshing.task import WheelMeasuring
from tmmcalc.gears.single.task import WheelTask
from tmmcalc.gears.tables.tasks.pair import cutter_of, rack_of

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables


def to_wheel(spec: GearTables) -> WheelTask:
    """The wheel of the spec; raises `UsageError` if it has none."""
    table = spec.wheel
    if table is None:
        raise UsageError("the spec has no [wheel]", remedy='add [wheel] with teeth = 27 and module = "5 mm"')
    told = {key: getattr(table, key) for key in ("rack", "pressure_angle", "addendum", "clearance", "tip_radius")}
    rack = rack_of({key: value for key, value in told.items() if value is not None}, Rack())
    measuring = WheelMeasuring(
        table.name,
        table.module,
        table.span_teeth,
        table.ball_diameter,
        "pins" if table.measure_over == "pins" else "balls",
        "exact" if table.face_width_rule == "exact" else "book",
        table.face_width,
    )
    return WheelTask(
        table.teeth,
        table.module,
        measuring,
        kind="internal" if table.kind == "internal" else "external",
        shift=table.x,
        helix=abs(table.helix_angle),
        rack=rack,
        tip=None if table.tip_diameter is None else table.tip_diameter / 2,
        cutter=None if table.cutter is None else cutter_of(table.cutter, table.module),
        face_width=table.face_width,
        fillet="circle" if table.fillet == "circle" else "ellipse",
        circles=tuple(diameter / 2 for diameter in table.circles),
        tip_thickness=table.tip_thickness_min,
        tip_thickness_wanted=table.tip_thickness_wanted,
        undercut=table.undercut != "none",
        points=table.points,
    )
