"""What is given of a cam or of an indexing drive: its kind, motion and law, sizes and limits, loads, strength."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.cams.notes.given.cam import of_cam
from tmmcalc.cams.notes.given.indexing import of_indexing
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.manuscript import Block


def blocks(order: Order) -> Iterator[Block]:
    """The data of what the spec has."""
    yield from of_cam(order)
    yield from of_indexing(order)
