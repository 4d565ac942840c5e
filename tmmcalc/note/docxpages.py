"""Page, fonts and styles of a document of Word, the numbers of its headings."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmmcalc.note.docxtables import CELLS
from tmmcalc.note.docxwords import SPACES, element, elements, field
from tmmcalc.note.tree import ACROSS

if TYPE_CHECKING:
    from docx.document import Document

MARGINS = {"left": 25, "right": 10, "top": 20, "bottom": 20}  # [mm]
FONT, SIZE, SMALL = "Times New Roman", 14.0, 12.0  # of text and of captions [pt]
CODE, CODED = "Courier New", 8.0  # font and size of lines as they are
AFTER = 8.0  # height of the line under a table [pt]
LEVELS = "".join(
    f'<w:lvl w:ilvl="{k}"><w:start w:val="1"/><w:numFmt w:val="decimal"/><w:pStyle w:val="Heading{k + 1}"/>'
    f'<w:suff w:val="space"/><w:lvlText w:val="{".".join(f"%{j}" for j in range(1, k + 2))}"/><w:lvlJc w:val="left"/>'
    '<w:pPr><w:ind w:left="0" w:firstLine="0"/></w:pPr></w:lvl>'
    for k in range(3)
)
NUMBERED = 77  # the list of headings among the lists of the document


def styled(found: Document) -> None:
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
    foot._p.extend(elements(field("PAGE", "2")))
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
    code = styles.add_style("Code", WD_STYLE_TYPE.PARAGRAPH)
    code.base_style, code.font.name, code.font.size = styles["Normal"], CODE, Pt(CODED)
    code.paragraph_format.line_spacing = 1.0
    under = styles.add_style("Under", WD_STYLE_TYPE.PARAGRAPH)  # of the blank line under a table
    under.base_style, under.font.size = styles["Normal"], Pt(AFTER)
    under.paragraph_format.line_spacing = Pt(AFTER)
    normal = styles["Normal"].paragraph_format
    normal.space_after, normal.line_spacing = Pt(0), 1.5
    for level in (1, 2, 3):
        heading = styles[f"Heading {level}"]
        heading.paragraph_format.space_before, heading.paragraph_format.space_after = Pt(12), Pt(6)
        heading.element.get_or_add_pPr().append(
            element(f'<w:numPr><w:ilvl w:val="{level - 1}"/><w:numId w:val="{NUMBERED}"/></w:numPr>')
        )
    styles["Caption"].font.bold = False
    styles["Caption"].paragraph_format.keep_with_next = True
    numbering = found.part.numbering_part.element
    lists = element(
        f'<w:abstractNum w:abstractNumId="{NUMBERED}"><w:multiLevelType w:val="multilevel"/>{LEVELS}</w:abstractNum>'
    )
    numbering.insert(0, lists)
    numbering.append(element(f'<w:num w:numId="{NUMBERED}"><w:abstractNumId w:val="{NUMBERED}"/></w:num>'))


def contents_styled(found: Document, close: float) -> None:
    """The lines of the contents, so close to each other: Word writes them anew in these styles."""
    from docx.enum.style import WD_STYLE_TYPE
    from docx.enum.text import WD_TAB_ALIGNMENT, WD_TAB_LEADER
    from docx.shared import Mm, Pt

    for level in (1, 2):
        style: Any = found.styles.add_style(f"toc {level}", WD_STYLE_TYPE.PARAGRAPH, builtin=True)
        style.base_style = found.styles["Normal"]
        lines = style.paragraph_format
        lines.left_indent, lines.space_after, lines.line_spacing = Mm(6 * (level - 1)), Pt(0), close
        lines.tab_stops.add_tab_stop(Mm(ACROSS), WD_TAB_ALIGNMENT.RIGHT, WD_TAB_LEADER.DOTS)
