"""A drawing as SVG in millimetres: lines by classes, text as text, its length fixed for whatever font is there."""

from __future__ import annotations

import math
from collections.abc import Iterator
from xml.sax.saxutils import escape, quoteattr

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.lettering import FAMILY, Placed, em, line
from tmmcalc.report.drawing.pens import INK, Pen
from tmmcalc.report.drawing.shapes import Arc, Area, Dimension, Drawing, Hatching, Shape, Stroke, Words, hatch_lines
from tmmcalc.report.drawing.wording import rows

FALLBACK = f"'{FAMILY}', 'STIX Two Text', 'Times New Roman', 'Liberation Serif', serif"
RIM = 0.45  # width of the white rim around words [mm]


def svg(drawing: Drawing) -> bytes:
    """The bytes of the file."""
    pens: dict[Pen, str] = {}
    body = [part for shape in drawing.shapes for part in _Writer(drawing, pens).shape(shape)]
    w, h = _n(drawing.width), _n(drawing.height)
    styles = [
        f".{name}{{stroke:{pen.colour};stroke-width:{_n(pen.width)}{_dashed(pen)}}}" for pen, name in pens.items()
    ]
    head = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{w}mm" height="{h}mm" viewBox="0 0 {w} {h}" '
        f'xml:lang={quoteattr(drawing.language)} role="img">',
        f"<title>{escape(drawing.title)}</title>",
        "<style>path{fill:none;stroke-linecap:round;stroke-linejoin:round}"
        f"text{{font-family:{FALLBACK};fill:{INK};white-space:pre}}.i{{font-style:italic}}{''.join(styles)}</style>",
        f'<rect width="{w}" height="{h}" fill="#fff"/>',
    ]
    return "\n".join([*head, *body, "</svg>", ""]).encode()


def _dashed(pen: Pen) -> str:
    return f";stroke-dasharray:{' '.join(map(_n, pen.dashes))};stroke-linecap:butt" if pen.dashes else ""


class _Writer:
    def __init__(self, drawing: Drawing, pens: dict[Pen, str]) -> None:
        self.top, self.pens = drawing.height, pens

    def shape(self, shape: Shape) -> Iterator[str]:
        """The elements of a shape."""
        match shape:
            case Stroke():
                yield f'<path class="{self.name(shape.pen)}" d="{self.path(shape.points, shape.closed)}"/>'
            case Arc():
                yield self.arc(shape)
            case Area():
                outline = f' class="{self.name(shape.pen)}"' if shape.pen and shape.pen.width else ""
                yield f'<path{outline} style="fill:{shape.fill}" d="{self.path(shape.points, True)}"/>'
            case Hatching():
                lines = "".join(self.path(each, False) for each in hatch_lines(shape))
                yield f'<path class="{self.name(shape.pen)}" d="{lines}"/>'
            case Dimension():
                for part in shape.parts():
                    yield from self.shape(part)
            case Words():
                yield from self.words(shape)

    def name(self, pen: Pen) -> str:
        """The class of a pen: its layer, with a number where another pen of that layer came first."""
        if pen not in self.pens:
            before = sum(other.layer == pen.layer for other in self.pens)
            self.pens[pen] = pen.layer.lower().replace("_", "-") + (f"--{before + 1}" if before else "")
        return self.pens[pen]

    def path(self, points: Plane, closed: bool) -> str:
        """Steps from point to point."""
        steps = [f"{_n(x)} {_n(self.top - y)}" for x, y in zip(points.real.tolist(), points.imag.tolist(), strict=True)]
        return f"M{steps[0]}L{' '.join(steps[1:])}{'Z' if closed else ''}"

    def arc(self, arc: Arc) -> str:
        x, y, r = _n(arc.centre.real), _n(self.top - arc.centre.imag), _n(arc.radius)
        fill = f' style="fill:{arc.fill}"' if arc.fill else ' fill="none"'
        if arc.whole:
            return f'<circle class="{self.name(arc.pen)}"{fill} cx="{x}" cy="{y}" r="{r}"/>'
        a, b = arc.points.tolist()
        large = int(arc.end - arc.start > math.pi)
        d = f"M{_n(a.real)} {_n(self.top - a.imag)}A{r} {r} 0 {large} 0 {_n(b.real)} {_n(self.top - b.imag)}"
        return f'<path class="{self.name(arc.pen)}" d="{d}"/>'

    def words(self, words: Words) -> Iterator[str]:
        """A text element for every line."""
        colour = f' fill="{words.colour}"' if words.colour != INK else ""
        rim = f' stroke="#fff" stroke-width="{_n(2 * RIM)}" stroke-linejoin="round" paint-order="stroke"'
        for start, text in rows(words):
            x, y = _n(start.real), _n(self.top - start.imag)
            turn = f' transform="rotate({_n(-math.degrees(words.turn))} {x} {y})"' if words.turn else ""
            inner = "".join(self.pieces(text, words.height, start))
            yield f'<text x="{x}" y="{y}"{turn}{colour}{rim if words.clear else ""}>{inner}</text>'

    def pieces(self, text: str, height: float, start: complex) -> Iterator[str]:
        for placed in line(text):
            piece = placed.piece
            x, y = start.real + height * placed.start, self.top - start.imag - height * piece.rise
            face = ' class="i"' if piece.italic else ""
            size = _n(height * em(piece))
            yield (
                f'<tspan{face} x="{_n(x)}" y="{_n(y)}" font-size="{size}"{_length(placed, height)}>'
                f"{escape(piece.text)}</tspan>"
            )


def _length(placed: Placed, height: float) -> str:
    """Words keep their length in another font; a letter alone keeps its shape."""
    if len(placed.piece.text) < 2:
        return ""
    return f' textLength="{_n(height * placed.width)}" lengthAdjust="spacingAndGlyphs"'


def _n(value: float) -> str:
    """A number with three decimals, a thousandth of a millimetre, without needless zeros."""
    text = f"{value:.3f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
