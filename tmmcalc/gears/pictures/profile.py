"""The sheet of one wheel: its generation, and the enlarged profile with the characteristic positions of the tool.

The profile is the left half of the tooth, the tooth along +Y from the centre of the wheel. L is where the end of the
rack's straight flank cuts, D where its rounding reaches the root circle, A the tip, F the beginning of the involute.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.gears.meshing.booktables import BookTables, book_tables
from tmmcalc.gears.meshing.halftooth import Half, ProfilePart, fault_of, half_tooth
from tmmcalc.gears.meshing.members import Member, Toothed, members
from tmmcalc.gears.meshing.refusal import error_of_all
from tmmcalc.gears.meshing.results import Pairs
from tmmcalc.gears.pictures.generation import generation_of
from tmmcalc.gears.pictures.listing import HEIGHT, Heading, Row, list_rows
from tmmcalc.gears.pictures.pair import chosen, heading, tell
from tmmcalc.gears.pictures.toothdrawing import (
    ACTIVE,
    CENTRE_PATH,
    MOMENTS,
    OUTLINE,
    SpaceDrawing,
    ToothDrawing,
    joint_of,
)
from tmmcalc.gears.pictures.toothpoints import INTERVALS, draw_tooth_points
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.key import Part, Sample, write_key
from tmmcalc.report.drawing.lettering import minus, plain, wrapped
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.scales import scale_text
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number

TABLE = 60.0  # width of the table [mm]
SCALED = 2.3  # height of the scales of both drawings


def figure(order: Order) -> Drawing:
    """The drawing of the stage, of the pair that is chosen."""
    return profile_drawing(order.results["pair"], choose=order.choice)


def profile_drawing(found: Pairs, *, choose: int | None = None) -> Drawing:
    """Two sheets a wheel, one of a rack; ``choose`` is the number of a pair, from 1, whose wheels are drawn; None: all.

    The sheet of a wheel that has no profile tells why. Raises `UsageError` for a pair that there is not,
    `NoSolutionError` if no wheel has a profile.
    """
    shown = members(Pairs(chosen(found, choose), found.train, ()))
    faults = [fault_of(member) for member in shown]
    errors = [fault for fault in faults if fault is not None]
    if len(errors) == len(shown):
        raise error_of_all(errors, len(shown))
    tables_of = [
        None if fault is not None else book_tables(member, "tooth", INTERVALS)
        for member, fault in zip(shown, faults, strict=True)
    ]
    drawing, boxes = sheets(len(shown) + sum(tables is not None for tables in tables_of), tr("Profiles of teeth"))
    left = iter(boxes)
    for member, fault, tables in zip(shown, faults, tables_of, strict=True):
        if fault is not None:
            tell(drawing, next(left), tr("{wheel} has no profile", wheel=_title(member)), [fault])
            continue
        draw_sheet(drawing, next(left), member)
        if tables is not None:
            draw_points(drawing, next(left), tables)
    return drawing


def draw_points(drawing: Drawing, box: Box, tables: BookTables) -> None:
    """The sheet of one wheel by the textbook's points."""
    draw_tooth_points(drawing, heading(drawing, box, tr("{wheel}, by points", wheel=_title(tables.member))), tables)


def draw_sheet(drawing: Drawing, box: Box, member: Toothed) -> None:
    """The sheet of one wheel and what cuts it."""
    half, generation = half_tooth(member), generation_of(member)
    free = heading(drawing, box, _title(member), tr("transverse section") if member.wheel.helix else "")
    beside = Box(free.right - TABLE, free.bottom, free.right, free.top)
    left, right = Box(free.left, free.bottom, beside.left - 3.0, free.top - 6.0).split(1.13, 1.0, gap=3.0, across=True)
    first = SpaceDrawing(drawing, left, member, half, generation)
    second = ToothDrawing(drawing, right, member, half)
    for place, text, board in (
        (left, generation.what, first.board),
        (right, tr("Left half of the tooth"), second.board),
    ):
        said = f"{text}\n{scale_text(board.mu)}"
        drawing.add(Words(complex(place.left, free.top), said, SCALED, -1 + 1j))
    end = list_rows(drawing, beside, _rows(member, half), (22.5, 41.0, TABLE))
    write_key(
        drawing,
        Box(beside.left, beside.bottom, beside.right, end - 6.0),
        [Part(tr("Lines"), (), _samples(member, half))],
    )


def _title(member: Toothed) -> str:
    if isinstance(member, Member) and member.shape == "rack":
        return tr("Tooth of the rack, mate of wheel {wheel}", wheel=plain(member.found.task.wheels[0]))
    shift = minus(number(round(member.shift, 5), 5))
    sizes = f"$z$ = {member.wheel.teeth}, $x$ = {shift}"
    said = {"wheel": plain(member.name), "pair": plain(member.pair), "sizes": sizes}
    if member.shape == "ring" and member.pair:
        return tr("Tooth of the ring, wheel {wheel} of {pair}: {sizes}", **said)
    if member.shape == "ring":
        return tr("Tooth of the ring, wheel {wheel}: {sizes}", **said)
    if member.pair:
        return tr("Tooth of wheel {wheel} of {pair}: {sizes}", **said)
    return tr("Tooth of wheel {wheel}: {sizes}", **said)


def _rows(member: Toothed, half: Half) -> list[Row]:
    """Points of the profile with their radii of curvature, and what else is to be known."""
    m, mm = member.module, tr_unit("mm")
    rolls: list[Row] = [Heading(("", "", f"$y$, {mm}", f"$R$, {mm}"))]
    if member.shape != "rack":
        rolls = [Heading(("", "$φ$, °", f"$r$, {mm}", f"$R$, {mm}"))]
    for name, part, at in _curvatures(member, half):
        at_ = np.array([at])
        place, radius, roll = part.curve.point(at_)[0], float(part.radius(at_)[0]), float(part.roll(at_)[0])
        height = place.imag if member.shape == "rack" else abs(place)
        turned = (
            ""
            if member.shape == "rack" or (member.shape == "ring" and part is half.fillet and not roll)
            else _deg(roll)
        )
        rolls.append((name, turned, _mm(m * height), _mm(m * radius) if radius else tr("straight")))
    rolls.append((tr("least $|R|$ of the fillet"), "", "", _mm(m * half.least_radius)))
    rolls += [("",), (tr("$R$ < 0: hollow"),)]
    if half.undercut:
        rolls.append((tr("undercut: the fillet crosses the involute in $F$"),))
    rolls += [(line,) for line in wrapped(_pointed(member, half), TABLE, HEIGHT)]
    return rolls


def _pointed(member: Toothed, half: Half) -> str:
    """What is said of a tooth that ends below its tip circle; empty of others."""
    if not half.remark:
        return ""
    radius = number(1e3 * half.tip * member.module, 6)
    return tr("pointed at the radius {radius} mm, below its tip circle", radius=radius)


def _samples(member: Toothed, half: Half) -> list[Sample]:
    """What the lines are."""
    found = [Sample(tr("tooth"), OUTLINE)]
    if isinstance(member, Member):
        found.append(Sample(tr("active flank"), ACTIVE))
    if member.shape != "external":
        return found
    for (name, pen), roll in zip(MOMENTS, half.rolls, strict=False):
        found.append(Sample(tr("rack at {angle}", angle=f"$φ_{name}$ = {_deg(roll)}°"), pen))
    return [*found, Sample(tr("path of $S$, centre of the rounding"), CENTRE_PATH)]


def _curvatures(member: Toothed, half: Half) -> list[tuple[str, ProfilePart, float]]:
    """Ends of fillet and flank."""
    fillet, flank = half.fillet, half.flank
    join = joint_of(member, half)
    return [
        (tr("fillet $D$"), fillet, fillet.curve.start),
        (tr("fillet {point}", point=f"${join}$"), fillet, fillet.curve.end),
        (tr("flank {point}", point=f"${join}$"), flank, flank.curve.start),
        (tr("flank $A$"), flank, flank.curve.end),
    ]


def _deg(value: float) -> str:
    return minus(number(round(math.degrees(value), 3), 7))


def _mm(value: float) -> str:
    return minus(number(round(1e3 * value, 4) + 0.0, 7))
