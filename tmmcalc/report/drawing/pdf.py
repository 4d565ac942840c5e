"""A drawing as PDF of exactly its size, text as text of an embedded font; PNG is made of this page."""

from __future__ import annotations

import math
from collections.abc import Sequence
from io import BytesIO
from typing import Any

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.lettering import FONTS, em, line
from tmmcalc.report.drawing.pens import Pen
from tmmcalc.report.drawing.shapes import Arc, Area, Dimension, Drawing, Hatching, Shape, Stroke, Words, hatch_lines
from tmmcalc.report.drawing.wording import rows

POINT = 72 / 25.4  # to a mm
RIM = 0.45  # width of the white rim around words [mm]
RESOLUTION = 200  # of png [dots/in]
FACES = {False: "TMMText-Regular", True: "TMMText-Italic"}


def pdf(drawing: Drawing) -> bytes:
    """The bytes of the file."""
    buffer = BytesIO()
    canvas = begun(buffer, drawing, drawing.width, drawing.height)
    draw_on(canvas, drawing.shapes)
    canvas.showPage()
    canvas.save()
    return buffer.getvalue()


def begun(file: BytesIO, drawing: Drawing, width: float, height: float) -> Any:
    """A canvas for a drawing, with pages of this size [mm], whose unit is a point."""
    from reportlab.pdfbase import pdfmetrics
    from reportlab.pdfbase.ttfonts import TTFont
    from reportlab.pdfgen.canvas import Canvas

    known = pdfmetrics.getRegisteredFontNames()
    for face in FACES.values():
        if face not in known:
            pdfmetrics.registerFont(TTFont(face, str(FONTS / f"{face}.ttf")))
    first: dict[str, Any] = {"initialFontName": FACES[False]}  # else a font is named that no letter is of
    size = (width * POINT, height * POINT)
    canvas = Canvas(file, pagesize=size, invariant=1, lang=drawing.language, **first)
    canvas.setTitle(drawing.title)
    canvas.setCreator("tmmcalc")
    return canvas


def draw_on(canvas: Any, shapes: Sequence[Shape]) -> None:
    """Shapes, a millimetre as a millimetre."""
    canvas.scale(POINT, POINT)
    canvas.setLineJoin(1)
    writer = _Writer(canvas)
    for shape in shapes:
        writer.shape(shape)


def png(drawing: Drawing, resolution: float = RESOLUTION) -> bytes:
    """The drawing in dots, ``resolution`` of them to an inch."""
    from pypdfium2 import PdfDocument

    document = PdfDocument(pdf(drawing))
    buffer = BytesIO()
    document[0].render(scale=resolution / 72).to_pil().save(buffer, format="png", dpi=(resolution, resolution))
    document.close()
    return buffer.getvalue()


class _Writer:
    """Shapes on a canvas whose unit is a millimetre."""

    def __init__(self, canvas: Any) -> None:
        self.canvas = canvas
        self.pen: Pen | None = None

    def shape(self, shape: Shape) -> None:
        """Draw a shape."""
        match shape:
            case Stroke():
                self.take(shape.pen)
                self.canvas.drawPath(self.path(shape.points, shape.closed), stroke=1, fill=0)
            case Arc():
                self.arc(shape)
            case Area():
                self.canvas.setFillColor(shape.fill)
                outlined = shape.pen is not None and shape.pen.width > 0
                if shape.pen is not None and outlined:
                    self.take(shape.pen)
                self.canvas.drawPath(self.path(shape.points, True), stroke=int(outlined), fill=1)
            case Hatching():
                self.take(shape.pen)
                self.canvas.lines([(a.real, a.imag, b.real, b.imag) for a, b in hatch_lines(shape)])
            case Dimension():
                for part in shape.parts():
                    self.shape(part)
            case Words():
                self.words(shape)

    def take(self, pen: Pen) -> None:
        """Draw the following lines with this pen."""
        if pen == self.pen:
            return
        self.pen = pen
        self.canvas.setLineWidth(pen.width)
        self.canvas.setStrokeColor(pen.colour)
        self.canvas.setDash(*([list(pen.dashes), 0] if pen.dashes else []))
        self.canvas.setLineCap(0 if pen.dashes else 1)

    def path(self, points: Plane, closed: bool) -> Any:
        """A path from point to point."""
        path = self.canvas.beginPath()
        z = points.tolist()
        path.moveTo(z[0].real, z[0].imag)
        for at in z[1:]:
            path.lineTo(at.real, at.imag)
        if closed:
            path.close()
        return path

    def arc(self, arc: Arc) -> None:
        self.take(arc.pen)
        x, y, r = arc.centre.real, arc.centre.imag, arc.radius
        if arc.whole:
            if arc.fill:
                self.canvas.setFillColor(arc.fill)
            self.canvas.circle(x, y, r, stroke=1, fill=int(bool(arc.fill)))
            return
        path = self.canvas.beginPath()
        turn = math.degrees(arc.end - arc.start)
        path.arc(x - r, y - r, x + r, y + r, math.degrees(arc.start), turn)
        self.canvas.drawPath(path, stroke=1, fill=0)

    def words(self, words: Words) -> None:
        """Every line, its rim first."""
        canvas = self.canvas
        for start, text in rows(words):
            canvas.saveState()
            canvas.translate(start.real, start.imag)
            canvas.rotate(math.degrees(words.turn))
            if words.clear:
                canvas.saveState()  # the mode in which letters are drawn outlasts a text
                canvas.setStrokeColor("#ffffff")
                canvas.setLineWidth(2 * RIM)
                canvas.setDash()
                self.pieces(text, words.height, 1)
                canvas.restoreState()
            canvas.setFillColor(words.colour)
            self.pieces(text, words.height, 0)
            canvas.restoreState()

    def pieces(self, text: str, height: float, mode: int) -> None:
        """The pieces of a line; ``mode`` 0 fills letters, 1 draws their outlines."""
        for placed in line(text):
            piece = placed.piece
            words = self.canvas.beginText(height * placed.start, height * piece.rise)
            words.setFont(FACES[piece.italic], height * em(piece))
            words.setTextRenderMode(mode)
            words.textOut(piece.text)
            self.canvas.drawText(words)
