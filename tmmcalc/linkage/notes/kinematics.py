"""The chapter on motion: the input link, then every group in the order of the formula, at the chosen positions."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmmcalc.linkage.notes import driven, loops, points
from tmmcalc.linkage.notes.told import Dyad, Told, told_of
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading


def blocks(order: Order) -> Iterator[Block]:
    """The input link and every group, with their formulas worked out."""
    told = told_of(order)
    if told.chain.structure.driven is None:
        yield Heading(tr("Input link"), 2)
        yield from _input(told)
    for group in told.groups:
        yield Heading(tr("Group {name}", name=group.step.group.name), 2)
        yield from _dyad(told, group) if isinstance(group, Dyad) else _looped(told, group)
        yield from _points(told, group.carried)


def _input(told: Told) -> Iterator[Block]:
    """The law of the input, and the points of the input link."""
    if told.slider is not None:
        (slid,) = told.slider.slid
        yield from told.lines(driven.LAW, {"s": str(slid.joint.links[0])})
        for texts in (loops.places_of(told.slider), *loops.rates_of(told.slider)):
            yield from told.lines([*texts], {})
    else:
        sense = "" if told.result.speed > 0 else "-"
        texts = ("omega_<k> = <sense>pi*n_<k>/30", "phi_<k> = phi_0 + phi")
        yield from told.lines(texts, {"k": str(told.result.structure.input_link), "sense": sense})
    yield from _points(told, told.crank)


def _dyad(told: Told, dyad: Dyad) -> Iterator[Block]:
    """A dyad by the formulas of its kind."""
    for title, texts in (
        (tr("Positions"), dyad.kind.POSITION),
        (tr("Velocities"), dyad.kind.VELOCITY),
        (tr("Accelerations"), dyad.kind.ACCELERATION),
    ):
        yield Heading(title, 3)
        yield from told.lines(texts, dyad.places)


def _looped(told: Told, group: loops.Looped) -> Iterator[Block]:
    yield Heading(tr("Positions"), 3)
    yield from told.lines([*loops.places(group)], {})
    for title, letter in ((tr("Velocities"), "B"), (tr("Accelerations"), "C")):
        yield Heading(title, 3)
        yield from told.lines([*loops.right_sides(group, letter)], {})
        yield from told.lines([*loops.equations(group, letter)], {})
    for arm in group.arms:
        for texts in loops.rates_of(arm):
            yield from told.lines(texts, {})


def _points(told: Told, carried: Sequence[points.Carried]) -> Iterator[Block]:
    """Points of links that are found from those of the group."""
    for found in carried:
        for texts in (points.POSITION, points.VELOCITY, points.ACCELERATION):
            yield from told.lines(texts, found.places)
