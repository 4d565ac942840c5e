"""Motion generation: a four-bar or slider-crank whose coupler passes through n poses.

The pins are body points whose places lie on circles (or, of a slider, on a line): any points of two or three poses,
those of a curve of four, up to four real points of five (see `burmester`). More poses are met in the least squares.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.core.progress import tell
from tmmcalc.linkage.synthesis.burmester import Poses, centres, circle_points, curve_points, line_points
from tmmcalc.linkage.synthesis.posed import pinned, ranked, spread, within
from tmmcalc.linkage.synthesis.posesearch import Found, search
from tmmcalc.linkage.synthesis.results import Synthesis
from tmmcalc.linkage.synthesis.task import PoseTask, SynthesisTask

MOST = {"four_bar": 5, "slider_crank": 4}  # poses that are met exactly
DYADS = 100  # pins that are paired, of each kind
REACH = 3.0  # pins and pivots stand within so many spreads of the poses


def solve(task: SynthesisTask) -> Synthesis:
    """The linkages that guide the body; raises `NoSolutionError` if none does."""
    asked: PoseTask = task.asked
    if len(asked.points) > MOST[asked.mechanism]:
        return search(task, "motion", None)
    return search(task, "motion", lambda: _exact(task))


def _exact(task: SynthesisTask) -> Found:
    """Pairs of the body's pins, ranked."""
    asked: PoseTask = task.asked
    assert asked.angles is not None
    tell(0.0, "pins of the body")
    poses = Poses(asked.points, asked.angles - asked.angles[0])
    rng = np.random.default_rng(task.seed)
    z, c = _pins(poses, rng)
    good = within(asked.region, c) & _near(asked, c, z)
    z, c = z[good][:DYADS], c[good][:DYADS]
    turn = np.exp(1j * poses.angles)[None, :]
    if asked.mechanism == "slider_crank":
        lines = _line_pins(poses, rng)
        i, j = (rows.ravel() for rows in np.meshgrid(np.arange(len(z)), np.arange(len(lines)), indexing="ij"))
        bars, b, ends = pinned(poses.points, turn, z[i], c[i], lines[j], None)
    else:
        i, j = (rows.ravel() for rows in np.meshgrid(np.arange(len(z)), np.arange(len(z)), indexing="ij"))
        i, j = i[i != j], j[i != j]
        bars, b, ends = pinned(poses.points, turn, z[i], c[i], z[j], c[j])
    lengths = bars.lengths()
    sound = lengths.max(axis=0) <= asked.largest_ratio * np.maximum(lengths.min(axis=0), 1e-300)
    if not sound.any() and len(sound):
        sound[:] = lengths.min(axis=0) > 1e-9 * lengths.max(axis=0)
    return Found(ranked(task, bars.rows(sound), b[sound], ends[sound]), {"pairs": len(sound)})


def _pins(poses: Poses, rng: np.random.Generator) -> tuple[Plane, Plane]:
    """Body points on circles, and the centres."""
    n, unit = len(poses.points), spread(poses.points)
    if n == 5:
        return circle_points(poses)
    if n == 4:
        z = curve_points(poses, REACH * unit, 48)
        z = z[rng.permutation(len(z))]
        return z, centres(poses, z)
    z = np.asarray(REACH / 2 * unit * (rng.normal(size=6 * DYADS) + 1j * rng.normal(size=6 * DYADS)))
    if n == 3:
        return z, centres(poses, z)
    places = poses.places(z)
    along = places[:, 1] - places[:, 0]
    return z, (places[:, 0] + places[:, 1]) / 2 + 1j * along * rng.normal(size=len(z))


def _line_pins(poses: Poses, rng: np.random.Generator) -> Plane:
    """Body points on lines."""
    if len(poses.points) > 2:
        return line_points(poses, DYADS)
    unit = spread(poses.points)
    return np.asarray(REACH / 2 * unit * (rng.normal(size=DYADS) + 1j * rng.normal(size=DYADS)))


def _near(asked: PoseTask, centre: Plane, z: Plane) -> np.ndarray:
    """Which pins and pivots are not too far away, where there is a choice."""
    if asked.region is not None or len(asked.points) >= MOST["four_bar"]:
        return np.ones(len(z), bool)
    far = 2 * REACH * spread(asked.points)
    return np.asarray((np.abs(centre - asked.points.mean()) < far) & (np.abs(z) < far))
