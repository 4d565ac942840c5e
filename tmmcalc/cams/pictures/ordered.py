"""The cam that a picture is ordered of."""

from __future__ import annotations

from tmmcalc.cams.tables.tasks.cam import to_cam
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.order import Order


def cam_of(order: Order) -> CamTask:
    """The cam of the spec at the speed that the machine has, if it turns with the crank."""
    return to_cam(order.spec).at_speed(order.results.get("motion"))
