"""The note as a source of Typst, and as PDF."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

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
    plain_text,
)
from tmmcalc.report.drawing.box import Box as Rectangle
from tmmcalc.report.drawing.lettering import FONTS
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.drawing.svg import svg
from tmmcalc.report.formula.breaking import broken, width
from tmmcalc.report.formula.layout import Box, Fraction, Row, Script, inner
from tmmcalc.report.formula.typst import typst as typeset
from tmmcalc.report.language import tr
from tmmcalc.report.sheets.gosttext import FIRST, OTHERS, PAGE, TextTitles, text_frame

SIZE, NUMBERS, WORDS = 12.0, 10.5, 9.0  # of letters, of formulas with numbers, of words before these [pt]
WIDE = 175.0  # of the text [mm]
INDENT, NUMBER, GAP = 13.0, 12.0, 2.0  # room before a formula, for its number, between two beside each other [mm]
EM = SIZE * 25.4 / 72.0  # a letter M of the text [mm]
LETTER = 0.53  # of an em, of words
NEARLY = 1.04  # of the estimated width: what a formula may take
SMALL = (9.5, 9.0, 8.5, 8.0)  # sizes of tables [pt], the first in which one fits
CELL = 2.4  # beside the letters of a cell, with its line [mm]
WHOLE = (12, 28)  # rows: up to the first a table stands where it is told of, up to the second on one page
CHAPTER = re.compile(r"\d+\.")  # what the number of a table in a numbered chapter begins with
NUMERIC = re.compile(r"[-−+–\d.,  %°]*")  # what a cell of numbers has
SCRIPTED = "3.6pt"  # over and under the letters of a cell with indices
HEAD = """#set page(paper: "a4", margin: (left: 25mm, right: 10mm, top: 15mm, bottom: 18mm), numbering: "1")
#set document(title: "TITLE")
#set text(font: "TMM Text", size: 12pt, lang: "LANGUAGE")
#set par(justify: true, leading: 0.68em, spacing: 0.68em, first-line-indent: (amount: 12.5mm, all: true))
#show heading: set block(above: 1.15em, below: 0.8em)
#show heading.where(level: 1): it => { block(breakable: false, sticky: true, below: 0pt, height: 45mm)
  v(-45mm); it }
#show raw: set text(size: 7.5pt)
#show math.equation.where(block: true): set align(left)
#show math.equation.where(block: true): set block(spacing: 0.6em)
#show outline.entry: set block(spacing: 0.7em)
#set table(stroke: 0.5pt, inset: (x: 3pt, y: 3pt))
#let line(columns, holds, ..cells) = block(width: 100%, breakable: false, sticky: holds, spacing: 0.55em,
  { set par(first-line-indent: 0pt); grid(columns: columns, align: horizon, ..cells) })
#let explained(body) = par(first-line-indent: 0pt, body)
#let listed(key, caption, continued, columns, aligned, size, wide, breaks, heads, cells) = {
  let above = context {
    let said = block(width: wide, text(size: 12pt,
      if here().page() == query(label(key)).first().location().page() { caption } else { continued }))
    block(height: measure(said).height, width: 0pt, place(said))
  }
  block(breakable: breaks, width: 100%, above: 1em, below: 1em)[
    #set par(justify: false, first-line-indent: 0pt, leading: 0.5em)
    #set text(size: size)
    #set align(left)
    #metadata(none) #label(key)
    #table(columns: columns, align: aligned, table.header(table.cell(colspan: columns, stroke: none,
      inset: (x: 0pt, y: 4pt), align: left, above), ..heads), ..cells)]
}
#let stood(columns, ..tables) = grid(columns: columns, column-gutter: 3mm, align: top, ..tables)
#let floated(body) = place(bottom, float: true, clearance: 1em, body)
#let turned(body) = page(flipped: true, body)
#let pictured(key, body, caption) = [#metadata(none) #label(key) #align(center)[#body #v(2mm, weak: true) #caption]]
#let shown(..pictures) = place(bottom, float: true, clearance: 1.2em,
  block(width: 100%, { set par(first-line-indent: 0pt, justify: false, leading: 0.5em)
  grid(columns: pictures.pos().len() * (1fr,), column-gutter: 3mm, align: bottom + center, ..pictures.pos()) }))
"""


def source(blocks: Iterable[Written], language: str, title: str, frame: TextTitles | None = None) -> str:
    """The text of the note, its pages after the title page in frames with these titles."""
    head = HEAD.replace("LANGUAGE", language).replace("TITLE", _quoted(title))
    found = [head]
    for group in _grouped(blocks):
        if isinstance(group[0], Contents) and frame is not None:
            opened, others = _framed(frame, first=True), _framed(frame, first=False)
            found += [opened, _block(group[0]), "#pagebreak(weak: true)", others]
        else:
            found += _group(group)
    return "\n".join(found) + "\n"


def _grouped(blocks: Iterable[Written]) -> Iterator[list[Written]]:
    """What may stand beside each other: a formula and its explanation, its numbers at places, pictures."""
    group: list[Written] = []
    for block in blocks:
        if group and not _joins(group, block):
            yield group
            group = []
        group.append(block)
    if group:
        yield group


def _joins(group: Sequence[Written], block: Written) -> bool:
    """Whether a block stands beside those before it."""
    last = group[-1]
    match block:
        case Text(_, explains):
            return explains and isinstance(last, Equation) and bool(last.number)
        case Equation(_, number):
            return not number and isinstance(last, Equation | Text) and isinstance(group[0], Equation)
        case Image(_, drawing):
            drawings = [each.drawing for each in group if isinstance(each, Image)]
            free = WIDE - sum(each.width + GAP for each in drawings)
            return len(drawings) == len(group) and drawing.width <= free
        case Grid():
            grids = [each for each in (*group, block) if isinstance(each, Grid)]
            return len(grids) > len(group) and len(set(map(_stands, grids))) == 1 and _size_of(grids, SMALL[:2]) > 0
    return False


def _group(group: Sequence[Written]) -> Iterator[str]:
    """A formula with what belongs to it, pictures beside each other, or a block by itself."""
    if isinstance(group[0], Image):
        yield f"#shown({', '.join(_picture(each) for each in group if isinstance(each, Image))})"
        return
    if isinstance(group[0], Grid):
        yield _grids([each for each in group if isinstance(each, Grid)])
        return
    if not isinstance(group[0], Equation):
        yield _block(group[0])
        return
    formulas = [each for each in group if isinstance(each, Equation)]
    said = next((each for each in group if isinstance(each, Text)), None)
    if formulas[0].number:
        yield from _formula(formulas.pop(0), said, holds=len(group) > 1)
    while formulas:
        two = formulas[:2]
        beside = _beside(two) if len(two) == 2 else None
        yield beside or _line([two[0]], WIDE)
        del formulas[: 2 if beside else 1]


def _formula(formula: Equation, said: Text | None, *, holds: bool) -> Iterator[str]:
    """A formula with its number; what its letters are beside it, where there is room, or under it."""
    (row, *more) = _broken(formula, WIDE)
    free = WIDE - INDENT - NUMBER - width(row) * EM - 2 * GAP
    if said is not None and not more and sum(map(_wide, said.parts)) * EM <= free:
        cells = f"[], [$ {typeset(row)} $], [,], [{_text(said)}], [({formula.number})]"
        columns = f"({INDENT:g}mm, auto, auto, 1fr, auto)"
        yield f"#line({columns}, {str(holds).lower()}, column-gutter: (0mm, 0mm, {GAP:g}mm, 0mm), {cells}){_eq(formula)}"
        return
    yield _line([formula], WIDE, holds=holds)
    if said is not None:
        yield f"#explained[{_text(said)}]"


def _beside(two: Sequence[Equation]) -> str | None:
    """Two formulas beside each other, where they take fewer rows so."""
    half = (WIDE - GAP) / 2
    halves, wholes = [_broken(each, half) for each in two], [_broken(each, WIDE) for each in two]
    rooms = [half - _lead(each) for each in two]
    fits = all(width(row) * _em(each) <= room for each, rows, room in zip(two, halves, rooms, strict=True) for row in rows)
    if not fits or max(map(len, halves)) >= sum(map(len, wholes)):
        return None
    return _line(two, half)


def _line(formulas: Sequence[Equation], wide: float, *, holds: bool = False) -> str:
    """Formulas in a row, each in so much room, with the words before it and its number."""
    columns, cells = [], []
    for formula in formulas:
        rows = _broken(formula, wide)
        body = " \\\n quad ".join(map(typeset, rows))
        numbered = f"({formula.number})" if formula.number else ""
        columns += [f"{_lead(formula):g}mm", "1fr", "auto"]
        cells += [f"text(size: {WORDS}pt)[{_escaped(formula.lead)}]", _sized(f"$ {body} $", rows, formula, wide), f"[{numbered}]"]
    label = _eq(formulas[0])
    return f"#line(({', '.join(columns)}), {str(holds).lower()}, {', '.join(cells)}){label}"


def _sized(body: str, rows: Sequence[Row], formula: Equation, wide: float) -> str:
    """The rows in letters in which even those that cannot be broken have room."""
    room = wide - _lead(formula) - (NUMBER if formula.number else 0.0)
    size = SIZE if formula.number else NUMBERS
    needed = (max(map(width, rows)) + (1.0 if rows[1:] else 0.0)) * _em(formula)
    return f"text(size: {size * min(1.0, room / needed):.4g}pt)[{body}]"


def _broken(formula: Equation, wide: float) -> list[Row]:
    """The rows of a formula in so much room [mm]."""
    room = wide - _lead(formula) - (NUMBER if formula.number else 0.0)
    whole = broken(formula.parts, room / _em(formula))
    return whole if len(whole) == 1 else broken(formula.parts, room / _em(formula) - 1.0)  # what goes on stands in


def _em(formula: Equation) -> float:
    """The letter M of a formula [mm]."""
    return EM * NEARLY * (1.0 if formula.number else NUMBERS / SIZE)


def _lead(formula: Equation) -> float:
    """The room of the words before a formula [mm]."""
    return max(INDENT, _wide(formula.lead) * EM * WORDS / SIZE + 1.0)


def _wide(part: str | Box | Reference) -> float:
    """About how wide a part of a text is [em]."""
    match part:
        case str():
            return LETTER * len(part)
        case Reference(_, number):
            return LETTER * len(number)
    return width(part)


def _eq(formula: Equation) -> str:
    return f" <eq:{formula.key}>" if formula.key else ""


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
            apart = "#place.flush()\n#pagebreak(weak: true)\n" if level == 1 and not number[:1].isdigit() else ""
            return f"{apart}{'=' * level} {_escaped(numbered)}"
        case Text():
            return _text(block) + "\n"
        case Equation():
            return _line([block], WIDE)
        case Grid():
            return _grids([block])
        case Image():
            return f"#shown({_picture(block)})"
        case Points(items):
            return "\n".join(f"- {_text(item)}" for item in items) + "\n"
        case Source(text):
            return f'#columns(2, gutter: 5mm)[#raw(block: true, "{_quoted(text)}")]'


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
            return f'#link(label("{key}"))[{number}]'
    return f"${typeset(part)}$"


def _grids(grids: Sequence[Grid]) -> str:
    """Tables beside each other, or one, in letters as small as they need.

    A short table stands where it is told of, a longer one whole where there is room, one of many rows over pages; one
    that is too wide in small letters stands turned on a page of its own.
    """
    size = _size_of(grids, SMALL)
    if not size:
        return f"#turned[#{_grid(grids[0], SMALL[0], WIDE)}]"
    free = (WIDE - GAP * (len(grids) - 1) - sum(_width_at(each, size) for each in grids)) / len(grids)
    shares = [_width_at(each, size) + free for each in grids]
    tables = [_grid(each, size, wide) for each, wide in zip(grids, shares, strict=True)]
    stood = f"stood(({', '.join(f'{wide:g}mm' for wide in shares)}), {', '.join(tables)})" if tables[1:] else tables[0]
    return f"#floated({stood})" if _stands(grids[0]) == "whole" else f"#{stood}"


def _stands(grid: Grid) -> str:
    """Where a table stands by the number of its rows."""
    rows = len(grid.rows)
    if not CHAPTER.match(grid.caption.number):
        return "on"
    return "here" if rows <= WHOLE[0] else "whole" if rows <= WHOLE[1] and _size_of([grid], SMALL) else "on"


def _size_of(grids: Sequence[Grid], sizes: Sequence[float]) -> float:
    """The size of letters [pt] in which tables have room beside each other, or 0."""
    room = WIDE - GAP * (len(grids) - 1)
    return next((size for size in sizes if sum(_width_at(each, size) for each in grids) <= room), 0.0)


def _width_at(grid: Grid, size: float) -> float:
    """How wide a table is at least, in letters of this size [mm]."""
    return _table_width(grid) * size / SIZE + CELL * len(grid.head)


def _grid(grid: Grid, size: float, wide: float) -> str:
    """A table in letters of a size, its caption no wider than so much [mm]."""
    caption = grid.caption
    heads = "".join(_cell(cell, "center + horizon") for cell in grid.head)
    cells = "".join(_cell(cell) for row in grid.rows for cell in row)
    columns = zip(*grid.rows, strict=True)
    aligned = "".join("right + horizon, " if _numeric(column) else "left + horizon, " for column in columns)
    continued = tr("Continuation of table {number}", number=caption.number)
    said = f"[{_escaped(str(caption))}], [{_escaped(continued)}]"
    breaks = str(_stands(grid) == "on").lower()
    laid = f"{len(grid.head)}, ({aligned}), {size}pt, {wide:g}mm, {breaks}"
    return f"listed({_label('tab', caption)}, {said}, {laid}, ({heads}), ({cells}))"


def _table_width(grid: Grid) -> float:
    """How wide the letters of a table are at least, at the size of the text [mm]."""
    return sum(max(map(_longest, column)) for column in zip(grid.head, *grid.rows, strict=True)) * EM


def _longest(cell: Text) -> float:
    """The width of what cannot be broken in a cell: its longest word, or a formula with what is written to it [em]."""
    widest, here = 0.0, 0.0
    for part in cell.parts:
        words = part.split(" ") if isinstance(part, str) else [part]
        for k, word in enumerate(words):
            here = _wide(word) + (0.0 if k else here)
            widest = max(widest, here)
    return widest


def _numeric(cells: Sequence[Text]) -> bool:
    """Whether a column is of numbers."""
    return all(NUMERIC.fullmatch(plain_text(cell)) for cell in cells)


def _cell(cell: Text, align: str = "") -> str:
    """A cell, with room for indices."""
    said = [f"align: {align}"] if align else []
    if any(isinstance(part, Row) and _scripted(part) for part in cell.parts):
        said.append(f"inset: (x: 3pt, y: {SCRIPTED})")
    return f"table.cell({', '.join(said)})[{_text(cell)}], " if said else f"[{_text(cell)}], "


def _scripted(box: Box) -> bool:
    return isinstance(box, Script | Fraction) or any(map(_scripted, inner(box)))


def _picture(image: Image) -> str:
    caption = image.caption
    return f"pictured({_label('fig', caption)}, {_image(image.drawing)}, [{_escaped(str(caption))}])"


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
    return text.replace("/", "/\u2060")  # a unit is not broken
