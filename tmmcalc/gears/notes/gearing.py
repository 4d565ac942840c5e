"""A train that is written out: its conditions if it has a layout, speeds, plans, torques, powers."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.gears.chosen.motion import written
from tmmcalc.gears.notes.conditions import told_conditions
from tmmcalc.gears.notes.speeds import told_motion, told_speeds
from tmmcalc.gears.notes.torques import told_torques
from tmmcalc.gears.notes.train import told_plans
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading


def blocks(order: Order) -> Iterator[Block]:
    """The train in its motion, then under its load."""
    found = order.results["gearing"]
    moving = written(found)
    yield Heading(tr("The train that is given"), 2)
    if moving.chosen is not None:
        yield from told_conditions(moving.chosen, "gearing_conditions")
    told = told_motion(moving)
    yield from told_speeds(told, "gearing_speeds")
    yield from told_plans(moving, "gearing_plans")
    yield from told_torques(told, found, "gearing_meshes")
