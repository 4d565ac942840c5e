"""Dimensions of the drawing of a cam: its radii, the place of the follower, the angles of the phases.

The angle of a phase lies between two positions of the axis of the stem, or of the line from O to the pivot of the
rocker, as the cam sees them: any circle about O is cut by them in points whose central angle is that of the phase.
"""

from __future__ import annotations

import cmath
from math import degrees, sqrt

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.pictures.curvature import farthest
from tmmcalc.cams.pictures.followersketch import centre_of, top_of
from tmmcalc.cams.pictures.wording import mm, phase_name
from tmmcalc.cams.profile.offsets import Rim
from tmmcalc.cams.profile.results import Profile
from tmmcalc.cams.task import CamTask
from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import DIMENSION, OTHER
from tmmcalc.report.drawing.shapes import Arc, Dimension, Words, arrowhead
from tmmcalc.report.drawing.wording import corners
from tmmcalc.report.numbers import number

HEIGHT = 2.3  # of dimensions [mm]
PHASE = 2.0  # height of the names of the phases
GAPS = (0.0, 0.6, 1.5)  # of them from their places [mm]
BEYOND = 7.0  # of a dimension line from what it measures [mm]
LEADER = 5.0  # how far the line of a radius goes beyond the cam [mm]
OVER = 1.12  # of the radius of the arcs: how far the lines to the pivot go
ARC = 0.8  # of the least radius of the cam: the arcs of the phases
SMALL, AROUND = 11.0, 1.15  # less than this [mm] they stand around the cam, at so much of its largest radius
CLEAR = 1.3  # of the eccentricity: the least radius of these arcs
PLACES = (  # where a phase is named, the best first: part of that radius, and of half its sector from the middle
    *((0.86, by) for by in (0.0, 0.35, -0.35)),
    *((1.16, by) for by in (0.0, 0.5, -0.5)),
    *((0.86, 0.65), (0.86, -0.65), (0.6, 0.0), (1.4, 0.0), (0.6, 0.5), (0.6, -0.5)),
)
CHORD = 0.5  # of an arc half the part that stands for it where names are told apart [rad]
WAYS = 24  # directions that a radius tries
HEAD = 2.2  # length of an arrowhead [mm]


def draw_phases(board: Board, task: CamTask, result: Profile) -> None:
    """The positions of the follower at the ends of the phases, and the arcs between them."""
    radius = _arc_radius(board, result)
    starts = np.asarray(task.program.starts)
    for phi in starts[:-1].tolist():
        foot, way = _axis_at(result.follower, phi)
        lift = float(task.program.at(np.array([phi]))[0, 0])
        end = OVER * radius if result.follower.kind == "oscillating" else result.follower.start + lift
        board.line((foot, foot + way * end), OTHER, weight=0.15, level=1)
    centre, size = board.place(0j), radius / board.mu
    for begin, end in zip(starts[:-1].tolist(), starts[1:].tolist(), strict=True):
        if end > begin:
            angles = np.angle([_cut(result.follower, phi, radius) for phi in (begin, end)])
            low, high = angles if result.follower.sense > 0 else angles[::-1]
            high = low + (high - low) % (2 * np.pi) if end - begin < 2 * np.pi - 1e-9 else low + 2 * np.pi
            head = min(HEAD, 0.4 * size * (high - low))
            board.drawing.add(Arc(centre, size, DIMENSION, float(low), float(high)), level=3)
            for at, sense in ((low, -1), (high, 1)):
                tangent = 1j * sense * cmath.exp(1j * (at - sense * head / size / 2))
                board.drawing.add(arrowhead(centre + size * cmath.exp(1j * at), tangent, DIMENSION, head), level=3)
            board.labels.avoid(centre + size * np.exp(1j * np.linspace(low, high, 61)), 1.0)


def name_phases(board: Board, task: CamTask, result: Profile) -> None:
    """The phases with their angles at their arcs, where they cover least."""
    program, radius = task.program, _arc_radius(board, result)
    chords = []
    for begin, end in zip(program.starts[:-1].tolist(), program.starts[1:].tolist(), strict=True):
        middle, half = (begin + end) / 2, min((end - begin) / 2, CHORD)
        ends = [_cut(result.follower, phi, radius) for phi in (middle - half, middle + half)]
        chords.append(board.paper(ends).tolist())
    for k, (begin, end, phase) in enumerate(zip(program.starts[:-1], program.starts[1:], program.phases, strict=True)):
        others = [chord for other, chord in enumerate(chords) if other != k]
        middle, half = (begin + end) / 2, (end - begin) / 2
        places = [part * _cut(result.follower, middle + by * half, radius) for part, by in PLACES]
        text = f"{phase_name(phase.kind)} {number(degrees(phase.angle), 5)}°"
        board.labels.put(
            text, board.paper(places), height=PHASE, prefer=places[0], gaps=GAPS, own=chords[k], others=others
        )


def draw_sizes(board: Board, rim: Rim, result: Profile, curves: Plane) -> list[tuple[str, complex, complex]]:
    """Lines of the radii, dimensions of the follower; what is to be written: text, place on paper, its side.

    ``curves`` are all points [m] of walls and pitch curve: the lines end outside of them.
    """
    follower = result.follower
    far = follower.placed(np.array([farthest(rim, result)[1]]))[0]
    found = [_radius(board, far, abs(far), f"$r_{{max}}$ = {mm(abs(far))}", _reach(curves, far))]
    found.append(_base(board, rim, result, far, curves))
    if not result.flat and follower.roller:
        found.append(_roller(board, follower))
    if follower.kind == "oscillating":
        _rocker(board, result, curves)
    elif abs(follower.offset) > board.mu:
        side, top = follower.offset * follower.sense, top_of(follower)
        line = board.place(top) + 4j
        board.line((0j, complex(0, top.imag) + 4j * board.mu), OTHER, weight=0.15, level=1)
        _dimension(board, complex(0, top.imag), top, line, f"$e$ = {mm(side)}")
    return found


def write_sizes(board: Board, texts: list[tuple[str, complex, complex]]) -> None:
    """The values of the radii at the ends of their lines."""
    for text, at, side in texts:
        board.labels.put(text, [at], height=HEIGHT, prefer=side, gaps=(0.6, 1.2, 2.0))


def _axis_at(follower: Follower, phi: float) -> tuple[complex, complex]:
    """Of the axis of the stem as the cam sees it at phi the point next to O [m] and its direction."""
    turn = cmath.exp(1j * phi)
    if follower.kind == "oscillating":
        return 0j, complex(follower.placed(np.array([turn]))[0])
    foot, way = follower.placed(np.array([follower.offset * turn, 1j * turn])).tolist()
    return foot, way


def _cut(follower: Follower, phi: float, radius: float) -> complex:
    """Where that axis cuts a circle about O."""
    foot, way = _axis_at(follower, phi)
    return foot + way * sqrt(max(radius**2 - abs(foot) ** 2, 0.0))


def _arc_radius(board: Board, result: Profile) -> float:
    """Inside of the cam, or of a cam that is small on paper around it [m]."""
    offset = result.follower.offset if result.follower.kind == "translating" else 0.0
    radius = max(ARC * result.nearest.value, CLEAR * abs(offset))
    if radius < SMALL * board.mu:
        radius = AROUND * float(np.max(np.abs(result.working.points)))
    return radius


def _radius(board: Board, way: complex, radius: float, text: str, reach: float = 0.0) -> tuple[str, complex, complex]:
    """A line from O with its head at the radius and its end beyond the cam."""
    way = way / abs(way)
    rim, end = radius * way, (max(radius, reach) + LEADER * board.mu) * way
    board.line((0j, end), DIMENSION, weight=0.7, level=3)
    board.arrowhead(rim, way, DIMENSION, HEAD, level=8)
    return text, board.place(end), way


def _base(board: Board, rim: Rim, result: Profile, far: complex, curves: Plane) -> tuple[str, complex, complex]:
    """The radius of the base circle, where least is drawn: a low dwell comes first."""
    follower, program = result.follower, rim.program
    phi = [(a + b) / 2 for a, b, each in zip(program.starts, program.starts[1:], program.phases, strict=False)
           if each.kind == "low dwell" and b > a]  # fmt: skip
    first = [_at(rim, result, x) for x in phi]
    ways = [z / abs(z) for z in [*first, *(_at(rim, result, x) for x in np.arange(WAYS) * 2 * np.pi / WAYS)]]
    costs = []
    for k, way in enumerate(ways):
        reach = _reach(curves, way)
        ends = board.paper([follower.base * way, (reach + 2.5 * LEADER * board.mu) * way])
        near = abs(np.angle(way / far)) < 0.3
        costs.append(board.labels.crowded(ends.tolist(), 2.5) + 100.0 * near - 20.0 * (k < len(first)))
    best = ways[int(np.argmin(costs))]
    return _radius(board, best, follower.base, f"$R_0$ = {mm(follower.base)}", _reach(curves, best))


def _at(rim: Rim, result: Profile, phi: float) -> complex:
    """The working profile at an angle of the cam [m]."""
    here = rim.at(np.array([phi]))
    return complex(result.follower.placed(here.offset(result.working.distance))[0])


def _reach(curves: Plane, way: complex) -> float:
    """How far what is drawn of the cam goes in a direction [m]."""
    within = np.abs(np.angle(curves / way)) < 0.1
    return float(np.max(np.abs(curves[within]), initial=0.0))


def _roller(board: Board, follower: Follower) -> tuple[str, complex, complex]:
    """A line to the roller of the follower from outside."""
    centre, radius = centre_of(follower), follower.roller
    costs = []
    ways = np.exp(2j * np.pi * np.arange(WAYS) / WAYS)
    for way in ways.tolist():
        ends = [board.place(centre + (radius + by * board.mu) * way) for by in (0.5, 3.0 * LEADER)]
        costs.append(board.labels.crowded(ends, 2.5))
    way = complex(ways[int(np.argmin(costs))])
    rim, end = centre + radius * way, centre + (radius + 1.3 * LEADER * board.mu) * way
    board.line((rim, end), DIMENSION, weight=0.7, level=8)
    board.arrowhead(rim, -way, DIMENSION, HEAD, level=8)
    return f"$r_2$ = {mm(radius)}", board.place(end), way


def _rocker(board: Board, result: Profile, curves: Plane) -> None:
    """The centre distance under all of the cam, the length of the rocker beside it."""
    follower = result.follower
    pivot, centre = complex(follower.centres), centre_of(follower)
    low = min(float(np.min(curves.imag)), centre.imag) - follower.roller * (centre.imag < 0)
    board.line((0j, 1j * low), OTHER, weight=0.15, level=1)
    below = board.place(1j * low) - 1j * BEYOND
    _dimension(board, 1j * low, pivot, below, f"$l_0$ = {mm(follower.centres)}", 0.0)
    side = 1j * (pivot - centre) / abs(pivot - centre)
    side = side if (side * np.conj(centre)).real > 0 else -side
    _dimension(board, centre, pivot, board.place(centre) + side * BEYOND, f"$l_2$ = {mm(follower.rocker)}")


def _dimension(
    board: Board, first: complex, second: complex, line: complex, text: str, angle: float | None = None
) -> None:
    """A dimension whose words and lines names keep clear of; ``line`` is on paper."""
    made = Dimension(board.place(first), board.place(second), line, text, HEIGHT, angle)
    board.drawing.add(made, level=3)
    for part in made.parts():
        if isinstance(part, Words):
            board.labels.keep(corners(part))
        else:
            board.labels.avoid(part.points, 1.0)
