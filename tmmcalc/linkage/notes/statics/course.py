"""The forces over the whole motion: tables with and without friction, the balance of powers, diagrams, hodographs."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.forces.kinetostatics import compile_statics
from tmmcalc.linkage.forces.stack import Stack, stacked
from tmmcalc.linkage.notes.statics.loaded import Loaded, packed
from tmmcalc.linkage.notes.statics.pairs import SMALL, ToldPair, along, rubs
from tmmcalc.linkage.pictures.course import course_of
from tmmcalc.linkage.pictures.cycle import closed
from tmmcalc.linkage.pictures.forces import drive_graphs, reaction_graphs
from tmmcalc.linkage.pictures.hodographs import draw_hodograph, hodographs_of
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import Graph, column
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Figure, Heading, Paragraph, Result, Table
from tmmcalc.report.numbers import NOISE
from tmmcalc.report.telling import WIDE, located, span, tabulated, two_sides

GRAPH, HALF = 46.0, (84.0, 52.0)  # height of a diagram of reactions, size of one of the drive [mm]
SQUARE = 80.0  # height of a hodograph [mm]


class Values(NamedTuple):
    """Reactions and drive of the rows: with friction, or without."""

    reaction: Plane  # (J, n)
    normal: Real
    couple: Real
    friction: Real | None  # None without friction
    drive: Real  # (n,)


def over_the_motion(loaded: Loaded, groups: Mapping[str, Sequence[ToldPair]]) -> Iterator[Block]:
    """All positions; ``groups`` are the pairs of each group, by its name, and of the input link."""
    yield Heading(tr("Results at all positions"), 2)
    result, statics = loaded.result, loaded.statics
    own = Values(result.reaction, result.normal, result.couple, result.friction, result.drive)
    if statics.scales:
        bare = statics.scene._replace(loading=replace(statics.scene.loading, pairs=()))
        side = np.broadcast_to(loaded.every.place.side, result.theta.shape)
        found: Stack = stacked(compile_statics(bare), result.theta, side, checked=False)[0]
        ideal = Values(found.reaction, found.normal, found.couple, None, found.drive)
        caption = tr("Reactions without friction, {group}", group="{group}")
        tables = [*_tables(loaded, groups, ideal, caption, "ideal")]
        more = [*_tables(loaded, groups, own, tr("Reactions with friction, {group}", group="{group}"), "rubbing")]
        said = tr(
            "The reactions at all positions without friction are {ideal}, with friction {rubbing}.",
            ideal=located(tables),
            rubbing=located(more),
        )
    else:
        tables, more = [*_tables(loaded, groups, own, tr("Reactions, {group}", group="{group}"), "all")], []
        said = tr("The reactions at all positions are {where}.", where=located(tables))
    yield Paragraph(said)
    yield from _jumps(loaded)
    yield from (*tables, *more)
    yield Paragraph(_balance(loaded))
    yield from _pictures(loaded)
    yield from _results(loaded, groups)


def _jumps(loaded: Loaded) -> Iterator[Paragraph]:
    """Which side of a jump the rows have."""
    result = loaded.result
    jump = next((label for label in result.labels if label.endswith("-")), None)
    if jump is not None:
        said = tr(
            "Where friction jumps, as at position {label}, the limit just before stands in the row {before}.",
            label=jump.removesuffix("-"),
            before=jump.replace("-", "−"),
        )
        yield Paragraph(said)
    if closed(loaded.told.chain):
        forces = np.concatenate((result.reaction.real, result.reaction.imag))
        turns = np.array([pair.kind == "revolute" for pair in result.pairs])
        groups = result.drive, forces, result.friction[turns], result.friction[~turns]
        yield from two_sides(result.labels, groups)


def _tables(
    loaded: Loaded, groups: Mapping[str, Sequence[ToldPair]], values: Values, caption: str, key: str
) -> Iterator[Table]:
    """The reactions group by group, no more than so many columns to a table; the drive with the input link."""
    turns = loaded.result.turns
    for k, (name, pairs) in enumerate(groups.items()):
        parts = [_columns(loaded, pair, values) for pair in pairs]
        if k == len(groups) - 1:
            parts.append({"$M_d$, N*m" if turns else "$F_d$, N": values.drive})
        for i, part in enumerate(packed(parts)):
            said = caption.replace("{group}", name)
            labels = [label.replace("-", "−") for label in loaded.result.labels]
            yield tabulated(said, part, labels, head=tr("No."), key=f"forces_{key}_{k}_{i}")


def _columns(loaded: Loaded, pair: ToldPair, values: Values) -> dict[str, Real]:
    """The columns of a pair on the link that takes its reaction; arms are nan where there is no normal reaction."""
    j, ij = loaded.row_of(pair.joint.name), pair.ij
    sign = 1.0 if pair.link > pair.other else -1.0
    largest = float(np.max(np.abs(values.reaction)))
    rubbing = sign * values.friction[j] if values.friction is not None and rubs(loaded, pair) else None
    if pair.joint.kind == "revolute":
        force = sign * values.reaction[j]
        x, y = (np.where(np.abs(part) > NOISE * largest, part, 0.0) for part in (force.real, force.imag))
        found = {f"$R_{{{ij}x}}$, N": x, f"$R_{{{ij}y}}$, N": y, f"$R_{{{ij}}}$, N": np.abs(force)}
        return found if rubbing is None else {**found, f"$M_{{{ij}}}$, N*m": rubbing}
    sense = along(loaded, pair)
    normal, couple = sign * sense * values.normal[j], sign * values.couple[j]
    found = {f"$N_{{{ij}}}$, N": normal}
    if np.max(np.abs(couple)) > NOISE * largest:
        there = np.abs(normal) > SMALL * largest
        found[f"$h_{{{ij}}}$, mm"] = np.where(there, 1e3 * couple / np.where(there, normal, 1.0), np.nan)
    return found if rubbing is None else {**found, f"$F_{{{ij}}}$, N": sense * rubbing}


def _balance(loaded: Loaded) -> str:
    """What is left of the equations, and the drive by the balance of powers."""
    result = loaded.result
    return tr(
        "At every position the forces and moments on each link sum up to zero: what is left is no more than {left} of "
        "the largest. The value of ${drive}$ by the balance of powers of all given forces, without the reactions, "
        "differs by no more than {apart} of the largest.",
        left=_part(result.equilibrium),
        apart=_part(result.virtual),
        drive="M_d" if result.turns else "F_d",
    )


def _part(residual: Real) -> str:
    """A bound of a small part as a power of ten."""
    largest = float(np.max(np.abs(residual)))
    return f"$10**(-{math.floor(-math.log10(largest))})$" if largest > 1e-15 else "$10**(-15)$"


def _pictures(loaded: Loaded) -> Iterator[Block]:
    """Diagrams of the reactions by group and of the drive; hodographs."""
    result, course = loaded.result, course_of(loaded.statics)
    shown = hodographs_of(loaded.told.chain.mechanism, result)
    link = loaded.told.result.structure.input_link

    def hodographs(drawing: Drawing, box: Box) -> None:
        places = box.split(*(1.0 for _ in shown), gap=4.0, across=True)
        for place, each in zip(places, shown, strict=True):
            draw_hodograph(drawing, place, result, course, each, link)

    reactions = reaction_graphs(loaded.statics, result, course)
    moment, power = drive_graphs(result, course)
    what = tr("Balancing moment over the motion") if result.turns else tr("Balancing force over the motion")
    graphs = [
        *(_graph(tr("Reactions over the motion"), graph, (WIDE, GRAPH), k) for k, graph in enumerate(reactions)),
        _graph(what, moment, HALF, len(reactions)),
        _graph(tr("Power of the drive over the motion"), power, HALF, len(reactions) + 1),
    ]
    said = tr(
        "Figures {figures} show the reactions, ${drive}$ and the power of the drive over the motion; $R_A$ (1–2) "
        "stands for the force of link 1 on link 2 in pair A.",
        figures=span(graphs),
        drive="M_d" if result.turns else "F_d",
    )
    yield Paragraph(said)
    yield from graphs
    if shown:
        yield Paragraph(tr("The hodographs of the reactions are in figure {fig:forces_hodographs}."))
        yield Figure(tr("Hodographs of reactions"), hodographs, (WIDE, SQUARE), "forces_hodographs")


def _graph(caption: str, graph: Graph, size: tuple[float, float], k: int) -> Figure:
    """A diagram over the motion, with the group that it is of."""
    whole = f"{caption}, {graph.title}" if graph.title else caption
    return Figure(whole, partial(_diagram, graph=graph), size, f"forces_diagram_{k}")


def _results(loaded: Loaded, groups: Mapping[str, Sequence[ToldPair]]) -> Iterator[Block]:
    """The largest reactions and what the drive must do, for the conclusions."""
    result = loaded.result
    largest = max(abs(extreme.value) for extreme in result.drive_extremes)
    if result.turns:
        yield Result("M_d", Given(largest, "N*m", tr("largest balancing moment")))
    else:
        yield Result("F_d", Given(largest, "N", tr("largest balancing force")))
    if not loaded.powered:  # which the chapter on works has
        yield Result("P_d", Given(result.power_mean.value, "W", tr("mean power of the drive")))
    for pair in (pair for pairs in groups.values() for pair in pairs):
        found = result.pairs[loaded.row_of(pair.joint.name)].force.value
        where = tr("pair {joint}", joint=pair.joint.name)
        yield Result(f"R_{{{pair.ij}}}", Given(found, "N", tr("largest reaction")), place=where)


def _diagram(drawing: Drawing, box: Box, graph: Graph) -> None:
    column(drawing, box, [graph])
