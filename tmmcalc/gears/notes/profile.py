"""The tooth profiles of the wheels of all pairs: a point of each curve by its formulas, the points, the picture."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.gears.meshing.halftooth import fault_of
from tmmcalc.gears.meshing.members import members
from tmmcalc.gears.notes.pairs.tooth import tooth
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Heading


def blocks(order: Order) -> Iterator[Block]:
    """Every wheel that has teeth of an involute."""
    shown = [each for each in members(order.results["pair"]) if each.shape != "rack" and fault_of(each) is None]
    if shown:
        yield Heading(tr("Tooth profiles"))
    told: set[str] = set()
    for k, member in enumerate(shown, 1):
        name = tr("Wheel {wheel}", wheel=member.name)
        yield Heading(f"{name} ({tr_name(member.pair)})" if member.pair else name, 3)
        yield from tooth(member, f"tooth{k}", alike=member.shape in told)
        told.add(member.shape)
