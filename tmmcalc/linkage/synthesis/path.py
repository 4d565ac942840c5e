"""Path generation: a four-bar or slider-crank whose coupler point passes through n points, timed or not.

A four-bar meets nine points exactly, five with prescribed timing; a slider-crank eight, four with timing. The equations
(see `pathequations`) are solved from random starts with a fixed seed, all at once; fewer points leave a family, from
which the starts take members. More points are met in the least squares.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.core.progress import tell
from tmmcalc.linkage.synthesis.batch import Course, levenberg
from tmmcalc.linkage.synthesis.pathequations import Path, residuals, starts, turns, unpacked
from tmmcalc.linkage.synthesis.posed import Rated, best_first, distinct, limits, pinned, ranked, spread, within
from tmmcalc.linkage.synthesis.posesearch import Found, search
from tmmcalc.linkage.synthesis.results import SearchStep, Synthesis
from tmmcalc.linkage.synthesis.task import PoseTask, SynthesisTask

STARTS = 400  # random starts of the first round; each further one has more
ROUNDS = 5  # at most
SOLVED = 1e-10  # residual of a solution, in units of the points' spread
LARGE = 12.0  # sizes against the points' spread beyond which a solution is left out


def solve(task: SynthesisTask) -> Synthesis:
    """The linkages that trace the points; raises `NoSolutionError` if none is found."""
    asked: PoseTask = task.asked
    middle, unit = complex(asked.points.mean()), spread(asked.points)
    path = Path((asked.points - middle) / unit, asked.timing, asked.mechanism == "slider_crank")
    if len(asked.points) > path.most:
        return search(task, "path", None)
    return search(task, "path", lambda: _exact(task, path, unit, middle))


def _exact(task: SynthesisTask, path: Path, unit: float, middle: complex) -> Found:
    """Solutions of the equations, ranked; rounds of starts go on until all that are listed are without a defect."""
    rng = np.random.default_rng(task.seed)
    best: list[Rated] = []
    solved = tried = 0
    course: list[SearchStep] = []
    for done in range(ROUNDS):
        count = STARTS * (done + 1)
        tell(done / ROUNDS, f"round {done + 1}, {solved} solutions")
        steps: list[Course] = []
        x, worst = levenberg(lambda x: residuals(path, x), starts(path, count, rng), large=LARGE, course=steps)
        course += [SearchStep(done + 1, k, *step) for k, step in enumerate(steps)]
        x = x[worst < SOLVED]
        solved, tried = solved + len(x), tried + count
        best = distinct(best_first(task, best + _ranked(task, path, x, unit, middle)))
        if sum(not rating.defects(0, limits(task)) for _, rating in best) >= task.solutions:
            break
    return Found(best, {"starts": tried, "solutions": solved}, tuple(course))


def _ranked(task: SynthesisTask, path: Path, x: np.ndarray, unit: float, middle: complex) -> list[Rated]:
    """Linkages of solutions and their cognates, every dyad on a circle as the crank."""
    asked: PoseTask = task.asked
    if not len(x):
        return []
    turn = turns(path, x)
    c1, z1, z2, last = (part[:, 0] * unit for part in unpacked(path, x))
    ways: list[Dyads] = [(turn, z1, c1 + middle, z2, None if path.slides else last + middle)]
    if not path.slides and path.timing is None:
        ways += cognates(asked.points, turn, z1, c1 + middle, z2, last + middle)
        ways += [(turns_, two, b, one, a) for turns_, one, a, two, b in ways if b is not None]
    found = []
    for way in ways:
        bars, b, c = pinned(asked.points, *way)
        sound = np.all(np.isfinite(b) & np.isfinite(c), axis=1) & within(asked.region, bars.pivot[:, 0])
        if not bars.slides:
            sound &= within(asked.region, bars.end[:, 0])
        if sound.any():
            found += ranked(task, bars.rows(sound), b[sound], c[sound])
    return found


Dyads = tuple[Plane, Plane, Plane, Plane, Plane | None]


def cognates(points: Plane, turn: Plane, z1: Plane, c1: Plane, z2: Plane, c2: Plane) -> list[Dyads]:
    """The two other four-bars that trace the same curve (Roberts): their couplers turn as crank and rocker did."""
    ratio = -z1 / (z2 - z1)
    found: list[Dyads] = []
    for k, z, c, other in ((ratio, z1, c1, c2), (1 - ratio, z2, c2, c1)):
        arm = points + turn * z[:, None] - c[:, None]
        first = arm[:, 0]
        found.append((arm / first[:, None], -first, c, (k - 1) * first, c + k * (other - c)))
    return found
