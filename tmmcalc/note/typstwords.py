"""Words in a source of Typst, and the measures of its pages."""

from __future__ import annotations

import re

from tmmcalc.note.tree import POINT, Caption, Reference, Text, part_width, tied
from tmmcalc.report.formula.layout import Box
from tmmcalc.report.formula.typst import typst as typeset

PRIMES = re.compile(r"(?<=\d)'+")
PAIR = re.compile(r"(?<=\d)–(?=\d|$)|^–(?=\d|$)")  # of links, the ends of a range
SIZE = 12.0  # of letters [pt]
EM = SIZE * POINT  # a letter M of the text [mm]
GAP = 2.0  # between what stands beside each other [mm]
WHOLE = 50.0  # of a formula of a text: no line ends within a shorter one [mm]


def set_text(text: Text) -> str:
    """A paragraph: words, formulas, references."""
    return "".join(map(_part, text.parts))


def _part(part: str | Box | Reference) -> str:
    match part:
        case str():
            return escaped(part)
        case Reference(key, number):
            return f'#link(label("{key}"))[{number}];'  # which ends the code: a semicolon of the text stays one
    formula = f"${typeset(part)}$"
    return f"#box({formula});" if part_width(part) * EM < WHOLE else formula


def label(kind: str, caption: Caption) -> str:
    """The name by which texts refer to a table or a figure."""
    return f'"{kind}:{caption.key or caption.number}"'


def quoted(text: str) -> str:
    """A text as it stands between quotes in code."""
    return text.replace("\\", "\\\\").replace('"', '\\"')


def escaped(text: str) -> str:
    """A text without signs of the language; what belongs together stays on a line.

    Primes after a number, as of a row 3'', are no quotation marks.
    """
    text = PAIR.sub("\u2060–\u2060", tied(text))
    text = PRIMES.sub(lambda found: "′" * len(found[0]), text)
    for sign in "\\#$*_`<>@[]~":
        text = text.replace(sign, "\\" + sign)
    return text.replace("/", "/\u2060")  # a unit is not broken
