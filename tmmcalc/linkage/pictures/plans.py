"""The plans of velocities and accelerations of one position: both, the length of each segment, how the links turn."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.pictures.scheme import position_text
from tmmcalc.linkage.pictures.vectors import MARGIN, designation, draw_polygon, drawn_vectors, vertex_name
from tmmcalc.linkage.polygons import polygons
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.segments import PlanScale
from tmmcalc.linkage.vectors import Polygon, VectorPolygons
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board, needed
from tmmcalc.report.drawing.key import samples_in_rows
from tmmcalc.report.drawing.lettering import wrapped
from tmmcalc.report.drawing.pens import VECTORS
from tmmcalc.report.drawing.scales import factor_text, standard_scale
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.drawing.tables import draw_table
from tmmcalc.report.language import tr, tr_measured, tr_name, tr_number, tr_unit
from tmmcalc.report.numbers import number

HEADING, TITLE, FOOT = 7.0, 6.0, 5.0  # room of the heading, of the name of a plan, of the kinds of lines [mm]
TABLES = 52.0  # height of the tables [mm]
GAP = 4.0
SMALL, LINE = 0.85, 1.9  # rotations of links beside the title of their plan, and a line of them, in heights of letters
REACH = 1.3  # a special point farther away than this against the rest is not on a plan
STILL = 1e-12  # of the fastest link: no sense
SENSES = {True: "↺", False: "↻"}  # counter-clockwise or not
UNITS = {"v": "m/s", "a": "m/s^2"}


def plans_of(mechanism: Mechanism, result: Kinematics, rows: Sequence[int]) -> list[VectorPolygons]:
    """The plans of some positions, with one special point of each basic link that lies on them all."""
    plans = [polygons(mechanism, result, row, special=True) for row in rows]
    kept = _special_points(plans)
    return [_with_special(plan, kept) for plan in plans]


def _special_points(plans: Sequence[VectorPolygons]) -> set[str]:
    """Of every basic link the special point that goes least far from the poles, where it stays among the rest."""
    reaches: dict[str, float] = {}
    links: dict[str, int] = {}
    for polygon in (each for plan in plans for each in (plan.velocity, plan.acceleration)):
        special = {vector.head: vector.link for vector in polygon.vectors if vector.kind == "special"}
        size = max(abs(tip) for name, tip in polygon.vertices.items() if name not in special)
        for name in special:
            reaches[name] = max(reaches.get(name, 0.0), abs(polygon.vertices[name]) / (size or 1.0))
        links |= special
    nearest = (min((n for n in links if links[n] == link), key=reaches.__getitem__) for link in set(links.values()))
    return {name for name in nearest if reaches[name] < REACH}


def _with_special(plan: VectorPolygons, kept: set[str]) -> VectorPolygons:
    """The plans with these special points alone."""

    def cleared(polygon: Polygon) -> Polygon:
        others = {v.head for v in polygon.vectors if v.kind == "special"} - kept
        vertices = {name: tip for name, tip in polygon.vertices.items() if name not in others}
        return Polygon(polygon.pole, vertices, tuple(v for v in polygon.vectors if v.head not in others))

    parts = cleared(plan.velocity), cleared(plan.acceleration)
    return VectorPolygons(plan.position, *parts, plan.fixed, plan.omega, plan.eps)


def plan_scale(plans: Sequence[VectorPolygons], box: Box) -> PlanScale:
    """The standard scales at which each plan of all positions fits into a rectangle."""
    return PlanScale(
        *(
            standard_scale(max(needed(np.array([*each.vertices.values()]), box, MARGIN) for each in polygons))
            for polygons in ([plan.velocity for plan in plans], [plan.acceleration for plan in plans])
        )
    )


class _Places(NamedTuple):
    """Where on a sheet both plans stand, and the tables of both and of the links."""

    plans: tuple[Box, Box]
    tables: tuple[Box, Box, Box]


def _places(box: Box, plans: Sequence[VectorPolygons]) -> _Places:
    """Tables below or beside the plans, as these become larger, the accelerations first."""
    free = box.inset(0, FOOT + 1.5, 0, HEADING)
    upper, lower = free.split(free.height - TABLES, TABLES)
    left, right = free.split(2.0, 1.0, gap=GAP, across=True)
    found = []
    for field, tables in (
        (upper, lower.split(2.1, 2.1, 1.3, gap=GAP, across=True)),
        (left, right.split(1.5, 2.2, 1.0, gap=GAP)),
    ):
        one, other = (half.inset(0, 0, 0, TITLE) for half in field.split(1, 1, gap=GAP, across=True))
        first, second, third = tables
        found.append(_Places((one, other), (first, second, third)))

    def size(places: _Places) -> tuple[float, float]:
        scale = plan_scale(plans, places.plans[0])
        return scale.velocity * scale.acceleration, scale.acceleration

    return min(found, key=size)


def draw_plan_sheets(
    drawing: Drawing, boxes: Sequence[Box], result: Kinematics, plans: Sequence[VectorPolygons]
) -> None:
    """A position to a sheet, all to one pair of scales."""
    scale = plan_scale(plans, _places(boxes[0], plans).plans[0])
    for box, plan in zip(boxes, plans, strict=True):
        drawing.add(Words(complex(box.middle.real, box.top), position_text(result, plan.position), 3.5, 1j))
        places = _places(box, plans)
        for half, (letter, polygon, mu) in zip(places.plans, _both(plan, scale), strict=True):
            title = complex(half.middle.real, half.top + TITLE)
            drawing.add(Words(title, f"{plan_name(letter)},  {scale_note(letter, mu)}", 3.0, 1j))
            draw_polygon(drawing, half, polygon, letter, plan.fixed, mu)
        _draw_tables(drawing, places.tables, plan, scale)
        _draw_kinds(drawing, Box(box.left, box.bottom, box.right, box.bottom + FOOT - 1.5), plan)


def _both(plan: VectorPolygons, scale: PlanScale) -> list[tuple[str, Polygon, float]]:
    return [("v", plan.velocity, scale.velocity), ("a", plan.acceleration, scale.acceleration)]


class _Row(NamedTuple):
    """Plans of one kind side by side."""

    polygons: list[Polygon]
    parts: list[Box]
    fields: list[Box]  # what of the parts is left to the plans
    turning: list[list[str]]  # lines of words about the links that turn

    @property
    def scale(self) -> float:
        """The standard scale factor at which all of them are as large as they can be."""
        tips = [np.array([*each.vertices.values()]) for each in self.polygons]
        return standard_scale(max(needed(z, field, MARGIN) for z, field in zip(tips, self.fields, strict=True)))


def _row(box: Box, plans: Sequence[VectorPolygons], letter: str, larger: float) -> _Row:
    head, height = TITLE * larger, 2.5 * larger
    polygons = [plan.velocity if letter == "v" else plan.acceleration for plan in plans]
    wide = [float(np.ptp(np.array([*each.vertices.values()]).real)) for each in polygons]
    shares = [max(each, max(wide) / 3) or 1.0 for each in wide]
    parts = box.inset(0, 0, 0, head).split(*shares, across=True)
    small = SMALL * height
    turning = [
        wrapped(_rotations(plan, letter), part.width - GAP, small) for plan, part in zip(plans, parts, strict=True)
    ]
    foot = LINE * small * max(map(len, turning))
    return _Row(polygons, [*parts], [part.inset(0, foot, 0, head) for part in parts], turning)


def scale_of_kind(box: Box, plans: Sequence[VectorPolygons], letter: str) -> float:
    """The scale factor to which `draw_plans_of_kind` draws them in a rectangle, where no other is asked for."""
    return _row(box, plans, letter, 1.0).scale


def draw_plans_of_kind(
    drawing: Drawing, box: Box, result: Kinematics, plans: Sequence[VectorPolygons], letter: str, mu: float = 0.0
) -> list[Board]:
    """The plans of velocities (``v``) or of accelerations (``a``) of some positions side by side, to one scale, ``mu``.

    Without it they are as large as a standard one allows.
    """
    height = 2.5 * drawing.letters
    row = _row(box, plans, letter, drawing.letters)
    mu = mu or row.scale
    drawing.add(Words(complex(box.middle.real, box.top), scale_note(letter, mu), height, 1j))
    boards = []
    for plan, polygon, part, field, said in zip(plans, *row, strict=True):
        title = complex(part.middle.real, part.top)
        drawing.add(Words(complex(part.middle.real, part.bottom), "\n".join(said), SMALL * height, -1j))
        drawing.add(Words(title, position_text(result, plan.position), height, 1j))
        boards.append(draw_polygon(drawing, field, polygon, letter, plan.fixed, mu))
    return boards


def _rotations(plan: VectorPolygons, letter: str) -> str:
    """The angular velocities, or accelerations, of the links with their senses."""
    rates, symbol, unit = (plan.omega, "ω", "rad/s") if letter == "v" else (plan.eps, "ε", "rad/s^2")
    largest = max(map(abs, rates.values()), default=0.0)
    listed = "; ".join(f"${symbol}_{{{link}}}$\u00a0=\u00a0{_size(rate, largest)}" for link, rate in rates.items())
    return f"{listed} {tr_unit(unit)}" if listed else ""


def plan_name(letter: str) -> str:
    """What a plan of ``v`` or ``a`` is."""
    return tr("Velocity polygon") if letter == "v" else tr("Acceleration polygon")


def scale_note(letter: str, mu: float) -> str:
    """The scale as it is written beside a plan."""
    return factor_text(f"μ_{letter}", mu, "(m/s)/mm" if letter == "v" else "(m/s²)/mm")


def _draw_tables(drawing: Drawing, boxes: tuple[Box, Box, Box], plan: VectorPolygons, scale: PlanScale) -> None:
    """The segments of the velocities, those of the accelerations, the links that turn."""
    fastest, quickest = (max(map(abs, rates.values()), default=0.0) for rates in (plan.omega, plan.eps))
    for part, (letter, polygon, mu) in zip(boxes, _both(plan, scale), strict=False):
        head = [tr("vector"), tr("segment"), tr_unit(UNITS[letter]), tr_unit("mm")]
        draw_table(drawing, part, head, _segment_rows(polygon, letter, mu))
    head = [tr("link"), f"$ω$, {tr_unit('rad/s')}", f"$ε$, {tr_unit('rad/s^2')}"]
    rows = [[str(link), _size(rate, fastest), _size(plan.eps[link], quickest)] for link, rate in plan.omega.items()]
    draw_table(drawing, boxes[2], head, rows)


def _segment_rows(polygon: Polygon, letter: str, mu: float) -> list[list[str]]:
    """Designation, vertices, size and length of every segment."""
    found = []
    for vector in drawn_vectors(polygon):
        size = abs(polygon.value(vector))
        ends = f"{vertex_name(vector.tail)}{vertex_name(vector.head)}".replace("$$", " ")
        found.append([designation(vector, letter), ends, number(size, 4), tr_number(f"{size / mu:.2f}")])
    return found


def _size(rate: float, largest: float) -> str:
    """The size of an angular velocity or acceleration with its sense."""
    still = abs(rate) <= STILL * largest
    return "0" if still else f"{tr_measured(f'{abs(rate):.5g}')}\u00a0{SENSES[rate > 0]}"


def _draw_kinds(drawing: Drawing, box: Box, plan: VectorPolygons) -> None:
    """What the lines of the vectors are."""
    names = {
        "relative": tr("relative, of two points of a link"),
        "normal": tr("normal part"),
        "tangential": tr("tangential part"),
        "sliding": tr("relative, of a slider on its guide"),
        "coriolis": tr("Coriolis"),
        "special": tr("of a special point"),
    }
    used = {vector.kind for polygon in (plan.velocity, plan.acceleration) for vector in drawn_vectors(polygon)}
    samples_in_rows(
        drawing, box, [(names.get(kind) or tr_name(kind), pen) for kind, pen in VECTORS.items() if kind in used], 2.2
    )
