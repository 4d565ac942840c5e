"""What is given of a machine: its diagram or drive, its flywheel, its motions in time, what of it is balanced."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.machine.notes.given.diagram import of_diagram
from tmmcalc.machine.notes.given.drive import of_drive
from tmmcalc.machine.notes.given.flywheel import of_flywheel
from tmmcalc.machine.notes.given.transients import of_transients
from tmmcalc.machine.notes.given.turning import of_turning
from tmmcalc.machine.notes.given.weights import of_weights
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Datum


def blocks(order: Order) -> Iterator[Block]:
    """The data, without those that the program has found."""
    yield from of_diagram(order)
    if order.spec.reduction is not None and order.spec.reduction.rods == "lumped":
        yield Datum(tr("masses of the connecting rods"), text=tr("put into their pins"))
    yield from of_drive(order)
    yield from of_turning(order)
    yield from of_flywheel(order)
    yield from of_transients(order)
    yield from of_weights(order)
