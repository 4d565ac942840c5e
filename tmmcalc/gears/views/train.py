"""The train that was chosen, turning; without criteria the first set of every variant."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.gears.details import searched_trains
from tmmcalc.gears.views.front import Front
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.moving import View


def views(order: Order) -> Iterator[View]:
    """One of each variant."""
    for k, (_, found) in enumerate(searched_trains(order.spec, order.results, 1), 1):
        yield Front(found).view("train" if k == 1 else f"train_{k}")
