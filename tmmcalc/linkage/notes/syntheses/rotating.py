"""The rotating slotted link, the crank longer than the line of centres; with an offset guide by roots."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.linkage.notes.syntheses.slotted import OVERLAP, given_of_both, pressure
from tmmcalc.linkage.notes.syntheses.told import Told, angle, length, meanings, ratio
from tmmcalc.linkage.synthesis.rotating import crank_angle
from tmmcalc.linkage.synthesis.task import RotatingTask
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Display, Paragraph
from tmmcalc.report.telling import held, numeral

STROKE = "S = sqrt((l + R)**2 - e**2) - sqrt((l - R)**2 - e**2)"
CRANK = "theta - asin(L*cos(theta)/r)"


def task(told: Told) -> str:
    """What is sought."""
    return tr(
        "A mechanism with a rotating slotted link is sought: crank $AB = r$, line of centres $CA = L$, arm $CD = R$ of "
        "the slotted link, connecting rod $DE = l$, and the slider $E$ on a guide across the line of centres, at the "
        "distance $e$ from the pivot $C$ of the slotted link."
    )


def given(told: Told) -> dict[str, Given]:
    """What is asked."""
    asked: RotatingTask = told.asked
    found = given_of_both(told, asked)
    return found | {"e": length(asked.guide, tr_name("guide over the pivot C"))} if asked.guide else found


def further(told: Told) -> Iterator[Block]:
    """The sense in which the guide is off the pivot."""
    asked: RotatingTask = told.asked
    if asked.guide:
        yield Paragraph(tr("The distance $e$ is positive to the side of the pivot $A$ of the crank."))


def blocks(told: Told) -> Iterator[Block]:
    """In closed form where the guide passes the pivot, else arm and line of centres as roots."""
    asked: RotatingTask = told.asked
    told.give({"nu_m": angle(told.achieved("nu_max"), meanings()["nu_m"])})
    yield from told.lines(OVERLAP)
    yield from _offset(told, asked) if asked.guide else _central(told, asked)


def _central(told: Told, asked: RotatingTask) -> Iterator[Block]:
    """The guide passes the pivot of the slotted link."""
    told.give({"alpha_x": angle(math.pi - told.design.size("psi"), tr("angle of the crank over the idle stroke"))})
    yield Paragraph(
        tr(
            "The guide passes the pivot $C$: between the extreme positions the slotted link has turned by half a "
            "turn, and arm and rod lie on the guide. So the crank pin is on the line of the guide in both, seen from "
            "$A$ under the angle $alpha_x$ of the idle stroke:"
        )
    )
    yield from told.lines("alpha_x = deg(360)/(K + 1)")
    yield from told.lines("L = r*cos(alpha_x/2)" if asked.crank is not None else "r = L/cos(alpha_x/2)")
    yield from told.lines("R = S/2", "l = R/sin(nu_m)" if asked.rod is None else "nu_m = asin(R/l)")


def _offset(told: Told, asked: RotatingTask) -> Iterator[Block]:
    """The guide passes the pivot at a distance: two equations, each with one unknown."""
    e, arm, rod = asked.guide, told.design.size("R"), told.design.size("l")
    yield Paragraph(
        tr(
            "In the extreme positions arm and rod lie on a line. The stroke is the difference of the ways of the "
            "slider from the foot of $C$ on the guide:"
        )
    )
    yield Display(read(STROKE))
    yield Paragraph(
        tr(
            "This is one equation with the unknown $R$. Where it changes its sign, the root is bracketed and refined "
            "until its digits stand: $R = {value}$ m. The root put in:",
            value=numeral(arm, 7),
        )
    )
    if asked.rod is None:
        yield from told.lines("l = (R + abs(e))/sin(nu_m)")
    yield from told.lines(STROKE)
    if asked.rod is not None:
        yield from told.lines("nu_m = asin((R + abs(e))/l)")
    far, near = math.asin(e / (rod + arm)), math.pi + math.asin(e / (rod - arm))
    said = tr("angle of the slotted link in an extreme position")
    told.give({"theta_I": angle(far, said), "theta_{II}": angle(near, said)})
    yield Paragraph(tr("The slotted link stands there at"))
    yield from told.lines("theta_I = asin(e/(l + R))", "sin(theta_{II}) = -e/(l - R)")
    yield Paragraph(
        tr(
            "In the triangle $ABC$ the crank stands at $phi = {crank}$ where the slotted link is at $theta$. Between "
            "the extreme positions it turns by $deg(180) + psi$; this is one equation with the unknown $chi = L/r$, "
            "whose root is $chi = {value}$.",
            crank=CRANK,
            value=numeral(told.design.merits["L/r"], 7),
        )
    )
    told.give({"chi": ratio(told.design.merits["L/r"], tr("line of centres over crank"))})
    yield from told.lines("L = chi*r" if asked.crank is not None else "r = L/chi")
    x = np.asarray(told.design.merits["L/r"])
    told.give(
        {
            "phi_I": angle(float(crank_angle(far, x)), told.meaning("phi_I")),
            "phi_{II}": angle(float(crank_angle(near, x)), told.meaning("phi_II")),
        }
    )
    yield Paragraph(tr("At the far and at the near end of the stroke the crank stands at"))
    ends = (CRANK.replace("theta", name) for name in ("theta_I", "theta_{II}"))
    yield from told.lines(*(f"{left} = {right}" for left, right in zip(("phi_I", "phi_{II}"), ends, strict=True)))
    told.give({"alpha_p": angle(math.pi + told.design.size("psi"), tr("angle of the crank over the working stroke"))})
    yield from told.lines("alpha_p = phi_{II} - phi_I")


def conditions(told: Told) -> Iterator[Block]:
    """The slotted link turns round; the rod is longer than the arm."""
    r, centres, arm, rod, e = (told.design.size(symbol) for symbol in ("r", "L", "R", "l", "e"))
    yield Paragraph(tr("The slotted link turns round with the crank, and the arm passes the guide:"))
    yield held("r > L", (r, centres), "m", holds=r > centres)
    text = "l > R + abs(e)" if e else "l > R"
    yield held(text, (rod, arm + abs(e)), "m", holds=rod > arm + abs(e))
    yield pressure(told)
