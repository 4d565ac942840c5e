"""What is given of gears: of a train its layout or its meshes, speeds and load; of a pair its teeth and shifts."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.gears.notes.given.gearing import of_gearing
from tmmcalc.gears.notes.given.pairs import of_pairs, of_wheel
from tmmcalc.gears.notes.given.strength import of_choice, of_strength
from tmmcalc.gears.notes.given.train import of_train
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.manuscript import Block


def blocks(order: Order) -> Iterator[Block]:
    """The scheme of a train that is written out, and the data."""
    yield from of_train(order)
    yield from of_strength(order)
    yield from of_choice(order)
    yield from of_gearing(order)
    yield from of_pairs(order)
    yield from of_wheel(order)
