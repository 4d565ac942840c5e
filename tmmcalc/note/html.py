"""The note as one page of HTML with MathML, which needs nothing else."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from xml.sax.saxutils import escape

from tmmcalc.note.assembled import Equation, Grid, Image, Points, Text, Title, Written
from tmmcalc.report.drawing.svg import svg
from tmmcalc.report.formula.breaking import broken
from tmmcalc.report.formula.mathml import mathml

WIDE = 52.0  # of a formula before it is broken [em]
STYLE = """body{max-width:50em;margin:2em auto;padding:0 1em;font-family:"STIX Two Text",Georgia,serif;line-height:1.5}
.line{display:grid;grid-template-columns:9em 1fr 4em;align-items:center;margin:.5em 0;overflow-x:auto}
.line>:nth-child(2){text-align:center}.line>:last-child{text-align:right}
table{border-collapse:collapse;margin:.5em 0 1em}td,th{border:1px solid #888;padding:.2em .6em;text-align:left}"""


def page(blocks: Iterable[Written], title: str, language: str) -> str:
    """The text of the page."""
    head = f'<meta charset="utf-8"><title>{escape(title)}</title><style>{STYLE}</style>'
    body = "\n".join(_block(block) for block in blocks)
    return f'<!DOCTYPE html>\n<html lang="{language}"><head>{head}</head>\n<body>\n{body}\n</body></html>\n'


def _block(block: Written) -> str:
    match block:
        case Title(number, words, level):
            return f"<h{level}>{number} {escape(words)}</h{level}>"
        case Text():
            return f"<p>{_words(block)}</p>"
        case Equation(parts, number, lead):
            rows = "".join(f'<div><math display="block">{mathml(row)}</math></div>' for row in broken(parts, WIDE))
            said = f"({number})" if number else ""
            return f'<div class="line"><span>{escape(lead)}</span><div>{rows}</div><span>{said}</span></div>'
        case Grid(caption, head, rows):
            return (
                f"<p>{escape(caption)}</p><table>{_row(head, 'th')}{''.join(_row(row, 'td') for row in rows)}</table>"
            )
        case Image(caption, drawing):
            return f"<figure>{svg(drawing).decode()}<figcaption>{escape(caption)}</figcaption></figure>"
        case Points(items):
            return f"<ul>{''.join(f'<li>{_words(item)}</li>' for item in items)}</ul>"


def _words(words: Text) -> str:
    return "".join(escape(part) if isinstance(part, str) else f"<math>{mathml(part)}</math>" for part in words.parts)


def _row(cells: Sequence[Text], kind: str) -> str:
    return f"<tr>{''.join(f'<{kind}>{_words(cell)}</{kind}>' for cell in cells)}</tr>"
