"""The picture of a train that is written out: its scheme to scale, the plan of velocities and the plan of speeds."""

from __future__ import annotations

from tmmcalc.gears.chosen.motion import written
from tmmcalc.gears.pictures.motionplans import draw_motion
from tmmcalc.gears.pictures.words import train_name
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import headed, sheets
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    found = written(order.results["gearing"])
    title = tr("Written train: kinematic scheme and plans")
    drawing, (box,) = sheets(1, title)
    draw_motion(drawing, headed(drawing, box, train_name(found.chosen.sets) if found.chosen else title), found)
    return drawing
