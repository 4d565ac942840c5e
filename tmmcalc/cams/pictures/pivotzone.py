"""Where the cam would sweep over the pivot of its rocker: what it takes from the admissible places of its axis.

With the rocker and the roller that were taken the cam just passes on a branch of a hyperbola about the pivot and the
highest roller (`tmmcalc.cams.synthesis.border`); all that lies on the side of the pivot sweeps over it.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.pivot import highest
from tmmcalc.cams.synthesis.border import hyperbola
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.cams.task import CamTask

POINTS = 241
FAR = 1e3  # of the longer of rocker and centre distance: where the branch is cut


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
