"""Methods for the least base circle: lines of the limits exactly, lines of sampled positions, the raster of a drawing.

On the sheet the rays of the limits are drawn at the points of n positions of each phase, and the cam's axis is set
where it is clear of them all. The raster does so on a grid of e and S0; by lines the corner is exact for the positions
drawn. Under a flat face S0 follows from the least F = dS + S'' of n positions. The reference closes the conditions at
the angles that hold the sizes in extended precision.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from math import hypot, tan

import numpy as np

from tmmcalc.accuracy.cam_rocker import rocker
from tmmcalc.accuracy.measure import Clock, Way, series
from tmmcalc.accuracy.study import FLOOR, Reference, Study
from tmmcalc.accuracy.subjects import Scene
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pressure import limited_phases
from tmmcalc.cams.program import TURN
from tmmcalc.cams.synthesis.flat import find
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.cams.synthesis.translating import Line, Lines, least_start, lines_of, nearest
from tmmcalc.cams.task import CamTask
from tmmcalc.cams.wide import WIDER, wide

POSITIONS = (6, 12, 24, 48, 96, 192, 384, 768)  # of a phase
GRIDS = (10, 20, 40, 80, 160, 320, 640)  # squares along the window of the raster
DRAWN = 96  # positions of a phase on the raster
WINDOW = 2.0  # of the raster, in least base circles
SECOND = "of order 2 on the whole: how near to the extreme a position happens to stand"

Find = Callable[[], float]  # of the base circle [m]


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


def _study(found: Synthesis, quantity: str, exact: np.longdouble, ways: list[tuple[str, list[Way], str]],
           clock: Clock) -> Study:  # fmt: skip
    def error(base: float) -> float:
        return max(float(abs(base - exact) / exact), FLOOR)

    name = "the conditions at the angles that hold the sizes, closed in extended precision (64-bit mantissa)"
    every = tuple(series(method, own, error, clock, note=note) for method, own, note in ways)
    return Study("cam_synthesis", quantity, Reference(name, found.error["sizes"]), every)


def _stem(task: CamTask, found: Synthesis, clock: Clock) -> Study:
    lines = lines_of(task)
    best = nearest(lines)

    def drawn(count: int) -> float:
        return hypot(*nearest(_sampled(task, count)))

    lines_drawn = _sampled(task, DRAWN)

    def raster(squares: int) -> float:
        step = WINDOW * hypot(*best) / squares
        across = step * np.arange(-squares, squares + 1)
        level = step * np.ceil(np.array([max(least_start(lines_drawn, e), 0.0) for e in across.tolist()]) / step)
        return float(np.min(np.hypot(across, level)))

    return _study(
        found,
        "least base circle",
        _exact(task, lines, best),
        [
            ("exact lines of the limits", [Way("", 1.0, lambda: hypot(*nearest(lines_of(task))))], ""),
            ("lines of n positions", [Way(f"{n} positions", 1 / n, partial(drawn, n)) for n in POSITIONS], SECOND),
            (
                f"raster, {DRAWN} positions",
                [Way(f"{n} squares", 1 / n, partial(raster, n)) for n in GRIDS],
                "of order 1 down to what the positions miss",
            ),
        ],
        clock,
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
    phi = wide(np.array([convexity.least.phi]))
    sides = task.program.piece(phi - 1e-9), task.program.piece(phi + 1e-9)
    motions = [task.program.wider.at(phi, piece) for piece in sides]
    least = min(np.longdouble((motion[0] + motion[2])[0]) for motion in motions)

    def drawn(count: int) -> float:
        motion = task.program.at(np.linspace(0.0, TURN, count + 1))
        return float(task.limits.convex - np.min(motion[0] + motion[2]))

    return _study(
        found,
        "least start distance",
        wide(task.limits.convex) - least,
        [
            ("exact least F", [Way("", 1.0, lambda: find(task)[0])], ""),
            ("F of n positions", [Way(f"{4 * n} positions", 1 / n, partial(drawn, 4 * n)) for n in POSITIONS], SECOND),
        ],
        clock,
    )
