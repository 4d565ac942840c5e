"""Outlines as the bytes of files: SVG and DXF drawings in millimetres, 1:1.

Equal outlines give equal bytes. Numbers of an SVG are rounded to a hundredth of the chord tolerance.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from importlib import import_module
from io import StringIO
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.escaping import escape, quoteattr
from tmmcalc.core.numerics.curves import Plane
from tmmcalc.core.printable import printable
from tmmcalc.report.outlines import Bow, Cubics, Line, Outline, Piece

if TYPE_CHECKING:
    from ezdxf.document import Drawing

MM = 1e3  # millimetres in a metre
MARGIN = 0.02  # of the larger side, left free about a drawing
STROKE = 0.001  # width of a line, of the larger side
BARRED = str.maketrans(dict.fromkeys('<>/\\":;?*|=`,', "_"))  # signs that the name of a layer cannot have


def svg(outlines: Sequence[Outline], tolerance: float, title: str) -> bytes:
    """One path an outline, to the scale 1:1, y upward as on paper; ``tolerance`` [m] sets the digits."""
    places = places_of(tolerance)
    corner, size = _frame(outlines)
    box = " ".join(f"{value:.6g}" for value in (corner.real, -corner.imag - size.imag, size.real, size.imag))
    paths = "\n".join(f'<path id={quoteattr(outline.name)} d="{_path(outline, places)}"/>' for outline in outlines)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{size.real:.6g}mm" height="{size.imag:.6g}mm" '
        f'viewBox="{box}">\n<title>{escape(printable(title))}</title>\n'
        f'<g fill="none" stroke="black" stroke-width="{STROKE * max(size.real, size.imag):.3g}">\n'
        f"{paths}\n</g>\n</svg>\n"
    ).encode()


def places_of(tolerance: float) -> int:
    """Decimals of millimetres that keep a hundredth of the chord tolerance [m].

    >>> places_of(1e-5)
    4
    """
    return max(0, math.ceil(-math.log10(tolerance * MM))) + 2


def circle(name: str, radius: float) -> Outline:
    """A circle about the origin [m]; its polygon reaches as far as it does."""
    halves = tuple(Bow(0j, radius, start, math.pi) for start in (0.0, math.pi))
    polygon: Plane = radius * np.exp(0.5j * math.pi * np.arange(4))
    return Outline(name, name, halves, polygon, True)


def _frame(outlines: Sequence[Outline]) -> tuple[complex, complex]:
    """Lower left corner and size of a drawing [mm]."""
    points = MM * np.concatenate([outline.polygon for outline in outlines])
    low = complex(points.real.min(), points.imag.min())
    size = complex(points.real.max(), points.imag.max()) - low
    free = MARGIN * max(size.real, size.imag)
    return low - complex(free, free), size + 2 * complex(free, free)


def _path(outline: Outline, places: int) -> str:
    """The data of an SVG path."""

    def text(points: Plane | Sequence[complex]) -> str:
        rows = MM * np.conj(np.asarray(points)).ravel()
        # + 0 clears a negative zero
        numbers = np.round(np.stack([rows.real, rows.imag], axis=-1).ravel(), places) + 0.0
        return " ".join(f"{number:.{places}f}" for number in numbers.tolist())

    first = outline.pieces[0]
    parts = [f"M{text(first.control[:1, 0] if isinstance(first, Cubics) else first.ends[:1])}"]
    for piece in outline.pieces:
        if isinstance(piece, Cubics):
            parts.append(f"C{text(piece.control[:, 1:])}")
        elif isinstance(piece, Line):
            parts.append(f"L{text(piece.ends[1:])}")
        else:
            radius = f"{MM * piece.radius:.{places}f}"
            parts.append(f"A{radius} {radius} 0 {int(piece.sweep > math.pi)} 0 {text(piece.ends[1:])}")
    return "\n".join([*parts, "Z"] if outline.closed else parts)


def require_dxf() -> None:
    """Raise `UsageError` if the package that writes DXF is missing."""
    try:
        import_module("ezdxf")
    except ImportError:
        from tmmcalc.core.installation import install

        raise UsageError("DXF drawings need the package ezdxf", where="--dxf", remedy=install("cad")) from None


def dxf(outlines: Sequence[Outline]) -> bytes:
    """Arcs, lines and cubic splines, every outline on a layer of its own; raises as `require_dxf` does."""
    require_dxf()
    from ezdxf import units
    from ezdxf._options import options
    from ezdxf.filemanagement import new

    # dates and random identities of the file, which would make its bytes differ
    kept, options.write_fixed_meta_data_for_testing = options.write_fixed_meta_data_for_testing, True
    try:
        drawing = new("R2010", units=units.MM)
        for outline in outlines:
            _add(drawing, outline)
        stream = StringIO()
        drawing.write(stream)
    finally:
        options.write_fixed_meta_data_for_testing = kept
    return stream.getvalue().encode(drawing.output_encoding)


def layer_name(text: str) -> str:
    """A name that a layer may have.

    >>> layer_name("2-3/2'")
    "2-3_2'"
    """
    return text.translate(BARRED)


def _add(drawing: Drawing, outline: Outline) -> None:
    layer = layer_name(outline.layer)
    if layer not in drawing.layers:
        drawing.layers.add(layer)
    space, attributes = drawing.modelspace(), {"layer": layer}
    for piece in _joined(outline.pieces):
        if isinstance(piece, Cubics):
            control = MM * piece.control
            _add_spline(space, np.append(control[0, 0], control[:, 1:].ravel()), attributes)
        elif isinstance(piece, Bow):
            centre, start = MM * piece.centre, math.degrees(piece.start)
            end = start + math.degrees(piece.sweep)
            space.add_arc((centre.real, centre.imag), MM * piece.radius, start, end, dxfattribs=attributes)
        else:
            first, last = ((MM * point.real, MM * point.imag) for point in piece.ends)
            space.add_line(first, last, dxfattribs=attributes)


def _joined(pieces: Sequence[Piece]) -> Iterator[Piece]:
    """The pieces, cubics that follow each other as one run: fillet and involute are one spline."""
    run: list[Plane] = []
    for piece in pieces:
        if isinstance(piece, Cubics):
            run.append(piece.control)
            continue
        if run:
            yield Cubics(np.concatenate(run))
            run = []
        yield piece
    if run:
        yield Cubics(np.concatenate(run))


def _add_spline(space: Any, points: Plane, attributes: dict[str, str]) -> None:
    """Cubics that share their ends as one spline: knots are triple inside, quadruple at both ends."""
    segments = (len(points) - 1) // 3
    spline = space.add_spline(degree=3, dxfattribs=attributes)
    spline.control_points = np.stack([points.real, points.imag, np.zeros(len(points))], axis=-1).tolist()
    spline.knots = [0.0, *(float(k) for k in range(segments + 1) for _ in range(3)), float(segments)]
