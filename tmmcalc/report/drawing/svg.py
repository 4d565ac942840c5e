"""A drawing as SVG in millimetres: lines by classes, text as text, its length fixed for whatever font is there.

Places are written in hundredths of a millimetre, along lines as steps from point to point, so that no error adds up.
Lines of one pen that follow one another are one path.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from functools import lru_cache
from itertools import groupby, pairwise
from typing import NamedTuple

import numpy as np

from tmmcalc.core.escaping import escape, quoteattr
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
    writer = _Writer(drawing, pens)
    body = [*_joined(part for shape in drawing.shapes for part in writer.shape(shape))]
    w, h = _n(drawing.width), _n(drawing.height)
    styles = [
        f".{name}{{stroke:{pen.colour};stroke-width:{_n(pen.width)}{_dashed(pen)}}}" for pen, name in pens.items()
    ]
    head = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{w}mm" height="{h}mm" viewBox="0 0 {w} {h}" '
        f'xml:lang={quoteattr(drawing.language)} role="img">',
        f"<title>{escape(drawing.title)}</title>",
        "<style>path{stroke-linecap:round;stroke-linejoin:round}"
        f"text{{font-family:{FALLBACK};fill:{INK};white-space:pre}}.i{{font-style:italic}}{''.join(styles)}</style>",
        f'<rect width="{w}" height="{h}" fill="#fff"/>',
        '<g fill="none">',
    ]
    return "\n".join([*head, *body, "</g>", "</svg>", ""]).encode()


class _Line(NamedTuple):
    """A line without an area of its own."""

    name: str  # class of its pen
    path: str


def _joined(parts: Iterable[str | _Line]) -> Iterator[str]:
    """Elements in their order; lines of one class that follow one another are one."""
    for name, group in groupby(parts, key=lambda part: part.name if isinstance(part, _Line) else None):
        if name is None:
            yield from (part for part in group if isinstance(part, str))
        else:
            path = "".join(part.path for part in group if isinstance(part, _Line))
            yield f'<path class="{name}" d="{path}"/>'


def _dashed(pen: Pen) -> str:
    return f";stroke-dasharray:{' '.join(map(_n, pen.dashes))};stroke-linecap:butt" if pen.dashes else ""


class _Writer:
    def __init__(self, drawing: Drawing, pens: dict[Pen, str]) -> None:
        self.top, self.pens = drawing.height, pens

    def shape(self, shape: Shape) -> Iterator[str | _Line]:
        """The elements of a shape."""
        match shape:
            case Stroke():
                yield _Line(self.name(shape.pen), self.path(shape.points, shape.closed))
            case Arc():
                yield self.circle(shape) if shape.whole else _Line(self.name(shape.pen), self.arc(shape))
            case Area():
                outline = f' class="{self.name(shape.pen)}"' if shape.pen and shape.pen.width else ""
                yield f'<path{outline} fill="{shape.fill}" d="{self.path(shape.points, True)}"/>'
            case Hatching():
                for each in hatch_lines(shape):
                    yield _Line(self.name(shape.pen), self.path(each, False))
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

    def places(self, points: Plane) -> list[tuple[int, int]]:
        """Points in hundredths of a millimetre, downwards."""
        x, y = np.rint(100 * points.real), np.rint(100 * (self.top - points.imag))
        return list(zip(x.astype(int).tolist(), y.astype(int).tolist(), strict=True))

    def path(self, points: Plane, closed: bool) -> str:
        """Steps from point to point."""
        places = self.places(points)
        found, letter = f"M{_pair(*places[0])}", "M"
        for (a, b), (c, d) in pairwise(places):
            x, y = c - a, d - b
            if x and y:
                found += f"l{_pair(x, y)}" if letter != "l" else _after(_pair(x, y))
                letter = "l"
            elif x or y:
                letter = "h" if x else "v"
                found += f"{letter}{_hundredths(x or y)}"
        return found + ("z" if closed else "h0" if letter == "M" else "")

    def arc(self, arc: Arc) -> str:
        """A part of a circle."""
        (a, b), (c, d) = self.places(arc.points)
        r, large = _hundredths(round(100 * arc.radius)), int(arc.end - arc.start > math.pi)
        return f"M{_pair(a, b)}a{r} {r} 0 {large} 0 {_pair(c - a, d - b)}"

    def circle(self, arc: Arc) -> str:
        """A whole circle."""
        fill = f' fill="{arc.fill}"' if arc.fill else ""
        x, y, r = _n(arc.centre.real), _n(self.top - arc.centre.imag), _n(arc.radius)
        return f'<circle class="{self.name(arc.pen)}"{fill} cx="{x}" cy="{y}" r="{r}"/>'

    def words(self, words: Words) -> Iterator[str]:
        """A text element for every line."""
        colour = f' style="fill:{words.colour}"' if words.colour != INK else ""
        rim = f' stroke="#fff" stroke-width="{_n(2 * RIM)}" stroke-linejoin="round" paint-order="stroke"'
        for start, text in rows(words):
            turn = f"rotate({_n(-math.degrees(words.turn))} {_n(start.real)} {_n(self.top - start.imag)})"
            turned = f' transform="{turn}"' if words.turn else ""
            pieces = list(self.pieces(text, words.height, start))
            said = f"{turned}{colour}{rim if words.clear else ''}"
            if len(pieces) == 1:
                ((how, letters),) = pieces
                yield f"<text{how}{said}>{letters}</text>"
            else:
                inner = "".join(f"<tspan{how}>{letters}</tspan>" for how, letters in pieces)
                yield f"<text{said}>{inner}</text>"

    def pieces(self, text: str, height: float, start: complex) -> Iterator[tuple[str, str]]:
        """How the letters of a line stand, and they."""
        for placed in line(text):
            piece = placed.piece
            x, y = start.real + height * placed.start, self.top - start.imag - height * piece.rise
            face = ' class="i"' if piece.italic else ""
            size = _n(height * em(piece))
            yield f'{face} x="{_n(x)}" y="{_n(y)}" font-size="{size}"{_length(placed, height)}', escape(piece.text)


def _length(placed: Placed, height: float) -> str:
    """Words keep their length in another font; a letter alone keeps its shape."""
    if len(placed.piece.text) < 2:
        return ""
    return f' textLength="{_n(height * placed.width)}" lengthAdjust="spacingAndGlyphs"'


def _pair(x: int, y: int) -> str:
    """Two numbers of hundredths; a minus parts them as well as a space."""
    return _hundredths(x) + _after(_hundredths(y))


def _after(text: str) -> str:
    return text if text.startswith("-") else f" {text}"


@lru_cache(1 << 16)
def _hundredths(value: int) -> str:
    """A whole number of hundredths without needless zeros.

    >>> _hundredths(-50), _hundredths(1200), _hundredths(0)
    ('-.5', '12', '0')
    """
    text = f"{abs(value) / 100:g}"
    return ("-" if value < 0 else "") + (text[1:] if text.startswith("0.") else text)


def _n(value: float) -> str:
    """A number with two decimals, a hundredth of a millimetre, without needless zeros."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
