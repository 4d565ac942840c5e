"""A formula as one line of plain text, for a terminal and for those who cannot see it."""

from __future__ import annotations

from tmmcalc.report.formula import layout
from tmmcalc.report.formula.setting import spelt

RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


def plain(box: layout.Box) -> str:
    """The text.

    >>> from tmmcalc.report.formula.setting import statement
    >>> from tmmcalc.report.formula.syntax import read
    >>> plain(statement(read("v_{Dx} = v_{Cx} - l_4*omega_4*sin(phi_4)/2")))
    'v_Dx = v_Cx − (l_4 ω_4 sin φ_4)/2'
    """
    match box:
        case layout.Letter(text) | layout.Word(text):
            return text
        case layout.Digits(text):
            return spelt(text)
        case layout.Sign(text, _, leads):
            return text if leads or text == "·" else {";": "; "}.get(text, f" {text} ")
        case layout.Gap():
            return " "
        case layout.Row(boxes):
            return "".join(map(plain, boxes))
        case layout.Fraction(over, under):
            return f"{_signed(over)}/{_signed(under)}"
        case layout.Marked(inner, mark):
            return f"{plain(inner)}{mark}"
        case layout.Root(inner, degree):
            raised = "" if degree is None else plain(degree).translate(RAISED)
            return f"{raised}√({plain(inner)})"
        case layout.Script(base, lower, upper, primes):
            below = "" if lower is None else f"_{plain(lower)}"
            above = "" if upper is None else f"^{_grouped(upper)}"
            return f"{plain(base)}{'′' * primes}{below}{above}"
        case layout.Fenced(inner, opening, closing):
            return f"{opening}{plain(inner)}{closing}"
        case layout.Big(sign, lower, body):
            return f"{sign}_{plain(lower)} {plain(body)}"
        case layout.Arrowed(inner):
            return f"vec({plain(inner)})"


def _signed(box: layout.Box) -> str:
    """A side of a fraction on one line, where a minus before it belongs in brackets."""
    text = _grouped(box)
    return f"({text})" if text.startswith("−") else text


def _grouped(box: layout.Box) -> str:
    text = plain(box)
    return f"({text})" if any(sign in text for sign in " ·/") else text
