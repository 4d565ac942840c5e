"""The chapter on motion: the input link, then every group in the order of the formula, at the chosen positions."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmmcalc.linkage.notes import course, driven, equations, loops, plans, points, strokes
from tmmcalc.linkage.notes.told import Dyad, Told, told_of
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_count
from tmmcalc.report.manuscript import Block, Display, Heading, Paragraph
from tmmcalc.report.telling import located, named


def blocks(order: Order) -> Iterator[Block]:
    """Extreme positions, the input link, every group with its formulas worked out, plans, the whole cycle."""
    told = told_of(order)
    yield Heading(tr("Positions of the mechanism"), 2)
    yield from strokes.blocks(told)
    if told.chain.structure.driven is None:
        yield Heading(tr("Input link"), 2)
        yield from _input(told)
    for group in told.groups:
        yield Heading(tr("Group {name}", name=group.step.group.name), 2)
        yield from _dyad(told, group) if isinstance(group, Dyad) else _looped(told, group)
        yield from _points(told, group.carried)
    yield from plans.blocks(told)
    yield from course.blocks(told)


def _input(told: Told) -> Iterator[Block]:
    """The law of the input, and the points of the input link."""
    if told.slider is not None:
        (slid,) = told.slider.slid
        yield from told.lines(driven.LAW, {"s": str(slid.joint.links[0])})
        velocities, accelerations = loops.rates_of(told.slider)
        yield from told.lines([*loops.places_of(told.slider), *velocities, *accelerations], {})
    else:
        sense = "" if told.result.speed > 0 else "-"
        texts = ("omega_<k> = <sense>pi*n_<k>/30", "phi_<k> = phi_0 + phi")
        yield from told.lines(texts, {"k": str(told.result.structure.input_link), "sense": sense})
    yield from _points(told, told.crank)


def _dyad(told: Told, dyad: Dyad) -> Iterator[Block]:
    """A dyad by the formulas of its kind."""
    marks = "e" if dyad.step.group.kind != "PRP" else "e{}"
    yield Heading(tr("Positions"), 3)
    yield Paragraph(_how(dyad))
    yield from told.lines(dyad.kind.POSITION, dyad.places)
    for heading, of_rates, texts in (
        (tr("Velocities"), equations.velocities, dyad.kind.VELOCITY),
        (tr("Accelerations"), equations.accelerations, dyad.kind.ACCELERATION),
    ):
        yield Heading(heading, 3)
        yield from of_rates(told, dyad.loops, marks)
        yield Paragraph(tr("The projections of the equation give:"))
        yield from told.lines(texts, dyad.places)


def _how(dyad: Dyad) -> str:
    """What gives the places of the links of a dyad."""
    places, kind = dyad.places, dyad.step.group.kind
    if kind == "RRR":
        return tr(
            "Of the triangle of {first}, {pin} and {second} all sides are known; the law of cosines gives its angle at "
            "{first}:",
            first=places["P"],
            pin=places["B"],
            second=places["Q"],
        )
    if kind == "RRP":
        return tr("The projections of link {link} across and along the guide give:", link=places["a"])
    if kind == "RPR":
        return tr("The distance of the pivots and that of the line of the slide from them give:")
    return tr("The projections along both guides give:")


def _looped(told: Told, group: loops.Looped) -> Iterator[Block]:
    """A group of higher class, or with the drive inside: by its triangle, or by Newton's method."""
    triangle = driven.triangle_of(group.loops, group.step.group.drive)
    if group.step.group.drive:
        yield from told.lines(driven.LAW, {"s": str(told.chain.input_joint.links[0])})
    if triangle is not None:
        yield from _triangle(told, group, triangle)
        return
    yield from _closed(told, group)
    yield Heading(tr("Velocities"), 3)
    yield from equations.velocities(told, group.loops)
    yield from _system(told, group, "B")
    yield Heading(tr("Accelerations"), 3)
    yield from equations.accelerations(told, group.loops)
    yield from _system(told, group, "C")


def _triangle(told: Told, group: loops.Looped, triangle: driven.Triangle) -> Iterator[Block]:
    """A link that a driven length turns."""
    words = driven.words_of(triangle, told.lexicons[0])
    for lexicon in told.lexicons:
        lexicon |= named(driven.quantities(triangle, lexicon))
    yield Heading(tr("Positions"), 3)
    yield Paragraph(
        tr(
            "The pivots {first} and {second} and the pin {pin} are a triangle with two constant sides; the third is "
            "the driven length.",
            first=words["O"],
            second=words["A"],
            pin=words["B"],
        )
    )
    yield from told.lines(driven.POSITION, words)
    yield Heading(tr("Velocities"), 3)
    yield from equations.velocities(told, group.loops)
    yield from told.lines(driven.VELOCITY, words)
    yield Heading(tr("Accelerations"), 3)
    yield from equations.accelerations(told, group.loops)
    yield from told.lines(driven.ACCELERATION, words)


def _closed(told: Told, group: loops.Looped) -> Iterator[Block]:
    """The closure of the loops, the steps of Newton, the places that they lead to."""
    yield Heading(tr("Positions"), 3)
    yield Paragraph(tr("The loops of the group are closed:"))
    for text in loops.closures(group):
        yield Display(read(text))
    names = ", ".join(f"${name}$" for name in loops.unknown_names(group, "position"))
    count = tr_count(2 * len(group.loops), "equation", "equations")
    tables = [*loops.newton(told.result, told.rows, group)]
    said = tr(
        "Their projections on the axes are {count} with the unknown {names}. They are solved by Newton's method: the "
        "corrections follow from a linear system with the matrix of the system of the velocities below. The steps are "
        "{where}.",
        count=count,
        names=names,
        where=located(tables),
    )
    yield Paragraph(said)
    yield from tables
    yield Paragraph(tr("With what was found every point has the same place by each way to it:"))
    yield from told.lines([*loops.places(group)], {})


def _system(told: Told, group: loops.Looped, letter: str) -> Iterator[Block]:
    """The linear system of the rates: its right sides, its matrix with the solution, the solution put into it."""
    kind = "velocity" if letter == "B" else "acceleration"
    names = ", ".join(f"${name}$" for name in loops.unknown_names(group, kind))
    yield Paragraph(
        tr(
            "The projections of these equations are a linear system with the unknown {names}. Its right sides hold "
            "what is known:",
            names=names,
        )
    )
    yield from told.lines([*loops.right_sides(group, letter)], {})
    tables = [*loops.systems(told.result, told.rows, group, letter)]
    yield Paragraph(tr("The coefficients of the system and its solution are {where}.", where=located(tables)))
    yield from tables
    yield Paragraph(tr("The equations of the system hold with this solution:"))
    yield from told.lines([*loops.equations(group, letter)], {})
    yield Paragraph(
        tr("Velocities of the points of the group:")
        if letter == "B"
        else tr("Accelerations of the points of the group:")
    )
    for arm in loops.reached(group):
        yield from told.lines(loops.rates_of(arm)[letter == "C"], {})


def _points(told: Told, carried: Sequence[points.Carried]) -> Iterator[Block]:
    """Points of links that are found from those of the group."""
    for found in carried:
        for texts in (points.POSITION, points.VELOCITY, points.ACCELERATION):
            yield from told.lines(texts, found.places)
