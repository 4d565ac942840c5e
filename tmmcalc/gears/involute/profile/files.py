"""Outlines and tables as files: rows of CSV, SVG paths of arcs and cubics, DXF of arcs and splines.

Lengths are multiplied by the normal module in the unit of the file, millimetres for drawings.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.errors import UsageError
from tmmcalc.gears.involute.profile.mesh import Placing
from tmmcalc.gears.involute.profile.outline import Arc, Element, Pieces, pieces
from tmmcalc.gears.involute.profile.tables import FilletTable, FlankTable, MainProfile
from tmmcalc.linkage.plane import Plane

if TYPE_CHECKING:
    from ezdxf.document import Drawing

CENTRED = Placing(0.0, 0j)


def outline_rows(points: Plane, module: float, unit: str = "m") -> Iterator[Sequence[Any]]:
    """Header and rows x, y of an outline (n,)."""
    return _rows([f"x[{unit}]", f"y[{unit}]"], [module * points.real, module * points.imag])


def main_rows(table: MainProfile, module: float, unit: str = "m") -> Iterator[Sequence[Any]]:
    """Header and rows of the main profile: phi, X, Y, R."""
    header = ["phi[rad]", *(f"{name}[{unit}]" for name in ("X_T", "Y_T", "R_T"))]
    return _rows(header, [table.roll, *(module * column for column in (table.x, table.y, table.radius))])


def fillet_rows(table: FilletTable, module: float, unit: str = "m") -> Iterator[Sequence[Any]]:
    """Header and rows of the fillet: phi, X_S, Y_S, X, Y, R_S, R."""
    header = ["phi[rad]", *(f"{name}[{unit}]" for name in ("X_S", "Y_S", "X", "Y", "R_S", "R"))]
    lengths = (table.centre_x, table.centre_y, table.x, table.y, table.centre_radius, table.radius)
    return _rows(header, [table.roll, *(module * column for column in lengths)])


def flank_rows(table: FlankTable, module: float, unit: str = "m") -> Iterator[Sequence[Any]]:
    """Header and rows of a whole flank: kind, phi, X, Y, curvature."""
    kinds = np.where(table.fillet, "fillet", "involute")
    header = ["kind", "phi[rad]", f"X[{unit}]", f"Y[{unit}]", f"curvature[1/{unit}]"]
    return _rows(header, [kinds, table.roll, module * table.x, module * table.y, table.curvature / module])


def _rows(header: list[str], columns: Sequence[Any]) -> Iterator[Sequence[Any]]:
    yield header
    yield from zip(*(column.tolist() for column in columns), strict=True)


def svg_path(element: Element, tolerance: float, module: float = 1.0, placing: Placing = CENTRED) -> str:
    """The data of one closed SVG path: the whole wheel within ``tolerance`` [module], y upward as on paper."""
    one, pitch = pieces(element, tolerance), 2 * math.pi / element.teeth
    places = max(0, math.ceil(-math.log10(tolerance * module))) + 2

    def text(points: Plane) -> str:
        # rounded to a hundredth of the tolerance; + 0 clears a negative zero
        numbers = np.stack([points.real, -points.imag], axis=-1).ravel() * module
        return " ".join(f"{number:.{places}f}" for number in (np.round(numbers, places) + 0.0).tolist())

    parts = [f"M{text(placing(one.right[:1, 0]))}"]
    for k in range(element.teeth):
        turn = np.exp(1j * pitch * k)
        for cubic, arc in ((one.right, one.crest), (one.left, one.gap)):
            parts.append(f"C{text(placing(turn * cubic[:, 1:].ravel()))}")
            if arc.sweep:
                end = placing(turn * arc.radius * np.exp(1j * np.array([arc.start + arc.sweep])))
                radius = f"{arc.radius * module:.{places}f}"
                parts.append(f"A{radius} {radius} 0 {int(arc.sweep > math.pi)} 0 {text(end)}")
    return "\n".join([*parts, "Z"])


def svg_document(paths: Sequence[str], box: tuple[float, float, float, float], stroke: float = 0.1) -> str:
    """An SVG drawing in millimetres of paths as from `svg_path`; ``box`` is x, y (upward), width and height [mm]."""
    x, y, width, height = box
    lines = "\n".join(f'<path d="{path}"/>' for path in paths)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}mm" height="{height:g}mm" '
        f'viewBox="{x:g} {-y - height:g} {width:g} {height:g}">\n'
        f'<g fill="none" stroke="black" stroke-width="{stroke:g}">\n{lines}\n</g>\n</svg>\n'
    )


def write_dxf(
    path: Path,
    elements: Sequence[tuple[Element, Placing]],
    tolerance: float,
    module: float = 1.0,
    polylines: Sequence[tuple[str, Plane]] = (),
) -> None:
    """A DXF drawing of whole wheels, each on a layer of its own, as arcs and splines within ``tolerance`` [module].

    ``module`` is in mm; ``polylines`` are further curves (n,) [module] with their layers. Raises `UsageError` if
    ezdxf is missing.
    """
    drawing = _new_drawing()
    for k, (element, placing) in enumerate(elements, 1):
        _add_wheel(drawing, f"wheel_{k}", element, pieces(element, tolerance), placing, module)
    for layer, points in polylines:
        rows = np.stack([points.real, points.imag], axis=-1) * module
        drawing.modelspace().add_lwpolyline(rows.tolist(), dxfattribs={"layer": layer})
    drawing.saveas(path)


def _new_drawing() -> Drawing:
    try:
        import ezdxf
    except ImportError:
        raise UsageError(
            "DXF drawings need the package ezdxf", where="tooth profile", remedy='pip install "tmmcalc[cad]"'
        ) from None
    drawing = ezdxf.new("R2010")
    drawing.units = 4  # millimetres
    return drawing


def _add_wheel(drawing: Drawing, layer: str, element: Element, one: Pieces, placing: Placing, module: float) -> None:
    space, attributes = drawing.modelspace(), {"layer": layer}
    centre = placing.centre * module
    knots = _knots(len(one.left))
    for k in range(element.teeth):
        turn = 2 * math.pi * k / element.teeth
        for cubic in (one.right, one.left):
            points = placing(np.exp(1j * turn) * np.concatenate([cubic[0, :1], cubic[:, 1:].ravel()])) * module
            spline = space.add_spline(degree=3, dxfattribs=attributes)
            spline.control_points = np.stack([points.real, points.imag, np.zeros(len(points))], axis=-1).tolist()
            spline.knots = knots
        for arc in (one.crest, one.gap):
            if arc.sweep:
                start, end = _ends(arc, turn + placing.turn)
                space.add_arc((centre.real, centre.imag), arc.radius * module, start, end, dxfattribs=attributes)


def _ends(arc: Arc, turn: float) -> tuple[float, float]:
    """Start and end [deg] of an arc."""
    return math.degrees(arc.start + turn), math.degrees(arc.start + turn + arc.sweep)


def _knots(segments: int) -> list[float]:
    """Knots of a chain of cubics that share their ends: triple inside, quadruple at both ends."""
    inner = [float(k) for k in range(segments + 1) for _ in range(3)]
    return [0.0, *inner, float(segments)]
