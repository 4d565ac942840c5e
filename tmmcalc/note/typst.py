"""The note as a source of Typst, and as PDF."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from tmmcalc.note.tree import (
    Caption,
    Contents,
    Cover,
    Equation,
    Grid,
    Image,
    Points,
    Reference,
    Source,
    Text,
    Title,
    Written,
    letters_wide,
)
from tmmcalc.report.drawing.box import Box as Rectangle
from tmmcalc.report.drawing.lettering import FONTS
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.drawing.svg import svg
from tmmcalc.report.formula.breaking import broken
from tmmcalc.report.formula.layout import Box
from tmmcalc.report.formula.typst import typst as formula
from tmmcalc.report.language import tr
from tmmcalc.report.sheets.gosttext import FIRST, OTHERS, PAGE, TextTitles, text_frame

SIZE = 12.0  # of letters [pt]
WIDE = 158.0  # that a formula may have, of 165 of the text [mm]
MM = 72.0 / 25.4  # points to a mm
LETTER = 0.55  # of the words before a formula [em]
NUMBER = 16.0  # room for the number of a formula [mm]
TURNED = 92  # letters in a row from which on a table stands turned
HEAD = """#set page(paper: "a4", margin: (left: 25mm, right: 20mm, top: 20mm, bottom: 20mm), numbering: "1")
#set document(title: "TITLE")
#set text(font: "TMM Text", size: 12pt, lang: "LANGUAGE")
#set par(justify: true, leading: 0.8em, spacing: 0.8em, first-line-indent: (amount: 12.5mm, all: true))
#show heading: set block(above: 1.4em, below: 0.9em)
#show heading.where(level: 1): it => { pagebreak(weak: true); it }
#show raw: set text(size: 8pt)
#show outline.entry: set block(spacing: 0.7em)
#set table(stroke: 0.5pt, inset: 4pt)
#let line(lead, body, number) = block(width: 100%, breakable: false, grid(columns: (auto, 1fr, auto),
  align: (left + horizon, center + horizon, right + horizon), lead, body, number))
#let listed(key, caption, continued, columns, heads, cells) = block(breakable: true, width: 100%, below: 1.2em)[
  #set par(justify: false, first-line-indent: 0pt)
  #metadata(none) #label(key)
  #table(columns: columns, table.header(table.cell(colspan: columns, stroke: none, inset: (x: 0pt), align: left,
    context { if here().page() == query(label(key)).first().location().page() { caption } else { continued } }),
    ..heads), ..cells)]
#let turned(body) = page(flipped: true, body)
#let pictured(key, body, caption) = [#block(breakable: false, width: 100%, above: 1.2em, below: 1.2em,
  align(center)[#body #v(2mm, weak: true) #caption]) #label(key)]
"""


def source(blocks: Iterable[Written], language: str, title: str, frame: TextTitles | None = None) -> str:
    """The text of the note, its pages after the title page in frames with these titles."""
    head = HEAD.replace("LANGUAGE", language).replace("TITLE", _quoted(title))
    found = [head]
    for block in blocks:
        if isinstance(block, Contents) and frame is not None:
            found += [_framed(frame, first=True), _block(block), "#pagebreak(weak: true)", _framed(frame, first=False)]
        else:
            found.append(_block(block))
    return "\n".join(found) + "\n"


def _framed(titles: TextTitles, *, first: bool) -> str:
    """Pages from here on have this frame, with their numbers in it."""
    drawing, number, total = text_frame(titles, first)
    numbers = _placed(number, "counter(page).display()")
    if total is not None:
        numbers += _placed(total, "counter(page).final().first()")
    margins = f"(left: 25mm, right: 10mm, top: 12mm, bottom: {(FIRST if first else OTHERS) + 12:g}mm)"
    lying = f"(top: 25mm, right: 12mm, bottom: 10mm, left: {OTHERS + 12:g}mm)"
    return f"""#let framed() = {{ {_image(drawing)}; {numbers} }}
#set page(numbering: none, margin: {margins},
  background: context if page.width > page.height {{ rotate(90deg, reflow: true, framed()) }} else {{ framed() }})
#let turned(body) = page(flipped: true, margin: {lying}, body)"""


def _placed(cell: Rectangle, body: str) -> str:
    """Something in the middle of a cell of the page."""
    left, top = cell.left, PAGE[1] - cell.top
    return (
        f"place(top + left, dx: {left:g}mm, dy: {top:g}mm, "
        f"box(width: {cell.width:g}mm, height: {cell.height:g}mm, align(center + horizon, [#{body}])));"
    )


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
        case Cover():
            return _cover(block)
        case Contents(title):
            return f"#outline(title: [{_escaped(title)}], depth: 2, indent: 5mm)"
        case Title(number, text, level):
            numbered = f"{number} {text}".strip()
            return f"{'=' * level} {_escaped(numbered)}"
        case Text():
            return _text(block) + "\n"
        case Equation():
            return _equation(block)
        case Grid():
            return _grid(block)
        case Image(caption, drawing):
            return f"#pictured({_label('fig', caption)}, {_image(drawing)}, [{_escaped(str(caption))}])"
        case Points(items):
            return "\n".join(f"- {_text(item)}" for item in items) + "\n"
        case Source(text):
            return f'#raw(block: true, "{_quoted(text)}")'


def _cover(cover: Cover) -> str:
    """The title page, which is not numbered."""
    people = ", ".join(f"[{_escaped(each)}]" for pair in cover.people for each in pair)
    groups = (
        _lines(cover.head),
        "v(1fr)",
        _lines(cover.kind[:1], 'weight: "bold", size: 20pt'),
        "parbreak()",
        _lines(cover.kind[1:]),
        "v(4mm)",
        _lines([cover.title], "size: 16pt"),
        "parbreak()",
        _lines([cover.designation]),
        "v(1fr)",
        f"align(right, grid(columns: 2, align: left, gutter: 4mm, {people}))" if people else "",
        "v(1fr)",
        _lines([cover.foot]),
    )
    body = "\n  ".join(each for each in groups if each)
    style = "set align(center)\n  set par(justify: false, first-line-indent: 0pt)"
    return f"#page(numbering: none, {{\n  {style}\n  {body}\n}})"


def _lines(lines: Sequence[str], style: str = "") -> str:
    said = " \\ ".join(_escaped(line) for line in lines if line)
    if not said:
        return ""
    return f"text({style})[{said}]" if style else f"[{said}]"


def _text(text: Text) -> str:
    return "".join(map(_part, text.parts))


def _part(part: str | Box | Reference) -> str:
    match part:
        case str():
            return _escaped(part)
        case Reference(key, number):
            return f'#link(label("{key}"))[{number}];'  # which ends the code: a semicolon of the text stays one
    return f"${formula(part)}$"


def _equation(equation: Equation) -> str:
    number, lead = equation.number, equation.lead
    wide = (WIDE - (NUMBER if number else 0.0)) * MM / SIZE - LETTER * len(lead)
    body = " \\\n ".join(formula(row) for row in broken(equation.parts, wide))
    label = f" <eq:{equation.key}>" if equation.key else ""
    return f"#line[{_escaped(lead)}][$ {body} $][{f'({number})' if number else ''}]{label}"


def _grid(grid: Grid) -> str:
    caption = grid.caption
    heads = "".join(f"[{_text(cell)}], " for cell in grid.head)
    cells = "".join(f"[{_text(cell)}], " for row in grid.rows for cell in row)
    continued = tr("Continuation of table {number}", number=caption.number)
    said = f"[{_escaped(str(caption))}], [{_escaped(continued)}]"
    table = f"#listed({_label('tab', caption)}, {said}, {len(grid.head)}, ({heads}), ({cells}))"
    return f"#turned[{table}]" if letters_wide(grid) > TURNED else table


def _image(drawing: Drawing) -> str:
    picture = _quoted(svg(drawing).decode())
    return f'image(bytes("{picture}"), format: "svg", width: {drawing.width:g}mm, alt: "{_quoted(drawing.title)}")'


def _label(kind: str, caption: Caption) -> str:
    """The name by which texts refer to a table or a figure."""
    return f'"{kind}:{caption.key or caption.number}"'


def _quoted(text: str) -> str:
    """A text as it stands between quotes in code."""
    return text.replace("\\", "\\\\").replace('"', '\\"')


def _escaped(text: str) -> str:
    for sign in "\\#$*_`<>@[]~":
        text = text.replace(sign, "\\" + sign)
    return text
