"""The laws of motion as formulas: those of the catalogue as books have them, all others by their coefficients.

A law has one or more pieces; of each s, s' and s'' stand as functions of k, the part of the phase.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tmmcalc.cams.laws.catalogue import NAMES, title_of
from tmmcalc.cams.laws.law import Law
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Lexicon

ORDERS = ("s", "s'", "s''")


class Piece(NamedTuple):
    """A piece of a law: from and to which k, and s, s', s'' there."""

    begin: float
    end: float
    formulas: tuple[str, str, str]


SINE, COSINE = "sin(4*pi*k)", "cos(4*pi*k)"  # of the ends of the modified laws
SLOW = "(4*pi*k/3 + pi/3)"
BOOK: dict[str, tuple[tuple[str, str, str], ...]] = {
    "sine": (("k - sin(2*pi*k)/(2*pi)", "1 - cos(2*pi*k)", "2*pi*sin(2*pi*k)"),),
    "cosine": (("(1 - cos(pi*k))/2", "pi*sin(pi*k)/2", "pi**2*cos(pi*k)/2"),),
    "linear": (("k**2*(3 - 2*k)", "6*k*(1 - k)", "6*(1 - 2*k)"),),
    "parab2": (
        ("8*k**3*(1 - k)", "8*k**2*(3 - 4*k)", "48*k*(1 - 2*k)"),
        ("1 - 8*k*(1 - k)**3", "8*(1 - k)**2*(4*k - 1)", "-48*(1 - k)*(2*k - 1)"),
    ),
    "const": (("2*k**2", "4*k", "4"), ("1 - 2*(1 - k)**2", "4*(1 - k)", "-4")),
    "shun": (("k**3*(10 - 15*k + 6*k**2)", "30*k**2*(1 - 2*k + k**2)", "60*k*(1 - 3*k + 2*k**2)"),),
    "poly5": (
        (
            "k**3*(18 - 55*k + 78*k**2 - 56*k**3 + 16*k**4)",
            "2*k**2*(27 - 110*k + 195*k**2 - 168*k**3 + 56*k**4)",
            "4*k*(27 - 165*k + 390*k**2 - 420*k**3 + 168*k**4)",
        ),
    ),
    "poly4567": (("k**4*(35 - 84*k + 70*k**2 - 20*k**3)", "140*k**3*(1 - k)**3", "420*k**2*(1 - k)**2*(1 - 2*k)"),),
    "modified_sine": (
        (f"(pi*k - {SINE}/4)/(4 + pi)", f"pi*(1 - {COSINE})/(4 + pi)", f"4*pi**2*{SINE}/(4 + pi)"),
        (
            f"(2 + pi*k - 9*sin{SLOW}/4)/(4 + pi)",
            f"pi*(1 - 3*cos{SLOW})/(4 + pi)",
            f"4*pi**2*sin{SLOW}/(4 + pi)",
        ),
        (f"(4 + pi*k - {SINE}/4)/(4 + pi)", f"pi*(1 - {COSINE})/(4 + pi)", f"4*pi**2*{SINE}/(4 + pi)"),
    ),
    "modified_trapezoid": (
        (f"(2*k - {SINE}/(2*pi))/(2 + pi)", f"2*(1 - {COSINE})/(2 + pi)", f"8*pi*{SINE}/(2 + pi)"),
        (
            "(4*pi*k**2 + (2 - pi)*k + pi/16 - 1/(2*pi))/(2 + pi)",
            "(8*pi*k + 2 - pi)/(2 + pi)",
            "8*pi/(2 + pi)",
        ),
        (
            f"(2*(1 + pi)*k + {SINE}/(2*pi) - pi/2)/(2 + pi)",
            f"2*(1 + pi + {COSINE})/(2 + pi)",
            f"-8*pi*{SINE}/(2 + pi)",
        ),
        (
            "1 - (4*pi*(1 - k)**2 + (2 - pi)*(1 - k) + pi/16 - 1/(2*pi))/(2 + pi)",
            "(8*pi*(1 - k) + 2 - pi)/(2 + pi)",
            "-8*pi/(2 + pi)",
        ),
        (f"(pi + 2*k - {SINE}/(2*pi))/(2 + pi)", f"2*(1 - {COSINE})/(2 + pi)", f"8*pi*{SINE}/(2 + pi)"),
    ),
}


def title(law: Law) -> str:
    """What the law is called."""
    return named_title(law.name)


def named_title(name: str) -> str:
    """What the law of this name is called."""
    if name in NAMES:
        return tr_name(title_of(name))
    if name == "polynomial":
        return tr("own polynomial")
    if name == "acceleration":
        return tr("acceleration by points")
    return tr("smooth curve through points") if name == "points" else tr("by the file {file}", file=name)


def pieces_of(law: Law) -> tuple[Piece, ...]:
    """The pieces of a law with their formulas."""
    ends = law.breaks.tolist()
    book = BOOK.get(law.name)
    formulas = book or [_by_coefficients(law, number) for number in range(law.count)]
    return tuple(Piece(*each) for each in zip(ends[:-1], ends[1:], formulas, strict=True))


def written_out(law: Law) -> bool:
    """Whether the formulas of a law have its coefficients by their letters."""
    return law.name not in BOOK


def _by_coefficients(law: Law, number: int) -> tuple[str, str, str]:
    """A polynomial of k less the begin of the piece, of its powers that are there, and a harmonic."""
    powers = [power for power in range(law.coefficients.shape[1]) if law.coefficients[:, power].any()]
    part = "(k - k_j)" if law.count > 1 else "k"
    texts = []
    for order, wave in enumerate(("A*sin(<w>)", "A*w*cos(<w>)", "-A*w**2*sin(<w>)")):
        terms = [_term(power, order, part) for power in powers if power >= order]
        if law.amplitude.any():
            terms.append(wave.replace("<w>", f"w*{part} + p"))
        texts.append(" + ".join(terms) or "0")
    return texts[0], texts[1], texts[2]


def _term(power: int, order: int, part: str) -> str:
    """The derivative of c t**power."""
    factor = int(np.prod(range(power - order + 1, power + 1)))
    left = power - order
    factors = [str(factor)] * (factor > 1) + [f"c_{power}"]
    factors += [part] * (left == 1) + [f"{part}**{left}"] * (left > 1)
    return "*".join(factors)


def coefficients(law: Law, number: int) -> Lexicon:
    """The coefficients of a piece by their letters, for a law that has its formulas with them."""
    found = {
        f"c_{power}": Given(float(value), "", tr("coefficients of the powers of the part of the phase"))
        for power, value in enumerate(law.coefficients[number])
    }
    found["k_j"] = Given(float(law.breaks[number]), "", tr("part of the phase at which the piece begins"))
    if law.amplitude.any():
        found["A"] = Given(float(law.amplitude[number]), "", tr("amplitude of the harmonic"))
        found["w"] = Given(float(law.frequency[number]), "", tr("frequency of the harmonic"))
        found["p"] = Given(float(law.phase[number]), "", tr("phase of the harmonic"))
    return found


def used(law: Law) -> Sequence[int]:
    """The powers that some piece of a law has."""
    return [power for power in range(law.coefficients.shape[1]) if law.coefficients[:, power].any()]
