"""The velocity and acceleration polygons of one position, to a round scale, with named vertices."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from tmmcalc.linkage.vectors import Polygon, Vector, VectorPolygons
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.style import INK, VECTORS
from tmmcalc.report.numbers import number

MARGIN = 13.0  # free border [mm]
SHORT = 1e-6  # a vector shorter than this, against the largest, is not drawn
HEAD = 2.4  # length of an arrowhead [mm]


def draw_polygon(axes: Axes, polygon: Polygon, fixed: tuple[str, ...]) -> float:
    """Draw one polygon on an axes whose place is settled; returns its scale, units to a mm of paper."""
    tips = np.array(list(polygon.vertices.values()))
    board = Board(axes, tips, MARGIN)
    size = float(np.max(np.abs(tips)))
    for vector in _by_rank(polygon):
        if abs(polygon.value(vector)) > SHORT * size:
            _draw(board, polygon, vector)
    board.circle(0j, 0.9, zorder=15)
    for place, names in _together(polygon, fixed, size).items():
        board.labels.put(names, [place], size=9, style="italic", prefer=place or -1 - 1j, gaps=(1.4, 2.4, 3.6, 5.0))
    axes.set_axis_off()
    return board.mu


def _by_rank(polygon: Polygon) -> list[Vector]:
    """Rays from the pole first, so that the parts are drawn over them."""
    order = list(VECTORS)
    return sorted(polygon.vectors, key=lambda vector: order.index(vector.kind))


def _draw(board: Board, polygon: Polygon, vector: Vector) -> None:
    tail, value = polygon.vertices[vector.tail], polygon.value(vector)
    head, length = tail + value, abs(value) / board.mu
    style = dict(VECTORS[vector.kind])
    arrow = min(HEAD, 0.45 * length)
    z = 5 + list(VECTORS).index(vector.kind)
    end = head - value / abs(value) * 0.8 * arrow * board.mu
    board.line((tail, end), solid_capstyle="butt", zorder=z, **style)
    board.arrowhead(head, value, arrow, facecolor=style["color"], zorder=z + 0.5)


def _together(polygon: Polygon, fixed: tuple[str, ...], size: float) -> dict[complex, str]:
    """Vertices that lie in one place share a label; points of the frame stand in brackets beside the pole."""
    names: dict[complex, list[str]] = {}
    for name, tip in polygon.vertices.items():
        place = next((other for other in names if abs(other - tip) <= 2e-3 * size), tip)
        names.setdefault(place, []).append(_shown(name))
    pole = polygon.vertices[polygon.pole]
    names[pole].extend(f"({name})" for name in [", ".join(fixed)] if name)
    return {place: ", ".join(group) for place, group in names.items()}


def _shown(name: str) -> str:
    return "π" if name == "pi" else name


def scale_note(letter: str, mu: float) -> str:
    """The scale as it is written beside a polygon."""
    unit = "m/s" if letter == "v" else "m/s²"
    return f"$\\mu_{letter}$ = {number(mu, 4)} ({unit})/mm"


def legend_of(vectors: VectorPolygons) -> list[Line2D]:
    """Handles of the kinds of vectors that appear."""
    names = {
        "absolute": "absolute",
        "relative": "relative, of two points of a link",
        "normal": "normal part",
        "tangential": "tangential part",
        "sliding": "relative, of a slider on its guide",
        "coriolis": "Coriolis",
    }
    used = {v.kind for polygon in (vectors.velocity, vectors.acceleration) for v in polygon.vectors}
    styles: Mapping[str, dict[str, Any]] = VECTORS
    return [Line2D([], [], label=names[kind], **style) for kind, style in styles.items() if kind in used]


def rotation_notes(vectors: VectorPolygons) -> list[str]:
    """One line a turning link: omega and eps with their senses."""
    return [
        f"link {link}:  {_turning('ω', omega, 'rad/s')},  {_turning('ε', vectors.eps[link], 'rad/s²')}"
        for link, omega in vectors.omega.items()
    ]


def _turning(letter: str, value: float, unit: str) -> str:
    sense = "" if math.isclose(value, 0.0, abs_tol=1e-12) else " (ccw)" if value > 0 else " (cw)"
    return f"{letter} = {number(abs(value) if sense else 0.0, 5)} {unit}{sense}"


def draw_notes(axes: Axes, vectors: VectorPolygons) -> None:
    """Legend and rotations, side by side, in an axes of their own."""
    axes.set_axis_off()
    legend = axes.legend(handles=legend_of(vectors), loc="upper left", ncols=3, handlelength=4, borderaxespad=0)
    legend.set_zorder(3)
    notes = rotation_notes(vectors)
    rows = math.ceil(len(notes) / 3)
    for k, note in enumerate(notes):
        column, row = divmod(k, rows)
        axes.text(column / 3, 0.5 - 0.17 * row, note, fontsize=8, color=INK, va="top", transform=axes.transAxes)
