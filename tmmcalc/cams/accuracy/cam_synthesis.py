"""Methods for the least base circle: lines of the limits exactly, lines of sampled positions, the raster of a drawing.

On the sheet the rays of the limits are drawn at the points of n positions of each phase, and the cam's axis is set
where it is clear of them all. The raster does so on a grid of e and S0; by lines the corner is exact for the positions
drawn. Under a flat face S0 follows from the least F = dS + S'' of n positions. The reference closes the conditions at
the angles that hold the sizes in extended precision. The method names these angles; that it passes none over is told
by many positions, which never ask for more than all. The least F is looked for by brute force.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from math import hypot, tan

import numpy as np

from tmmcalc.cams.accuracy.cam_rocker import MANY, RASTER, rocker
from tmmcalc.cams.accuracy.sides import beside
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pressure.angle import limited_phases
from tmmcalc.cams.program import TURN
from tmmcalc.cams.synthesis.flatface import flat_sizes
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.cams.synthesis.translatingsizes import Line, Lines, least_start, lines_of, nearest
from tmmcalc.cams.task import CamTask
from tmmcalc.cams.wide import wide
from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.core.studies.measure import Clock, Way, relative, series
from tmmcalc.core.studies.sampled import of_positions, summit
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Study

POSITIONS = (6, 12, 24, 48, 96, 192, 384, 768)  # of a phase
GRIDS = (10, 20, 40, 80, 160, 320, 640)  # squares along the window of the raster
DRAWN = 96  # positions of a phase on the raster
WINDOW = 2.0  # of the raster, in least base circles


def studies(scene: Scene) -> Iterator[Study]:
    """The least base circle of a stem with both sizes free or of a rocker, S0 of a flat face; else there is one way."""
    task: CamTask = scene.inputs
    found: Synthesis = scene.results["cam_synthesis"]
    asked = task.asked
    if not WIDER or asked.start is not None or (asked.base is not None and asked.kind != "oscillating"):
        return
    if asked.kind == "flat" and found.governs == "convexity":
        yield _flat(task, found, scene.clock)
    elif asked.kind == "translating" and asked.offset is None:
        yield _stem(task, found, scene.clock)
    elif asked.kind == "oscillating" and asked.centres is None:
        yield rocker(task, found, scene.clock)


def _stem(task: CamTask, found: Synthesis, clock: Clock) -> Study:
    lines = lines_of(task)
    best = nearest(lines)
    closed, asked = _exact(task, lines, best), hypot(*nearest(_sampled(task, MANY)))
    exact = max(closed, np.longdouble(asked))

    def error(base: float) -> float:
        return relative(base, exact)

    def drawn(count: int) -> float:
        return hypot(*nearest(_sampled(task, count)))

    def raster(squares: int) -> float:
        step, lines_drawn = WINDOW * hypot(*best) / squares, _sampled(task, DRAWN)
        across = step * np.arange(-squares, squares + 1)
        level = step * np.ceil(np.array([max(least_start(lines_drawn, e), 0.0) for e in across.tolist()]) / step)
        return float(np.min(np.hypot(across, level)))

    ways = [Way(f"{n} positions", 1 / n, partial(drawn, n)) for n in POSITIONS]
    squares = [Way(f"{n} squares", 1 / n, partial(raster, n)) for n in GRIDS]
    name = f"the lines that the search finds, closed in extended precision; {MANY} positions a phase ask for no more"
    own = max(found.error["sizes"], float((exact - closed) / exact))
    return Study(
        "cam_synthesis",
        "least base circle",
        Reference(name, own),
        (
            series("exact lines of the limits", [Way("", None, lambda: hypot(*nearest(lines_of(task))))], error, clock),
            of_positions("lines of n positions", ways, error, clock),
            series(f"raster, {DRAWN} positions", squares, error, clock, note=RASTER, stepwise=False),
        ),
    )


def _sampled(task: CamTask, count: int) -> Lines:
    """The lines of the limits at n equal steps of every limited phase."""
    found = []
    for _, limit, part, _ in limited_phases(task):
        phi = np.linspace(part.edges[0], part.edges[-1], count + 1)
        y, y1 = task.program.at(phi)[:2]
        for side in (1, -1):
            heights = side * y1 / tan(limit) - y
            k = int(np.argmax(heights))
            found.append(Line(side / tan(limit), float(heights[k]), side, float(phi[k])))
    return tuple(found)


def _exact(task: CamTask, lines: Lines, best: tuple[float, float]) -> np.longdouble:
    """R0 of the corner, or the foot, of the lines that hold it, in extended precision."""
    e, start = best
    held = [line for line in lines if abs(line.at(e) - start) <= 1e-9 * start]
    phi = wide(np.array([line.phi for line in held]))
    y, y1 = task.program.wider.at(phi, task.program.piece(phi))[:2]
    limits = [task.limits.rise if line.phi <= task.program.starts[1] else task.limits.back or 0.0 for line in held]
    slope = np.array([line.side for line in held]) / np.tan(wide(np.array(limits)))
    height: Values = slope * y1 - y
    if len(held) == 1 or slope[0] == slope[1]:
        return np.longdouble(height[0] / np.sqrt(1 + slope[0] ** 2))
    at = (height[1] - height[0]) / (slope[0] - slope[1])
    return np.longdouble(np.hypot(at, slope[0] * at + height[0]))


def _flat(task: CamTask, found: Synthesis, clock: Clock) -> Study:
    convexity = found.convexity
    assert convexity is not None

    def short(phi: Values) -> Values:
        """S0 (1, m) that convexity asks for, of both sides of an end of a piece of the law the larger."""
        sides = [task.program.wider.at(at, piece) for at, piece in beside(task.program, wide(phi))]
        return np.max([task.limits.convex - (motion[0] + motion[2]) for motion in sides], axis=0)[None]

    exact = summit(short, TURN, [convexity.least.phi])

    def error(start: float) -> float:
        return relative(start, exact.values)

    def drawn(count: int) -> float:
        motion = task.program.at(np.linspace(0.0, TURN, count + 1))
        return float(task.limits.convex - np.min(motion[0] + motion[2]))

    ways = [Way(f"{4 * n} positions", 1 / n, partial(drawn, 4 * n)) for n in POSITIONS]
    return Study(
        "cam_synthesis",
        "least start distance",
        Reference(
            "ever finer positions about the least F, in extended precision (64-bit mantissa)",
            max(found.error["sizes"], exact.short),
        ),
        (
            series("exact least F", [Way("", None, lambda: flat_sizes(task)[0])], error, clock),
            of_positions("F of n positions", ways, error, clock),
        ),
    )
