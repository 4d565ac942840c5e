"""Outlines of gears as the bytes of files: SVG and DXF drawings in millimetres, CSV in metres.

Equal outlines give equal bytes. Numbers of an SVG are rounded to a hundredth of the chord tolerance.
"""

from __future__ import annotations

import csv
from collections.abc import Sequence
from io import StringIO

import numpy as np

from tmmcalc.gears.meshing.tracks import Track
from tmmcalc.numerics.strokes import Outline
from tmmcalc.report import outlinefiles
from tmmcalc.report.outlinefiles import layer_name, require_dxf

__all__ = ["dxf", "layer_of", "outline_csv", "require_dxf", "svg"]


def svg(tracks: Sequence[Track], tolerance: float, title: str) -> bytes:
    """One path a track, to the scale 1:1, y upward as on paper; ``tolerance`` [m] sets the digits."""
    return outlinefiles.svg([_outline(track) for track in tracks], tolerance, title)


def dxf(tracks: Sequence[Track]) -> bytes:
    """Arcs, lines and cubic splines, every track on a layer of its own; raises as `require_dxf` does."""
    return outlinefiles.dxf([_outline(track) for track in tracks])


def layer_of(track: Track) -> str:
    """The name of a track's layer."""
    return layer_name(f"wheel {track.member.label}")


def _outline(track: Track) -> Outline:
    return Outline(track.member.label, layer_of(track), track.pieces, track.polygon, track.closed)


def outline_csv(tracks: Sequence[Track]) -> bytes:
    """The points of every track in chords, one track after the other; a closed one ends where it began."""
    buffer = StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    named = any(track.member.pair for track in tracks)
    writer.writerow([*(["pair"] if named else []), "wheel", "x[m]", "y[m]"])
    for track in tracks:
        names = [*([track.member.pair] if named else []), track.member.name]
        points = np.append(track.polygon, track.polygon[:1]) if track.closed else track.polygon
        rows = zip(points.real.tolist(), points.imag.tolist(), strict=True)
        writer.writerows([*names, x, y] for x, y in rows)
    return buffer.getvalue().encode()
