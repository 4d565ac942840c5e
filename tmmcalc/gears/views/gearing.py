"""The train that is written out, turning."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.gears.chosen.motion import written
from tmmcalc.gears.views.front import Front
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.moving import View


def views(order: Order) -> Iterator[View]:
    """The train in the motion that is known of it."""
    yield Front(written(order.results["gearing"])).view("gearing")
