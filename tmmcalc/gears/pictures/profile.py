"""The sheet of one wheel: its generation, and the enlarged profile with the characteristic positions of the tool.

The profile is the left half of the tooth, the tooth along +Y from the centre of the wheel. L is where the end of the
rack's straight flank cuts, D where its rounding reaches the root circle, A the tip, F the beginning of the involute.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.gears.meshing.halftooth import Half, ProfilePart, fault_of, half_tooth
from tmmcalc.gears.meshing.members import Member, Toothed, members
from tmmcalc.gears.meshing.refusal import error_of_all
from tmmcalc.gears.meshing.results import Pairs
from tmmcalc.gears.pictures.generation import generation_of
from tmmcalc.gears.pictures.listing import HEIGHT, Heading, Row, list_rows
from tmmcalc.gears.pictures.pair import chosen, heading, scale, tell
from tmmcalc.gears.pictures.toothdrawing import (
    ACTIVE,
    CENTRE_PATH,
    MOMENTS,
    OUTLINE,
    SpaceDrawing,
    ToothDrawing,
    joint_of,
)
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.key import Part, Sample, write_key
from tmmcalc.report.drawing.lettering import minus, plain, wrapped
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.numbers import number

TABLE = 60.0  # width of the table [mm]
SCALED = 2.3  # height of the scales of both drawings


def figure(order: Order) -> Drawing:
    """The drawing of the stage, of the pair that is chosen."""
    return profile_drawing(order.results["pair"], choose=order.choice)


def profile_drawing(found: Pairs, *, choose: int | None = None) -> Drawing:
    """One sheet a wheel; ``choose`` is the number of a pair, from 1, whose wheels are drawn; None: all.

    The sheet of a wheel that has no profile tells why. Raises `UsageError` for a pair that there is not,
    `NoSolutionError` if no wheel has a profile.
    """
    shown = members(Pairs(chosen(found, choose), found.train, ()))
    faults = [fault_of(member) for member in shown]
    errors = [fault for fault in faults if fault is not None]
    if len(errors) == len(shown):
        raise error_of_all(errors, len(shown))
    drawing, boxes = sheets(len(shown), "Profiles of teeth")
    for box, member, fault in zip(boxes, shown, faults, strict=True):
        if fault is None:
            draw_sheet(drawing, box, member)
        else:
            tell(drawing, box, f"{_title(member)} has no profile", [fault])
    return drawing


def draw_sheet(drawing: Drawing, box: Box, member: Toothed) -> None:
    """The sheet of one wheel."""
    half, generation = half_tooth(member), generation_of(member)
    free = heading(drawing, box, _title(member), "transverse section" if member.wheel.helix else "")
    beside = Box(free.right - TABLE, free.bottom, free.right, free.top)
    left, right = Box(free.left, free.bottom, beside.left - 3.0, free.top - 6.0).split(1.13, 1.0, gap=3.0, across=True)
    first = SpaceDrawing(drawing, left, member, half, generation)
    second = ToothDrawing(drawing, right, member, half)
    for place, text, board in ((left, generation.what, first.board), (right, "Left half of the tooth", second.board)):
        said = f"{text}\n{scale(board.mu)}"
        drawing.add(Words(complex(place.left, free.top), said, SCALED, -1 + 1j))
    end = list_rows(drawing, beside, _rows(member, half), (22.5, 41.0, TABLE))
    write_key(
        drawing, Box(beside.left, beside.bottom, beside.right, end - 6.0), [Part("Lines", (), _samples(member, half))]
    )


def _title(member: Toothed) -> str:
    named = {"external": "Tooth", "ring": "Tooth of the ring,", "rack": "Tooth of the rack"}[member.shape]
    if isinstance(member, Member) and member.shape == "rack":
        return f"{named}, mate of wheel {plain(member.found.task.wheels[0])}"
    shift = minus(number(round(member.shift, 5), 5))
    pair = f" of {plain(member.pair)}" if member.pair else ""
    return f"{named} of wheel {plain(member.name)}{pair}: $z$ = {member.wheel.teeth}, $x$ = {shift}".replace(
        "ring, of", "ring,"
    )


def _rows(member: Toothed, half: Half) -> list[Row]:
    """Points of the profile with their radii of curvature, and what else is to be known."""
    m = member.module
    rolls: list[Row] = [Heading(("", "", "$y$, mm", "$R$, mm"))]
    if member.shape != "rack":
        rolls = [Heading(("", "$φ$, deg", "$r$, mm", "$R$, mm"))]
    for name, part, at in _curvatures(member, half):
        at_ = np.array([at])
        place, radius, roll = part.curve.point(at_)[0], float(part.radius(at_)[0]), float(part.roll(at_)[0])
        height = place.imag if member.shape == "rack" else abs(place)
        turned = (
            ""
            if member.shape == "rack" or (member.shape == "ring" and part is half.fillet and not roll)
            else _deg(roll)
        )
        rolls.append((name, turned, _mm(m * height), _mm(m * radius) if radius else "straight"))
    rolls.append(("least $|R|$ of the fillet", "", "", _mm(m * half.least_radius)))
    rolls += [("",), ("$R$ < 0: hollow",)]
    if half.undercut:
        rolls.append(("undercut: the fillet crosses the involute in $F$",))
    rolls += [(line,) for line in wrapped(half.remark, TABLE, HEIGHT)]
    return rolls


def _samples(member: Toothed, half: Half) -> list[Sample]:
    """What the lines are."""
    found = [Sample("tooth", OUTLINE)]
    if isinstance(member, Member):
        found.append(Sample("active flank", ACTIVE))
    if member.shape != "external":
        return found
    for (name, pen), roll in zip(MOMENTS, half.rolls, strict=False):
        found.append(Sample(f"rack at $φ_{name}$ = {_deg(roll)}°", pen))
    return [*found, Sample("path of $S$, centre of the rounding", CENTRE_PATH)]


def _curvatures(member: Toothed, half: Half) -> list[tuple[str, ProfilePart, float]]:
    """Ends of fillet and flank."""
    fillet, flank = half.fillet, half.flank
    join = joint_of(member, half)
    return [
        ("fillet $D$", fillet, fillet.curve.start),
        (f"fillet ${join}$", fillet, fillet.curve.end),
        (f"flank ${join}$", flank, flank.curve.start),
        ("flank $A$", flank, flank.curve.end),
    ]


def _deg(value: float) -> str:
    return minus(number(round(math.degrees(value), 3), 7))


def _mm(value: float) -> str:
    return minus(number(round(1e3 * value, 4) + 0.0, 7))
