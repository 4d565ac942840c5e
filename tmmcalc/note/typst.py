"""The note as a source of Typst, and as PDF."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from tmmcalc.note.tree import (
    Contents,
    Cover,
    Equation,
    Grid,
    Image,
    Points,
    Source,
    Text,
    Title,
    Written,
    leads,
)
from tmmcalc.note.typstlines import set_lines
from tmmcalc.note.typstplaces import Place, placed
from tmmcalc.note.typsttables import PLAIN, set_pictured, set_tables
from tmmcalc.note.typstwords import escaped, label, quoted, set_text
from tmmcalc.report.drawing.box import Box as Rectangle
from tmmcalc.report.drawing.lettering import FONTS
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.drawing.svg import svg
from tmmcalc.report.sheets.gosttext import FIRST, OTHERS, PAGE, TextTitles, text_frame

LETTERS, LONG = 53, 0.05  # of a line of a file in half a page; share of longer lines that are broken there
HEAD = """#set page(paper: "a4", margin: (left: 25mm, right: 10mm, top: 16mm, bottom: 18mm), numbering: "1")
#set document(title: "TITLE", date: none)
#set text(font: "TMM Text", size: 12pt, lang: "LANGUAGE")
#set par(justify: true, leading: 0.68em, spacing: 0.68em, first-line-indent: (amount: 12.5mm, all: true))
#show heading: set block(above: 1.15em, below: 0.8em)
#show heading.where(level: 1): it => { block(breakable: false, sticky: true, below: 0pt, height: 45mm)
  v(-45mm); it }
#show raw: set text(size: 7.5pt)
#show math.equation.where(block: true): set align(left)
#show math.equation.where(block: true): set block(spacing: 0.6em)
#show outline.entry: set block(spacing: 0.52em)
#set table(stroke: 0.5pt, inset: (x: 3pt, y: PLAINpt))
#let line(columns, holds, ..cells) = block(width: 100%, breakable: false, sticky: holds, spacing: 0.55em,
  { set par(first-line-indent: 0pt); grid(columns: columns, align: horizon, ..cells) })
#let alone(room, holds, body, before: none, number: none) = block(
  width: 100%, breakable: false, sticky: holds, spacing: 0.55em, {
  set par(first-line-indent: 0pt)  // a grid of its own for every formula took a tenth of the time of a note
  pad(left: room, body)
  if before != none { place(left + horizon, before) }
  if number != none { place(right + horizon, number) }
})
#let leading(body) = block(sticky: true, spacing: 0.68em, par(body))
#let explained(body) = par(first-line-indent: 0pt, body)
#let listed(key, caption, continued, columns, rows, aligned, size, wide, breaks, heads, cells) = {
  let said(words) = block(width: wide, spacing: 4pt, text(size: 12pt, words))
  let above = context {
    let words = said(if here().page() == query(label(key)).first().location().page() { caption } else { continued })
    block(height: measure(words).height, width: 0pt, place(words))
  }
  let whole = table.cell.with(colspan: columns.len(), stroke: none, inset: (x: 0pt, y: 4pt), align: left)
  let named = if breaks { (whole(above),) }
  block(breakable: breaks, width: 100%, above: 1em, below: 1em)[
    #set par(justify: false, first-line-indent: 0pt, leading: 0.5em)
    #set text(size: size)
    #set align(left)
    #metadata(none) #label(key)
    #if not breaks { said(caption) }
    #table(columns: columns, rows: rows, align: aligned, table.header(..named, ..heads), ..cells)]
}
#let stood(columns, ..tables) = grid(columns: columns, column-gutter: 3mm, align: top, ..tables)
#let floated(key, stays, body, clearance: 1em) = if stays {
  block(width: 100%, breakable: false, above: clearance, below: clearance, body)
} else { context {
  let found = query(label(key))  // under the text that tells of it; on a later page over the text
  let late = found.len() > 0 and found.first().location().page() > here().page()
  place(if late { top } else { bottom }, float: true, clearance: clearance, body)
} }
#let turned(body) = page(flipped: true, body)
#let pictured(key, body, caption) = [#metadata(none) #label(key) #align(center)[#body #v(2mm, weak: true) #caption]]
#let shown(key, stays, ..pictures) = floated(key, stays, clearance: 1.2em,
  block(width: 100%, { set par(first-line-indent: 0pt, justify: false, leading: 0.5em)
  grid(columns: pictures.pos().len() * (1fr,), column-gutter: 3mm, align: bottom + center, ..pictures.pos()) }))
"""
ONE_PAGE = 46, 60  # titles: more than the first do not fit on a page, up to the second do if they stand close
CLOSE = "#set text(size: 11pt); #show outline.entry: set block(spacing: 0.36em); "


def source(blocks: Iterable[Written], language: str, title: str, frame: TextTitles | None = None) -> str:
    """The text of the note, its pages after the title page in frames with these titles."""
    head = HEAD.replace("LANGUAGE", language).replace("PLAIN", f"{PLAIN:g}").replace("TITLE", quoted(title))
    found = [head]
    for group, place in placed(blocks):
        if len(found) == 1 and isinstance(group[0], Title):
            found.append(_title(group[0]))  # on the first page
        elif isinstance(group[0], Contents) and frame is not None:
            opened, others = _framed(frame, first=True), _framed(frame, first=False)
            found += [opened, _block(group[0]), "#pagebreak(weak: true)", others]
        else:
            found += _group(group, place)
    return "\n".join(found) + "\n"


def _group(group: Sequence[Written], place: Place) -> Iterator[str]:
    """A formula with what belongs to it, pictures beside each other, or a block by itself."""
    first, last, stays = group[0], group[-1], place is Place.LAST
    if stays:
        yield "#place.flush()"  # what floats stands before it
    if isinstance(first, Image):
        pictures = ", ".join(_picture(each) for each in group if isinstance(each, Image))
        yield f"#shown({label('fig', first.caption)}, {str(stays).lower()}, {pictures})"
        return
    if isinstance(first, Grid) and isinstance(last, Image):
        yield set_pictured(first, _picture(last), last.drawing.width, stays=stays)
        return
    if isinstance(first, Grid):
        grids = [each for each in group if isinstance(each, Grid)]
        yield set_tables(grids, floats=place is not Place.HERE, stays=stays)
        return
    if not isinstance(group[0], Equation):
        yield _block(group[0])
        return
    said = next((each for each in group if isinstance(each, Text)), None)
    yield from set_lines([each for each in group if isinstance(each, Equation)], said)


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
        case Contents(title, entries):
            outline = f"#outline(title: [{escaped(title)}], depth: 2, indent: 5mm)"
            return f"#[{CLOSE}{outline}]" if ONE_PAGE[0] < entries <= ONE_PAGE[1] else outline
        case Title(number, _, level):
            before = "#place.flush()\n" if level == 1 else ""  # what floats stands with its chapter
            before += "#pagebreak(weak: true)\n" if level == 1 and not number[:1].isdigit() else ""
            return before + _title(block)
        case Text() if leads(block):
            return f"#leading[{set_text(block)}]"
        case Text():
            return set_text(block) + "\n"
        case Equation():
            return "\n".join(set_lines([block], None))
        case Grid() | Image():
            raise AssertionError(block.caption)  # they stand in groups
        case Points(items):
            return "\n".join(f"- {set_text(item)}" for item in items) + "\n"
        case Source(text):
            return f'#columns({_columns(text)}, gutter: 5mm)[#raw(block: true, "{quoted(text)}")]'


def _title(title: Title) -> str:
    numbered = f"{escaped(title.number)} {set_text(title.text)}".strip()
    return f"{'=' * title.level} {numbered}"


def _columns(text: str) -> int:
    """How many columns of a page lines have room in as they are, but for a few that are longer."""
    lines = text.splitlines()
    return 2 if sum(len(line) > LETTERS for line in lines) <= LONG * len(lines) else 1


def _cover(cover: Cover) -> str:
    """The title page, which is not numbered."""
    people = ", ".join(f"[{escaped(each)}]" for pair in cover.people for each in pair)
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
    said = " \\ ".join(escaped(line) for line in lines if line)
    if not said:
        return ""
    return f"text({style})[{said}]" if style else f"[{said}]"


def _picture(image: Image) -> str:
    caption = image.caption
    return f"pictured({label('fig', caption)}, {_image(image.drawing)}, [{set_text(caption.whole)}])"


def _image(drawing: Drawing) -> str:
    picture = quoted(svg(drawing).decode())
    return f'image(bytes("{picture}"), format: "svg", width: {drawing.width:g}mm, alt: "{quoted(drawing.title)}")'
