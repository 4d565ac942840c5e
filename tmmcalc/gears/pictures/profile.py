"""The sheet of one wheel: its generation, and the enlarged profile with the characteristic positions of the tool.

The profile is the left half of the tooth, the tooth along +Y from the centre of the wheel. L is where the end of the
rack's straight flank cuts, D where its rounding reaches the root circle, A the tip, F the beginning of the involute.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from matplotlib.figure import Figure, SubFigure
from matplotlib.lines import Line2D

from tmmcalc.gears.meshing.halftooth import Half, ProfilePart, fault_of, half_tooth
from tmmcalc.gears.meshing.members import Member, Toothed, members
from tmmcalc.gears.meshing.refusal import error_of_all
from tmmcalc.gears.meshing.results import Pairs
from tmmcalc.gears.pictures.generation import generation_of
from tmmcalc.gears.pictures.listing import Heading, Row, list_rows
from tmmcalc.gears.pictures.pair import chosen, scale, tell
from tmmcalc.gears.pictures.toothdrawing import (
    ACTIVE,
    CENTRE_PATH,
    MOMENTS,
    OUTLINE,
    SpaceDrawing,
    ToothDrawing,
    joint_of,
)
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import INK


def figure(order: Order) -> Figure:
    """The figure of the stage, of the pair that is chosen."""
    return profile_figure(order.results["pair"], choose=order.choice)


def profile_figure(found: Pairs, *, choose: int | None = None) -> Figure:
    """One sheet a wheel; ``choose`` is the number of a pair, from 1, whose wheels are drawn; None: all.

    The sheet of a wheel that has no profile tells why. Raises `UsageError` for a pair that there is not,
    `NoSolutionError` if no wheel has a profile.
    """
    shown = members(Pairs(chosen(found, choose), found.train, ()))
    faults = [fault_of(member) for member in shown]
    errors = [fault for fault in faults if fault is not None]
    if len(errors) == len(shown):
        raise error_of_all(errors, len(shown))
    figure, sheets = blank(len(shown))
    finish = []
    for sheet, member, fault in zip(sheets, shown, faults, strict=True):
        if fault is None:
            finish.append(draw_sheet(sheet, member))
        else:
            tell(sheet, f"{_title(member)} has no profile", [fault])
    settle(figure)
    for draw in finish:
        draw()
    return figure


def draw_sheet(sheet: SubFigure, member: Toothed) -> Callable[[], None]:
    """Lay the sheet of one wheel out; what is returned draws."""
    half, generation = half_tooth(member), generation_of(member)
    left, middle = sheet.add_axes((0.015, 0.03, 0.41, 0.86)), sheet.add_axes((0.435, 0.03, 0.335, 0.86))
    table = sheet.add_axes((0.785, 0.05, 0.205, 0.84))

    def finish() -> None:
        section = "; transverse section" if member.wheel.helix else ""
        sheet.text(0.015, 0.965, f"{_title(member)}{section}", size=10)
        first = SpaceDrawing(left, member, half, generation)
        second = ToothDrawing(middle, member, half)
        heads = ((0.015, generation.what, first.board), (0.435, "Left half of the tooth", second.board))
        for x, text, board in heads:
            sheet.text(x, 0.925, f"{text}, {scale(board.mu)}", size=8)
        list_rows(table, _rows(member, half), (27.0, 43.5, 60.0))
        table.legend(
            handles=_handles(member, half), loc="lower left", handlelength=3, borderaxespad=0, labelspacing=0.7
        )

    return finish


def _title(member: Toothed) -> str:
    named = {"external": "Tooth", "ring": "Tooth of the ring,", "rack": "Tooth of the rack"}[member.shape]
    if isinstance(member, Member) and member.shape == "rack":
        return f"{named}, mate of wheel {member.found.task.wheels[0]}"
    shift = signed(round(member.shift, 5), 5)
    pair = f" of {member.pair}" if member.pair else ""
    return f"{named} of wheel {member.name}{pair}: $z$ = {member.wheel.teeth}, $x$ = {shift}".replace(
        "ring, of", "ring,"
    )


def _rows(member: Toothed, half: Half) -> list[Row]:
    """Points of the profile with their radii of curvature, and what else is to be known."""
    m = member.module
    rolls: list[Row] = [Heading(("", "", "$y$, mm", "$R$, mm"))]
    if member.shape != "rack":
        rolls = [Heading(("", "$\\varphi$, deg", "$r$, mm", "$R$, mm"))]
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
    if half.remark:
        rolls.append((half.remark,))
    return rolls


def _handles(member: Toothed, half: Half) -> list[Line2D]:
    """What the lines are."""
    found = [Line2D([], [], label="tooth", **OUTLINE, color=INK)]
    if isinstance(member, Member):
        found.append(Line2D([], [], label="active flank", **ACTIVE))
    if member.shape != "external":
        return found
    for (name, color, dashes), roll in zip(MOMENTS, half.rolls, strict=False):
        text = f"rack at $\\varphi_{name}$ = {_deg(roll)}°"
        found.append(Line2D([], [], label=text, color=color, linestyle=dashes, linewidth=1.0))
    return [*found, Line2D([], [], label="path of $S$, centre of the rounding", **CENTRE_PATH)]


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
    return signed(round(math.degrees(value), 3), 7)


def _mm(value: float) -> str:
    return signed(round(1e3 * value, 4) + 0.0, 7)
