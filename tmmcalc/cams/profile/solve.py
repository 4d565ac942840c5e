"""The profile stage: curves at the rows of the tables, exact limits, and what is wrong with them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.pivot import pivot_room
from tmmcalc.cams.profile.crossings import crossings
from tmmcalc.cams.profile.curvature import LEVEL, Bends, bends
from tmmcalc.cams.profile.errors import profile_errors
from tmmcalc.cams.profile.offsets import Frame, Rim, frame, working_curvature
from tmmcalc.cams.profile.reach import reach
from tmmcalc.cams.profile.results import Face, Place, Profile, Reach, Wall, WallName
from tmmcalc.cams.profile.verdicts import refuse, remarks
from tmmcalc.cams.program import levelled
from tmmcalc.cams.task import CamTask
from tmmcalc.core.errors import UsageError

TOUCH = 1e-12  # of a reach: an offset that has a point, but no loop yet


def solve_profile(task: CamTask, follower: Follower) -> Profile:
    """Pitch curve, walls and tool paths at the rows of the task, with all limits exact to rounding.

    Raises `NoSolutionError` if a wall that the cam needs is undercut or crosses itself, or if the cam sweeps over the
    pivot of its rocker, unless the task asks for a report, and `UsageError` for a tool that does not fit the groove.
    """
    rim = Rim(follower, task.program)
    rows = task.positions
    here = frame(follower, rows.phi, task.motion)
    bend = bends(rim)
    flat, groove = rim.flat, task.asked.closure == "groove"
    sharpest, hollowest = _extremes(bend)
    inner = None if flat else reach(rim, sharpest, 1)
    outer = None if flat else reach(rim, hollowest, -1)
    builder = _Builder(bend, here, inner, outer)
    r2, tool = follower.roller, task.asked.tool
    _check_tool(tool, r2, groove)
    found = Profile(
        positions=rows,
        follower=follower,
        pitch=None if flat else follower.placed(here.points),
        working=builder.wall("inner", r2),
        outer=builder.wall("outer", -r2) if groove else None,
        tool=None if tool is None else builder.wall("tool", r2 - tool),
        outer_tool=builder.wall("outer tool", tool - r2) if tool is not None and groove else None,
        normal=follower.placed(-1j * here.tangent),
        pitch_curvature=None if flat else here.bend,
        curvature=working_curvature(here, r2, flat),
        tool_radius=tool,
        sharpest=sharpest,
        hollowest=hollowest,
        inner_reach=inner,
        outer_reach=outer,
        largest_tool=r2 if groove else None if outer is None else r2 + outer.distance,
        nearest=_nearest(bend, r2),
        face=_face(task, follower) if flat else None,
        pivot=pivot_room(task, follower),
        remarks=(),
        error={},
    )
    if not task.asked.report_faults:
        refuse(found, task)
    return replace(found, remarks=tuple(remarks(found, task)), error=profile_errors(task, found))


def _check_tool(tool: float | None, roller: float, groove: bool) -> None:
    if tool is not None and groove and tool > roller * (1 + TOUCH):
        raise UsageError(
            f"a tool of radius {1e3 * tool:.6g} mm does not fit the groove of a roller of {1e3 * roller:.6g} mm",
            where="cam profile",
            value=tool,
            limit=roller,
            remedy="a tool_radius of at most roller_radius",
        )


class _Builder:
    """Makes walls; those within the reach of the pitch curve are sound without a search."""

    def __init__(self, bend: Bends, here: Frame, inner: Reach | None, outer: Reach | None) -> None:
        self.bend, self.here, self.inner, self.outer = bend, here, inner, outer

    def wall(self, name: WallName, distance: float) -> Wall:
        """The offset inwards by ``distance``."""
        follower = self.bend.rim.follower
        points = follower.placed(self.here.offset(distance))
        if self._within(distance):
            return Wall(name, distance, points, (), (), True)
        loops = self.bend.backwards(distance)
        found = crossings(self.bend, distance, loops)
        placed = [replace(each, point=complex(follower.placed(np.array([each.point]))[0])) for each in found]
        return Wall(name, distance, points, loops, tuple(placed), self.bend.rim.flat and not loops)

    def _within(self, distance: float) -> bool:
        if self.bend.rim.flat:
            return False
        limit = self.inner if distance > 0 else self.outer
        return limit is None or abs(distance) <= limit.distance * (1 + TOUCH)


def _extremes(bend: Bends) -> tuple[Place, Place | None]:
    """The sharpest convex place and the hollowest concave one; under a flat face the least rho alone."""
    if bend.rim.flat:
        return bend.extreme(-1), None
    sharpest, hollowest = bend.extreme(1), bend.extreme(-1)
    concave = hollowest.value < -LEVEL * sharpest.value
    return sharpest, hollowest if concave else None


def _nearest(bend: Bends, roller: float) -> Place:
    """The place of the working profile that is nearest to the axis of the cam."""
    rim, on = bend.rim, bend.panels
    phi = on.x.ravel()
    away = np.abs(rim.at(phi, rim.pieces(phi)).offset(roller)).reshape(on.x.shape)
    at, found = on.turning(levelled(away))
    least = float(np.min(found))
    level = np.flatnonzero(found <= least * (1 + LEVEL))
    return Place(least, float(np.min(at[level])), 0)


def _face(task: CamTask, follower: Follower) -> Face:
    """The contact stands at -S' from the axis: to the left on the rise if the cam turns clockwise."""
    program = task.program
    (low, _), (high, _) = program.panels.extremes(program.sampled[1])
    reaches = max(high, 0.0), max(-low, 0.0)
    left, right = reaches if follower.sense > 0 else reaches[::-1]
    return Face(left, right, task.asked.margin)
