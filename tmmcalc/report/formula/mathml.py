"""A formula in MathML."""

from __future__ import annotations

from tmmcalc.core.escaping import escape
from tmmcalc.report.formula import layout
from tmmcalc.report.formula.setting import spelt


def mathml(box: layout.Box) -> str:
    """Elements for within ``<math>``.

    >>> from tmmcalc.report.formula.setting import statement
    >>> from tmmcalc.report.formula.syntax import read
    >>> mathml(statement(read("u = z_2/z_1")))
    '<mrow><mi>u</mi><mo>=</mo><mfrac><mrow><msub><mi>z</mi><mi mathvariant="normal">2</mi></msub></mrow><mrow>\
<msub><mi>z</mi><mi mathvariant="normal">1</mi></msub></mrow></mfrac></mrow>'
    """
    match box:
        case layout.Letter(text):
            return f"<mi>{escape(text)}</mi>"
        case layout.Word(text):
            return f'<mi mathvariant="normal">{escape(text)}</mi>'
        case layout.Digits(text):
            return f"<mn>{escape(spelt(text))}</mn>"
        case layout.Sign(text):
            return f"<mo>{escape(text)}</mo>"
        case layout.Gap():
            return '<mspace width="0.167em"/>'
        case layout.Row(boxes):
            return f"<mrow>{''.join(map(mathml, boxes))}</mrow>"
        case layout.Fraction(over, under):
            return f"<mfrac>{mathml(over)}{mathml(under)}</mfrac>"
        case layout.Marked(inner, mark):
            return f"<mrow>{mathml(inner)}<mo lspace='0' rspace='0'>{mark}</mo></mrow>"
        case layout.Root(inner, degree):
            if degree is None:
                return f"<msqrt>{mathml(inner)}</msqrt>"
            return f"<mroot>{mathml(inner)}{mathml(degree)}</mroot>"
        case layout.Script(base, lower, upper, primes):
            marks = "<mo>" + "′" * primes + "</mo>" if primes else ""
            above = f"<mrow>{marks}{'' if upper is None else mathml(upper)}</mrow>"
            if lower is None:
                return f"<msup>{mathml(base)}{above}</msup>"
            if upper is None and not primes:
                return f"<msub>{mathml(base)}{mathml(lower)}</msub>"
            return f"<msubsup>{mathml(base)}{mathml(lower)}{above}</msubsup>"
        case layout.Fenced(inner, opening, closing):
            return f"<mrow><mo>{opening}</mo>{mathml(inner)}<mo>{closing}</mo></mrow>"
        case layout.Big(sign, lower, body):
            return f"<mrow><munder><mo>{sign}</mo>{mathml(lower)}</munder>{mathml(body)}</mrow>"
        case layout.Arrowed(inner):
            return f"<mover>{mathml(inner)}<mo>→</mo></mover>"
