"""The note as a source of Typst, and as PDF."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from tmmcalc.note.assembled import Equation, Grid, Image, Points, Text, Title, Written
from tmmcalc.report.drawing.lettering import FONTS
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.drawing.svg import svg
from tmmcalc.report.formula.breaking import broken
from tmmcalc.report.formula.layout import Row
from tmmcalc.report.formula.typst import typst as formula

SIZE = 12.0  # of letters [pt]
WIDE = 158.0  # that a formula may have, of 165 of the text [mm]
MM = 72.0 / 25.4  # points to a mm
LETTER = 0.55  # of the words before a formula [em]
NUMBER = 16.0  # room for the number of a formula [mm]
HEAD = """#set page(paper: "a4", margin: (left: 25mm, right: 20mm, top: 20mm, bottom: 20mm), numbering: "1")
#set text(font: "TMM Text", size: 12pt, lang: "LANGUAGE")
#set par(justify: true, leading: 0.8em, spacing: 0.8em, first-line-indent: (amount: 12.5mm, all: true))
#show heading: set block(above: 1.4em, below: 0.9em)
#set table(stroke: 0.5pt)
#let line(lead, body, number) = block(width: 100%, breakable: false, grid(columns: (auto, 1fr, auto),
  align: (left + horizon, center + horizon, right + horizon), lead, body, number))
"""


def source(blocks: Iterable[Written], language: str) -> str:
    """The text of the note."""
    return HEAD.replace("LANGUAGE", language) + "\n".join(_block(block) for block in blocks) + "\n"


def pdf(text: str) -> bytes:
    """The note set; raises for a warning, as of a letter that no font has."""
    import typst

    fonts = typst.Fonts(include_system_fonts=False, font_paths=[str(FONTS)])
    compiled, warnings = typst.compile_with_warnings(text.encode(), format="pdf", font_paths=fonts)
    assert not warnings, [str(warning) for warning in warnings]
    assert isinstance(compiled, bytes)
    return compiled


def _block(block: Written) -> str:
    match block:
        case Title(number, text, level):
            return f"{'=' * level} {number} {_escaped(text)}"
        case Text():
            return _text(block) + "\n"
        case Equation(parts, number, lead):
            return _equation(parts, number, lead)
        case Grid(caption, head, rows):
            return _grid(caption, head, rows)
        case Image(caption, drawing):
            return _image(caption, drawing)
        case Points(items):
            return "\n".join(f"- {_text(item)}" for item in items) + "\n"


def _text(text: Text) -> str:
    return "".join(_escaped(part) if isinstance(part, str) else f"${formula(part)}$" for part in text.parts)


def _equation(parts: Sequence[Row], number: str, lead: str) -> str:
    wide = (WIDE - (NUMBER if number else 0.0)) * MM / SIZE - LETTER * len(lead)
    body = " \\\n ".join(formula(row) for row in broken(parts, wide))
    return f"#line[{_escaped(lead)}][$ {body} $][{f'({number})' if number else ''}]"


def _grid(caption: str, head: tuple[Text, ...], rows: tuple[tuple[Text, ...], ...]) -> str:
    cells = ", ".join(f"[{_text(cell)}]" for row in rows for cell in row)
    heads = ", ".join(f"[{_text(cell)}]" for cell in head)
    table = f"table(columns: {len(head)}, table.header({heads}), {cells})"
    return f"#block(breakable: true)[#block(sticky: true)[{_escaped(caption)}]\n#{table}]"


def _image(caption: str, drawing: Drawing) -> str:
    picture = svg(drawing).decode().replace("\\", "\\\\").replace('"', '\\"')
    shown = f'#image(bytes("{picture}"), format: "svg", width: {drawing.width:g}mm)'
    return f"#block(breakable: false, width: 100%)[#align(center)[{shown}\n{_escaped(caption)}]]"


def _escaped(text: str) -> str:
    for sign in "\\#$*_`<>@[]~":
        text = text.replace(sign, "\\" + sign)
    return text
