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
from tmmcalc.linkage.notes.statics.inertia import rows_of
from tmmcalc.linkage.notes.statics.loaded import Loaded
from tmmcalc.linkage.notes.statics.pairs import SMALL, ToldPair, along
from tmmcalc.linkage.pictures.course import course_of
from tmmcalc.linkage.pictures.forces import drive_graphs, reaction_graphs
from tmmcalc.linkage.pictures.hodographs import draw_hodograph, hodographs_of
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import Graph, column
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Figure, Heading, Paragraph, Table
from tmmcalc.report.telling import WIDE, tabulated

COLUMNS = 7  # of numbers in a table
GRAPH, GRAPHS = 62.0, 3  # height of a diagram [mm], and how many stand in a figure
SQUARE = 105.0  # height of a hodograph [mm]
NOISE = 1e-12  # of the largest: less is nothing


class Values(NamedTuple):
    """Reactions and drive of the rows: with friction, or without."""

    reaction: Plane  # (J, n)
    normal: Real
    couple: Real
    drive: Real  # (n,)


def over_the_motion(loaded: Loaded, groups: Mapping[str, Sequence[ToldPair]]) -> Iterator[Block]:
    """All positions; ``groups`` are the pairs of each group, by its name, and of the input link."""
    yield Heading(tr("Results at all positions"), 2)
    result, statics = loaded.result, loaded.statics
    own = Values(result.reaction, result.normal, result.couple, result.drive)
    if statics.scales:
        bare = statics.scene._replace(loading=replace(statics.scene.loading, pairs=()))
        side = np.broadcast_to(loaded.every.place.side, result.theta.shape)
        found: Stack = stacked(compile_statics(bare), result.theta, side, checked=False)[0]
        ideal = Values(found.reaction, found.normal, found.couple, found.drive)
        caption = tr("Reactions without friction, {group}", group="{group}")
        tables = [*_tables(loaded, groups, ideal, caption, "ideal")]
        more = [*_tables(loaded, groups, own, tr("Reactions with friction, {group}", group="{group}"), "rubbing")]
        said = tr(
            "The reactions at all positions: without friction (tab. {ideal}) and with it (tab. {rubbing}).",
            ideal=_span(tables),
            rubbing=_span(more),
        )
        yield Paragraph(said)
        yield from (*tables, *more)
    else:
        tables = [*_tables(loaded, groups, own, tr("Reactions, {group}", group="{group}"), "all")]
        yield Paragraph(tr("The reactions at all positions: tab. {tables}.", tables=_span(tables)))
        yield from tables
    yield Paragraph(_balance(loaded))
    yield from _pictures(loaded)


def _span(tables: Sequence[Table]) -> str:
    """The numbers of some tables that follow each other."""
    ends = dict.fromkeys(f"{{tab:{table.key}}}" for table in (tables[0], tables[-1]))
    return "–".join(ends)


def _tables(
    loaded: Loaded, groups: Mapping[str, Sequence[ToldPair]], values: Values, caption: str, key: str
) -> Iterator[Table]:
    """The reactions group by group, no more than so many columns to a table; the drive with the input link."""
    turns = loaded.result.turns
    for k, (name, pairs) in enumerate(groups.items()):
        parts = [_columns(loaded, pair, values) for pair in pairs]
        if k == len(groups) - 1:
            parts.append({"$M_d$, N*m" if turns else "$F_d$, N": values.drive})
        for i, part in enumerate(_packed(parts)):
            said = caption.replace("{group}", name)
            labels = rows_of(loaded.result)
            yield tabulated(said, part, labels, head=tr("Position"), key=f"forces_{key}_{k}_{i}")


def _packed(parts: Sequence[Mapping[str, Real]]) -> list[dict[str, Real]]:
    """Columns of pairs together in tables that are not too wide."""
    found: list[dict[str, Real]] = [{}]
    for part in parts:
        if len(found[-1]) + len(part) > COLUMNS and found[-1]:
            found.append({})
        found[-1] |= part
    return [part for part in found if part]


def _columns(loaded: Loaded, pair: ToldPair, values: Values) -> dict[str, Real]:
    """The columns of a pair on the link that takes its reaction; arms are nan where there is no normal reaction."""
    j, ij = loaded.row_of(pair.joint.name), pair.ij
    sign = 1.0 if pair.link > pair.other else -1.0
    largest = float(np.max(np.abs(values.reaction)))
    if pair.joint.kind == "revolute":
        force = sign * values.reaction[j]
        clean = [np.where(np.abs(part) > NOISE * largest, part, 0.0) for part in (force.real, force.imag)]
        return {f"$R_{{{ij}x}}$, N": clean[0], f"$R_{{{ij}y}}$, N": clean[1], f"$R_{{{ij}}}$, N": np.abs(force)}
    normal, couple = sign * along(loaded, pair) * values.normal[j], sign * values.couple[j]
    found = {f"$N_{{{ij}}}$, N": normal}
    if np.max(np.abs(couple)) > NOISE * largest:
        there = np.abs(normal) > SMALL * largest
        found[f"$h_{{{ij}}}$, mm"] = np.where(there, 1e3 * couple / np.where(there, normal, 1.0), np.nan)
    return found


def _balance(loaded: Loaded) -> str:
    """What is left of the equations, and the drive by the balance of powers."""
    result = loaded.result
    return tr(
        "At every position the forces and moments on each link sum up to zero: what is left is no more than {left} of "
        "the largest. The balance of powers of all given forces gives the drive once more, without the reactions; it "
        "differs by no more than {apart} of the largest value.",
        left=_part(result.equilibrium),
        apart=_part(result.virtual),
    )


def _part(residual: Real) -> str:
    """A bound of a small part as a power of ten."""
    largest = float(np.max(np.abs(residual)))
    return f"$10**(-{math.floor(-math.log10(largest))})$" if largest > 1e-15 else "$10**(-15)$"


def _pictures(loaded: Loaded) -> Iterator[Block]:
    """Diagrams of the reactions by group and of the drive; hodographs."""
    result, course = loaded.result, course_of(loaded.statics)
    graphs = reaction_graphs(loaded.statics, result, course)
    keys = [f"forces_reactions_{k}" for k in range(0, len(graphs), GRAPHS)]
    said = tr(
        "Figures {first}–{last} show reactions and drive over the motion: $R_A$ (1–2) is the force of link 1 on link "
        "2 in joint A.",
        first=f"{{fig:{keys[0]}}}",
        last="{fig:forces_drive}",
    )
    yield Paragraph(said)
    for k, key in enumerate(keys):
        yield _diagrams(tr("Reactions over the motion"), graphs[GRAPHS * k : GRAPHS * (k + 1)], key)
    yield _diagrams(tr("Drive and its power over the motion"), drive_graphs(result, course), "forces_drive")
    structure = loaded.told.result.structure
    for k, shown in enumerate(hodographs_of(loaded.told.chain.mechanism, result)):
        draw = partial(draw_hodograph, result=result, course=course, drawn=shown, link=structure.input_link)
        yield Figure(tr("Hodograph of reactions"), draw, (SQUARE, SQUARE), f"forces_hodograph_{k}")


def _diagrams(caption: str, graphs: Sequence[Graph], key: str) -> Figure:
    def draw(drawing: Drawing, box: Box) -> None:
        column(drawing, box, graphs)

    return Figure(caption, draw, (WIDE, GRAPH * len(graphs)), key)
