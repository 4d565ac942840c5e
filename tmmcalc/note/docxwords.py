"""Pieces of a document of Word as XML: paragraphs, runs, fields, marks that texts refer to."""

from __future__ import annotations

import re
from typing import Any

from tmmcalc.core.escaping import escape
from tmmcalc.note.tree import NUMERIC, Reference, Text, Title, tied
from tmmcalc.report.formula.layout import Box, Letter, Row, Script, Sign, Word
from tmmcalc.report.formula.omml import omml
from tmmcalc.report.formula.plain import plain

SPACES = {
    "w": "http://schemas.openxmlformats.org/wordprocessingml/2006/main",
    "m": "http://schemas.openxmlformats.org/officeDocument/2006/math",
    "a": "http://schemas.openxmlformats.org/drawingml/2006/main",
    "r": "http://schemas.openxmlformats.org/officeDocument/2006/relationships",
    "asvg": "http://schemas.microsoft.com/office/drawing/2016/SVG/main",
}

UPRIGHT = '<w:rPr><w:rFonts w:ascii="Times New Roman" w:hAnsi="Times New Roman" w:cs="Times New Roman"/></w:rPr>'


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
    return _typed(tied(text), sized)


def in_cell(content: str, to: str = "left", style: str = "", *, holds: bool = False) -> str:
    """A paragraph of single lines in a cell; one that ``holds`` stays on a page with the row under it."""
    styled = f'<w:pStyle w:val="{style}"/>' if style else ""
    told = f'{styled}{"<w:keepNext/>" * holds}<w:spacing w:line="240" w:lineRule="auto"/><w:jc w:val="{to}"/>'
    return f"<w:p><w:pPr>{told}</w:pPr>{content}</w:p>"


def runs(text: Text) -> str:
    """Words, equations, references; no line begins between an equation and what is written to it."""
    found: list[str] = []
    parts: list[str | Box | Reference] = [tied(part) if isinstance(part, str) else part for part in text.parts]
    for k, part in enumerate(parts):
        match part:
            case str():
                found.append(_typed(part))
            case Reference(key, number):
                found.append(field(f"REF {bookmark(key)} \\h", number))
            case _ if NUMERIC.fullmatch(number := plain(part)):
                found.append(run(number))
            case _:
                before, after = "", ""
                if k and isinstance(last := parts[k - 1], str) and not last.endswith(" "):
                    before = last.rpartition(" ")[2]
                    found[-1] = _typed(last.removesuffix(before))
                if k + 1 < len(parts) and isinstance(following := parts[k + 1], str):
                    after, space, rest = following.partition(" ")
                    parts[k + 1] = space + rest
                found.append(f"<m:oMath>{_worded(before)}{omml(part)}{_worded(after)}</m:oMath>")
    return "".join(found)


def cell_runs(text: Text) -> str:
    """The words of a cell, in which letters with an index are words too: these have the size of the table."""
    lettered = [
        _letters(part) if isinstance(part, tuple) and not isinstance(part, Reference) else "" for part in text.parts
    ]
    if not any(lettered):
        return runs(text)
    found, pending = [], 0
    for k, said in enumerate(lettered):
        if said:
            found += [runs(Text(text.parts[pending:k])), said]
            pending = k + 1
    return "".join([*found, runs(Text(text.parts[pending:]))])


def _typed(text: str, properties: str = "") -> str:
    return f'<w:r>{properties}<w:t xml:space="preserve">{escape(text)}</w:t></w:r>' if text else ""


def _worded(text: str) -> str:
    """Words of a text within an equation."""
    said = f'<m:t xml:space="preserve">{escape(text)}</m:t>'
    return f"<m:r><m:rPr><m:nor/></m:rPr>{UPRIGHT}{said}</m:r>" if text else ""


def _letters(box: Box) -> str:
    """A letter, or one with an index, as words; nothing for what takes more than a line of them."""
    match box:
        case Row(boxes):
            each = [*map(_letters, boxes)]
            return "".join(each) if all(each) else ""
        case Letter(text):
            return _typed(text, "" if "Α" <= text <= "Ω" else "<w:rPr><w:i/></w:rPr>")
        case Word(text) if text.strip():
            return _typed(text)
        case Sign("/"):
            return _typed("/")
        case Script(Letter() | Word() as base, lower, upper, primes):
            said = _letters(base)
            for index, place in ((lower, "subscript"), (upper, "superscript")):
                told = "" if index is None else plain(index).replace("_", "")
                if not re.fullmatch(r"[\w′,–()+-]*", told):
                    return ""
                said += _typed(told, f'<w:rPr><w:vertAlign w:val="{place}"/></w:rPr>')
            return said + _typed("′" * primes)
    return ""


def bookmark(key: str) -> str:
    """The name of what texts refer to."""
    return "_" + re.sub(r"\W", "_", key)[:39]


def mark_of(title: Title) -> str:
    """What the contents refer to a heading by."""
    return f"part:{title.number or title}"
