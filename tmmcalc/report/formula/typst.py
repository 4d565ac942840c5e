"""A formula in the mathematics of Typst."""

from __future__ import annotations

from tmmcalc.report.formula import layout
from tmmcalc.report.formula.setting import spelt

OPERATORS = {"·": "dot.op", ";": "\\;", "=": "=", "<": "<", "≤": "<=", ">": ">", "≥": ">=", "≈": "approx"}


def typst(box: layout.Box) -> str:
    """The source, without the signs that enclose it.

    >>> from tmmcalc.report.formula.setting import statement
    >>> from tmmcalc.report.formula.syntax import read
    >>> typst(statement(read("a_{BA}^n = omega_2**2*l_2/2")))
    'attach(a, b: B A, t: upright("n")) = frac(attach(ω, b: upright("2"), t: 2) thin attach(l, b: \
upright("2")), 2)'
    """
    match box:
        case layout.Letter(text):
            return text
        case layout.Word(text):
            return f'upright("{text}")' if text.strip(",") == text else f'class("normal", upright("{text}"))'
        case layout.Digits(text):
            number = spelt(text)
            return f'"{number}"' if "," in number else number
        case layout.Sign("−", leads=True):
            return 'class("normal", −)'
        case layout.Sign(text):
            return OPERATORS.get(text, text)
        case layout.Gap():
            return "thin"
        case layout.Row(boxes):
            return _row(boxes)
        case layout.Fraction(over, under):
            return f"frac({typst(over)}, {typst(under)})"
        case layout.Marked(inner, mark):
            return (
                f"attach({typst(inner)}, tr: {mark})"
                if not isinstance(inner, layout.Digits)
                else f'"{spelt(inner.text)}{mark}"'
            )
        case layout.Root(inner, degree):
            return f"sqrt({typst(inner)})" if degree is None else f"root({typst(degree)}, {typst(inner)})"
        case layout.Script(base, lower, upper, primes):
            below = "" if lower is None else f", b: {typst(lower)}"
            above = "" if upper is None else f", t: {typst(upper)}"
            body = typst(base) + "'" * primes
            return f"attach({body}{below}{above})"
        case layout.Fenced(inner, opening, closing):
            return f"lr({opening} {typst(inner)} {closing})"
        case layout.Big(_, lower, body):
            return f"sum_({typst(lower)}) {typst(body)}"
        case layout.Arrowed(inner):
            return f"arrow({typst(inner)})"


def _row(boxes: tuple[layout.Box, ...]) -> str:
    """Boxes one after another; a number in quotes follows its minus at once, where Typst would keep a space."""
    found = ""
    for k, box in enumerate(boxes):
        piece = typst(box)
        close = k and isinstance(boxes[k - 1], layout.Sign) and boxes[k - 1].leads and piece.startswith('"')
        found += piece if close or not k else f" {piece}"
    return found
