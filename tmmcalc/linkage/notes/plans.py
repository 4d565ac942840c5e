"""The plans of velocities and accelerations: scale factors, the length of every segment, what follows from them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from tmmcalc.linkage.notes.group import plain_name
from tmmcalc.linkage.notes.told import Told
from tmmcalc.linkage.outputs import default_outputs
from tmmcalc.linkage.pictures.plans import SENSES, draw_plans_of_kind, plans_of, scale_of_kind
from tmmcalc.linkage.pictures.vectors import SUPERSCRIPTS, drawn_vectors, lettered
from tmmcalc.linkage.pins import find_pins
from tmmcalc.linkage.turning import turnings
from tmmcalc.linkage.vectors import Polygon, Vector, VectorPolygons
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import NUMBERED
from tmmcalc.report.formula.digits import significant
from tmmcalc.report.formula.setting import spelt
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Figure, Heading, Paragraph, Table
from tmmcalc.report.telling import WIDE, cell, located, number_of

SIDE_BY_SIDE = 3  # positions whose segments stand in one table
LEAST, MOST = (70.0, 45.0), 122.0  # width and height of a plan, the largest height [mm]
TEXTS = 50.0, 36.0  # of it that words take [mm]
UNITS = {"v": "m/s", "a": "m/s^2"}
TURNS = {"v": ("omega", "rad/s"), "a": ("eps", "rad/s^2")}
READ = 0.1  # to which a segment is read off the plan [mm]


class Plan(NamedTuple):
    """The plans of one kind at all shown positions."""

    letter: str  # ``v`` or ``a``
    polygons: tuple[Polygon, ...]
    figures: tuple[Figure, ...]
    mu: float  # scale factor [(m/s)/mm] or [(m/s^2)/mm]


def blocks(told: Told) -> Iterator[Block]:
    """Both plans with their segments, then the angular velocities and accelerations, and the outputs by the plans."""
    found = plans_of(told.chain.mechanism, told.result, told.rows)
    yield Heading(tr("Plans of velocities and accelerations"), 2)
    plans = [_plan(told, found, letter) for letter in "va"]
    segments = [[*_segments(told, plan)] for plan in plans]
    words = {plan.letter: f"{cell(plan.mu)} {tr_unit(f'({UNITS[plan.letter]})/mm')}" for plan in plans}
    yield Paragraph(
        tr(
            "The vector equations of the groups are solved by plans to the scale factors $mu_v$ = {v}, $mu_a$ = {a}. "
            "They are {figures}. A vector is drawn as a segment of its size divided by the scale factor; the lengths "
            "of the segments are {tables}.",
            **words,
            figures=located([figure for plan in plans for figure in plan.figures]),
            tables=located([table for part in segments for table in part]),
        )
    )
    yield from _special(plans)
    yield from _sliding(told, plans)
    for plan, tables in zip(plans, segments, strict=True):
        yield from tables
        yield from plan.figures
    yield from _compared(told, found, plans)


def _special(plans: Sequence[Plan]) -> Iterator[Block]:
    """What the special points are, where a group has some."""
    points = {v.point: v.link for plan in plans for p in plan.polygons for v in p.vectors if v.kind == "special"}
    if points:
        names = ", ".join(map(_vertex, points))
        yield Paragraph(
            tr(
                "The special points {points} belong to the basic link with the first number; the lines of the two "
                "links in brackets meet there, so the velocity of such a point across either line is known.",
                points=names,
            )
        )


def _sliding(told: Told, plans: Sequence[Plan]) -> Iterator[Block]:
    """Which vectors of the plans are the motion along a guide that the equations of the groups have."""
    same: dict[str, str] = {}
    for plan in plans:
        for vector in (v for polygon in plan.polygons for v in polygon.vectors if v.kind in ("sliding", "coriolis")):
            links = [NUMBERED.fullmatch(name) for name in (vector.point, vector.base)]
            index = "".join(link[2] for link in links if link)
            name = f"{plan.letter}_{index}" + "^K" * (vector.kind == "coriolis")
            if all(links) and name in told.lexicons[0]:
                same[f"${designation(vector, plan.letter)}$"] = f"${name}$"
    if same:
        names = ", ".join(f"{ours} = {theirs}" for ours, theirs in same.items())
        yield Paragraph(
            tr("In the equations of the groups some vectors of the plans have other letters: {names}.", names=names)
        )


def _plan(told: Told, found: Sequence[VectorPolygons], letter: str) -> Plan:
    """The plans of a kind, each in a figure of its own, to one scale."""
    polygons = tuple(plan.velocity if letter == "v" else plan.acceleration for plan in found)
    mu = max(scale_of_kind(Box(0.0, 0.0, WIDE, MOST), [plan], letter) for plan in found)
    draws = [partial(draw_plans_of_kind, result=told.result, plans=[plan], letter=letter) for plan in found]
    figures = []
    for k, draw in enumerate(draws):
        label = told.result.labels[told.rows[k]]
        captions = {
            "v": tr("Plan of velocities in position {label}", label=label),
            "a": tr("Plan of accelerations in position {label}", label=label),
        }
        figures.append(Figure(captions[letter], partial(draw, mu=mu), _size(polygons[k], mu), f"plan_{letter}{k}"))
    return Plan(letter, polygons, tuple(figures), mu)


def _size(polygon: Polygon, mu: float) -> tuple[float, float]:
    """Width and height [mm] that a plan takes to scale, with its words."""
    tips = np.array([*polygon.vertices.values()]) / mu
    wide, high = float(np.ptp(tips.real)) + TEXTS[0], float(np.ptp(tips.imag)) + TEXTS[1]
    return min(max(wide, LEAST[0]), WIDE), min(max(high, LEAST[1]), MOST)


def _segments(told: Told, plan: Plan) -> Iterator[Table]:
    """Size and length of every segment."""
    captions = {
        "v": tr("Segments of the plans of velocities"),
        "a": tr("Segments of the plans of accelerations"),
    }
    shown = [vector for polygon in plan.polygons for vector in drawn_vectors(polygon)]
    vectors = list(dict.fromkeys(shown))
    labels = [told.result.labels[row] for row in told.rows]
    for start in range(0, len(labels), SIDE_BY_SIDE):
        part = range(start, min(start + SIDE_BY_SIDE, len(labels)))
        heads = [
            text
            for k in part
            for text in (
                f"{tr('Position {label}', label=labels[k])}, {tr_unit(UNITS[plan.letter])}",
                f"{tr('Position {label}', label=labels[k])}, {tr_unit('mm')}",
            )
        ]
        rows = []
        for vector in vectors:
            cells = []
            for k in part:
                size = abs(plan.polygons[k].value(vector))
                cells += [spelt(significant(size, 5)), spelt(f"{size / plan.mu:.1f}")]
            rows.append((f"${designation(vector, plan.letter)}$", ends(vector), *cells))
        key = f"plan_{plan.letter}" if not start else f"plan_{plan.letter}_{start}"
        yield Table(captions[plan.letter], (tr("Vector"), tr("Segment"), *heads), tuple(rows), key)


def designation(vector: Vector, letter: str) -> str:
    """The name of a vector of a plan in formulas.

    >>> designation(Vector("a", "n3", "normal", 3, "B2", "A"), "a")
    'a_{B2A}^n'
    """
    above = SUPERSCRIPTS.get(vector.kind, "r" if vector.kind == "sliding" and letter == "a" else "")
    points = "".join((*lettered(vector.point), *lettered(vector.base)))
    return f"{letter}_{{{points}}}" + (f"^{above}" if above else "")


def ends(vector: Vector) -> str:
    """The vertices of a segment as they stand in the plan.

    >>> ends(Vector("pi", "s3", "absolute", 3, "S3"))
    '$pi$$s_3$'
    >>> ends(Vector("c", "k7'", "relative", 7, "K7", "C"))
    "$c$$k'_7$"
    """
    return "".join(map(_vertex, (vector.tail, vector.head)))


def _vertex(name: str) -> str:
    letter, index = lettered(name)
    if index:
        number = index.rstrip("'")
        return f"${canonical(f'{letter}{index[len(number) :]}_{{{number}}}')}$"
    return f"${name}$" if len(name) == 1 or name == "pi" else name


def _compared(told: Told, found: Sequence[VectorPolygons], plans: Sequence[Plan]) -> Iterator[Block]:
    """What follows from the segments beside what the formulas give."""
    every = (
        row
        for k in range(len(found))
        for plan in plans
        for row in (*_turned(told, found[k], plan, k), *_moved(told, plan, k))
    )
    rows = [*dict.fromkeys(every)]  # both projections of a point are outputs, its vector is one
    if not rows:
        return
    yield Paragraph(
        tr(
            "With the length $z$ of a segment, read off the plan to {read} mm, a link turns with $omega = mu_v*z/l$ "
            "and $eps = mu_a*z/l$, where $l$ is the distance of the two points; the sense (↺ counter-clockwise, "
            "↻ clockwise) follows from the direction of the segment at its point. Table {tab:plan_compared} compares "
            "the plan with the formulas.",
            read=spelt(f"{READ}"),
        )
    )
    heads = (
        tr("Position"),
        tr("Quantity"),
        f"{tr('Segment')} $z$, {tr_unit('mm')}",
        f"$l$, {tr_unit('m')}",
        tr("By the plan"),
        tr("By the formulas"),
        tr("Difference") + ", %",
    )
    yield Table(tr("Comparison with the plans"), heads, tuple(rows), "plan_compared")
    largest = max((row for row in rows if row[-1] != "–"), key=lambda row: float(row[-1].replace(",", ".")), default=())
    if largest:
        said = tr(
            "The largest difference, {part} %, is that of {quantity} in position {label}; the shorter a segment, the "
            "larger what reading it off leaves.",
            part=largest[-1],
            quantity=largest[1].partition("$ ")[0].partition("$,")[0].rstrip("$") + "$",
            label=largest[0],
        )
        yield Paragraph(said)


def _turned(told: Told, found: VectorPolygons, plan: Plan, k: int) -> Iterator[tuple[str, ...]]:
    """Angular velocities, or accelerations, of the links from the segments about their points."""
    polygon = plan.polygons[k]
    symbol, unit = TURNS[plan.letter]
    mechanism, structure = told.chain.mechanism, told.result.structure
    seen = {vector.link: vector for vector in found.acceleration.vectors if vector.kind == "tangential"}
    tails = {vector.link: vector.tail for vector in found.acceleration.vectors if vector.kind == "normal"}
    for turning in turnings(mechanism, structure, find_pins(mechanism)):
        link = turning.link
        if link not in seen or (link == structure.input_link and told.result.turns):
            continue
        vector = seen[link]
        if plan.letter == "v":
            tail = "p" if tails[link] == "pi" else tails[link]
            vector = Vector(tail, vector.head, "relative", link, vector.point, vector.base)
        size = round(abs(polygon.value(vector)) / plan.mu / READ) * READ
        lexicon = told.lexicons[k]
        base, head = plain_name(turning.base.name), plain_name(turning.head.name)
        across, up = (
            number_of(lexicon, f"{axis}_{{{head}}}") - number_of(lexicon, f"{axis}_{{{base}}}") for axis in "xy"
        )
        length = math.hypot(across, up)
        exact = number_of(lexicon, f"{symbol}_{link}")
        sense = f" {SENSES[exact > 0]}" if size else ""
        name = f"${symbol}_{link}${sense}, {tr_unit(unit)}"
        yield _row(told, k, (name, ends(vector)), size, length, (plan.mu * size / length, abs(exact)))


def _moved(told: Told, plan: Plan, k: int) -> Iterator[tuple[str, ...]]:
    """The velocities, or accelerations, of the points of outputs."""
    polygon = plan.polygons[k]
    for output in default_outputs(told.chain):
        rays = (vector for vector in polygon.vectors if vector.kind == "absolute")
        vector = next((ray for ray in rays if ray.point in (output.point, f"{output.point}{ray.link}")), None)
        if output.point is None or vector is None:
            continue
        exact = abs(polygon.value(vector))
        size = round(exact / plan.mu / READ) * READ
        name = f"${plan.letter}_{{{plain_name(output.point)}}}$, {tr_unit(UNITS[plan.letter])}"
        yield _row(told, k, (name, ends(vector)), size, None, (plan.mu * size, exact))


def _row(
    told: Told, k: int, names: tuple[str, str], size: float, length: float | None, values: tuple[float, float]
) -> tuple[str, ...]:
    """A quantity with its segment [mm]: its value by the plan, and by the formulas."""
    (name, segment), (found, exact) = names, values
    lever = "–" if length is None else spelt(significant(length, 4))
    apart = spelt(f"{100 * abs(found - exact) / exact:.2f}") if exact else "–"
    label = told.result.labels[told.rows[k]]
    return label, name, f"{segment} = {spelt(f'{size:.1f}')}", lever, _said(found), _said(exact), apart


def _said(value: float) -> str:
    return f"${significant(value, 4)}$"
