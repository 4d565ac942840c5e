"""What of linkages stands on the sheets that are handed in: of kinematics on the first, of forces on the second."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial

import numpy as np

from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.forces.results import side_of
from tmmcalc.linkage.freebody import FreeBody, cleared, free_bodies
from tmmcalc.linkage.pictures.choice import at_parts, chosen
from tmmcalc.linkage.pictures.course import statics_of
from tmmcalc.linkage.pictures.cutting import NAME, SEEN, body_scale, draw_body
from tmmcalc.linkage.pictures.cycle import LinkageMotion, motion_at, whole_cycle
from tmmcalc.linkage.pictures.diagrams import OutputCurve, columns_of, draw_diagrams
from tmmcalc.linkage.pictures.forcepolygon import draw_force_polygon, polygon_scale
from tmmcalc.linkage.pictures.groups import cells, draw_groups
from tmmcalc.linkage.pictures.lever import draw_lever
from tmmcalc.linkage.pictures.plans import draw_plans_of_kind, plans_of
from tmmcalc.linkage.pictures.scheme import draw_scheme
from tmmcalc.linkage.pictures.vectors import drawn_vectors
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.structure import Structure
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr
from tmmcalc.report.sheets.piece import Piece
from tmmcalc.report.sheets.wish import diagrams_of, positions_of

LARGER = 1.4  # names on a sheet against those of a picture: 3.5 mm
PARTS = (1 / 3, 2 / 3)  # of the working stroke, where plans are drawn by default
NAMED = 32.0  # side of the room that a name of a plan has [mm]
WIDE = 1.35  # of so many more pictures side by side than one under another


def of_kinematics(order: Order) -> Iterator[Piece]:
    """Scheme, plans of the chosen positions, diagrams of the outputs, groups."""
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    result, mechanism = order.results["kinematics"], to_linkage(order.spec.linkage)
    cycle = whole_cycle(chain_of(mechanism, result), result)
    rows = positions_of(order, result.labels) or at_parts(cycle.chain, result, PARTS)
    plans, count = plans_of(mechanism, result, rows), len(rows)
    yield _on_sheet(of_scheme(result, cycle, rows[0]))
    for letter, heading in (("v", tr("Velocity polygons")), ("a", tr("Acceleration polygons"))):
        plan = partial(draw_plans_of_kind, result=result, plans=plans, letter=letter)
        drawn = drawn_vectors(plans[0].velocity if letter == "v" else plans[0].acceleration)
        side = NAMED * math.sqrt(len(drawn) + 1)
        yield Piece("linkage", heading, _larger(plan), (0.6 * side * count, 0.7 * side), (side * count, 1.2 * side))
    yield from map(_on_sheet, of_outputs(result, cycle, _wished(order, columns_of(result, cycle))))
    yield _on_sheet(of_groups(result.structure, cycle, float(result.x[rows[0]])))


def of_scheme(result: Kinematics, cycle: LinkageMotion, row: int) -> Piece:
    """The scheme in all positions, one of them with main lines."""
    scheme = partial(draw_scheme, result=result, cycle=cycle, positions=chosen(cycle, result, None, [row]))
    return Piece("linkage", tr("Kinematic scheme in its positions"), scheme, (120, 110), (300, 250))


def of_outputs(result: Kinematics, cycle: LinkageMotion, columns: list[list[OutputCurve]]) -> Iterator[Piece]:
    """The diagrams of the outputs over the cycle, linear and angular ones apart."""
    for curves in columns:
        diagram = partial(draw_diagrams, result=result, cycle=cycle, curves=curves, scaled=True)
        heading = tr("Diagrams of angles of links") if curves[0].angular else tr("Diagrams of the outputs")
        yield Piece("linkage", heading, diagram, (90, 110), (190, 200))


def of_groups(structure: Structure, cycle: LinkageMotion, x: float) -> Piece:
    """The groups apart, as they stand at an input coordinate."""
    columns, lines = _grid(len(structure.groups) + (structure.driven is None))
    groups = partial(draw_groups, structure=structure, motion=motion_at(cycle.chain, np.array([x])), cycle=cycle)
    sizes = (60.0 * columns, 65.0 * lines), (90.0 * columns, 100.0 * lines)
    return Piece("linkage", tr("Assur groups"), groups, *sizes)


def of_forces(order: Order) -> Iterator[Piece]:
    """Load diagrams, force polygons and the lever of the first of the chosen positions."""
    from tmmcalc.linkage.tables.tasks.loading import to_loading
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    result, kinematics = order.results["forces"], order.results["kinematics"]
    mechanism = to_linkage(order.spec.linkage)
    wished = positions_of(order, result.labels)
    statics = statics_of(mechanism, to_loading(order.spec), kinematics)
    cycle = whole_cycle(statics.scene.chain, kinematics)
    row = wished[0] if wished else result.labels.index(kinematics.labels[at_parts(cycle.chain, kinematics, PARTS)[0]])
    bodies = cleared(free_bodies(statics, float(result.theta[row]), side_of(result, row)), SEEN)
    chain = statics.scene.chain
    motion = motion_at(chain, statics.scene.travel.x(result.theta[[row]]))
    label = result.labels[row].removesuffix("-")
    columns, lines = _grid(len(bodies))
    draw = partial(_load_diagrams, bodies=bodies, motion=motion, cycle=cycle)
    sizes = (65.0 * columns, 75.0 * lines), (105.0 * columns, 105.0 * lines)
    heading = tr("Groups with their forces in position {label}", label=label)
    yield Piece("forces", heading, _larger(draw), *sizes)
    heading = tr("Force polygons in position {label}", label=label)
    yield Piece("forces", heading, _larger(partial(_force_polygons, bodies=bodies)), *sizes)
    lever = partial(draw_lever, statics=statics, kinematics=kinematics, result=result, row=row)
    yield Piece("forces", tr("Lever of Zhukovsky"), _larger(lever), (190, 120), (320, 220))


def _on_sheet(piece: Piece) -> Piece:
    """A piece as it stands on a sheet."""
    return piece._replace(draw=_larger(piece.draw))


def _larger(draw: Callable[..., object]) -> Callable[[Drawing, Box], object]:
    """The same with names as large as on a sheet."""

    def drawn(drawing: Drawing, box: Box) -> object:
        with drawing.lettered(LARGER):
            return draw(drawing, box)

    return drawn


def _wished(order: Order, columns: list[list[OutputCurve]]) -> list[list[OutputCurve]]:
    """The outputs that the spec names by a column of theirs, all where it names none."""
    own = {
        column: curve
        for curves in columns
        for curve in curves
        for column in (f"{letter}S_{curve.name.partition(',')[0]}" for letter in ("", "v", "a"))
    }
    names = diagrams_of(order, list(own))
    if not names:
        return columns
    kept = [own[name] for name in names]
    return [found for curves in columns if (found := [curve for curve in curves if curve in kept])]


def _load_diagrams(
    drawing: Drawing, box: Box, bodies: Sequence[FreeBody], motion: LinkageMotion, cycle: LinkageMotion
) -> None:
    def scales(places: list[Box]) -> list[float]:
        return [body_scale(drawing, place, body, motion, cycle) for place, body in zip(places, bodies, strict=True)]

    for cell, body in zip(cells(box, len(bodies), scales), bodies, strict=True):
        draw_body(drawing, cell, body, motion, cycle)


def _force_polygons(drawing: Drawing, box: Box, bodies: Sequence[FreeBody]) -> None:
    head = NAME * drawing.letters

    def scales(places: list[Box]) -> list[float]:
        return [polygon_scale(place.inset(0, 0, 0, head), body) for place, body in zip(places, bodies, strict=True)]

    for cell, body in zip(cells(box, len(bodies), scales), bodies, strict=True):
        drawing.add(Words(complex(cell.middle.real, cell.top), body.name, 2.5 * drawing.letters, 1j))
        draw_force_polygon(drawing, cell.inset(0, 0, 0, head), body, None)


def _grid(count: int) -> tuple[int, int]:
    """Columns and rows for so many pictures.

    >>> _grid(1), _grid(3), _grid(5)
    ((1, 1), (3, 1), (3, 2))
    """
    columns = count if count <= 3 else math.ceil(math.sqrt(count * WIDE))
    return columns, math.ceil(count / columns)
