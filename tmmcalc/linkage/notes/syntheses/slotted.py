"""The oscillating slotted link, the crank shorter than the line of centres: every size follows from the one before."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.linkage.notes.syntheses.told import Told, angle, length, meanings, ratio
from tmmcalc.linkage.synthesis.task import RotatingTask, SlottedTask
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Paragraph, Result
from tmmcalc.report.telling import held

OVERLAP = "psi = deg(180)*(K - 1)/(K + 1)"


def task(told: Told) -> str:
    """What is sought."""
    return tr(
        "A mechanism with an oscillating slotted link is sought: crank $AB = r$, line of centres $CA = L$, arm $CD = "
        "R$ of the slotted link, connecting rod $DE = l$, and the slider $E$ on a guide across the line of centres, "
        "at the distance $e$ from the pivot $C$ of the slotted link."
    )


def given(told: Told) -> dict[str, Given]:
    """What is asked."""
    asked: SlottedTask = told.asked
    found = given_of_both(told, asked)
    if asked.guide is not None:
        found["e"] = length(asked.guide, told.meaning("e"))
    if by_clearance(asked):
        found["k"] = ratio(asked.clearance, tr("clearance factor of the layout"))
    return found


def given_of_both(told: Told, asked: SlottedTask | RotatingTask) -> dict[str, Given]:
    """What is asked of a slotted link of either kind."""
    words = meanings()
    found = {"S": length(asked.stroke, words["S"]), "K": ratio(asked.time_ratio, words["K"])}
    if asked.pressure is not None:
        found["nu_m"] = angle(asked.pressure, words["nu_m"])
    for letter, value in (("l", asked.rod), ("r", asked.crank), ("L", asked.centres)):
        if value is not None:
            found[letter] = length(value, told.meaning(letter))
    return found


def by_clearance(asked: SlottedTask) -> bool:
    """Whether the layout settles the guide or the crank."""
    return asked.guide is None or (asked.crank is None and asked.centres is None)


def further(told: Told) -> Iterator[Block]:
    """The rule of the layout."""
    if by_clearance(told.asked):
        yield Paragraph(tr("The guide passes the circle of the crank pin with some clearance, $e = L + k*r$."))


def blocks(told: Told) -> Iterator[Block]:
    """Swing, arm, crank with the line of centres, guide, rod."""
    asked: SlottedTask = told.asked
    told.give({"phi": angle(told.design.size("two_phi") / 2, tr("half of the swing of the slotted link"))})
    yield Paragraph(
        tr(
            "In its extreme positions the slotted link is a tangent of the circle of the crank pin, and the crank "
            "stands across it. So its swing is the overlap angle of the strokes:"
        )
    )
    yield from told.lines(OVERLAP, "phi = psi/2")
    yield Paragraph(tr("The ends of the arm are equally high in both extreme positions, so its chord is the stroke:"))
    yield from told.lines("R = S/(2*sin(phi))")
    if asked.crank is not None:
        yield from told.lines("L = r/sin(phi)")
    elif asked.centres is not None:
        yield from told.lines("r = L*sin(phi)")
    else:
        yield Paragraph(tr("The guide passes the circle of the crank pin with some clearance, $e = L + k*r$:"))
        yield from told.lines("r = e/(1/sin(phi) + k)", "L = r/sin(phi)")
    if asked.guide is None:
        yield Paragraph(tr("The guide passes the circle of the crank pin with some clearance:"))
        yield from told.lines("e = L + k*r")
    yield from rod(told)


def rod(told: Told) -> Iterator[Block]:
    """The rod by its pressure angle, or the pressure angle of a given rod."""
    asked: SlottedTask = told.asked
    told.give({"nu_m": angle(told.achieved("nu_max"), meanings()["nu_m"])})
    yield Paragraph(
        tr(
            "The end $D$ of the arm is $e - R$ from the guide in the middle of its swing and $e - R*cos(phi)$ in the "
            "extreme positions; the larger distance gives the largest pressure angle:"
        )
    )
    if asked.rod is None:
        yield from told.lines("l = max(abs(e - R), abs(e - R*cos(phi)))/sin(nu_m)")
    else:
        yield from told.lines("nu_m = asin(max(abs(e - R), abs(e - R*cos(phi)))/l)")


def conditions(told: Told) -> Iterator[Block]:
    """Crank and line of centres, the slider that turns with the slotted link, the layout."""
    r, centres, arm, e = (told.design.size(symbol) for symbol in ("r", "L", "R", "e"))
    yield Paragraph(tr("The slotted link oscillates while the crank turns fully:"))
    yield held("r < L", (r, centres), "m", holds=r < centres)
    half, rod_ = told.design.size("two_phi") / 2, told.design.size("l")
    if e > arm * math.cos(half):
        tilt = math.degrees(math.asin(abs(e - arm * math.cos(half)) / rod_) + half)
        yield Paragraph(
            tr("The slider turns back with the slotted link: the rod does not stand along the path of $D$ at the ends:")
        )
        yield held("asin((e - R*cos(phi))/l) + phi < deg(90)", (tilt, 90.0), "deg", holds=tilt < 90)
    yield Paragraph(tr("The guide stays clear of the circle of the crank pin:"))
    yield held("e > L + r", (e, centres + r), "m", holds=e > centres + r)
    if arm < centres + r:
        yield Paragraph(tr("The block goes beyond the end $D$ of the arm: the slot is longer than the arm."))
    yield pressure(told)


def pressure(told: Told) -> Result:
    """The largest pressure angle with its limit."""
    limit = told.asked.pressure
    found = angle(told.achieved("nu_max"), meanings()["nu_m"])
    if limit is None:
        return Result("nu_m", found)
    return Result("nu_m", found, math.degrees(limit) * (1 + 1e-12), "<=")
