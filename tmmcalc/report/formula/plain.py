"""A formula as one line of plain text, for a terminal and for those who cannot see it."""

from __future__ import annotations

from tmmcalc.report.formula.layout import (
    Arrowed,
    Big,
    Box,
    Digits,
    Fenced,
    Fraction,
    Gap,
    Letter,
    Marked,
    Root,
    Row,
    Script,
    Sign,
    Word,
)
from tmmcalc.report.formula.setting import spelt

RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


def plain(box: Box) -> str:
    """The text.

    >>> from tmmcalc.report.formula.setting import statement
    >>> from tmmcalc.report.formula.syntax import read
    >>> plain(statement(read("v_{Dx} = v_{Cx} - l_4*omega_4*sin(phi_4)/2")))
    'v_Dx = v_Cx − (l_4 ω_4 sin φ_4)/2'
    """
    match box:
        case Letter(text) | Word(text):
            return text
        case Digits(text):
            return spelt(text)
        case Sign(text, _, leads):
            return text if leads or text == "·" else {";": "; "}.get(text, f" {text} ")
        case Gap():
            return " "
        case Row(boxes):
            return "".join(map(plain, boxes))
        case Fraction(over, under):
            return f"{_grouped(over)}/{_grouped(under)}"
        case Marked(inner, mark):
            return f"{plain(inner)}{mark}"
        case Root(inner, degree):
            raised = "" if degree is None else plain(degree).translate(RAISED)
            return f"{raised}√({plain(inner)})"
        case Script(base, lower, upper, primes):
            below = "" if lower is None else f"_{plain(lower)}"
            above = "" if upper is None else f"^{_grouped(upper)}"
            return f"{plain(base)}{'′' * primes}{below}{above}"
        case Fenced(inner, opening, closing):
            return f"{opening}{plain(inner)}{closing}"
        case Big(sign, lower, body):
            return f"{sign}_{plain(lower)} {plain(body)}"
        case Arrowed(inner):
            return f"vec({plain(inner)})"


def _grouped(box: Box) -> str:
    text = plain(box)
    return f"({text})" if any(sign in text for sign in " ·/") else text
