"""How the admissible zone, its limits and the axis of the cam are drawn, and what the rocker's pivot takes from it.

With the rocker and the roller that were taken the cam just passes on a branch of a hyperbola about the pivot and the
highest roller (`tmmcalc.cams.synthesis.pivotborder`); all that lies on the side of the pivot sweeps over it.
"""

from __future__ import annotations

import cmath
from typing import NamedTuple

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.pivot import highest
from tmmcalc.cams.synthesis.pivotborder import hyperbola
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.cams.task import CamTask
from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import CURVES, DIMENSION, INK, MARK, MIDDLE, PATH, Pen
from tmmcalc.report.drawing.shapes import Area

POINTS = 241
FAR = 1e3  # of the longer of rocker and centre distance: where the branch is cut
ZONE, HATCH = "#e3f1ea", Pen("ADMISSIBLE", 0.13, colour="#a9d6bf")
LIMIT = Pen("LIMITS", 0.4, (3.0, 1.0), MARK.colour)
PASSING = Pen("PASSING", 0.4, (4.5, 1.0, 1.0, 1.0), "#7a5195")
OTHER = Pen("OTHER_LINES", 0.18, colour="#9a9a9a")
BASE = Pen("BASE_CIRCLE", 0.3, (3.5, 0.9, 0.7, 0.9), PATH.colour)
BOOK = CURVES[3]._replace(layer="TEXTBOOK", dashes=())
MARKED = Pen("ALLOWED_ANGLES", 0.25, colour=MARK.colour)
HEIGHT = 2.4  # of names [mm]
GAPS = (0.9, 1.7, 3.0, 5.0, 7.0)  # of them from their places


def axis_of_cam(board: Board, at: complex) -> None:
    """A double circle with its name."""
    board.circle(at, 1.3, level=15)
    board.dot(at, 0.35, level=16)
    board.labels.put("$O$", board.paper([at]), height=2.6, prefer=-1 - 1j)


def dimension(board: Board, a: complex, b: complex, text: str) -> None:
    """A dimension line from a to b with heads at both ends and its text where it covers least beside the middle."""
    if abs(b - a) < 1.5 * board.mu:
        return
    board.line([a, b], DIMENSION, level=7)
    length = min(2.2, 0.3 * abs(b - a) / board.mu)
    board.arrowhead(a, a - b, DIMENSION, length)
    board.arrowhead(b, b - a, DIMENSION, length)
    places = board.paper([a + part * (b - a) for part in (0.5, 0.35, 0.65)])
    board.labels.put(text, places, height=HEIGHT, prefer=1j * (b - a), gaps=GAPS)


def textbook_choice(board: Board, at: complex, name: str) -> None:
    """A square where the textbook's formulas put the axis, with their name."""
    here = board.place(at)
    corners = here + 0.95 * np.array([-1 - 1j, 1 - 1j, 1 + 1j, -1 + 1j])
    board.drawing.add(Area(corners, "#ffffff", BOOK), level=14)
    board.labels.avoid([*corners, corners[0]], 3.0)
    board.labels.put(name, [here], height=HEIGHT, gaps=(2.0, 3.0, 5.0, 7.0), colour=BOOK.colour)


def limit_point(board: Board, at: complex) -> None:
    """An open circle where a line of the limit begins."""
    board.circle(at, 0.7, MIDDLE._replace(colour=LIMIT.colour, width=0.25), level=12)


def name_limit(board: Board, at: complex, text: str, prefer: complex, height: float = 2.1) -> None:
    """Its name."""
    gaps = (1.0, 2.0, 3.5, 5.0, 7.0, 9.0, 11.0)
    board.labels.put(text, board.paper([at]), height=height, prefer=prefer, gaps=gaps, colour=INK)


class Angle(NamedTuple):
    """An angle that is marked, and where its value may stand."""

    text: str
    places: Plane  # on paper
    outward: complex


def mark_angle(board: Board, apex: complex, ways: tuple[complex, complex], radius: float, text: str) -> Angle:
    """An arc from the first of two directions to the second with heads at both ends; radius in mm.

    Its value is for `name_angle`, when all is drawn that it keeps clear of.
    """
    first, turn = cmath.phase(ways[0]), cmath.phase(ways[1] / ways[0])
    ends = sorted((first, first + turn))
    board.arc(apex, radius * board.mu, MARKED, start=ends[0], end=ends[1], weight=1.0, level=7)
    head = min(2.2, 0.4 * radius * abs(turn))
    for at, sense in zip(ends, (-1, 1), strict=True):
        tip = apex + radius * board.mu * cmath.exp(1j * at)
        board.arrowhead(tip, 1j * sense * cmath.exp(1j * (at - sense * head / radius / 2)), MARKED, head)
    parts = first + turn * np.array([0.5, 0.25, 0.75])
    places = board.paper(apex + radius * board.mu * np.exp(1j * parts))
    return Angle(text, places, cmath.exp(1j * (first + turn / 2)))


def name_angle(board: Board, angle: Angle) -> None:
    """Write its value."""
    board.labels.put(angle.text, angle.places, height=HEIGHT, prefer=angle.outward, gaps=GAPS, colour=MARKED.colour)


def swept_of(task: CamTask, result: Synthesis) -> tuple[Complex, Complex] | None:
    """The branch (m,) and all the border (n,) of the places that sweep over the pivot, cut far away; None: no such.

    In the rocker's plane, in units of l2.
    """
    room, follower = result.pivot, result.follower
    if room is None or room.beside:
        return None
    u, c = complex(np.exp(1j * highest(task.program)[0])), (follower.roller - room.pivot) / follower.rocker
    found = hyperbola(u, c)
    if found is None:
        return None
    _, high, points, _ = found
    far = FAR * max(1.0, follower.centres / follower.rocker)
    radius = np.geomspace((1 - c) / 2, far, POINTS)
    x = np.minimum(np.arccos(np.clip((1 - c * c) / 2 / radius - c, -1.0, 1.0)), high)
    branch = points(np.concatenate((-x[::-1], x[1:])))
    around = far * np.exp(-1j * np.linspace(high, 2 * np.pi - high, POINTS)) * u
    return branch, np.concatenate((branch, around))
