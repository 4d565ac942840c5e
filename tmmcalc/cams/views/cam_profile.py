"""What a page moves of a cam: the cam under its follower, the region of the places where its axis may stand."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.cams.views.flatregion import region_under_face
from tmmcalc.cams.views.motion import CamInMotion
from tmmcalc.cams.views.region import region_of_axis
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.moving import View


def views(order: Order) -> Iterator[View]:
    """Both over the turn of the cam."""
    made = CamInMotion(order)
    yield made.view()
    yield from region_of_axis(made, order.results["cam_synthesis"])
    yield from region_under_face(made, order.results["cam_synthesis"])
