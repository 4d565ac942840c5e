"""What rounding leaves of the curves, their curvature, the limits of the profile, and where a wall fails."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.profile.offsets import Frame, Rim, frame, working_curvature
from tmmcalc.cams.profile.results import Crossing, Profile, Reach, Wall
from tmmcalc.cams.program import TURN
from tmmcalc.cams.rounding import APART, FLOOR, MARGIN, Errors, chosen, nearer, relative, root_error, sides, steep
from tmmcalc.cams.task import CamTask
from tmmcalc.cams.wide import wide


def profile_errors(task: CamTask, found: Profile) -> Errors:
    """Estimates of points, normals and curvature at the rows, of the limits, and of the angles of loops."""
    rows, exact = task.positions, _WideRim(Rim(found.follower, task.program))
    bends = () if found.pitch_curvature is None else (found.pitch_curvature,)
    which = chosen(len(rows.phi), found.curvature, *bends, *steep(rows.phi, task.motion))
    here = exact.at(rows.phi[which], rows.piece[which])
    placed, roller = exact.follower.placed, exact.follower.roller
    size = float(np.max(np.abs(found.working.points)))
    points = [relative(wall.points[which], placed(here.offset(wide(wall.distance))), size) for wall in found.walls]
    if found.pitch is not None:
        points.append(relative(found.pitch[which], placed(here.points), size))
    errors = {
        "points": max(points),
        "normals": relative(found.normal[which], placed(-1j * here.tangent), 1.0),
        "curvature": _at_rows(found.curvature, which, working_curvature(here, roller, found.flat)),
        "limits": max(_limits(exact, found)),
    }
    if found.pitch_curvature is not None:
        errors["pitch_curvature"] = _at_rows(found.pitch_curvature, which, here.bend)
    angles = list(_angles(exact, found.walls))
    return errors | ({"loops": max(MARGIN * max(angles) / TURN, FLOOR)} if angles else {})


def _at_rows(values: Values, which: np.ndarray, exact: Values) -> float:
    return relative(values[which], exact, float(np.max(np.abs(values))))


class _WideRim:
    """The curve of a follower in extended precision."""

    def __init__(self, rim: Rim) -> None:
        self.program, self.follower, self.flat = rim.program, wide(rim.follower), rim.flat

    def at(self, phi: Values, piece: np.ndarray) -> Frame:
        """The frame at phi (n,) of the turn on pieces (n,)."""
        phi = wide(phi)
        return frame(self.follower, phi, self.program.wider.at(phi, piece))

    def both(self, *phi: float) -> Frame:
        """The frame before and after angles (m,), (2 m,)."""
        rows = sides(self.program, np.mod(phi, TURN))
        return self.at(rows.phi, rows.piece)


def _limits(exact: _WideRim, found: Profile) -> Iterator[float]:
    """Each relative to itself."""
    for place in (found.sharpest, found.hollowest):
        if place is not None:
            there = exact.both(place.phi)
            yield nearer([place.value], there.speed if found.flat else there.bend)
    there = exact.both(found.nearest.phi)
    yield nearer([found.nearest.value], np.abs(there.offset(exact.follower.roller)))
    for reach, side in ((found.inner_reach, 1), (found.outer_reach, -1)):
        if reach is not None:
            yield _reach(exact, reach, side)


def _reach(exact: _WideRim, reach: Reach, side: int) -> float:
    there = exact.both(*reach.at)
    if reach.cause == "cusp":
        return nearer([reach.distance], side / there.bend)
    return relative([reach.distance], [np.abs(there.points[1] - there.points[0]) / 2])


def _angles(exact: _WideRim, walls: tuple[Wall, ...]) -> Iterator[float]:
    """By how much the angles of loops and crossings are off, in rad."""
    for wall in walls:
        for crossing in wall.crossings:
            yield _crossing(exact, wall, crossing)
        for phi in (each % TURN for interval in wall.loops for each in interval):
            if np.min(np.abs(exact.program.edges - phi)) > 4 * APART:
                piece = exact.program.piece(np.full(7, phi))

                def factor(x: Values, piece: np.ndarray = piece, distance: float = wall.distance) -> Values:
                    return exact.at(x, piece).factor(wide(distance), exact.flat)

                yield root_error(factor, phi)


def _crossing(exact: _WideRim, wall: Wall, crossing: Crossing) -> float:
    """One step of Newton on both points being one."""
    phi, distance = np.array([crossing.first, crossing.second]), wide(wall.distance)
    ends = exact.at(phi, exact.program.piece(phi))
    (p, q), rates = ends.offset(distance), ends.rate(distance, exact.flat)
    rest, area = p - q, float((np.conj(rates[0]) * rates[1]).imag)
    steps = [abs(float((np.conj(rest) * rate).imag)) for rate in rates]
    return max(steps) / abs(area) if area else 0.0
