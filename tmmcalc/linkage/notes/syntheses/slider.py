"""The slider-crank: ratios of the crank and of the offset to the rod, by closed forms or as roots, then the scale."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from tmmcalc.linkage.notes.syntheses.told import Told, angle, length, meanings, ratio, turned
from tmmcalc.linkage.synthesis.task import SliderCrankTask
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Display, Paragraph
from tmmcalc.report.telling import held, number_of, numeral

FAR, NEAR = "sqrt((1 + lambda)**2 - kappa**2)", "sqrt((1 - lambda)**2 - kappa**2)"
EQUATIONS = {  # what a demand asks of the ratios
    "nu_p": "sin(nu_p) = lambda - kappa",
    "nu_x": "sin(nu_x) = lambda + kappa",
    "eps": "kappa = eps*lambda",
    "K": "psi = asin(kappa/(1 - lambda)) - asin(kappa/(1 + lambda))",
    "S/l": f"S/l = {FAR} - {NEAR}",
    "S/r": f"S/r = ({FAR} - {NEAR})/lambda",
    "S/e": f"S/e = ({FAR} - {NEAR})/kappa",
    "e/S": f"e_S = kappa/({FAR} - {NEAR})",
}
OVERLAP = "psi = deg(180)*(K - 1)/(K + 1)"
OF_LENGTHS = {"lambda": "lambda = r/l", "eps": "eps = e/r", "kappa": "kappa = e/l"}
CLOSED = {  # the ratios of two demands that are straight lines
    ("nu_p", "nu_x"): ("lambda = (sin(nu_x) + sin(nu_p))/2", "eps = (sin(nu_x) - sin(nu_p))/(2*lambda)"),
    ("lambda", "nu_p"): ("kappa = lambda - sin(nu_p)",),
    ("lambda", "nu_x"): ("kappa = sin(nu_x) - lambda",),
    ("eps", "lambda"): (),
    ("eps", "nu_p"): ("lambda = sin(nu_p)/(1 - eps)",),
    ("eps", "nu_x"): ("lambda = sin(nu_x)/(1 + eps)",),
    ("eps", "kappa"): ("lambda = kappa/eps",),
    ("kappa", "lambda"): (),
    ("kappa", "nu_p"): ("lambda = kappa + sin(nu_p)",),
    ("kappa", "nu_x"): ("lambda = sin(nu_x) - kappa",),
    ("central", "lambda"): (),
    ("central", "nu_p"): ("lambda = sin(nu_p)",),
    ("central", "nu_x"): ("lambda = sin(nu_x)",),
    ("S/l", "central"): ("lambda = S/(2*l)",),
}
STRAIGHT = {  # by which the offset follows from lambda where the other demand is no straight line
    "nu_p": "kappa = lambda - sin(nu_p)",
    "nu_x": "kappa = sin(nu_x) - lambda",
    "eps": "kappa = eps*lambda",
}


class Demands(NamedTuple):
    """What two of the given sizes ask of the ratios, and what is given of the lengths beside them."""

    names: tuple[str, str]
    lengths: tuple[str, ...]  # ratios that are those of given lengths


def task(told: Told) -> str:
    """What is sought."""
    return tr(
        "A slider-crank is sought: crank $r$, connecting rod $l$ and offset $e$ of the guide to the side on which the "
        "crank pin is on the working stroke."
    )


def given(told: Told) -> dict[str, Given]:
    """What is asked."""
    asked: SliderCrankTask = told.asked
    words, sizes = meanings(), {letter: each.meaning for letter, each in told.lexicon.items()}
    found = {
        "S": asked.stroke is not None and length(asked.stroke, words["S"]),
        "r": asked.crank is not None and length(asked.crank, sizes["r"]),
        "l": asked.rod is not None and length(asked.rod, sizes["l"]),
        "e": asked.offset is not None and length(asked.offset, sizes["e"]),
        "K": asked.time_ratio is not None and ratio(asked.time_ratio, words["K"]),
        "lambda": asked.crank_ratio is not None and ratio(asked.crank_ratio, words["lambda"]),
        "eps": asked.offset_ratio is not None and ratio(asked.offset_ratio, words["eps"]),
        "e_S": asked.offset_part is not None and ratio(asked.offset_part, tr("offset over stroke")),
        "nu_p": asked.pressure_working is not None and angle(asked.pressure_working, words["nu_p"]),
        "nu_x": asked.pressure_idle is not None and angle(asked.pressure_idle, words["nu_x"]),
    }
    return {name: each for name, each in found.items() if isinstance(each, Given)}


def further(told: Told) -> Iterator[Block]:
    """The sense of the offset stands in the task."""
    yield from ()


def blocks(told: Told) -> Iterator[Block]:
    """The ratios of two demands, the length that gives the scale, all sizes."""
    asked: SliderCrankTask = told.asked
    _complete(told)
    yield Paragraph(
        tr(
            "Without its scale the linkage has two dimensions, $lambda = r/l$ and $kappa = e/l = eps*lambda$. The "
            "pressure angle is extreme where the crank stands across the guide, and the pivot of the crank with both "
            "ends of the stroke forms a triangle with the sides $l + r$, $l - r$ and $S$:"
        )
    )
    yield Display(read("sin(nu_p) = (r - e)/l = lambda - kappa"))
    yield Display(read("sin(nu_x) = (r + e)/l = lambda + kappa"))
    yield Display(read("S = sqrt((l + r)**2 - e**2) - sqrt((l - r)**2 - e**2)"))
    demands = demands_of(asked)
    if asked.time_ratio not in (None, 1):
        yield from told.lines(OVERLAP)
    if asked.offset_part is not None and "e" in {*_lengths_given(asked)} and asked.offset is None:
        yield from told.lines("e = e_S*S")
    yield from told.lines(*(OF_LENGTHS[name] for name in demands.lengths))
    if "central" in demands.names:
        yield Paragraph(tr("The guide passes the pivot of the crank: $e = 0$, $kappa = 0$."))
    yield from _ratios(told, demands)
    yield from _scaled(told, asked, demands)
    yield from told.lines("psi = asin(e/(l - r)) - asin(e/(l + r))")
    if asked.time_ratio is None:
        yield from told.lines("K = (deg(180) + psi)/(deg(180) - psi)")


def _complete(told: Told) -> None:
    """Stroke, time ratio and pressure angles that are not given, as the linkage has them."""
    words = meanings()
    known = {
        "S": length(told.achieved("S"), words["S"]),
        "K": ratio(told.achieved("K"), words["K"]),
        "nu_p": angle(told.achieved("nu_p"), words["nu_p"]),
        "nu_x": angle(told.achieved("nu_x"), words["nu_x"]),
    }
    told.give({**known, **told.lexicon})


def demands_of(asked: SliderCrankTask) -> Demands:
    """Which two demands the given sizes are, beside the scale."""
    found, lengths = [], []
    part = asked.offset_part
    settled = part is not None and asked.stroke is not None and bool(asked.crank or asked.rod)
    for name, value in (
        ("lambda", asked.crank_ratio),
        ("eps", asked.offset_ratio),
        ("nu_p", asked.pressure_working),
        ("nu_x", asked.pressure_idle),
        ("K", asked.time_ratio),
        ("e/S", None if settled else part),
    ):
        if value is not None:
            central = (name == "K" and value == 1) or (name == "e/S" and value == 0)
            found.append("central" if central else name)
    there = {*_lengths_given(asked)}
    zero = asked.offset == 0 or (settled and part == 0)
    if zero:
        found.append("central")
        there -= {"e"}
    for name, pair in (("lambda", {"r", "l"}), ("kappa", {"e", "l"}), ("eps", {"e", "r"})):
        if pair <= there and not (name == "eps" and "l" in there):
            found.append(name)
            lengths.append(name)
    if "S" in there and there & {"l", "r", "e"}:
        other = next(letter for letter in "lre" if letter in there)
        found.append(f"S/{other}")
    first, second = sorted(found)
    return Demands((first, second), tuple(lengths))


def _lengths_given(asked: SliderCrankTask) -> Iterator[str]:
    lengths = {"S": asked.stroke, "r": asked.crank, "l": asked.rod, "e": asked.offset}
    yield from (letter for letter, value in lengths.items() if value is not None)
    if asked.offset_part is not None and asked.stroke is not None and bool(asked.crank or asked.rod):
        yield "e"


def _ratios(told: Told, demands: Demands) -> Iterator[Block]:
    """Both ratios: by their formulas, or as roots of the equations that the demands are."""
    if demands.names in CLOSED:
        yield from told.lines(*CLOSED[demands.names])
    else:
        yield from _roots(told, demands)
    if "central" in demands.names:
        return
    if "eps" in demands.names or demands.names == ("nu_p", "nu_x"):
        yield from told.lines("kappa = eps*lambda")
    else:
        yield from told.lines("eps = kappa/lambda")


def _roots(told: Told, demands: Demands) -> Iterator[Block]:
    """Equations that are solved numerically, and how the roots keep them."""
    straight = [name for name in demands.names if name in STRAIGHT or name in ("lambda", "kappa", "central")]
    others = [EQUATIONS[name] for name in demands.names if name not in straight]
    letter = ""
    if straight:
        letter = "kappa" if straight[0] == "lambda" else "lambda"
        if straight[0] in STRAIGHT:
            yield Display(read(STRAIGHT[straight[0]]))
        yield Paragraph(
            tr(
                "What else is asked is an equation with the one unknown ${name}$. Where it changes its sign along the "
                "line, the root is bracketed and refined until its digits stand: ${name} = {value}$.",
                name=letter,
                value=_value(told, letter),
            )
        )
    else:
        yield Paragraph(
            tr(
                "What is asked are two equations with the unknown $lambda$ and $kappa$. Along the curve of the first "
                "one the roots of the second one are bracketed and refined until their digits stand: "
                "$lambda = {first}$, $kappa = {second}$.",
                first=_value(told, "lambda"),
                second=_value(told, "kappa"),
            )
        )
    yield Paragraph(tr("The root put in:"))
    yield from told.lines(*others, *(STRAIGHT[name] for name in straight if name in STRAIGHT))


def _value(told: Told, letter: str) -> str:
    return numeral(number_of(told.lexicon, letter), 7)


def _scaled(told: Told, asked: SliderCrankTask, demands: Demands) -> Iterator[Block]:
    """The lengths by the one that gives the scale."""
    there = {*_lengths_given(asked)}
    if "l" not in there:
        if asked.stroke is not None:
            yield from told.lines(f"l = S/({FAR} - {NEAR})")
        else:
            yield from told.lines("l = r/lambda" if asked.crank is not None else "l = e/kappa")
    if "r" not in there:
        yield from told.lines("r = lambda*l")
    if "e" not in there:
        yield from told.lines("e = eps*r")
    if asked.stroke is None:
        yield from told.lines("S = sqrt((l + r)**2 - e**2) - sqrt((l - r)**2 - e**2)")


def conditions(told: Told) -> Iterator[Block]:
    """The crank turns fully; the pressure angles."""
    r, l, e = (told.design.size(symbol) for symbol in "rle")
    yield Paragraph(tr("The crank turns fully where it is shorter than the rod with the offset taken off:"))
    yield held("r + abs(e) < l", (r + abs(e), l), "m", holds=r + abs(e) < l)
    if e < 0:
        yield Paragraph(
            tr("The offset is negative and $K < 1$: the strokes exchange their roles, the working one is the faster.")
        )
    yield Paragraph(tr("Where the crank stands across the guide, the pressure angle is"))
    shown = {"nu_p": told.achieved("nu_p"), "nu_x": told.achieved("nu_x")}
    told.give({name: angle(value, meanings()[name]) for name, value in shown.items()})
    yield from told.lines("nu_p = asin((r - e)/l)", "nu_x = asin((r + e)/l)")
    yield from _beyond(told, asked=told.asked)


def _beyond(told: Told, asked: SliderCrankTask) -> Iterator[Block]:
    """Pressure angles at the ends of the stroke that are larger."""
    for name, limit, check in (
        ("nu_p", asked.pressure_working, "largest pressure angle working"),
        ("nu_x", asked.pressure_idle, "largest pressure angle idle"),
    ):
        found = told.achieved(check)
        if limit is not None and found > limit * (1 + 1e-9) + 1e-12:
            yield Paragraph(
                tr(
                    "At an end of the stroke the pressure angle is larger, {value}, than ${name}$.",
                    value=turned(math.degrees(found)),
                    name=name,
                )
            )
