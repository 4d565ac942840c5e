"""A formula in the mathematics of Office documents, which Word edits as an equation."""

from __future__ import annotations

from tmmcalc.core.escaping import escape, quoteattr
from tmmcalc.report.formula import layout
from tmmcalc.report.formula.setting import spelt

UPRIGHT = '<m:rPr><m:sty m:val="p"/></m:rPr>'
TEXT = "<m:rPr><m:nor/></m:rPr>"


def omml(box: layout.Box) -> str:
    """Elements for within ``<m:oMath>``.

    >>> from tmmcalc.report.formula.setting import statement
    >>> from tmmcalc.report.formula.syntax import read
    >>> omml(statement(read("u = z/2")))
    '<m:r><m:t>u</m:t></m:r><m:r><m:rPr><m:sty m:val="p"/></m:rPr><m:t>=</m:t></m:r><m:f><m:num><m:r><m:t>z</m:t></m:r>\
</m:num><m:den><m:r><m:rPr><m:sty m:val="p"/></m:rPr><m:t>2</m:t></m:r></m:den></m:f>'
    """
    match box:
        case layout.Letter(text):
            return _run(text, "")
        case layout.Word(text):
            return _run(text, TEXT)
        case layout.Digits(text):
            return _run(spelt(text), UPRIGHT)
        case layout.Sign(text):
            return _run(text, UPRIGHT)
        case layout.Gap():
            return _run("\u2009", UPRIGHT)
        case layout.Row(boxes):
            return "".join(map(omml, boxes))
        case layout.Fraction(over, under):
            return f"<m:f><m:num>{omml(over)}</m:num><m:den>{omml(under)}</m:den></m:f>"
        case layout.Marked(layout.Digits(text), mark):
            return _run(spelt(text) + mark, UPRIGHT)
        case layout.Marked(inner, mark):
            return omml(inner) + _run(mark, UPRIGHT)
        case layout.Root(inner, degree):
            hidden = '<m:radPr><m:degHide m:val="1"/></m:radPr><m:deg/>'
            above = hidden if degree is None else f"<m:deg>{omml(degree)}</m:deg>"
            return f"<m:rad>{above}<m:e>{omml(inner)}</m:e></m:rad>"
        case layout.Script(base, lower, upper, primes):
            body = f"<m:e>{omml(base)}</m:e>"
            above = _run("′" * primes, UPRIGHT) * bool(primes) + ("" if upper is None else omml(upper))
            if lower is None:
                return f"<m:sSup>{body}<m:sup>{above}</m:sup></m:sSup>"
            below = f"<m:sub>{omml(lower)}</m:sub>"
            if not above:
                return f"<m:sSub>{body}{below}</m:sSub>"
            return f"<m:sSubSup>{body}{below}<m:sup>{above}</m:sup></m:sSubSup>"
        case layout.Fenced(inner, opening, closing):
            ends = f"<m:begChr m:val={quoteattr(opening)}/><m:endChr m:val={quoteattr(closing)}/>"
            return f"<m:d><m:dPr>{ends}</m:dPr><m:e>{omml(inner)}</m:e></m:d>"
        case layout.Big(sign, lower, body):
            kind = f'<m:naryPr><m:chr m:val={quoteattr(sign)}/><m:supHide m:val="1"/></m:naryPr>'
            return f"<m:nary>{kind}<m:sub>{omml(lower)}</m:sub><m:sup/><m:e>{omml(body)}</m:e></m:nary>"
        case layout.Arrowed(inner):
            return f'<m:acc><m:accPr><m:chr m:val="⃗"/></m:accPr><m:e>{omml(inner)}</m:e></m:acc>'


def _run(text: str, properties: str) -> str:
    spaced = ' xml:space="preserve"' if text != text.strip() else ""
    return f"<m:r>{properties}<m:t{spaced}>{escape(text)}</m:t></m:r>"
