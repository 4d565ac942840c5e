"""How the admissible zone, its limits and the axis of the cam are drawn, and what the rocker's pivot takes from it.

With the rocker and the roller that were taken the cam just passes on a branch of a hyperbola about the pivot and the
highest roller (`tmmcalc.cams.synthesis.pivotborder`); all that lies on the side of the pivot sweeps over it.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.pivot import highest
from tmmcalc.cams.synthesis.pivotborder import hyperbola
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.style import INK, MARK, PATH, THIN

POINTS = 241
FAR = 1e3  # of the longer of rocker and centre distance: where the branch is cut
ZONE: dict[str, Any] = {"facecolor": "#e3f1ea", "edgecolor": "#7fbf9f", "hatch": "////", "linewidth": 0.0, "zorder": 1}
LIMIT: dict[str, Any] = {"color": MARK, "linewidth": 1.2, "linestyle": (0, (6, 2)), "zorder": 6}
PASSING: dict[str, Any] = {"color": "#7a5195", "linewidth": 1.2, "linestyle": (0, (8, 2, 2, 2)), "zorder": 6}
OTHER: dict[str, Any] = {"color": THIN, "linewidth": 0.5, "linestyle": "-", "zorder": 2}
BASE: dict[str, Any] = {"color": PATH, "linewidth": 1.0, "linestyle": (0, (6, 2, 1, 2)), "zorder": 5}
DIMENSION: dict[str, Any] = {"color": INK, "linewidth": 0.6, "zorder": 7}


def axis_of_cam(board: Board, at: complex, name: str = "$O$", **style: Any) -> None:
    """A double circle with its name."""
    board.circle(at, 1.5, zorder=15, **style)
    board.circle(at, 0.35, zorder=16, **{"facecolor": INK, **style})
    board.labels.put(name, [at], size=9.5, prefer=-1 - 1j)


def dimension(board: Board, a: complex, b: complex, text: str) -> None:
    """A dimension line from a to b with heads at both ends and its text beside the middle."""
    if abs(b - a) < 1.5 * board.mu:
        return
    board.line([a, b], **DIMENSION)
    length = min(2.2, 0.3 * abs(b - a) / board.mu)
    board.arrowhead(a, a - b, length)
    board.arrowhead(b, b - a, length)
    board.labels.put(text, [(a + b) / 2], size=8.5, prefer=1j * (b - a))


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
