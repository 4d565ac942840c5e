"""x."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.report.drawing.order import Order
from tmmcalc.report.manuscript import Block


def blocks(order: Order) -> Iterator[Block]:
    """x."""
    yield from ()
