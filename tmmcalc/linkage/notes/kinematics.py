"""The chapter on motion: the input link, then every group in the order of the formula, at the chosen positions."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmmcalc.linkage.notes import points
from tmmcalc.linkage.notes.told import Told, told_of
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading


def blocks(order: Order) -> Iterator[Block]:
    """The input link and every dyad, with their formulas worked out."""
    told = told_of(order)
    yield from told.beyond()
    if told.chain.turns and told.chain.structure.driven is None:
        yield Heading(tr("Input link"), 2)
        sense = "" if told.result.speed > 0 else "-"
        texts = ("omega_<k> = <sense>pi*n_<k>/30", "phi_<k> = phi_0 + phi")
        yield from told.lines(texts, {"k": str(told.result.structure.input_link), "sense": sense})
        yield from _points(told, told.crank)
    for dyad in told.dyads:
        yield Heading(tr("Group {name}", name=dyad.step.group.name), 2)
        for title, texts in (
            (tr("Positions"), dyad.kind.POSITION),
            (tr("Velocities"), dyad.kind.VELOCITY),
            (tr("Accelerations"), dyad.kind.ACCELERATION),
        ):
            yield Heading(title, 3)
            yield from told.lines(texts, dyad.places)
        yield from _points(told, dyad.carried)


def _points(told: Told, carried: Sequence[points.Carried]) -> Iterator[Block]:
    """Points of links that are found from those of the group."""
    for found in carried:
        for texts in (points.POSITION, points.VELOCITY, points.ACCELERATION):
            yield from told.lines(texts, found.places)
