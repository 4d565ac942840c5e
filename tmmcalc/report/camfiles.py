"""Profiles of cams as the bytes of files: SVG and DXF drawings in millimetres, a table for a machine tool.

Equal profiles give equal bytes. The table holds as many points as the chord tolerance asks for, and the directions of
the normal, which a wire or a side mill needs.
"""

from __future__ import annotations

import csv
import math
from collections.abc import Sequence
from io import StringIO

import numpy as np

from tmmcalc.cams.profile.columns import polar_angle
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.outline import adaptive, outline
from tmmcalc.cams.profile.results import Profile, Wall
from tmmcalc.cams.program import Program
from tmmcalc.errors import NoSolutionError
from tmmcalc.numerics.curves import Plane
from tmmcalc.numerics.strokes import Bow, Outline
from tmmcalc.report.outlinefiles import MM, dxf, require_dxf, svg

__all__ = ["dxf", "nc_table", "outlines", "require_dxf", "svg"]

NAMES = {"inner": "working profile", "outer": "second wall", "tool": "tool path", "outer tool": "second tool path"}
DEGREES = 6  # decimals of phi


def outlines(found: Profile, program: Program, tolerance: float) -> tuple[Outline, ...]:
    """All curves of a cam, each on a layer of its own, with the base circle of the pitch curve and a mark at O."""
    rim = Rim(found.follower, program)
    chain = [] if found.flat or not found.follower.roller else [outline(rim, "pitch curve", 0.0, tolerance)]
    chain += [outline(rim, NAMES[wall.name], wall.distance, tolerance) for wall in found.walls]
    return (*chain, _circle("base circle", found.follower.base))


def _circle(name: str, radius: float) -> Outline:
    halves = tuple(Bow(0j, radius, start, math.pi) for start in (0.0, math.pi))
    polygon: Plane = radius * np.exp(0.5j * math.pi * np.arange(4))
    return Outline(name, name, halves, polygon, True)


def nc_table(found: Profile, program: Program, tolerance: float) -> bytes:
    """phi, X, Y, radius and polar angle of every wall or tool path, with the normal out of the cam; mm and deg.

    With a tool the rows follow its path and hold the profile beside it. Raises `NoSolutionError` for a wall or path
    that is undercut, and `UsageError` for a tolerance that is too fine.
    """
    buffer = StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    tooled = found.tool is not None
    head = ["curve", "phi[deg]", "X[mm]", "Y[mm]", "R[mm]", "alpha[deg]", "N_x", "N_y"]
    writer.writerow([*head, *(["X_w[mm]", "Y_w[mm]"] if tooled else [])])
    for path, wall in _paths(found):
        _check(found, path)
        writer.writerows(_rows(found, program, tolerance, path, wall if tooled else None))
    return buffer.getvalue().encode()


def _paths(found: Profile) -> list[tuple[Wall, Wall]]:
    """What a machine follows, with the wall that comes of it."""
    pairs = [(found.tool or found.working, found.working)]
    if found.outer is not None:
        pairs.append((found.outer_tool or found.outer, found.outer))
    return pairs


def _check(found: Profile, path: Wall) -> None:
    if path.sound:
        return
    of_tool = path.name.endswith("tool")
    limit = found.largest_tool if of_tool else None if found.inner_reach is None else found.inner_reach.distance
    raise NoSolutionError(
        f"the {NAMES[path.name]} cannot be cut: it runs backwards or crosses itself",
        where="--nc",
        value=found.tool_radius if of_tool else found.follower.roller,
        limit=limit,
        remedy="a tool that fits" if limit is None else f"{'a tool' if of_tool else 'a roller'} of {MM * limit:.6g} mm",
    )


def _rows(found: Profile, program: Program, tolerance: float, path: Wall, wall: Wall | None) -> Sequence[list[str]]:
    follower = found.follower
    rim, places = Rim(follower, program), max(0, math.ceil(-math.log10(tolerance * MM))) + 2
    phi, pieces = adaptive(rim, path.distance, tolerance)
    here = rim.at(phi, pieces)
    points, normal = follower.placed(here.offset(path.distance)), follower.placed(-1j * here.tangent)
    side = 1 if path.name in ("inner", "tool") else -1
    polar = np.degrees(polar_angle(follower, phi, points))
    columns = [
        _texts(np.degrees(phi), DEGREES),
        *(_texts(MM * values, places) for values in (points.real, points.imag, np.abs(points))),
        _texts(polar, DEGREES),
        *(_texts(side * values, DEGREES + 2) for values in (normal.real, normal.imag)),
    ]
    if wall is not None:
        beside = follower.placed(here.offset(wall.distance))
        columns += [_texts(MM * values, places) for values in (beside.real, beside.imag)]
    name = NAMES[path.name]
    return [[name, *row] for row in zip(*columns, strict=True)]


def _texts(values: np.ndarray, places: int) -> list[str]:
    return [f"{value:.{places}f}" for value in (np.round(values, places) + 0.0).tolist()]
