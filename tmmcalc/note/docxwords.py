"""Pieces of a document of Word as XML: paragraphs, runs, fields, marks that texts refer to."""

from __future__ import annotations

import re
from typing import Any
from xml.sax.saxutils import escape

from tmmcalc.note.tree import NUMERIC, Reference, Text, Title, tied
from tmmcalc.report.formula.omml import omml
from tmmcalc.report.formula.plain import plain

SPACES = {
    "w": "http://schemas.openxmlformats.org/wordprocessingml/2006/main",
    "m": "http://schemas.openxmlformats.org/officeDocument/2006/math",
    "a": "http://schemas.openxmlformats.org/drawingml/2006/main",
    "r": "http://schemas.openxmlformats.org/officeDocument/2006/relationships",
    "asvg": "http://schemas.microsoft.com/office/drawing/2016/SVG/main",
}


def element(text: str) -> Any:
    """An element with the name spaces that it needs."""
    (found,) = elements(text)
    return found


def elements(text: str) -> list[Any]:
    """Elements one after another."""
    from docx.oxml import parse_xml

    spaces = " ".join(f'xmlns:{key}="{space}"' for key, space in SPACES.items() if f"{key}:" in text)
    return list(parse_xml(f"<all {spaces}>{text}</all>"))


def field(code: str, shown: str) -> str:
    """Runs of a field with what it shows until it is brought up to date."""
    parts = (
        '<w:fldChar w:fldCharType="begin"/>',
        f'<w:instrText xml:space="preserve"> {escape(code)} </w:instrText>',
        '<w:fldChar w:fldCharType="separate"/>',
        f"<w:t>{escape(shown)}</w:t>",
        '<w:fldChar w:fldCharType="end"/>',
    )
    return "".join(f"<w:r>{part}</w:r>" for part in parts)


def run(text: str, size: float | None = None) -> str:
    """A run of text, of this size [pt] or of that of its paragraph."""
    sized = "" if size is None else f'<w:rPr><w:sz w:val="{2 * size:g}"/></w:rPr>'
    return f'<w:r>{sized}<w:t xml:space="preserve">{escape(tied(text))}</w:t></w:r>' if text else ""


def in_cell(content: str, to: str = "left", style: str = "", *, holds: bool = False) -> str:
    """A paragraph of single lines in a cell; one that ``holds`` stays on a page with the row under it."""
    styled = f'<w:pStyle w:val="{style}"/>' if style else ""
    told = f'{styled}{"<w:keepNext/>" * holds}<w:spacing w:line="240" w:lineRule="auto"/><w:jc w:val="{to}"/>'
    return f"<w:p><w:pPr>{told}</w:pPr>{content}</w:p>"


def runs(text: Text) -> str:
    """Words, equations, references."""
    found = []
    for part in text.parts:
        match part:
            case str():
                found.append(run(part))
            case Reference(key, number):
                found.append(field(f"REF {bookmark(key)} \\h", number))
            case _:
                number = plain(part)
                alone = NUMERIC.fullmatch(number)
                found.append(run(number) if alone else f"<m:oMath>{omml(part)}</m:oMath>")
    return "".join(found)


def bookmark(key: str) -> str:
    """The name of what texts refer to."""
    return "_" + re.sub(r"\W", "_", key)[:39]


def mark_of(title: Title) -> str:
    """What the contents refer to a heading by."""
    return f"part:{title.number or title}"
