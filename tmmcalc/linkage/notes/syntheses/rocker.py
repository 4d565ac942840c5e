"""The crank-rocker by swing and time ratio: what both settle, then the free size by a length or the transmission."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.linkage.notes.syntheses.fourbar import grashof, transmission
from tmmcalc.linkage.notes.syntheses.told import Told, angle, length, meanings, ratio
from tmmcalc.linkage.synthesis.results import TRANSMISSION
from tmmcalc.linkage.synthesis.rocker import LENGTHS, WEAK
from tmmcalc.linkage.synthesis.rockerfamily import Family, cosines, family
from tmmcalc.linkage.synthesis.task import CrankRockerTask
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Display, Paragraph, Result, Table
from tmmcalc.report.telling import numeral, tabulated

LETTERS = dict(zip(LENGTHS, "rlRL", strict=True))
CHORD = "(l*sin(psi/2))**2 + (r*cos(psi/2))**2 = (c/2)**2"
CRANK = "r = sqrt((c/2)**2 - (l*sin(psi/2))**2)/cos(psi/2)"
COUPLER = "l = sqrt((c/2)**2 - (r*cos(psi/2))**2)/sin(psi/2)"
ALONG, OFF, FRAME = "p = 2*l*r/c", "q = (l**2 - r**2)*sin(psi)/c", "L = sqrt(p**2 + (R*cos(phi) <side> q)**2)"
AROUND, ROWS = 0.6, 9  # of the way to the ends of the family that is shown, and how many of it
NEAR = 1e-6  # of a condition of the best transmission: it is the one that holds


def task(told: Told) -> str:
    """What is sought."""
    return tr(
        "A crank-rocker is sought: crank $AB = r$, coupler $BC = l$, rocker $DC = R$ and frame $AD = L$, whose rocker "
        "swings by the angle $Theta$ with the time ratio $K$."
    )


def given(told: Told) -> dict[str, Given]:
    """What is asked."""
    asked: CrankRockerTask = told.asked
    words = {letter: each.meaning for letter, each in told.lexicon.items()}
    found = {
        "Theta": angle(asked.swing, words["Theta"]),
        "K": ratio(asked.time_ratio, meanings()["K"]),
    }
    for name, letter in LETTERS.items():
        value = getattr(asked, name)
        if value is not None:
            found[letter] = length(value, words[letter])
    if asked.transmission is not None:
        found["mu_m"] = angle(asked.transmission, tr_name("least transmission angle"))
    elif len(_lengths(asked)) == 1:
        found["m"] = ratio(asked.largest_ratio, tr("largest ratio of the longest link to the crank"))
    return found


def _lengths(asked: CrankRockerTask) -> list[str]:
    return [name for name in LENGTHS if getattr(asked, name) is not None]


def further(told: Told) -> Iterator[Block]:
    """The rule that settles the free size."""
    asked: CrankRockerTask = told.asked
    if asked.transmission is None and len(_lengths(asked)) == 1:
        yield Paragraph(
            tr(
                "One size is free. That linkage is taken whose least transmission angle is largest, no link being "
                "longer than $m$ cranks."
            )
        )


def blocks(told: Told) -> Iterator[Block]:
    """The family of swing and time ratio, the condition that takes one member of it, its sizes."""
    asked: CrankRockerTask = told.asked
    half, psi = asked.swing / 2, told.design.size("psi")
    l, rocker = (told.design.size(symbol) for symbol in "lR")
    side, chord = side_of(told), 2 * rocker * math.sin(half)
    one = family(np.array([chord / (2 * l)]), half, psi, side)
    off = (float(one.pivot.imag[0]) - math.cos(half)) * side
    told.give(
        {
            "phi": angle(half, tr("half of the swing of the rocker")),
            "c": length(chord, tr("chord between the extreme positions of the pin C")),
            "p": length(
                rocker * float(one.pivot.real[0]), tr("distance of the pivot A along the chord from its middle")
            ),
            "q": length(rocker * off, tr("distance of the pivot A from the chord")),
        }
    )
    if psi:
        yield from told.lines("psi = deg(180)*(K - 1)/(K + 1)")
    yield from told.lines("phi = Theta/2")
    yield Paragraph(
        tr(
            "In the extreme positions crank and coupler lie on a line: $A*C_1 = l + r$, $A*C_2 = l - r$, with the "
            "overlap angle $psi$ between them. With the chord $c = 2*R*sin(phi)$ of the pin $C$ the triangle "
            "$A*C_1*C_2$ gives"
        )
    )
    yield Display(read(CHORD))
    yield Paragraph(
        tr(
            "The pivot $A$ of the crank is $p = 2*l*r/c$ along the chord from its middle and $q = (l**2 - "
            "r**2)*sin(psi)/c$ off it, on the far side from the pivot $D$ or on its side:"
        )
    )
    yield Display(read("L = sqrt(p**2 + (R*cos(phi) + q)**2)"))
    yield Display(read("L = sqrt(p**2 + (R*cos(phi) - q)**2)"))
    yield from _settled(told, asked, side)
    yield from _sizes(told, asked, side)


def side_of(told: Told) -> int:
    """On which side of the chord the pivot of the crank is."""
    asked: CrankRockerTask = told.asked
    half, psi = asked.swing / 2, told.design.size("psi")
    l, rocker, frame = (told.design.size(symbol) for symbol in "lRL")
    at = np.array([rocker * math.sin(half) / l])
    return min((1, -1), key=lambda way: abs(float(family(at, half, psi, way).frame[0]) - frame / rocker))


def _settled(told: Told, asked: CrankRockerTask, side: int) -> Iterator[Block]:
    """What takes one member of the family."""
    lengths = _lengths(asked)
    if len(lengths) > 1:
        first, second = (LETTERS[name] for name in lengths)
        yield Paragraph(
            tr(
                "One size is free; the two given lengths ${first}$ and ${second}$ settle it.",
                first=first,
                second=second,
            )
        )
    elif asked.transmission is not None:
        yield Paragraph(
            tr(
                "One size is free: it is varied along the family, table {tab:synthesis_family}, until the least "
                "transmission angle is the one asked for; the root is bracketed and refined until its digits stand."
            )
        )
        yield _around(told, asked, side)
    else:
        yield Paragraph(
            tr(
                "One size is free. Of the family, table {tab:synthesis_family}, that linkage is taken whose least "
                "transmission angle is largest, no link being longer than $m$ cranks. {why}",
                why=_why(told, asked, side),
            )
        )
        yield _around(told, asked, side)


def _why(told: Told, asked: CrankRockerTask, side: int) -> str:
    """Which condition the best member keeps."""
    r, l, rocker, frame = (told.design.size(symbol) for symbol in "rlRL")
    if abs(max(l, rocker, frame) / r - asked.largest_ratio) < NEAR * asked.largest_ratio:
        return tr("There the longest link has reached that length.")
    found = _member(told, asked, side, np.array([rocker * math.sin(asked.swing / 2) / l]))
    first, second = (abs(float(each)) for each in cosines(found)[:, 0])
    if abs(first - second) < NEAR:
        return tr(
            "There the transmission angle deviates from $deg(90)$ as much in both positions of the crank on the frame."
        )
    return tr("There the least transmission angle does not change along the family.")


def _member(told: Told, asked: CrankRockerTask, side: int, x: np.ndarray) -> Family:
    return family(x, asked.swing / 2, told.design.size("psi"), side)


def _around(told: Told, asked: CrankRockerTask, side: int) -> Table:
    """Members of the family on both sides of the one that is taken, of the same rocker."""
    rocker, l = told.design.size("R"), told.design.size("l")
    half, least = asked.swing / 2, math.sin(told.design.size("psi") / 2)
    at = rocker * math.sin(half) / l
    ends = at - AROUND * (at - least), at + AROUND * (1 - at)
    x = np.concatenate((np.linspace(ends[0], at, ROWS // 2 + 1), np.linspace(at, ends[1], ROWS // 2 + 1)[1:]))
    found = _member(told, asked, side, x)
    angles = np.where(found.transmission > 0, np.degrees(found.transmission), np.nan)
    columns = {
        "$l$/$R$": found.coupler,
        "$r$/$R$": found.crank,
        "$L$/$R$": found.frame,
        "$mu_m$, deg": angles,
    }
    labels = [str(k + 1) for k in range(len(x))]
    return tabulated(
        tr("Crank-rockers of this swing and time ratio"), columns, labels, head=tr("Number"), key="synthesis_family"
    )


def _sizes(told: Told, asked: CrankRockerTask, side: int) -> Iterator[Block]:
    """The sizes: closed forms where two lengths give them, else what the root keeps."""
    given_, central = {*_lengths(asked)}, told.design.size("psi") == 0
    yield Paragraph(tr("The dimensions of the linkage:"))
    told.give({"x": ratio(_parameter(told), tr("parameter of the family"))})
    if "rocker" in given_:
        yield from told.lines("c = 2*R*sin(phi)")
        if central:
            yield from _free(told, asked)
        elif "crank" in given_:
            yield from told.lines(COUPLER)
        else:
            yield from _free(told, asked)
            yield from told.lines(*(CRANK,) * ("crank" not in given_))
    elif given_ == {"crank", "coupler"} and not central:
        yield from told.lines("c = 2*sqrt((l*sin(psi/2))**2 + (r*cos(psi/2))**2)", "R = c/(2*sin(phi))")
    else:
        yield from _by_ratios(told, given_)
    yield from told.lines(ALONG, OFF)
    yield from told.lines(FRAME, words={"side": "+" if side > 0 else "-"})


def _parameter(told: Told) -> float:
    return told.design.size("R") * math.sin(told.design.size("two_phi") / 2) / told.design.size("l")


def _free(told: Told, asked: CrankRockerTask) -> Iterator[Block]:
    """The coupler by the parameter that was found, where it is not given; the crank of a central linkage."""
    if asked.coupler is None:
        yield from _found(told)
        yield from told.lines("l = c/(2*x)")
    if told.design.size("psi") == 0 and asked.crank is None:
        yield from told.lines("r = c/2")


def _by_ratios(told: Told, given_: set[str]) -> Iterator[Block]:
    """All by the parameter, the scale by the length that is given."""
    yield from _found(told)
    base = next(letter for name, letter in LETTERS.items() if name in given_)
    central = told.design.size("psi") == 0
    if base == "l":
        yield from told.lines("c = 2*l*x")
    elif base == "r":
        text = "c = 2*r" if central else "c = 2*r*x*cos(psi/2)/sqrt(x**2 - sin(psi/2)**2)"
        yield from told.lines(text)
    else:
        yield Paragraph(tr("The rocker follows from the ratio $L/R$ of this member of the family:"))
        told.give({"chi": ratio(told.design.size("L") / told.design.size("R"), tr("frame over rocker, of the family"))})
        yield from told.lines("R = L/chi", "c = 2*R*sin(phi)")
    if base != "l":
        yield from told.lines("l = c/(2*x)")
    if base != "r":
        yield from told.lines("r = c/2" if central else CRANK)
    if base != "L":
        yield from told.lines("R = c/(2*sin(phi))")


def _found(told: Told) -> Iterator[Block]:
    yield Paragraph(
        tr(
            "The free size is told by $x = c/(2*l)$; the value that was found is $x = {value}$.",
            value=numeral(_parameter(told), 7),
        )
    )


def conditions(told: Told) -> Iterator[Block]:
    """Grashof, the transmission angle where the crank lies on the frame."""
    told.give({"mu_m": angle(told.achieved("least transmission angle"), tr_name("least transmission angle"))})
    sizes = {letter: told.design.size(letter) for letter in "rlRL"}
    yield from grashof(sizes)
    yield from transmission(told, sizes)
    found = Given(told.design.merits[TRANSMISSION.key], "deg", tr_name("least transmission angle"))
    if told.asked.time_ratio == 1:
        yield Paragraph(
            tr(
                "With $K = 1$ the linkage is central: the pivot $A$ lies on the line of both extreme positions of the "
                "pin $C$."
            )
        )
    limit = told.asked.transmission
    yield Result("mu_m", found, WEAK if limit is None else math.degrees(limit) * (1 - 1e-9), ">=")
