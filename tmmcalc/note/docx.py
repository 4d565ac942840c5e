"""The note as a document of Word: formulas are equations that can be edited, numbers and contents are fields."""

from __future__ import annotations

import math
from collections.abc import Sequence
from io import BytesIO
from typing import TYPE_CHECKING
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from tmmcalc.core.escaping import quoteattr
from tmmcalc.note.columns import widths_of
from tmmcalc.note.docxpages import SIZE, SMALL, contents_styled, styled
from tmmcalc.note.docxplaces import WIDE, holds, ordered
from tmmcalc.note.docxtables import CELLS, PADDING, WHOLE, size_of, table
from tmmcalc.note.docxwords import SPACES, bookmark, cell_runs, element, elements, field, in_cell, mark_of, run, runs
from tmmcalc.note.tree import (
    ACROSS,
    ALONG,
    POINT,
    Caption,
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
    numeric,
)
from tmmcalc.report.drawing.pdf import png
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.drawing.svg import svg
from tmmcalc.report.formula.breaking import broken
from tmmcalc.report.formula.layout import Sign
from tmmcalc.report.formula.omml import omml

if TYPE_CHECKING:
    from docx.document import Document
    from docx.text.paragraph import Paragraph

INDENT = 12.5  # of the first line of a paragraph [mm]
LEAD, FORMULA, NUMBER = 36, 121, 18  # widths of the words before a formula, of itself and of its number [mm]
CLOSE = ((36, 1.15), (42, 1.0), (math.inf, 0.86))  # entries of the contents up to which lines are so close
SVG = "{96DAC541-7B7A-43D3-8B79-37D633B846F1}"  # the extension of a picture that is beside it as SVG
TOGETHER = 3  # rows of a long table that stand on a page at least
OPENING = '<m:r><m:rPr><m:nor/></m:rPr><m:t xml:space="preserve"> </m:t></m:r>'  # before a sign that goes on


def document(blocks: Sequence[Written], title: str) -> bytes:
    """The bytes of the file."""
    from datetime import UTC, datetime

    import docx

    found = docx.Document()
    found.core_properties.title = title
    found.core_properties.author = ""
    found.core_properties.created = found.core_properties.modified = datetime(2000, 1, 1, tzinfo=UTC)
    styled(found)
    found.settings.element.append(element('<w:updateFields w:val="true"/>'))
    writer = _Writer(found, [block for block in blocks if isinstance(block, Title) and block.level < 3])
    every = [*ordered(blocks)]
    for block, following in zip(every, [*every[1:], None], strict=True):
        writer.block(block, following)
    buffer = BytesIO()
    found.save(buffer)
    return _undated(buffer)


def _undated(buffer: BytesIO) -> bytes:
    """The archive without the time at which its parts were packed, so that equal notes are equal files."""
    found = BytesIO()
    with ZipFile(buffer) as read, ZipFile(found, "w", ZIP_DEFLATED) as written:
        for name in read.namelist():
            written.writestr(ZipInfo(name, (1980, 1, 1, 0, 0, 0)), read.read(name), ZIP_DEFLATED)
    return found.getvalue()


class _Writer:
    """Puts one block after another into the document."""

    def __init__(self, found: Document, titles: Sequence[Title]) -> None:
        self.found = found
        self.titles = titles
        self.marks = 0  # bookmarks so far
        self.lying = False  # whether the page is turned

    def block(self, block: Written, following: Written | None) -> None:
        """Put a block; a formula stays on a page with what its letters are, or with its first numbers."""
        if self.lying and not (isinstance(block, Grid) and size_of(block, ACROSS) is None):
            self.turn()
        match block:
            case Cover():
                self.cover(block)
            case Contents(title):
                self.contents(title)
            case Title():
                self.title(block)
            case Text():
                self.paragraph(block)
            case Equation():
                self.equation(block, holds=holds(block, following))
            case Grid():
                self.grid(block)
            case Image(caption, drawing):
                self.image(caption, drawing)
            case Points(items):
                for item in items:
                    self.found.add_paragraph(style="List Bullet")._p.extend(elements(runs(item)))
            case Source(text):
                self.source(text)

    def cover(self, cover: Cover) -> None:
        """The title page; the next part begins a page by itself."""
        from docx.enum.text import WD_PARAGRAPH_ALIGNMENT as TO
        from docx.shared import Mm, Pt

        def lines(said: Sequence[str], above: float, size: float = SIZE) -> None:
            for k, line in enumerate(each for each in said if each):
                paragraph = self.found.add_paragraph()
                paragraph.alignment = TO.CENTER
                paragraph.paragraph_format.space_before = Mm(0 if k else above)
                paragraph.add_run(line).font.size = Pt(size)

        lines(cover.head, 0)
        lines(cover.kind[:1], 60, 20)
        lines(cover.kind[1:], 0)
        lines([cover.title], 6, 16)
        lines([cover.designation], 4)
        for k, (what, name) in enumerate(cover.people):
            paragraph = self.found.add_paragraph(f"{what}: {name}")
            paragraph.paragraph_format.left_indent = Mm(100)
            paragraph.paragraph_format.space_before = Mm(0 if k else 40)
        lines([cover.foot], 40)

    def contents(self, title: str) -> None:
        """A field of contents, which holds the titles until Word finds their pages.

        Only what breaks the pages knows their numbers, so the file asks to be brought up to date when it is opened.
        """
        head = self.found.add_paragraph()
        head.paragraph_format.page_break_before = True
        head.add_run(title).bold = True
        first = self.found.add_paragraph()
        for part in (
            '<w:fldChar w:fldCharType="begin" w:dirty="true"/>',
            '<w:instrText xml:space="preserve"> TOC \\o "1-2" \\h \\z \\u </w:instrText>',
            '<w:fldChar w:fldCharType="separate"/>',
        ):
            first._p.append(element(f"<w:r>{part}</w:r>"))
        contents_styled(self.found, next(close for most, close in CLOSE if len(self.titles) <= most))
        paragraph = first
        for k, each in enumerate(self.titles):
            paragraph = self.found.add_paragraph() if k else first
            paragraph.style = f"toc {each.level}"
            mark = bookmark(mark_of(each))
            said = run(f"{each.number} ".lstrip()) + runs(each.text) + "<w:r><w:tab/></w:r>"
            linked = said + field(f"PAGEREF {mark} \\h", "")
            paragraph._p.append(element(f'<w:hyperlink w:anchor="{mark}" w:history="1">{linked}</w:hyperlink>'))
        paragraph._p.append(element('<w:r><w:fldChar w:fldCharType="end"/></w:r>'))

    def title(self, title: Title) -> None:
        """A heading that Word numbers; one without a number, or of an appendix, as it is, on a page that begins."""
        counted = title.number[:1].isdigit()
        heading = self.found.add_heading("", title.level)
        heading.paragraph_format.page_break_before = title.level == 1 and (not counted or title == self.titles[0])
        said = ("" if counted else run(f"{title.number} ".lstrip())) + runs(title.text)
        heading._p.extend(elements(said + "".join(self.marked(mark_of(title)))))
        if not counted:
            heading._p.get_or_add_pPr().append(element('<w:numPr><w:numId w:val="0"/></w:numPr>'))

    def paragraph(self, text: Text) -> None:
        """A paragraph of the text."""
        from docx.enum.text import WD_PARAGRAPH_ALIGNMENT as TO
        from docx.shared import Mm

        paragraph = self.found.add_paragraph()
        paragraph.alignment = TO.JUSTIFY
        paragraph.paragraph_format.first_line_indent = Mm(0 if text.explains else INDENT)
        paragraph.paragraph_format.keep_with_next = leads(text) or None
        paragraph._p.extend(elements(runs(text)))

    def add(self, text: str) -> None:
        """Put an element behind all that is there."""
        self.found.element.body.sectPr.addprevious(element(text))

    def equation(self, equation: Equation, *, holds: bool) -> None:
        """A formula in the middle, its place before it or its number at the right margin, in a table without lines.

        ``holds``: it stays on a page with what follows.
        """
        rows = []
        for row in broken(equation.parts, WIDE):
            lead = OPENING if isinstance(row.boxes[0], Sign) and not row.boxes[0].leads else ""
            formula = f"<m:oMathPara><m:oMath>{lead}{omml(row)}</m:oMath></m:oMathPara>"
            rows.append(in_cell(formula, "center", holds=holds))
        number = ""
        if equation.number:
            key = f"eq:{equation.key}" if equation.key else ""
            number = f"{run('(')}{self.number('Formula', equation.number, key)}{run(')')}"
        cells = [in_cell(run(equation.lead, SMALL)), "".join(rows), in_cell(number, "right")]
        sizes: tuple[int, ...] = (LEAD, FORMULA, NUMBER) if equation.lead else (NUMBER, FORMULA + LEAD - NUMBER, NUMBER)
        if equation.lead and not equation.number:
            del cells[2:]
            sizes = (LEAD, FORMULA + NUMBER)
        self.add(table(sizes, [("", cells)]))

    def number(self, sequence: str, number: str, key: str) -> str:
        """A number such as 2.3 as fields, with a bookmark for references to it."""
        chapter, dot, own = number.rpartition(".")
        before, after = self.marked(key) or ("", "")
        counted = field("STYLEREF 1 \\s", chapter) if chapter.isdigit() else run(chapter)
        told = f" \\r {own}" if own == "1" or not chapter else ""  # of parts without a number all are counted together
        counter = field(f"SEQ {sequence} \\* ARABIC \\s 1{told}", own)
        return f"{before}{counted}{run(dot)}{counter}{after}"

    def marked(self, key: str) -> tuple[str, ...]:
        """The two ends of a bookmark of what texts refer to; nothing without a key."""
        if not key:
            return ()
        self.marks += 1
        name = quoteattr(bookmark(key))
        return f'<w:bookmarkStart w:id="{self.marks}" w:name={name}/>', f'<w:bookmarkEnd w:id="{self.marks}"/>'

    def caption(self, caption: Caption, sequence: str, kind: str) -> Paragraph:
        """The line over a table or under a figure."""
        paragraph = self.found.add_paragraph(f"{caption.word} ", style="Caption")
        number = self.number(sequence, caption.number, f"{kind}:{caption.key}" if caption.key else "")
        paragraph._p.extend(elements(number + (run(" – ") + runs(caption.text) if caption.text.parts else "")))
        return paragraph

    def grid(self, grid: Grid) -> None:
        """A table with lines, whose head is repeated on every page; a wide one on a turned page."""
        size = size_of(grid, ACROSS)
        turned = size is None
        follows = turned and self.lying
        if turned and not self.lying:
            self.turn()
        self.caption(grid.caption, "Table", "tab").paragraph_format.page_break_before = follows
        size = size or size_of(grid, ALONG) or CELLS[-1]
        sides = ["right" if numeric(column) else "left" for column in zip(*grid.rows, strict=True)]
        style, last = f"Cell{size}", len(grid.rows) - 1
        rows = [("<w:tblHeader/>", [in_cell(cell_runs(cell), "center", style, holds=True) for cell in grid.head])]
        for k, row in enumerate(grid.rows):
            holds = k < last and (last < WHOLE or k < TOGETHER or k > last - TOGETHER)
            cells = [in_cell(cell_runs(cell), to, style, holds=holds) for cell, to in zip(row, sides, strict=True)]
            rows.append(("", cells))
        widths = widths_of(grid, size * POINT, PADDING, ALONG if turned else ACROSS)
        self.add(table(widths, rows, "TableGrid"))
        if not turned:
            self.found.add_paragraph(style="Under")

    def turn(self) -> None:
        """A new section, of pages that are turned against those before."""
        from docx.enum.section import WD_ORIENTATION, WD_SECTION

        section = self.found.add_section(WD_SECTION.NEW_PAGE)
        section.page_width, section.page_height = section.page_height, section.page_width
        lying = section.page_width > section.page_height
        section.orientation = WD_ORIENTATION.LANDSCAPE if lying else WD_ORIENTATION.PORTRAIT
        self.lying = lying
        section.different_first_page_header_footer = False

    def image(self, caption: Caption, drawing: Drawing) -> None:
        """A picture as SVG with a PNG beside it, for programs that read no SVG."""
        from docx.enum.text import WD_PARAGRAPH_ALIGNMENT as TO
        from docx.opc.packuri import PackURI
        from docx.opc.part import Part
        from docx.shared import Mm, Pt

        self.found.add_picture(BytesIO(png(drawing)), width=Mm(drawing.width))
        paragraph = self.found.paragraphs[-1]
        paragraph.alignment = TO.CENTER
        paragraph.paragraph_format.keep_with_next, paragraph.paragraph_format.line_spacing = True, 1.0
        main = self.found.part
        count = sum(1 for part in main.package.iter_parts() if part.content_type == "image/svg+xml")
        part = Part(PackURI(f"/word/media/figure{count + 1}.svg"), "image/svg+xml", svg(drawing), main.package)
        related = main.relate_to(part, f"{SPACES['r']}/image")
        blip = paragraph._p.find(f".//{{{SPACES['a']}}}blip")
        held = f'<asvg:svgBlip r:embed="{related}"/>'
        blip.append(element(f'<a:extLst><a:ext uri="{SVG}">{held}</a:ext></a:extLst>'))
        for told in paragraph._p.iter("{http://schemas.openxmlformats.org/drawingml/2006/wordprocessingDrawing}docPr"):
            told.set("descr", drawing.title)
        said = self.caption(caption, "Figure", "fig")
        said.alignment, said.paragraph_format.space_after = TO.CENTER, Pt(SMALL)
        said.paragraph_format.keep_with_next = False

    def source(self, text: str) -> None:
        """Lines as they are."""
        for line in text.splitlines():
            self.found.add_paragraph(line, style="Code")
