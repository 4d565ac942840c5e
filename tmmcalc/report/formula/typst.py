"""A formula in the mathematics of Typst."""

from __future__ import annotations

from tmmcalc.report.formula import layout
from tmmcalc.report.formula.setting import spelt

OPERATORS = {"·": "dot.op", ";": "\\;", "=": "=", "<": "<", "≤": "<=", ">": ">", "≥": ">=", "≈": "approx"}

UNARY = 'class("unary", −)'  # a minus before a whole


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
            return spelt(text).replace(",", '","')  # the comma alone: a text of several letters has gaps around it
        case layout.Sign("−", leads=True):
            return UNARY
        case layout.Sign(text):
            return OPERATORS.get(text, text)
        case layout.Gap():
            return "thin"
        case layout.Row(boxes):
            # a space before a text would be set as one
            return " ".join(map(typst, boxes)).replace(f'{UNARY} "', f'{UNARY}"')
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
        case layout.Script(layout.Row((*letters, last)), lower, upper, primes) if letters:  # ``Delta phi'``
            return f"{typst(layout.Row(tuple(letters)))} {typst(layout.Script(last, lower, upper, primes))}"
        case layout.Script(base, lower, upper, primes):
            below = "" if lower is None else f", b: {_script(lower)}"
            above = "" if upper is None else f", t: {_script(upper)}"
            body = typst(base) + "'" * primes
            return f"attach({body}{below}{above})"
        case layout.Fenced(inner, opening, closing):
            return f"lr({opening} {typst(inner)} {closing})"
        case layout.Big(_, lower, body):
            return f"sum_({typst(lower)}) {typst(body)}"
        case layout.Arrowed(inner):
            return f"arrow({typst(inner)})"


def _script(box: layout.Box) -> str:
    """An index: a space beside a word in it would be set as one, so that a comment parts them."""
    if isinstance(box, layout.Row) and all(isinstance(each, layout.Letter | layout.Word) for each in box.boxes):
        worded = any(isinstance(each, layout.Word) for each in box.boxes)
        return ("/**/" if worded else " ").join(map(typst, box.boxes))
    return typst(box)
