"""Diagrams beside the drawing of a cam: curvature over the turn, distance from the axis."""

from __future__ import annotations

from itertools import pairwise
from math import degrees

import numpy as np

from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.results import Profile
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import input_axis
from tmmcalc.report.drawing.diagram import Axis, Diagram, room
from tmmcalc.report.drawing.pens import INK, MARK, PATH, Pen
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.numbers import number

VALUE = 2.0  # height of marked curvatures [mm]
DENSE = 160  # points of a piece of the motion
PITCH = Pen("PITCH_CURVE", 0.4, colour=PATH.colour)
WORKING = Pen("WORKING_PROFILE", 0.4, colour=INK)
CUSP = Pen("CUSP", 0.3, (2.4, 0.9), MARK.colour)
CUSPED = 0.02  # of the pitch curve's radius: a working profile that is sharper has a cusp, without end on paper
NEAR_CUSP = 2.5  # 1/r2 against the largest curvature of the pitch curve, where it is drawn
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


def draw_bends(drawing: Drawing, box: Box, rim: Rim, result: Profile) -> None:
    """Curvature of pitch curve and working profile, or the radius under a flat face, with the extremes."""
    drawn = [(phi, _bend(rim, result, phi, piece)) for phi, piece in pieces_of(rim)]
    pens = [WORKING] if result.flat else [PITCH, WORKING]
    worked = None if result.flat or not result.follower.roller else _working_peak(result)
    if result.flat:
        up = Axis("$ρ = S + S''$, mm", *room([values[0] for _, values in drawn]))
    else:
        up = Axis("curvature $κ$, 1/mm", *_ends(result))
    diagram = Diagram(drawing, box, TURN, up, numbered=False)
    diagram.labels.avoid(diagram.paper([0j, complex(TURN.high)]), 0.4)
    if cusp := _cusp(result):
        diagram.level(cusp, CUSP)
    diagram.key(names_of(result))
    for phi, values in drawn:
        for pen, each in zip(pens, values, strict=False):
            diagram.curve(np.degrees(phi) + 1j * each, pen)
    factor, pen = (1e3, WORKING) if result.flat else (1e-3, PITCH)
    marks = [(place, factor * place.value, pen) for place in (result.sharpest, result.hollowest) if place is not None]
    marks += [] if worked is None else [(result.sharpest, worked, WORKING)]
    for place, value, pen in marks:
        diagram.mark(complex(degrees(place.phi), value), number(value, 4), pen, VALUE)


def names_of(result: Profile) -> list[tuple[str, Pen]]:
    """The names of the lines in the diagram of the curvature."""
    if result.flat:
        return []
    names = [("pitch curve", PITCH), ("working profile", WORKING)][: 2 if result.follower.roller else 1]
    return [*names, ("$1/r_2$: cusp of the pitch curve", CUSP)] if _cusp(result) else names


def _cusp(result: Profile) -> float | None:
    """The curvature [1/mm] of the pitch curve that would be a cusp, where it is near."""
    roller = 0.0 if result.flat else result.follower.roller
    return 1e-3 / roller if roller and 1 / roller < NEAR_CUSP * result.sharpest.value else None


def _ends(result: Profile) -> tuple[float, float]:
    """Heights [1/mm] that show all of both curves, where a cusp does not make them endless."""
    peak = max(result.sharpest.value / 1e3, _working_peak(result) or 0.0, _cusp(result) or 0.0)
    low = 0.0 if result.hollowest is None else result.hollowest.value / 1e3
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
    up = Axis("distance from $O$, mm", *room([values for _, both in drawn for values, _ in both]))
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
