"""Balancing: of a linkage with its shaking force, its counterweights and what they leave; of an engine; of a rotor."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from tmmcalc.report.drawing.order import Order
from tmmcalc.report.manuscript import Block

if TYPE_CHECKING:
    from tmmcalc.machine.stages.balance import Balances


def blocks(order: Order) -> Iterator[Block]:
    """What of the scene is balanced."""
    result: Balances = order.results["balance"]
    if result.linkage is not None:
        from tmmcalc.machine.notes.shaking import linkage_blocks

        yield from linkage_blocks(order, result.linkage)
    if result.engine is not None:
        from tmmcalc.machine.notes.engine import engine_blocks

        yield from engine_blocks(order, result.engine)
    if result.rotor is not None:
        from tmmcalc.machine.notes.rotor import rotor_blocks

        yield from rotor_blocks(order, result.rotor)
