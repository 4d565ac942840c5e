"""The note as one page of HTML with MathML, which needs nothing else."""

from __future__ import annotations

from collections.abc import Sequence
from zlib import crc32

from tmmcalc.core.escaping import escape, quoteattr
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
    tied,
)
from tmmcalc.report.drawing.svg import svg
from tmmcalc.report.formula.breaking import broken
from tmmcalc.report.formula.layout import Box
from tmmcalc.report.formula.mathml import mathml

WIDE = 52.0  # of a formula before it is broken [em]
STYLE = """body{max-width:50em;margin:2em auto;padding:0 1em;font-family:"STIX Two Text",Georgia,serif;line-height:1.5}
.line{display:grid;grid-template-columns:9em 1fr 4em;align-items:center;margin:.5em 0;overflow-x:auto}
.line>:nth-child(2){text-align:center}.line>:last-child{text-align:right}
.wide{overflow-x:auto}table{border-collapse:collapse;margin:.2em 0 1em}
td,th{border:1px solid #888;padding:.2em .6em;text-align:left}figure{margin:1em 0;text-align:center}
figure svg{max-width:100%;height:auto}pre{overflow-x:auto;font-size:.85em}header{text-align:center;margin:4em 0}
nav li{list-style:none}@media print{.wide{overflow:visible}h1{break-before:page}}"""


def page(blocks: Sequence[Written], title: str, language: str) -> str:
    """The text of the page."""
    head = f'<meta charset="utf-8"><title>{escape(title)}</title><style>{STYLE}</style>'
    titles = [block for block in blocks if isinstance(block, Title) and block.level < 3]
    body = "\n".join(_block(block, titles) for block in blocks)
    return f'<!DOCTYPE html>\n<html lang="{language}"><head>{head}</head>\n<body>\n{body}\n</body></html>\n'


def _block(block: Written, titles: Sequence[Title]) -> str:
    match block:
        case Cover(head, kind, title, people, foot, designation):
            lines = [*head, *kind, f"<strong>{escape(title)}</strong>", designation]
            lines += [f"{escape(what)}: {escape(name)}" for what, name in people]
            return f"<header>{''.join(f'<p>{line}</p>' for line in (*lines, foot) if line)}</header>"
        case Contents(title):
            items = "".join(f'<li><a href="#{_anchor(each)}">{_titled(each)}</a></li>' for each in titles)
            return f"<nav><h1>{escape(title)}</h1><ul>{items}</ul></nav>"
        case Title(_, _, level):
            return f'<h{level} id="{_anchor(block)}">{_titled(block)}</h{level}>'
        case Text():
            return f"<p>{_words(block)}</p>"
        case Equation(parts, number, lead, key):
            rows = "".join(f'<div><math display="block">{mathml(row)}</math></div>' for row in broken(parts, WIDE))
            said = f"({number})" if number else ""
            cells = f"<span>{escape(lead)}</span><div>{rows}</div><span>{said}</span>"
            return f'<div class="line"{_id("eq", key)}>{cells}</div>'
        case Grid(caption, head, rows):
            cells = f"{_row(head, 'th')}{''.join(_row(row, 'td') for row in rows)}"
            return f'<div class="wide"{_of(caption, "tab")}><p>{_words(caption.whole)}</p><table>{cells}</table></div>'
        case Image(caption, drawing):
            said = f"<figcaption>{_words(caption.whole)}</figcaption>"
            picture = svg(drawing).decode().partition("?>")[2].strip()  # without what begins a file
            return f"<figure{_of(caption, 'fig')}>{picture}{said}</figure>"
        case Points(items):
            return f"<ul>{''.join(f'<li>{_words(item)}</li>' for item in items)}</ul>"
        case Source(text):
            return f"<pre>{escape(text)}</pre>"


def _titled(title: Title) -> str:
    return f"{title.number} {_words(title.text)}".strip()


def _anchor(title: Title) -> str:
    return f"part-{title.number}" if title.number else f"part-{crc32(str(title).encode())}"


def _of(caption: Caption, kind: str) -> str:
    return _id(kind, caption.key)


def _id(kind: str, key: str) -> str:
    return f" id={quoteattr(f'{kind}:{key}')}" if key else ""


def _words(words: Text) -> str:
    return "".join(map(_part, words.parts))


def _part(part: str | Box | Reference) -> str:
    match part:
        case str():
            return escape(tied(part))
        case Reference(key, number):
            return f'<a href="#{key}">{number}</a>'
    return f"<math>{mathml(part)}</math>"


def _row(cells: Sequence[Text], kind: str) -> str:
    return f"<tr>{''.join(f'<{kind}>{_words(cell)}</{kind}>' for cell in cells)}</tr>"
