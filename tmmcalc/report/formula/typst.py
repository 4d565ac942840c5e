"""A formula in the mathematics of Typst."""

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

OPERATORS = {"·": "dot.op", ";": "\\;", "=": "=", "<": "<", "≤": "<=", ">": ">", "≥": ">=", "≈": "approx"}


def typst(box: Box) -> str:
    """The source, without the signs that enclose it.

    >>> from tmmcalc.report.formula.setting import statement
    >>> from tmmcalc.report.formula.syntax import read
    >>> typst(statement(read("a_{BA}^n = omega_2**2*l_2/2")))
    'attach(a, b: upright("BA"), t: upright("n")) = frac(attach(ω, b: upright("2"), t: 2) thin attach(l, b: \
upright("2")), 2)'
    """
    match box:
        case Letter(text):
            return text
        case Word(text):
            return f'upright("{text}")'
        case Digits(text):
            number = spelt(text)
            return f'"{number}"' if "," in number else number
        case Sign("−", leads=True):
            return 'class("unary", −)'
        case Sign(text):
            return OPERATORS.get(text, text)
        case Gap():
            return "thin"
        case Row(boxes):
            return " ".join(map(typst, boxes))
        case Fraction(over, under):
            return f"frac({typst(over)}, {typst(under)})"
        case Marked(inner, mark):
            return (
                f"attach({typst(inner)}, tr: {mark})"
                if not isinstance(inner, Digits)
                else f'"{spelt(inner.text)}{mark}"'
            )
        case Root(inner):
            return f"sqrt({typst(inner)})"
        case Script(base, lower, upper, primes):
            below = "" if lower is None else f", b: {typst(lower)}"
            above = "" if upper is None else f", t: {typst(upper)}"
            body = typst(base) + "'" * primes
            return f"attach({body}{below}{above})"
        case Fenced(inner, opening, closing):
            return f"lr({opening} {typst(inner)} {closing})"
        case Big(_, lower, body):
            return f"sum_({typst(lower)}) {typst(body)}"
        case Arrowed(inner):
            return f"arrow({typst(inner)})"
