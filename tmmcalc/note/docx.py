"""The note as a document of Word, whose formulas are equations that can be edited."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from io import BytesIO
from typing import TYPE_CHECKING, Any
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from tmmcalc.note.assembled import Equation, Grid, Image, Points, Text, Title, Written
from tmmcalc.report.drawing.pdf import png
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula.breaking import broken
from tmmcalc.report.formula.layout import Box
from tmmcalc.report.formula.omml import omml

if TYPE_CHECKING:
    from docx.document import Document

WIDE = 34.0  # of a formula before it is broken [em]
MARGINS = {"left": 25, "right": 10, "top": 20, "bottom": 20}  # [mm]
FONT, SIZE = "Times New Roman", 14  # [pt]
MATH = "http://schemas.openxmlformats.org/officeDocument/2006/math"
PARTS = (30, 125, 15)  # widths of the words before a formula, of itself and of its number [mm]
HEADER = '<w:tblHeader xmlns:w="http://schemas.openxmlformats.org/wordprocessingml/2006/main"/>'


def document(blocks: Iterable[Written], title: str) -> bytes:
    """The bytes of the file."""
    from datetime import UTC, datetime

    import docx
    from docx.shared import Mm, Pt

    found = docx.Document()
    found.core_properties.title = title
    found.core_properties.author = ""
    found.core_properties.created = found.core_properties.modified = datetime(2000, 1, 1, tzinfo=UTC)
    section = found.sections[0]
    section.page_width, section.page_height = Mm(210), Mm(297)
    for side, size in MARGINS.items():
        setattr(section, f"{side}_margin", Mm(size))
    style: Any = found.styles["Normal"]
    style.font.name, style.font.size = FONT, Pt(SIZE)
    for block in blocks:
        _block(found, block)
    buffer = BytesIO()
    found.save(buffer)
    return _undated(buffer)


def _undated(buffer: BytesIO) -> bytes:
    """The archive with no time in it, so that equal notes are equal files."""
    found = BytesIO()
    with ZipFile(buffer) as read, ZipFile(found, "w", ZIP_DEFLATED) as written:
        for name in read.namelist():
            written.writestr(ZipInfo(name, (1980, 1, 1, 0, 0, 0)), read.read(name), ZIP_DEFLATED)
    return found.getvalue()


def _block(found: Document, block: Written) -> None:
    match block:
        case Title(number, words, level):
            found.add_heading(f"{number} {words}", level)
        case Text():
            _fill(found.add_paragraph(), block)
        case Equation(parts, number, lead):
            _equation(found, broken(parts, WIDE), number, lead)
        case Grid(caption, head, rows):
            found.add_paragraph(caption)
            _grid(found, [head, *rows])
        case Image(caption, drawing):
            _image(found, caption, drawing)
        case Points(items):
            for item in items:
                _fill(found.add_paragraph(style="List Bullet"), item)


def _fill(paragraph: Any, words: Text) -> None:
    for part in words.parts:
        if isinstance(part, str):
            paragraph.add_run(part)
        else:
            paragraph._p.append(_math(part))


def _math(box: Box) -> Any:
    from docx.oxml import parse_xml

    return parse_xml(f'<m:oMath xmlns:m="{MATH}">{omml(box)}</m:oMath>')


def _equation(found: Document, rows: Sequence[Box], number: str, lead: str) -> None:
    """A formula in the middle, its place before it and its number at the right margin, in a table without lines."""
    from docx.enum.table import WD_CELL_VERTICAL_ALIGNMENT as ALIGNED
    from docx.enum.text import WD_PARAGRAPH_ALIGNMENT as TO
    from docx.shared import Mm

    table = found.add_table(rows=1, cols=3)
    table.autofit = False
    cells = table.rows[0].cells
    for cell, size, to in zip(cells, PARTS, (TO.LEFT, TO.CENTER, TO.RIGHT), strict=True):
        cell.width, cell.vertical_alignment = Mm(size), ALIGNED.CENTER
        cell.paragraphs[0].alignment = to
    cells[0].paragraphs[0].add_run(lead)
    cells[2].paragraphs[0].add_run(f"({number})" if number else "")
    for k, row in enumerate(rows):
        paragraph = cells[1].paragraphs[0] if not k else cells[1].add_paragraph()
        paragraph.alignment = TO.CENTER
        paragraph._p.append(_math(row))


def _image(found: Document, caption: str, drawing: Drawing) -> None:
    from docx.shared import Mm

    found.add_picture(BytesIO(png(drawing)), width=Mm(drawing.width))
    found.add_paragraph(caption)


def _grid(found: Document, rows: Sequence[Sequence[Text]]) -> None:
    """A table with lines, whose head is repeated on every page."""
    from docx.oxml import parse_xml

    table = found.add_table(rows=0, cols=len(rows[0]), style="Table Grid")
    for row in rows:
        for cell, text in zip(table.add_row().cells, row, strict=True):
            _fill(cell.paragraphs[0], text)
    table.rows[0]._tr.get_or_add_trPr().append(parse_xml(HEADER))
    found.add_paragraph()
