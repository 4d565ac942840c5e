"""Where the extreme positions lie, for a dyad between the crank and the frame, textbook 2.5.1, 2.5.3, 2.5.4.

Crank and connecting rod are in line, stretched or folded; a slotted link is a tangent of the circle of the crank's pin.
The formulas are told where they give the extreme positions that the program found, whatever moves with the dyad.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.linkage.notes.group import angle, length
from tmmcalc.linkage.notes.told import Dyad, Told
from tmmcalc.linkage.results import OutputSummary
from tmmcalc.report.formula.digits import Given, value_of
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.formula.tree import Statement
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Lexicon, Paragraph, Place
from tmmcalc.report.telling import filled, lines, named, number_of

NEAR = 1e-7  # [deg] of an angle that a formula gives
ENDS = {"RRR": "OQ", "RPR": "QO"}  # of the line of the pivots
OFFSET = "e_<b> = (y_{<Q>} - y_{<O>})*cos(gamma_<b>) - (x_{<Q>} - x_{<O>})*sin(gamma_<b>) + h_<b>"
PIVOTS = (
    "l_{<F><S>} = sqrt((x_{<S>} - x_{<F>})**2 + (y_{<S>} - y_{<F>})**2)",
    "phi_{<F><S>} = atan2(y_{<S>} - y_{<F>}, x_{<S>} - x_{<F>})",
)
IN_LINE = {
    "RRP": (
        "gamma_<b> + asin(e_<b>/(l_{<O><P>} + l_<a>))",
        "gamma_<b> + deg(180) - asin(e_<b>/(l_{<O><P>} + l_<a>))",
        "gamma_<b> + deg(180) + asin(e_<b>/(l_<a> - l_{<O><P>}))",
        "gamma_<b> - asin(e_<b>/(l_<a> - l_{<O><P>}))",
    ),
    "RRR": tuple(
        f"phi_{{<O><Q>}} {turn} acos((l_{{<O><Q>}}**2 + ({reach})**2 - l_<b>**2)/(2*l_{{<O><Q>}}*({reach})))"
        for turn, reach in (
            ("+", "l_{<O><P>} + l_<a>"),
            ("-", "l_{<O><P>} + l_<a>"),
            ("+ deg(180) +", "l_<a> - l_{<O><P>}"),
            ("+ deg(180) -", "l_<a> - l_{<O><P>}"),
        )
    ),
    "RPR": (
        "phi_{<Q><O>} - deg(180) + acos(l_{<O><P>}/l_{<Q><O>})",
        "phi_{<Q><O>} + deg(180) - acos(l_{<O><P>}/l_{<Q><O>})",
    ),
}


def inputs_of(told: Told, summary: OutputSummary) -> list[float]:
    """The input coordinate [rad or m] in the extreme positions: of two the second one after the first."""
    found = [centre.x for centre in summary.dead_centres]
    if summary.working_angle is not None:
        found[1] = found[0] + math.copysign(summary.working_angle, told.result.speed)
    return found


def lines_of(told: Told, summary: OutputSummary, lexicon: Lexicon) -> Iterator[Block]:
    """The angles of the crank in the extreme positions of an output, which are put into the lexicon."""
    found = _dyad_of(told)
    if found is None:
        return
    dyad, words = found
    lexicon |= named(_quantities(dyad, words, lexicon))
    place = Place("", lexicon)
    index = told.result.structure.input_link
    chosen: list[str] = []
    for mark, x in zip(("I", "{II}"), inputs_of(told, summary), strict=False):
        name, wanted = f"phi_{index}^{mark}", math.degrees(x)
        lexicon |= named({name: Given(wanted, "deg", tr("angle of the crank in an extreme position"))})
        for text in IN_LINE[dyad.step.group.kind]:
            formula = read(filled(f"{name} = {text}", words))
            if (given := _given_by(formula, lexicon)) is None:
                continue
            turns = round((given - wanted) / 360.0)
            if abs(given - wanted - 360.0 * turns) < NEAR:
                chosen.append(f"{name} = {_turned_back(text, turns)}")
    if len(chosen) == len(summary.dead_centres) == 2:
        yield Paragraph(
            tr("In the extreme positions the slotted link touches the circle of the crank pin:")
            if dyad.step.group.kind == "RPR"
            else tr("In the extreme positions the crank and link {link} are in line:", link=words["a"])
        )
        if dyad.step.group.kind == "RRP":
            yield from lines([OFFSET], [place], words)
        else:
            ends = ENDS[dyad.step.group.kind]
            yield from lines(PIVOTS, [place], {"F": words[ends[0]], "S": words[ends[1]]})
        yield from lines(chosen, [place], words)


def _dyad_of(told: Told) -> tuple[Dyad, dict[str, str]] | None:
    """The dyad that joins the crank's pin with the frame, and what stands in the formulas."""
    for dyad in told.dyads:
        places = dyad.places
        crank = next((each.places for each in told.crank if each.places["D"] == places["P"]), None)
        fixed = places["f"] == str(told.result.structure.input_link) and places["g"] == "0"
        if crank is not None and fixed and dyad.step.group.kind in IN_LINE:
            return dyad, {**places, "O": crank["O"]}
    return None


def _quantities(dyad: Dyad, words: dict[str, str], lexicon: Lexicon) -> Lexicon:
    """The line of the pivots; the offset of the guide from the crank's pivot."""
    pivot, other = (
        complex(number_of(lexicon, f"x_{{{words[key]}}}"), number_of(lexicon, f"y_{{{words[key]}}}")) for key in "OQ"
    )
    if dyad.step.group.kind == "RRP":
        guide = dyad.states[0].port2
        offset = ((other - pivot) * complex(guide.e).conjugate()).imag + dyad.states[0].dyad.h
        return {filled("e_<b>", words): length(offset, tr("offset of the guide from the pivot of the crank"))}
    ends = ENDS[dyad.step.group.kind]
    way = other - pivot if ends == "OQ" else pivot - other
    first, second = (words[key] for key in ends)
    said = {"first": first, "second": second}
    return {
        f"l_{{{first}{second}}}": length(abs(way), tr("distance between points {first} and {second}", **said)),
        f"phi_{{{first}{second}}}": angle(way, tr("angle of the line {first}{second}", **said)),
    }


def _given_by(formula: Statement, lexicon: Lexicon) -> float | None:
    """The angle [deg] that a formula gives, if it has a value."""
    try:
        return value_of(formula.sides[1], lexicon, "deg")
    except (ValueError, ArithmeticError):
        return None


def _turned_back(text: str, turns: int) -> str:
    """A formula that gives as many whole turns less, half a turn that it has taken the other way where that does."""
    signs = {1: "+", -1: "-"}
    if turns in signs and f"{signs[turns]} deg(180)" in text:
        return text.replace(f"{signs[turns]} deg(180)", f"{signs[-turns]} deg(180)")
    return text if not turns else f"{text} - deg({360 * turns})" if turns > 0 else f"{text} + deg({-360 * turns})"
