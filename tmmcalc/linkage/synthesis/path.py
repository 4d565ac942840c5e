"""Path generation: a four-bar or slider-crank whose coupler point passes through n points, timed or not.

A four-bar meets nine points exactly, five with prescribed timing; a slider-crank eight, four with timing. The equations
(see `pathequations`) are solved from random starts with a fixed seed, all at once; fewer points leave a family, from
which the starts take members. More points are met in the least squares.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.errors import NoSolutionError
from tmmcalc.linkage.plane import Plane
from tmmcalc.linkage.synthesis.batch import levenberg
from tmmcalc.linkage.synthesis.designs import CLOSED
from tmmcalc.linkage.synthesis.guidance import error_of, spread
from tmmcalc.linkage.synthesis.pathequations import Path, residuals, starts, turns, unpacked
from tmmcalc.linkage.synthesis.planar import Bars
from tmmcalc.linkage.synthesis.posed import RULE, best_first, designed, limits, pinned, ranked
from tmmcalc.linkage.synthesis.posefit import fitted
from tmmcalc.linkage.synthesis.rating import Rating
from tmmcalc.linkage.synthesis.results import Design, Synthesis
from tmmcalc.linkage.synthesis.task import PoseTask, SynthesisTask
from tmmcalc.progress import tell

STARTS = 400  # random starts of the first round; each further one has more
ROUNDS = 8  # at most
SOLVED = 1e-10  # residual of a solution, in units of the points' spread
LARGE = 12.0  # sizes against the points' spread beyond which a solution is left out


def solve(task: SynthesisTask) -> Synthesis:
    """The linkages that trace the points; raises `NoSolutionError` if none is found."""
    asked: PoseTask = task.asked
    middle, unit = complex(asked.points.mean()), spread(asked.points)
    path = Path((asked.points - middle) / unit, asked.timing, asked.mechanism == "slider_crank")
    exact = len(asked.points) <= path.most
    found, counters = _exact(task, path, unit, middle) if exact else ([], {})
    designs = [design for bars, rating in found if (design := designed(task, bars, rating, "path generator"))]
    designs = best_first([design for design in designs if error_of(design, unit) < CLOSED])
    met = bool(designs)
    if not designs:
        found = fitted(task)
        designs = [design for bars, rating in found if (design := designed(task, bars, rating, "path generator"))]
        designs.sort(key=lambda design: (len(design.defects), design.merits["error_max[mm]"]))
    if not designs:
        linkage, count = asked.mechanism.replace("_", "-"), len(asked.points)
        raise NoSolutionError(
            f"no {linkage} was found whose coupler point passes the {count} points",
            where="synthesis.path",
            value=float(count),
            remedy="try another seed, leave region and timing out, or give fewer points",
        )
    shown = tuple(designs[: task.solutions])
    residual = max(error_of(design, unit) for design in shown) if met else 0.0
    rule = RULE if met else "fewest defects; then the least distance from the points"
    notes = tuple(_notes(asked, exact, met, shown))
    return Synthesis("path", rule, shown, residual, notes, {**counters, "designs": len(designs)})


def _exact(
    task: SynthesisTask, path: Path, unit: float, middle: complex
) -> tuple[list[tuple[Bars, Rating]], dict[str, int]]:
    """Solutions of the equations, ranked; rounds of starts go on until all that are listed are without a defect."""
    rng = np.random.default_rng(task.seed)
    best: list[tuple[Bars, Rating]] = []
    solved = tried = 0
    for done in range(ROUNDS):
        count = STARTS * min(done + 1, 4)
        tell(done / ROUNDS, f"round {done + 1}, {solved} solutions")
        x, worst = levenberg(lambda x: residuals(path, x), starts(path, count, rng), large=LARGE)
        x = x[worst < SOLVED]
        solved, tried = solved + len(x), tried + count
        best += _ranked(task, path, x, unit, middle)
        if sum(not rating.defects(0, limits(task)) for _, rating in best) >= task.solutions:
            break
    best.sort(key=lambda each: (len(each[1].defects(0, limits(task))), -float(each[1].transmission[0])))
    return best[:40], {"starts": tried, "solutions": solved}


def _ranked(task: SynthesisTask, path: Path, x: np.ndarray, unit: float, middle: complex) -> list[tuple[Bars, Rating]]:
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
        sound = np.all(np.isfinite(b) & np.isfinite(c), axis=1) & _within(asked, bars)
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


def _within(asked: PoseTask, bars: Bars) -> np.ndarray:
    """Which fixed pivots stand in the region, if there is one."""
    good = np.ones(len(bars.crank), bool)
    if asked.region is None:
        return good
    low, high = asked.region
    for pivot in (bars.pivot[:, 0], *(() if bars.slides else (bars.end[:, 0],))):
        good &= (pivot.real >= low.real) & (pivot.real <= high.real)
        good &= (pivot.imag >= low.imag) & (pivot.imag <= high.imag)
    return good


def _notes(asked: PoseTask, exact: bool, met: bool, designs: tuple[Design, ...]) -> Iterator[str]:
    count = len(asked.points)
    if met:
        yield f"note: the {count} points are met exactly"
    elif exact:
        yield f"warning: no linkage was found that meets the {count} points exactly: they are met in the least squares"
    else:
        yield f"note: {count} points are more than can be met exactly: they are met in the least squares"
    if designs[0].defects:
        yield f"warning: the best design has a defect: {'; '.join(designs[0].defects)}"
