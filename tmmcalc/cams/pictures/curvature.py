"""Diagrams beside the drawing of a cam: curvature over the turn, distance from the axis."""

from __future__ import annotations

from itertools import pairwise
from math import degrees

import numpy as np

from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pictures.toscale import ends_to_scale, turn_to_scale
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.results import Profile
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import input_axis
from tmmcalc.report.drawing.diagram import Axis, Diagram, room
from tmmcalc.report.drawing.pens import INK, MARK, PATH, Pen
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number

VALUE = 2.0  # height of marked curvatures [mm]
DENSE = 160  # points of a piece of the motion
PITCH = Pen("PITCH_CURVE", 0.4, (5.0, 1.2, 0.9, 1.2), PATH.colour)
WORKING = Pen("WORKING_PROFILE", 0.4, colour=INK)
CUSP = Pen("CUSP", 0.3, (2.4, 0.9), MARK.colour)
CONVEX = Pen("CONVEX_LIMIT", 0.3, (2.4, 0.9, 0.7, 0.9), MARK.colour)
CONCAVE = Pen("CONCAVE_LIMIT", 0.3, (0.9, 0.9), MARK.colour)
STRAIGHT = 0.005  # of the largest: a curvature that is not told
CUSPED = 0.02  # of the pitch curve's radius: a working profile that is sharper has a cusp, without end on paper
NEAR_CUSP = 2.5  # 1/r2 against the largest curvature of the pitch curve, where it is drawn
NEAR_LIMIT = 1.4  # and the least radius against the largest curvature of the working profile
TURN = input_axis(True, np.array([0.0, 360.0]))


def pieces_of(rim: Rim) -> list[tuple[Values, np.ndarray]]:
    """Angles (m,) of every piece of the motion with its number (m,), up to both its ends."""
    edges = rim.program.edges
    return [(np.linspace(a, b, DENSE), np.full(DENSE, k)) for k, (a, b) in enumerate(pairwise(edges))]


def _bend(rim: Rim, result: Profile, phi: Values, piece: np.ndarray) -> list[Values]:
    """Curvature [1/mm] of pitch curve and working profile, or the radius [mm] under a flat face."""
    here = rim.at(phi, piece)
    if result.flat:
        return [1e3 * here.speed]
    kappa = here.bend
    gap = 1 - kappa * result.follower.roller
    working = np.where(gap > CUSPED, kappa / np.where(gap > CUSPED, gap, 1.0), np.nan)
    return [kappa / 1e3, working / 1e3] if result.follower.roller else [kappa / 1e3]


def draw_bends(
    drawing: Drawing,
    box: Box,
    task: CamTask,
    rim: Rim,
    result: Profile,
    *,
    to_scale: bool = False,
    numbered: bool = False,
) -> Diagram:
    """Curvature of pitch curve and working profile, or the radius under a flat face, with limits and extremes.

    ``numbered``: with numbers along; ``to_scale``: at standard scales, with numbers too.
    """
    drawn = [(phi, _bend(rim, result, phi, piece)) for phi, piece in pieces_of(rim)]
    pens = [WORKING] if result.flat else [PITCH, WORKING]
    worked = None if result.flat or not result.follower.roller else _working_peak(result)
    if result.flat:
        up = Axis(f"$ρ = S + S''$, {tr_unit('mm')}", *room([values[0] for _, values in drawn]))
    else:
        up = Axis(tr("curvature $κ$, 1/mm"), *_ends(task, result))
    if to_scale:
        low, high = ends_to_scale((up.low, up.high), box.height)
        box, up = turn_to_scale(box), up._replace(low=low, high=high)
    diagram = Diagram(drawing, box, TURN, up, numbered=to_scale or numbered)
    diagram.labels.avoid(diagram.paper([0j, complex(TURN.high)]), 0.4)
    for height, _, pen in limits_of(task, result):
        diagram.level(height, pen)
    diagram.key(names_of(task, result))
    for phi, values in drawn:
        for pen, each in zip(pens, values, strict=False):
            diagram.curve(np.degrees(phi) + 1j * each, pen)
    factor, pen = (1e3, WORKING) if result.flat else (1e-3, PITCH)
    places = (place for place in (result.sharpest, result.hollowest) if place is not None)
    least = STRAIGHT * abs(result.sharpest.value)
    marks = [(place, factor * place.value, pen) for place in places if abs(place.value) > least]
    marks += [] if worked is None else [(result.sharpest, worked, WORKING)]
    for place, value, pen in marks:
        diagram.mark(complex(degrees(place.phi), value), number(value, 4), pen, VALUE)
    return diagram


def names_of(task: CamTask, result: Profile) -> list[tuple[str, Pen]]:
    """The names of the lines in the diagram of the curvature."""
    names = [(tr("pitch curve"), PITCH), (tr("working profile"), WORKING)][: 2 if result.follower.roller else 1]
    return [*([] if result.flat else names), *((name, pen) for _, name, pen in limits_of(task, result))]


def limits_of(task: CamTask, result: Profile) -> list[tuple[float, str, Pen]]:
    """Limits that are near: their heights [1/mm, of a flat face mm], what they are, their pens."""
    limits = task.limits
    if result.flat:
        return [(1e3 * limits.convex, tr("least radius $r_m$"), CUSP)] if limits.convex else []
    found = []
    if cusp := _cusp(result):
        found.append((cusp, tr("$1/r_2$: cusp of the working profile"), CUSP))
    peak = _working_peak(result)
    if limits.convex and peak is not None and 1e-3 / limits.convex < NEAR_LIMIT * peak:
        found.append((1e-3 / limits.convex, tr("$1/r_m$: least convex radius"), CONVEX))
    hollow = 0.0 if result.hollowest is None else -result.hollowest.value
    if hollow and not limits.allow_concave:
        found.append((0.0, tr("no concave parts allowed"), CONCAVE))
    elif limits.concave and 1 / limits.concave < NEAR_CUSP * hollow:
        found.append((-1e-3 / limits.concave, tr("$−1/r_i$: least wheel for concave parts"), CONCAVE))
    return found


def _cusp(result: Profile) -> float | None:
    """The curvature [1/mm] of the pitch curve that would be a cusp, where it is near."""
    roller = 0.0 if result.flat else result.follower.roller
    return 1e-3 / roller if roller and 1 / roller < NEAR_CUSP * result.sharpest.value else None


def _ends(task: CamTask, result: Profile) -> tuple[float, float]:
    """Heights [1/mm] that show all of both curves and the limits, where a cusp does not make them endless."""
    limits = [height for height, _, _ in limits_of(task, result)]
    peak = max(result.sharpest.value / 1e3, _working_peak(result) or 0.0, *limits)
    low = min(0.0 if result.hollowest is None else result.hollowest.value / 1e3, *limits, 0.0)
    return 1.6 * low - 0.13 * peak, 1.25 * peak


def _working_peak(result: Profile) -> float | None:
    """The largest curvature of the working profile [1/mm], where that of the pitch curve is; None by a cusp."""
    gap = 1 - result.sharpest.value * result.follower.roller
    return result.sharpest.value / gap / 1e3 if gap > CUSPED else None


def draw_distance(drawing: Drawing, box: Box, rim: Rim, result: Profile) -> None:
    """How far the curves are from the axis of the cam, with the nearest and the farthest place."""
    drawn = []
    for phi, piece in pieces_of(rim):
        here = rim.at(phi, piece)
        pitch = [] if result.flat else [(1e3 * np.abs(here.points), PITCH)]
        drawn.append((phi, [*pitch, (1e3 * np.abs(here.offset(result.working.distance)), WORKING)]))
    up = Axis(tr("distance from $O$, mm"), *room([values for _, both in drawn for values, _ in both]))
    diagram = Diagram(drawing, box, TURN, up)
    for phi, both in drawn:
        for values, pen in both:
            diagram.curve(np.degrees(phi) + 1j * values, pen)
    nearest = 1e3 * result.nearest.value
    diagram.mark(complex(degrees(result.nearest.phi), nearest), number(nearest, 4), WORKING)
    far = farthest(rim, result)
    diagram.mark(complex(degrees(far[0]), 1e3 * abs(far[1])), number(1e3 * abs(far[1]), 4), WORKING)


def farthest(rim: Rim, result: Profile) -> tuple[float, complex]:
    """Angle of the cam and canonical place [m] of the working profile farthest from the axis, near a dwell's begin."""
    phi, z = (np.concatenate(each) for each in zip(*_working(rim, result), strict=True))
    far = np.flatnonzero(np.abs(z) > np.max(np.abs(z)) * (1 - 1e-9))
    row = int(far[len(far) // 10])  # its name stands in the middle
    return float(phi[row]), complex(z[row])


def _working(rim: Rim, result: Profile) -> list[tuple[Values, np.ndarray]]:
    """Angles (m,) and places (m,) of the working profile, piece by piece."""
    return [(phi, rim.at(phi, piece).offset(result.working.distance)) for phi, piece in pieces_of(rim)]
