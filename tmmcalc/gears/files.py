"""Outlines of gears for drawings, a layer each, and as the bytes of a CSV file in metres."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from io import StringIO

import numpy as np

from tmmcalc.core.quantity import quantities
from tmmcalc.gears.meshing.outlines import Track
from tmmcalc.gears.meshing.profiles import WheelProfile
from tmmcalc.report.outlinefiles import layer_name
from tmmcalc.report.outlines import Outline


def layer_of(track: Track) -> str:
    """The name of a track's layer."""
    return layer_name(f"wheel {track.member.label}")


def outlines(tracks: Sequence[Track]) -> list[Outline]:
    """Every track on a layer of its own."""
    return [Outline(each.member.label, layer_of(each), each.pieces, each.polygon, each.closed) for each in tracks]


def outline_csv(tracks: Sequence[Track]) -> bytes:
    """The points of every track in chords, one track after the other; a closed one ends where it began."""
    buffer = StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    named, told = any(track.member.pair for track in tracks), quantities(WheelProfile)
    writer.writerow([*(["pair"] if named else []), *(told[name].key for name in ("wheel", "x", "y"))])
    for track in tracks:
        names = [*([track.member.pair] if named else []), track.member.name]
        points = np.append(track.polygon, track.polygon[:1]) if track.closed else track.polygon
        rows = zip(points.real.tolist(), points.imag.tolist(), strict=True)
        writer.writerows([*names, x, y] for x, y in rows)
    return buffer.getvalue().encode()
