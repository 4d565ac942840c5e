"""Profiles of cams as the bytes of files: SVG and DXF drawings in millimetres, a table for a machine tool.

Equal profiles give equal bytes. The table holds as many points as the chord tolerance asks for, and the directions of
the normal, which a wire or a side mill needs.
"""

from __future__ import annotations

import csv
from collections.abc import Sequence
from io import StringIO

from tmmcalc.cams.files.machinetool import BESIDE, HEAD, place_texts, point_texts
from tmmcalc.cams.profile.columns import polar_angle
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.outline import adaptive, outline
from tmmcalc.cams.profile.results import WALLS, Profile, Wall
from tmmcalc.cams.program import Program
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.report.outlinefiles import MM, circle
from tmmcalc.report.outlines import Outline


def outlines(found: Profile, program: Program, tolerance: float) -> tuple[Outline, ...]:
    """All curves of a cam, each on a layer of its own, with the base circle of the pitch curve and a mark at O."""
    rim = Rim(found.follower, program)
    chain = [] if found.flat or not found.follower.roller else [outline(rim, "pitch curve", 0.0, tolerance)]
    chain += [outline(rim, WALLS[wall.name], wall.distance, tolerance) for wall in found.walls]
    return (*chain, circle("base circle", found.follower.base))


def nc_table(found: Profile, program: Program, tolerance: float) -> bytes:
    """phi, X, Y, radius and polar angle of every wall or tool path, with the normal out of the cam; mm and deg.

    With a tool the rows follow its path and hold the profile beside it. Raises `NoSolutionError` for a wall or path
    that is undercut, and `UsageError` for a tolerance that is too fine.
    """
    buffer = StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    tooled = found.tool is not None
    writer.writerow(["curve", *HEAD, *(BESIDE if tooled else ())])
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
        f"the {WALLS[path.name]} cannot be cut: it runs backwards or crosses itself",
        where="--nc",
        value=found.tool_radius if of_tool else found.follower.roller,
        limit=limit,
        remedy="a tool that fits" if limit is None else f"{'a tool' if of_tool else 'a roller'} of {MM * limit:.6g} mm",
    )


def _rows(found: Profile, program: Program, tolerance: float, path: Wall, wall: Wall | None) -> Sequence[list[str]]:
    follower = found.follower
    rim = Rim(follower, program)
    phi, pieces = adaptive(rim, path.distance, tolerance)
    here = rim.at(phi, pieces)
    points, normal = follower.placed(here.offset(path.distance)), follower.placed(-1j * here.tangent)
    side = 1 if path.name in ("inner", "tool") else -1
    columns = point_texts(phi, points, polar_angle(follower, phi, points), side * normal, tolerance)
    if wall is not None:
        columns += place_texts(follower.placed(here.offset(wall.distance)), tolerance)
    name = WALLS[path.name]
    return [[name, *row] for row in zip(*columns, strict=True)]
