"""The note as a document of Word: formulas are equations that can be edited, numbers and contents are fields."""

from __future__ import annotations

import re
from collections.abc import Sequence
from io import BytesIO
from typing import TYPE_CHECKING, Any
from xml.sax.saxutils import escape, quoteattr
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from tmmcalc.note.tree import (
    NUMERIC,
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
    numeric,
    plain_text,
    tied,
    widest,
)
from tmmcalc.report.drawing.pdf import png
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.drawing.svg import svg
from tmmcalc.report.formula.breaking import broken
from tmmcalc.report.formula.layout import Sign
from tmmcalc.report.formula.omml import omml
from tmmcalc.report.formula.plain import plain

if TYPE_CHECKING:
    from docx.document import Document
    from docx.text.paragraph import Paragraph

WIDE = 34.0  # of a formula before it is broken [em]
MARGINS = {"left": 25, "right": 10, "top": 20, "bottom": 20}  # [mm]
FONT, SIZE, SMALL = "Times New Roman", 14.0, 12.0  # of text and of tables [pt]
CODE, CODED = "Courier New", 8.0  # font and size of lines as they are
INDENT = 12.5  # of the first line of a paragraph [mm]
LEAD, FORMULA, NUMBER = 36, 121, 18  # widths of the words before a formula, of itself and of its number [mm]
ACROSS, ALONG = 175.0, 257.0  # widths of a table, and of one that is turned [mm]
LETTER, PADDING = 2.45, 4.5  # of a column: by letter, and between its texts and lines [mm]
TWIPS = 1440 / 25.4  # to a mm
BESIDE = 108  # free beside the texts of a cell, by which its line would stand out of the margin [twips]
AROUND = 50  # free over and under a formula with a number [twips]
WHOLE = 12  # rows up to which a table stays on one page
CELLS = (12, 11, 10, 9)  # sizes of tables [pt], the first in which one fits; one that does not stands turned
SPACES = {
    "w": "http://schemas.openxmlformats.org/wordprocessingml/2006/main",
    "m": "http://schemas.openxmlformats.org/officeDocument/2006/math",
    "a": "http://schemas.openxmlformats.org/drawingml/2006/main",
    "r": "http://schemas.openxmlformats.org/officeDocument/2006/relationships",
    "asvg": "http://schemas.microsoft.com/office/drawing/2016/SVG/main",
}
MILLIMETRE = 25.4 / 72.0  # of a point
SVG = "{96DAC541-7B7A-43D3-8B79-37D633B846F1}"  # the extension of a picture that is beside it as SVG
LEVELS = "".join(
    f'<w:lvl w:ilvl="{k}"><w:start w:val="1"/><w:numFmt w:val="decimal"/><w:pStyle w:val="Heading{k + 1}"/>'
    f'<w:suff w:val="space"/><w:lvlText w:val="{".".join(f"%{j}" for j in range(1, k + 2))}"/><w:lvlJc w:val="left"/>'
    '<w:pPr><w:ind w:left="0" w:firstLine="0"/></w:pPr></w:lvl>'
    for k in range(3)
)
OPENING = '<m:r><m:rPr><m:nor/></m:rPr><m:t xml:space="preserve"> </m:t></m:r>'  # before a sign that goes on
NUMBERED = 77  # the list of headings among the lists of the document


def document(blocks: Sequence[Written], title: str) -> bytes:
    """The bytes of the file."""
    from datetime import UTC, datetime

    import docx

    found = docx.Document()
    found.core_properties.title = title
    found.core_properties.author = ""
    found.core_properties.created = found.core_properties.modified = datetime(2000, 1, 1, tzinfo=UTC)
    _styled(found)
    found.settings.element.append(_xml('<w:updateFields w:val="true"/>'))
    writer = _Writer(found, [block for block in blocks if isinstance(block, Title) and block.level < 3])
    for block, following in zip(blocks, [*blocks[1:], None], strict=True):
        writer.block(block, following)
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


def _xml(text: str) -> Any:
    """An element with the name spaces that it needs."""
    (found,) = _elements(text)
    return found


def _elements(text: str) -> list[Any]:
    """Elements one after another."""
    from docx.oxml import parse_xml

    spaces = " ".join(f'xmlns:{key}="{space}"' for key, space in SPACES.items() if f"{key}:" in text)
    return list(parse_xml(f"<all {spaces}>{text}</all>"))


def _styled(found: Document) -> None:
    """Page, fonts and paragraphs of all styles, the numbers of headings."""
    from docx.enum.style import WD_STYLE_TYPE
    from docx.enum.text import WD_PARAGRAPH_ALIGNMENT as TO
    from docx.shared import Mm, Pt, RGBColor

    section = found.sections[0]
    section.page_width, section.page_height = Mm(210), Mm(297)
    for side, free in MARGINS.items():
        setattr(section, f"{side}_margin", Mm(free))
    section.different_first_page_header_footer = True
    foot = section.footer.paragraphs[0]
    foot.alignment = TO.CENTER
    foot._p.extend(_elements(_field("PAGE", "2")))
    styles: Any = found.styles
    for name, size in (
        ("Normal", SIZE),
        ("Heading 1", 16.0),
        ("Heading 2", SIZE),
        ("Heading 3", SIZE),
        ("Caption", SMALL),
    ):
        style = styles[name]
        style.font.name, style.font.size, style.font.color.rgb = FONT, Pt(size), RGBColor(0, 0, 0)
        fonts = style.element.get_or_add_rPr().get_or_add_rFonts()
        for script in ("asciiTheme", "hAnsiTheme", "eastAsiaTheme", "cstheme"):
            fonts.attrib.pop(f"{{{SPACES['w']}}}{script}", None)
        for script in ("eastAsia", "cs"):
            fonts.set(f"{{{SPACES['w']}}}{script}", FONT)
    for size in CELLS:
        cell = styles.add_style(f"Cell{size}", WD_STYLE_TYPE.PARAGRAPH)
        cell.base_style, cell.font.size = styles["Normal"], Pt(size)
    normal = styles["Normal"].paragraph_format
    normal.space_after, normal.line_spacing = Pt(0), 1.5
    for level in (1, 2, 3):
        heading = styles[f"Heading {level}"]
        heading.paragraph_format.space_before, heading.paragraph_format.space_after = Pt(12), Pt(6)
        heading.element.get_or_add_pPr().append(
            _xml(f'<w:numPr><w:ilvl w:val="{level - 1}"/><w:numId w:val="{NUMBERED}"/></w:numPr>')
        )
    styles["Caption"].font.bold = False
    styles["Caption"].paragraph_format.keep_with_next = True
    numbering = found.part.numbering_part.element
    lists = _xml(
        f'<w:abstractNum w:abstractNumId="{NUMBERED}"><w:multiLevelType w:val="multilevel"/>{LEVELS}</w:abstractNum>'
    )
    numbering.insert(0, lists)
    numbering.append(_xml(f'<w:num w:numId="{NUMBERED}"><w:abstractNumId w:val="{NUMBERED}"/></w:num>'))


def _field(code: str, shown: str) -> str:
    """Runs of a field with what it shows until it is brought up to date."""
    parts = (
        '<w:fldChar w:fldCharType="begin"/>',
        f'<w:instrText xml:space="preserve"> {escape(code)} </w:instrText>',
        '<w:fldChar w:fldCharType="separate"/>',
        f"<w:t>{escape(shown)}</w:t>",
        '<w:fldChar w:fldCharType="end"/>',
    )
    return "".join(f"<w:r>{part}</w:r>" for part in parts)


def _run(text: str, size: float | None = None) -> str:
    """A run of text, of this size [pt] or of that of its paragraph."""
    sized = "" if size is None else f'<w:rPr><w:sz w:val="{2 * size:g}"/></w:rPr>'
    return f'<w:r>{sized}<w:t xml:space="preserve">{escape(text)}</w:t></w:r>' if text else ""


def _paragraph(runs: str, to: str = "left", style: str = "", *, holds: bool = False, free: int = 0) -> str:
    """A paragraph of single lines in a cell, ``free`` over and under it [twips]; ``holds``: on a page with the next."""
    styled = f'<w:pStyle w:val="{style}"/>' if style else ""
    spaced = f'<w:spacing w:before="{free}" w:after="{free}" w:line="240" w:lineRule="auto"/>'
    properties = f'{styled}{"<w:keepNext/>" * holds}{spaced}<w:jc w:val="{to}"/>'
    return f"<w:p><w:pPr>{properties}</w:pPr>{runs}</w:p>"


def _table(widths: Sequence[float], rows: Sequence[tuple[str, Sequence[str]]], style: str = "") -> str:
    """A table of columns so wide [mm]; rows are what is said of them, and cells of paragraphs.

    Without a style there are no lines, and nothing is kept free beside the texts.
    """
    dxa = [round(size * TWIPS) for size in widths]
    grid = "".join(f'<w:gridCol w:w="{size}"/>' for size in dxa)
    said = []
    for properties, cells in rows:
        each = (
            f'<w:tc><w:tcPr><w:tcW w:w="{size}" w:type="dxa"/><w:vAlign w:val="center"/></w:tcPr>{cell}</w:tc>'
            for size, cell in zip(dxa, cells, strict=True)
        )
        said.append(f"<w:tr><w:trPr><w:cantSplit/>{properties}</w:trPr>{''.join(each)}</w:tr>")
    styled = f'<w:tblStyle w:val="{style}"/>' if style else ""
    bare = '<w:tblCellMar><w:left w:w="0" w:type="dxa"/><w:right w:w="0" w:type="dxa"/></w:tblCellMar>' * (not style)
    inwards = f'<w:tblInd w:w="{BESIDE}" w:type="dxa"/>' * bool(style)
    sized = f'<w:tblW w:w="{sum(dxa)}" w:type="dxa"/>{inwards}<w:tblLayout w:type="fixed"/>'
    return f"<w:tbl><w:tblPr>{styled}{sized}{bare}</w:tblPr><w:tblGrid>{grid}</w:tblGrid>{''.join(said)}</w:tbl>"


class _Writer:
    """Puts one block after another into the document."""

    def __init__(self, found: Document, titles: Sequence[Title]) -> None:
        self.found = found
        self.titles = titles
        self.marks = 0  # bookmarks so far
        self.lying = False  # whether the page is turned

    def block(self, block: Written, following: Written | None) -> None:
        """Put a block; with what follows it stays on a page where one says nothing without the other."""
        if self.lying and not (isinstance(block, Grid) and _size_of(block, ACROSS) is None):
            self.turn()
        match block:
            case Cover():
                self.cover(block)
            case Contents(title):
                self.contents(title)
            case Title():
                self.title(block)
            case Text():
                self.paragraph(block, holds=isinstance(following, Equation) and not block.explains)
            case Equation():
                explained = isinstance(following, Text) and following.explains
                placed = isinstance(following, Equation) and not following.number
                self.equation(block, holds=bool(block.number) and (explained or placed))
            case Grid():
                self.grid(block)
            case Image(caption, drawing):
                self.image(caption, drawing)
            case Points(items):
                for item in items:
                    self.found.add_paragraph(style="List Bullet")._p.extend(_elements(_runs(item)))
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
        """A field of contents, which holds the titles until Word finds their pages."""
        from docx.enum.text import WD_TAB_ALIGNMENT, WD_TAB_LEADER
        from docx.shared import Mm

        head = self.found.add_paragraph()
        head.paragraph_format.page_break_before = True
        head.paragraph_format.space_after = Mm(2)
        head.add_run(title).bold = True
        first = self.found.add_paragraph()
        for part in (
            '<w:fldChar w:fldCharType="begin" w:dirty="true"/>',
            '<w:instrText xml:space="preserve"> TOC \\o "1-2" \\h \\z \\u </w:instrText>',
            '<w:fldChar w:fldCharType="separate"/>',
        ):
            first._p.append(_xml(f"<w:r>{part}</w:r>"))
        paragraph = first
        for k, each in enumerate(self.titles):
            paragraph = self.found.add_paragraph() if k else first
            paragraph.paragraph_format.left_indent = Mm(6 * (each.level - 1))
            paragraph.paragraph_format.line_spacing = 1.0
            paragraph.paragraph_format.tab_stops.add_tab_stop(Mm(ACROSS), WD_TAB_ALIGNMENT.RIGHT, WD_TAB_LEADER.DOTS)
            said = _run(f"{each.number} ".lstrip()) + _runs(each.text) + "<w:r><w:tab/></w:r>"
            paragraph._p.extend(_elements(said + _field(f"PAGEREF {_bookmark(_heading(each))} \\h", "")))
        paragraph._p.append(_xml('<w:r><w:fldChar w:fldCharType="end"/></w:r>'))

    def title(self, title: Title) -> None:
        """A heading that Word numbers; one without a number, or of an appendix, as it is."""
        counted = title.number[:1].isdigit()
        heading = self.found.add_heading("", title.level)
        said = ("" if counted else _run(f"{title.number} ".lstrip())) + _runs(title.text)
        heading._p.extend(_elements(said + "".join(self.marked(_heading(title)))))
        heading.paragraph_format.page_break_before = title.level == 1 and not counted
        if not counted:
            heading._p.get_or_add_pPr().append(_xml('<w:numPr><w:numId w:val="0"/></w:numPr>'))

    def paragraph(self, text: Text, *, holds: bool) -> None:
        """A paragraph of the text; ``holds``: on a page with the formula that it leads to."""
        from docx.enum.text import WD_PARAGRAPH_ALIGNMENT as TO
        from docx.shared import Mm

        paragraph = self.found.add_paragraph()
        paragraph.alignment = TO.JUSTIFY
        paragraph.paragraph_format.first_line_indent = Mm(0 if text.explains else INDENT)
        paragraph.paragraph_format.keep_with_next = holds or None
        paragraph._p.extend(_elements(_runs(text)))

    def add(self, text: str) -> None:
        """Put an element behind all that is there."""
        self.found.element.body.sectPr.addprevious(_xml(text))

    def equation(self, equation: Equation, *, holds: bool) -> None:
        """A formula in the middle, its place before it or its number at the right margin, in a table without lines.

        ``holds``: it stays on a page with what is said of it.
        """
        rows = []
        free = AROUND if equation.number else 0
        for row in broken(equation.parts, WIDE):
            lead = OPENING if isinstance(row.boxes[0], Sign) and not row.boxes[0].leads else ""
            formula = f"<m:oMathPara><m:oMath>{lead}{omml(row)}</m:oMath></m:oMathPara>"
            rows.append(_paragraph(formula, "center", holds=holds, free=free))
        number = ""
        if equation.number:
            key = f"eq:{equation.key}" if equation.key else ""
            number = f"{_run('(')}{self.number('Formula', equation.number, key)}{_run(')')}"
        cells = [_paragraph(_run(equation.lead, SMALL)), "".join(rows), _paragraph(number, "right")]
        sizes: tuple[int, ...] = (LEAD, FORMULA, NUMBER) if equation.lead else (NUMBER, FORMULA + LEAD - NUMBER, NUMBER)
        if equation.lead and not equation.number:
            del cells[2:]
            sizes = (LEAD, FORMULA + NUMBER)
        self.add(_table(sizes, [("", cells)]))

    def number(self, sequence: str, number: str, key: str) -> str:
        """A number such as 2.3 as fields, with a bookmark for references to it."""
        chapter, dot, own = number.rpartition(".")
        before, after = self.marked(key) or ("", "")
        counted = _field("STYLEREF 1 \\s", chapter) if chapter.isdigit() else _run(chapter)
        field = _field(f"SEQ {sequence} \\* ARABIC \\s 1" + (" \\r 1" if own == "1" else ""), own)
        return f"{before}{counted}{_run(dot)}{field}{after}"

    def marked(self, key: str) -> tuple[str, ...]:
        """The two ends of a bookmark of what texts refer to; nothing without a key."""
        if not key:
            return ()
        self.marks += 1
        name = quoteattr(_bookmark(key))
        return f'<w:bookmarkStart w:id="{self.marks}" w:name={name}/>', f'<w:bookmarkEnd w:id="{self.marks}"/>'

    def caption(self, caption: Caption, sequence: str, kind: str) -> Paragraph:
        """The line over a table or under a figure."""
        paragraph = self.found.add_paragraph(f"{caption.word} ", style="Caption")
        number = self.number(sequence, caption.number, f"{kind}:{caption.key}" if caption.key else "")
        paragraph._p.extend(_elements(number + (_run(" – ") + _runs(caption.text) if caption.text.parts else "")))
        return paragraph

    def grid(self, grid: Grid) -> None:
        """A table with lines, whose head is repeated on every page; a wide one on a turned page."""
        size = _size_of(grid, ACROSS)
        turned = size is None
        follows = turned and self.lying
        if turned and not self.lying:
            self.turn()
        self.caption(grid.caption, "Table", "tab").paragraph_format.page_break_before = follows
        size = size or _size_of(grid, ALONG) or CELLS[-1]
        right = [numeric(column) for column in zip(*grid.rows, strict=True)]
        style, whole = f"Cell{size}", len(grid.rows) <= WHOLE
        rows = [("<w:tblHeader/>", [_paragraph(_runs(cell), "center", style, holds=True) for cell in grid.head])]
        for k, row in enumerate(grid.rows, 1):
            holds = whole and k < len(grid.rows)
            cells = zip(row, ("right" if to else "left" for to in right), strict=True)
            rows.append(("", [_paragraph(_runs(cell), to, style, holds=holds) for cell, to in cells]))
        self.add(_table(_widths(grid, size, ALONG if turned else ACROSS), rows, "TableGrid"))
        if not turned:
            self.found.add_paragraph()

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
        paragraph.paragraph_format.keep_with_next = True
        main = self.found.part
        count = sum(1 for part in main.package.iter_parts() if part.content_type == "image/svg+xml")
        part = Part(PackURI(f"/word/media/figure{count + 1}.svg"), "image/svg+xml", svg(drawing), main.package)
        related = main.relate_to(part, f"{SPACES['r']}/image")
        blip = paragraph._p.find(f".//{{{SPACES['a']}}}blip")
        held = f'<asvg:svgBlip r:embed="{related}"/>'
        blip.append(_xml(f'<a:extLst><a:ext uri="{SVG}">{held}</a:ext></a:extLst>'))
        for told in paragraph._p.iter("{http://schemas.openxmlformats.org/drawingml/2006/wordprocessingDrawing}docPr"):
            told.set("descr", drawing.title)
        said = self.caption(caption, "Figure", "fig")
        said.alignment, said.paragraph_format.space_after = TO.CENTER, Pt(SMALL)
        said.paragraph_format.keep_with_next = False

    def source(self, text: str) -> None:
        """Lines as they are."""
        from docx.shared import Pt

        for line in text.splitlines():
            paragraph = self.found.add_paragraph()
            paragraph.paragraph_format.line_spacing = 1.0
            run = paragraph.add_run(line)
            run.font.name, run.font.size = CODE, Pt(CODED)


def _runs(text: Text, size: float | None = None) -> str:
    """Words, equations, references."""
    found = []
    for part in text.parts:
        match part:
            case str():
                found.append(_run(tied(part), size))
            case Reference(key, number):
                found.append(_field(f"REF {_bookmark(key)} \\h", number))
            case _:
                number = plain(part)
                alone = NUMERIC.fullmatch(number)
                found.append(_run(number, size) if alone else f"<m:oMath>{omml(part)}</m:oMath>")
    return "".join(found)


def _size_of(grid: Grid, room: float) -> int | None:
    """The size of letters [pt] in which a table fits so much room [mm], if there is one."""
    return next((size for size in CELLS if sum(_least(grid, size)) <= room), None)


def _least(grid: Grid, size: float) -> list[float]:
    """How wide columns are at least in letters of a size [mm]: as what cannot be broken in them asks."""
    columns = zip(grid.head, *grid.rows, strict=True)
    return [widest(column) * size * MILLIMETRE + PADDING for column in columns]


def _widths(grid: Grid, size: float, whole: float) -> list[float]:
    """How wide columns are [mm]: each as its longest word asks, and what is left by the lengths of their texts."""
    least = _least(grid, size)
    columns = zip(grid.head, *grid.rows, strict=True)
    wished = [LETTER * max(len(plain_text(cell)) for cell in column) + PADDING for column in columns]
    more = [max(wish - need, 0.0) for wish, need in zip(wished, least, strict=True)]
    left = whole - sum(least)
    if left <= 0 or not sum(more):
        return [whole * need / sum(least) for need in least]
    share = left / sum(more)
    return [need + share * each for need, each in zip(least, more, strict=True)]


def _bookmark(key: str) -> str:
    """The name of what texts refer to."""
    return "_" + re.sub(r"\W", "_", key)[:39]


def _heading(title: Title) -> str:
    """What the contents refer to a heading by."""
    return f"part:{title.number or title}"
