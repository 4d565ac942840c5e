"""A drawing as DXF (R2010) in millimetres: layers by meaning, real dimensions and hatches, text as text."""

from __future__ import annotations

import math
import re
from io import StringIO
from typing import Any

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.lettering import LEADING, Piece, pieces
from tmmcalc.report.drawing.pens import INK, PENS, Pen
from tmmcalc.report.drawing.shapes import ARROW, Arc, Area, Dimension, Drawing, Hatching, Shape, Stroke, Words
from tmmcalc.report.drawing.wording import rows

STYLE = "TMM"
FONT = "times.ttf"  # what every CAD program has, with Greek and Cyrillic letters
MADE = re.compile(r"@ \d{4}-\d\d-\d\dT[\d:.+]+")  # when the file was made, in its own notes


def dxf(drawing: Drawing) -> bytes:
    """The bytes of the file."""
    from ezdxf import units
    from ezdxf._options import options
    from ezdxf.filemanagement import new

    document = new("R2010", setup=False, units=units.MM)
    document.header["$LWDISPLAY"] = 1
    document.header["$EXTMIN"], document.header["$EXTMAX"] = (0, 0, 0), (drawing.width, drawing.height, 0)
    document.header["$LIMMIN"], document.header["$LIMMAX"] = (0, 0), (drawing.width, drawing.height)
    document.styles.add(STYLE, font=FONT)
    document.styles.add(f"{STYLE}_ITALIC", font="timesi.ttf")
    _set_dimensions(document)
    writer = _Writer(document)
    for shape in drawing.shapes:
        writer.shape(shape)
    document.modelspace().reset_extents((0, 0, 0), (drawing.width, drawing.height, 0))
    out = StringIO()
    options.write_fixed_meta_data_for_testing = True  # no dates: equal drawings give equal bytes
    try:
        document.write(out)
    finally:
        options.write_fixed_meta_data_for_testing = False
    return MADE.sub("", out.getvalue()).encode("utf-8")


def _set_dimensions(document: Any) -> None:
    """The style of dimensions: text above an unbroken line, closed arrows."""
    style = document.dimstyles.add(STYLE)
    for key, value in {
        "dimtxsty": STYLE,
        "dimasz": ARROW,
        "dimexo": 0.5,
        "dimexe": 1.5,
        "dimgap": 0.9,
        "dimtad": 1,
        "dimtih": 0,
        "dimtoh": 0,
        "dimdec": 4,
        "dimzin": 8,
        "dimlfac": 1.0,
    }.items():
        style.set_dxf_attrib(key, value)


def lineweight(width: float) -> int:
    """The standard line weight nearest to a width, in hundredths of a mm."""
    weights = (0, 5, 9, 13, 15, 18, 20, 25, 30, 35, 40, 50, 53, 60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211)
    return min(weights, key=lambda weight: abs(weight - 100 * width))


class _Writer:
    def __init__(self, document: Any) -> None:
        self.document, self.space = document, document.modelspace()

    def shape(self, shape: Shape) -> None:
        """Enter a shape."""
        match shape:
            case Stroke():
                points = _pairs(shape.points)
                self.space.add_lwpolyline(points, close=shape.closed, dxfattribs=self.drawn(shape.pen))
            case Arc():
                self.arc(shape)
            case Area():
                self.area(shape)
            case Hatching():
                self.hatching(shape)
            case Dimension():
                self.dimension(shape)
            case Words():
                self.words(shape)

    def drawn(self, pen: Pen) -> dict[str, Any]:
        """Layer of a pen, made when it is first used."""
        if pen.layer not in self.document.layers:
            linetype = "CONTINUOUS"
            if pen.dashes:
                linetype = f"TMM_{pen.layer}"
                lengths = [d if k % 2 == 0 else -d for k, d in enumerate(pen.dashes)]
                self.document.linetypes.add(linetype, [sum(pen.dashes), *lengths])
            known = next((each for each in PENS if each.layer == pen.layer), pen)
            layer = self.document.layers.add(pen.layer, linetype=linetype, lineweight=lineweight(known.width))
            layer.rgb = _rgb(pen.colour)
        return {"layer": pen.layer}

    def arc(self, arc: Arc) -> None:
        if arc.fill:
            hatch = self.space.add_hatch(dxfattribs=self.drawn(arc.pen))
            hatch.rgb = _rgb(arc.fill)
            hatch.paths.add_edge_path().add_arc((arc.centre.real, arc.centre.imag), arc.radius)
        centre, attributes = (arc.centre.real, arc.centre.imag), self.drawn(arc.pen)
        if arc.whole:
            self.space.add_circle(centre, arc.radius, dxfattribs=attributes)
        else:
            ends = math.degrees(arc.start), math.degrees(arc.end)
            self.space.add_arc(centre, arc.radius, *ends, dxfattribs=attributes)

    def area(self, area: Area) -> None:
        attributes = self.drawn(area.pen) if area.pen else {}
        hatch = self.space.add_hatch(dxfattribs=attributes)
        hatch.rgb = _rgb(area.fill)
        hatch.paths.add_polyline_path(_pairs(area.points), is_closed=True)
        if area.pen and area.pen.width:
            self.space.add_lwpolyline(_pairs(area.points), close=True, dxfattribs=attributes)

    def hatching(self, hatching: Hatching) -> None:
        hatch = self.space.add_hatch(dxfattribs=self.drawn(hatching.pen))
        angle = math.degrees(hatching.angle)
        e = complex(math.cos(hatching.angle), math.sin(hatching.angle)) * 1j * hatching.pitch
        hatch.set_pattern_fill("TMM", definition=[[angle, (0.0, 0.0), (e.real, e.imag), []]])
        for k, loop in enumerate(hatching.loops):
            hatch.paths.add_polyline_path(_pairs(loop), is_closed=True, flags=1 if k == 0 else 16)

    def dimension(self, dimension: Dimension) -> None:
        """A dimension that measures; its text is the one given, which counts the scale in."""
        attributes = self.drawn(dimension.pen)
        base = (dimension.line.real, dimension.line.imag)
        p1, p2 = ((p.real, p.imag) for p in (dimension.first, dimension.second))
        along = dimension.second - dimension.first
        angle = math.atan2(along.imag, along.real) if dimension.angle is None else dimension.angle
        override = {"dimtxt": dimension.height, "dimtxsty": STYLE}
        made = self.space.add_linear_dim(
            base=base,
            p1=p1,
            p2=p2,
            angle=math.degrees(angle),
            text=formatted(dimension.text, dimension.height),
            dimstyle=STYLE,
            override=override,
            dxfattribs=attributes,
        )
        made.render()

    def words(self, words: Words) -> None:
        """One MTEXT a line: words that wrap by themselves would move."""
        for start, text in rows(words):
            attributes = {
                **self.drawn(words.pen),
                "style": STYLE,
                "char_height": words.height,
                "insert": (start.real, start.imag),
                "rotation": math.degrees(words.turn),
                "attachment_point": 7,  # bottom left
                "line_spacing_factor": LEADING * 3 / 5,
            }
            made = self.space.add_mtext(formatted(text, words.height), dxfattribs=attributes)
            if words.colour != INK:
                made.rgb = _rgb(words.colour)


def formatted(text: str, height: float) -> str:
    """A line with the codes of MTEXT: italic letters, indices as fractions without a bar.

    >>> formatted("$R_{21}$, N", 3.5)
    '{\\\\FTimes New Roman|i1;R}{\\\\H0.7x;\\\\S^ 21;}, N'
    """
    found = []
    for piece in pieces(text):
        words = _plain(piece)
        if piece.rise:
            level = f"^ {words}" if piece.rise < 0 else f"{words}^ "
            found.append(f"{{\\H{piece.size:g}x;\\S{level};}}")
        elif piece.italic:
            found.append(f"{{\\FTimes New Roman|i1;{words}}}")
        else:
            found.append(words)
    return "".join(found)


def _plain(piece: Piece) -> str:
    """Letters that mean something to MTEXT are escaped."""
    return "".join(f"\\{letter}" if letter in "\\{};^/#" else letter for letter in piece.text)


def _pairs(points: Plane) -> list[tuple[float, float]]:
    return list(zip(points.real.tolist(), points.imag.tolist(), strict=True))


def _rgb(colour: str) -> tuple[int, int, int]:
    return int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16)
