"""Pages of PDF and drawings in DXF read back: sizes, straight lines, words, in mm from the lower left corner."""

from __future__ import annotations

import ctypes
from io import StringIO
from itertools import pairwise
from typing import Any, NamedTuple

import pypdfium2 as pdfium
import pypdfium2.raw as raw
from ezdxf.filemanagement import read

MM = 25.4 / 72


class Line(NamedTuple):
    """A straight part of a drawn path."""

    start: complex
    end: complex
    width: float


def size(data: bytes, page: int = 0) -> tuple[float, float]:
    """Width and height of a page."""
    document = pdfium.PdfDocument(data)
    return document[page].get_width() * MM, document[page].get_height() * MM


def words(data: bytes, page: int = 0) -> str:
    """All that can be searched on a page."""
    found: str = pdfium.PdfDocument(data)[page].get_textpage().get_text_range()
    return found


def lines(data: bytes, page: int = 0) -> list[Line]:
    """All straight lines of a page."""
    document = pdfium.PdfDocument(data)
    found: list[Line] = []
    for item in document[page].get_objects(filter=[raw.FPDF_PAGEOBJ_PATH]):
        matrix = item.get_matrix()
        points: list[complex] = []
        for k in range(raw.FPDFPath_CountSegments(item)):
            segment = raw.FPDFPath_GetPathSegment(item, k)
            x, y = ctypes.c_float(), ctypes.c_float()
            raw.FPDFPathSegment_GetPoint(segment, x, y)
            at = complex(*matrix.on_point(x.value, y.value)) * MM
            if raw.FPDFPathSegment_GetType(segment) == raw.FPDF_SEGMENT_LINETO and points:
                found.append(Line(points[-1], at, _width(item) * matrix.a * MM))
            points.append(at)
            if raw.FPDFPathSegment_GetClose(segment):
                found.append(Line(at, points[0], _width(item) * matrix.a * MM))
    return found


def _width(item: Any) -> float:
    width = ctypes.c_float()
    raw.FPDFPageObj_GetStrokeWidth(item, width)
    return width.value


def modelspace(data: bytes) -> Any:
    """What a DXF draws; it must pass the audit without a fault."""
    document = read(StringIO(data.decode()))
    auditor = document.audit()
    assert not [*auditor.errors, *auditor.fixes]
    return document.modelspace()


def dxf_lines(data: bytes) -> list[Line]:
    """All straight lines of a DXF, with the line weights of their layers."""
    space = modelspace(data)
    layers = space.doc.layers
    found = []
    for item in space.query("LWPOLYLINE"):
        points = [complex(x, y) for x, y in item.get_points("xy")]
        points += points[:1] if item.closed else []
        width = layers.get(item.dxf.layer).dxf.lineweight / 100
        found += [Line(a, b, width) for a, b in pairwise(points)]
    return found


def dxf_words(data: bytes) -> str:
    """All words of a DXF without their codes."""
    return "\n".join(item.plain_text() for item in modelspace(data).query("MTEXT")).replace("\\/", "/")
