"""The trailing rod of a V-engine: where its pin sits on the master rod, and its length."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.linkage.notes.syntheses.told import Told, angle, length
from tmmcalc.linkage.synthesis.results import PRESSURE
from tmmcalc.linkage.synthesis.task import TrailingRodTask
from tmmcalc.linkage.synthesis.trailing import exact_of
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Paragraph, Result
from tmmcalc.report.telling import held

ALPHA, ROD = "alpha = beta + asin(r*sin(beta)/l)", "l_4 = l - l_C"


def task(told: Told) -> str:
    """What is sought."""
    return tr(
        "The trailing rod $CD$ of a V-engine is sought. Its pin $C$ is on the lug $AC$ of the master rod $AB$; both "
        "pistons are to have equally high top dead centres, the left one with the crank $OA$ on the axis of its "
        "cylinder."
    )


def given(told: Told) -> dict[str, Given]:
    """What is asked."""
    asked: TrailingRodTask = told.asked
    words = {letter: each.meaning for letter, each in told.lexicon.items()}
    found = {
        "beta": angle(asked.v_angle, words["beta"]),
        "r": length(asked.crank, words["r"]),
        "l": length(asked.rod, words["l"]),
        "l_C": length(asked.lug, words["l_C"]),
    }
    if asked.lug_angle is not None:
        found["alpha"] = angle(asked.lug_angle, words["alpha"])
    if asked.length is not None:
        found["l_4"] = length(asked.length, words["l_4"])
    return found


def further(told: Told) -> Iterator[Block]:
    """What is found where it is not given."""
    asked: TrailingRodTask = told.asked
    yield Paragraph(
        tr(
            "Angles of the lug are those from the master rod $AB$, those of the cylinders from the axis of the right "
            "one to that of the left one."
        )
    )
    if asked.lug_angle is not None or asked.length is not None:
        yield Paragraph(tr("What is given is kept, also where the dead centres are not equally high by it."))


def blocks(told: Told) -> Iterator[Block]:
    """The angle of the lug and the length of the rod, beside those that are given."""
    asked: TrailingRodTask = told.asked
    exact = exact_of(asked)
    yield Paragraph(
        tr(
            "With the crank on the axis of the left cylinder the master rod stands at $-asin(r*sin(beta)/l)$ to the "
            "axis of the right one, and the lug is to lie on the axis of the left cylinder:"
        )
    )
    marked = "^{*}" if asked.lug_angle is not None else ""
    told.give({f"alpha{marked}": angle(exact[0], tr("angle of the lug for equally high dead centres"))})
    yield from told.lines(ALPHA.replace("alpha", f"alpha{marked}"))
    yield Paragraph(
        tr("The left piston is then $r + l_C + l_4$ from the axis of the crank, the right one at its top $r + l$:")
    )
    marked = "^{*}" if asked.length is not None else ""
    told.give({f"l_4{marked}": length(exact[1], tr("length of the trailing rod for equally high dead centres"))})
    yield from told.lines(ROD.replace("l_4", f"l_4{marked}"))
    if asked.lug_angle is not None or asked.length is not None:
        yield Paragraph(tr("What is given is kept; the table of checks shows what it does to the dead centres."))


def conditions(told: Told) -> Iterator[Block]:
    """The crank turns, the strokes, the top dead centres."""
    r, l = told.design.size("r"), told.design.size("l")
    yield held("r < l", (r, l), "m", holds=r < l)
    told.give(
        {
            "S": length(told.achieved("S"), tr("stroke of the right piston")),
            "h_1": length(
                told.achieved("top of the right piston"), tr("right piston from the axis of the crank at its top")
            ),
            "h_2": length(
                told.achieved("top of the left piston"), tr("left piston from the axis of the crank at its top")
            ),
        }
    )
    yield from told.lines("S = 2*r", "h_1 = r + l")
    if told.asked.lug_angle is None and told.asked.length is None:
        yield from told.lines("h_2 = r + l_C + l_4")
    pressure = Given(told.design.merits[PRESSURE.key], "deg", tr_name("pressure max"))
    yield Result("nu_m", pressure)
    top = math.fsum((told.achieved("top of the left piston"), -told.achieved("top of the right piston")))
    if abs(top) > 1e-9 * l:
        yield Paragraph(tr("The top dead centres of both pistons are not equally high."))
