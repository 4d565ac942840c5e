"""The blocking contours: where the chosen shifts stand in them, how far they are from every line, points of note."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from math import nan

from tmmcalc.gears.involute.contour.task import LINES
from tmmcalc.gears.meshing.contours import UNBOUNDED, ContourPoint, PairContour
from tmmcalc.gears.notes.pairs.tables import decimals
from tmmcalc.gears.pictures.contourlines import Stroke, chosen, indexed, number_of
from tmmcalc.gears.pictures.contourplane import draw_plane
from tmmcalc.gears.pictures.words import pair_name
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula.digits import significant
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Figure, Heading, Paragraph, Table
from tmmcalc.report.telling import WIDE

SHIFTS = re.compile(r"x[₁₂](?: \+ x[₁₂])*")
HEADS = "$x_1$", "$x_2$", "$eps_alpha$", "$s_a1/m$", "$s_a2/m$", "$theta_1$", "$theta_2$"
SIZE = WIDE, 150.0  # of the picture [mm]
PLACES = 4  # decimals of shifts and distances


def blocks(order: Order) -> Iterator[Block]:
    """Every external pair that has a contour."""
    for k, found in enumerate(order.results["blocking"].pairs, 1):
        yield from _contour(found, f"contour{k}")


def _contour(found: PairContour, key: str) -> Iterator[Block]:
    title = tr("Blocking contour of the pair {teeth}", teeth="/".join(map(str, found.teeth)))
    yield Heading(f"{title} ({pair_name(found.name)})" if found.name else title)
    thickness = f"{_text(found.thickness)}*m" if found.thickness else "0"
    limits = f"$eps_alpha >= {_text(found.contact_ratio)}$, $s_a >= {thickness}$"
    said = tr(
        "The contour in figure {figure} bounds the shifts at which the pair works without interference, {limits}; "
        "table {table} says what its lines are.",
        figure=f"{{fig:{key}}}",
        limits=limits,
        table=f"{{tab:{key}_numbers}}",
    )
    yield Paragraph(said)
    picture = Drawing(*SIZE)
    seen = draw_plane(picture, Box(0.0, 0.0, *SIZE), found)
    rows = tuple((stroke.number, _lettered(stroke.text)) for stroke in seen if stroke.number)
    yield Table(tr("Lines of the blocking contour"), (tr("Line"), tr("What it is")), rows, f"{key}_numbers")
    yield Figure(tr("Blocking contour"), lambda drawing, _: drawing.add(*picture.shapes), SIZE, key)
    if (point := chosen(found)) is not None:
        yield Paragraph(_standing(point))
        yield from _distances(found, point, seen, key)
    yield from _points(found, key)


def _standing(point: ContourPoint) -> str:
    """Whether the contour holds the chosen shifts."""
    place = f"$x_1 = {_text(point.x1)}$, $x_2 = {_text(point.x2)}$"
    if point.strict:
        return tr("The chosen shifts {place} lie within the contour without undercut.", place=place)
    if point.tolerated:
        return tr("The chosen shifts {place} lie where undercut leaves the active flanks whole.", place=place)
    return tr("The chosen shifts {place} lie outside the contour.", place=place)


def _text(value: float) -> str:
    return significant(round(value, PLACES) + 0.0, PLACES + 2)


def _distances(found: PairContour, point: ContourPoint, seen: Sequence[Stroke], key: str) -> Iterator[Block]:
    """How far the chosen shifts are from every line that bounds them, and how far x1 may go at their sum."""
    rows = []
    for name, margin in found.margins.items():
        kind, wheel = name[:-1], name[-1]
        cut = found.margins.get(f"undercut{wheel}", 0.0) < 0
        # where a wheel is undercut its flank ends at the fillet, else at the limit point
        if kind != ("interference" if cut else "tolerated"):
            rows.append((number_of(found, name, seen), tr_name(LINES[name][1]), decimals(margin, PLACES)))
    said = tr(
        "The distances of the chosen shifts from the lines of the contour are in table {table}.",
        table=f"{{tab:{key}_lines}}",
    )
    yield Paragraph(said)
    head = tr("Line"), tr("What it is"), tr("Distance")
    yield Table(tr("Distances from the lines of the blocking contour"), head, tuple(rows), f"{key}_lines")
    if found.low is not None and found.high is not None:
        span = f"${_text(found.low)} <= x_1 <= {_text(found.high)}$"
        total = f"$x_Sigma = {_text(point.x1 + point.x2)}$"
        yield Paragraph(tr("At the sum of shifts {total} the contour admits {span}.", total=total, span=span))


def _points(found: PairContour, key: str) -> Iterator[Block]:
    """The points of note beside the chosen one."""
    if not found.points:
        return
    rows = []
    for point in found.points:
        values = point.x1, point.x2, point.contact_ratio, *point.tip_thickness, *map(_sliding, point.sliding)
        name = tr_name(point.name)
        if point.name != "chosen":
            name += f": {_lettered(indexed(tr_name(point.title)))}"
        rows.append((name, *(decimals(value, PLACES - 1) for value in values)))
    yield Paragraph(tr("Points of the contour are in table {table}.", table=f"{{tab:{key}_points}}"))
    yield Table(tr("Points of the blocking contour"), (tr("Point"), *HEADS), tuple(rows), f"{key}_points")


def _lettered(text: str) -> str:
    """The shifts that a drawing writes with small numbers, as a formula.

    >>> _lettered("largest x₁ + x₂")
    'largest $x_1 + x_2$'
    """
    return SHIFTS.sub(lambda found: f"${found[0].replace('₁', '_1').replace('₂', '_2')}$", text)


def _sliding(theta: float) -> float:
    """Specific sliding; nan of a flank that would have to begin at its base circle or within it."""
    return nan if not theta or abs(theta) > UNBOUNDED else theta
