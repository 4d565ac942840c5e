"""What is given of the balancing of a linkage: the schemes that are tried, the weights that they are made of."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.machine.balance.redistribution import Place
from tmmcalc.machine.balance.solve import BalanceTask
from tmmcalc.machine.pictures.words import scheme_name
from tmmcalc.machine.tables.balance import BalanceTable, RotatingWeightTable
from tmmcalc.machine.tables.tasks.balance import to_balance
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Datum


def of_weights(order: Order) -> Iterator[Datum]:
    """Schemes where the spec names them, what is chosen of their weights, counterweights and weights of one's own."""
    if "balance" not in order.results or order.results["balance"].linkage is None:
        return
    table: BalanceTable | None = order.spec.balance
    if table is not None and "schemes" in table.model_fields_set:
        names = ", ".join(map(scheme_name, table.schemes))
        yield Datum(tr("schemes of balancing"), text=names or tr("none"))
    task = to_balance(order.spec)
    if task.schemes:
        yield _chosen(task)
    if table is None:
        return
    if task.point is not None:
        said = tr("coordinates of the point that moments of the shaking force are about")
        yield Datum(said, (), (task.point.real, task.point.imag), "m")
    for place in task.places:
        yield _on_link(place)
    for number, weight in enumerate(table.add, 1):
        yield from _own(weight, number)


def _chosen(task: BalanceTask) -> Datum:
    """What is chosen of the weights of all schemes: their mass or their radius."""
    if task.mass is not None:
        return Datum(tr("mass of each balancing weight"), ("m_w",), (task.mass,), "kg")
    said = tr("radius of the balancing weights")
    if task.radius is not None:
        return Datum(said, ("r_U",), (task.radius,), "m")
    return Datum(said, ("r_U",), text=tr("the length of the crank"))


def _on_link(place: Place) -> Datum:
    """A counterweight on a link, by its mass or its radius."""
    if place.mass is not None:
        return Datum(tr("mass of the counterweight of link {link}", link=place.link), (), (place.mass,), "kg")
    said = tr("distance of the counterweight of link {link} from its pin", link=place.link)
    return Datum(said, (), (place.radius or 0.0,), "m")


def _own(weight: RotatingWeightTable, number: int) -> Iterator[Datum]:
    """A weight of one's own on a shaft geared to the crank."""
    said = tr("speed of weight {number} over that of the crank", number=number)
    yield Datum(said, (), (float(weight.order),))
    yield Datum(tr("mass of weight {number}", number=number), (), (weight.mass,), "kg")
    yield Datum(tr("radius of weight {number}", number=number), (), (weight.radius,), "m")
    said = tr("direction of weight {number} where the crank lies along axis $x$, from that axis", number=number)
    if weight.order == 1:
        said = tr("direction of weight {number} from the crank", number=number)
    yield Datum(said, (), (math.degrees(weight.angle),), "deg")
    if weight.axis is not None:
        yield Datum(tr("coordinates of the shaft of weight {number}", number=number), (), tuple(weight.axis), "m")
