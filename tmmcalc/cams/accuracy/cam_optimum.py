"""Methods for the lowest mechanism: whole steps ever finer, a complete grid, and the exact corner of the constraints.

The search in whole steps tries only the heights that a step point can have; the complete grid judges every S0, r2 and
H2 about the lowest. Both give the least H2 rounded up to where a step point fits in, so their error falls with the
step. The reference is the corner on nodes of the turn four times as dense.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

import numpy as np

from tmmcalc.cams.optimum import flatface
from tmmcalc.cams.optimum.leastheight import least_height
from tmmcalc.cams.optimum.margins import SLACK, margins
from tmmcalc.cams.optimum.results import CamOptimum
from tmmcalc.cams.optimum.rockerleast import least_centres
from tmmcalc.cams.optimum.rockershapes import scanned
from tmmcalc.cams.optimum.rockersizes import rocker_scene
from tmmcalc.cams.optimum.rockersteps import search_steps
from tmmcalc.cams.optimum.scene import Phases, Scene, scene_of
from tmmcalc.cams.optimum.wholesteps import search
from tmmcalc.cams.task import CamTask, Optimum
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.studies.measure import Way, relative, series
from tmmcalc.core.studies.scene import Scene as Studied
from tmmcalc.core.studies.study import Reference, Study

STEPS = (4e-3, 2e-3, 1e-3, 5e-4)  # [m] of S0, r2 and H2
COARSE = (8e-3, 4e-3, 2e-3, 1e-3)  # [m] of the complete grid
DENSER = 4
ROUNDED = "the least size rounded up to a step point: an error below the step, anywhere"
AROUND = 0.25  # of the sizes of the lowest: how far the complete grid reaches


def studies(studied: Studied) -> Iterator[Study]:
    """The least H2 of the task as it is asked for."""
    task: CamTask = studied.inputs.at_speed(studied.results.get("motion"))
    found: CamOptimum = studied.results["cam_optimum"]
    if found.refused:
        return
    asked = Optimum() if task.optimum is None else replace(task.optimum, heights=None)
    follower = studied.results["cam_synthesis"].follower
    phases: Phases = asked.phases
    if follower.kind == "oscillating":
        yield _rocker_study(studied, task, found, asked)
        return
    scene, denser = (scene_of(task, follower, phases, many) for many in (1, DENSER))
    exact = _corner(denser, found)
    reference = Reference(f"the corner on nodes {DENSER} times as dense", found.error["height"])

    def error(height: float) -> float:
        return relative(height, exact)

    corner = [Way("", None, partial(_corner, scene, found))]
    steps = [Way(f"{1e3 * s:g} mm", s, partial(_steps, scene, asked, s)) for s in STEPS]
    every = [
        series("exact corner", corner, error, studied.clock),
        series("whole steps", steps, error, studied.clock, note=ROUNDED, stepwise=False),
    ]
    if not _flat(scene):
        grid = [Way(f"{1e3 * s:g} mm", s, partial(_grid, scene, found, s)) for s in COARSE]
        every.append(series("complete grid about the lowest", grid, error, studied.clock, note=ROUNDED, stepwise=False))
    yield Study("cam_optimum", "least height H2", reference, tuple(every))


def _rocker_study(studied: Studied, task: CamTask, found: CamOptimum, asked: Optimum) -> Study:
    """The least l0 of a rocker: the exact corner, and whole steps ever finer."""
    asked = replace(asked, centre_distances=None)
    follower = studied.results["cam_synthesis"].follower
    of, denser = (rocker_scene(task, follower, asked.phases, many) for many in (1, DENSER))
    start = np.array([[found.least.length], [found.least.start], [found.least.roller], [found.least.height]])
    exact = float(least_centres(denser, asked, start)[3])

    def error(centres: float) -> float:
        return relative(centres, exact)

    def by_steps(step: float) -> float:
        return float(search_steps(of, replace(asked, step=step), found.least.height).sizes[3, 0])

    corner = [Way("", None, lambda: float(least_centres(of, asked, scanned(of, asked))[3]))]
    steps = [Way(f"{1e3 * s:g} mm", s, partial(by_steps, s)) for s in STEPS]
    reference = Reference(f"the corner on nodes {DENSER} times as dense", found.error["height"])
    every = (
        series("exact corner", corner, error, studied.clock),
        series("whole steps", steps, error, studied.clock, note=ROUNDED, stepwise=False),
    )
    return Study("cam_optimum", "least distance of the centres l0", reference, every)


def _flat(scene: Scene) -> bool:
    return scene.follower.kind == "flat"


def _corner(scene: Scene, found: CamOptimum) -> float:
    """The least H2 of any sizes [m]."""
    if _flat(scene):
        return flatface.lowest(scene)[1]
    return least_height(scene, found.chosen.start, found.chosen.roller, found.chosen.height).height


def _steps(scene: Scene, asked: Optimum, step: float) -> float:
    if _flat(scene):
        return flatface.steps(scene, step, step)[0]
    lowest, _ = search(scene, replace(asked, step=step, height_step=step))
    if lowest is None:
        raise NoSolutionError(f"no step point of {1e3 * step:g} mm keeps all constraints", where="cam_optimum")
    return lowest.height


def _grid(scene: Scene, found: CamOptimum, step: float) -> float:
    """The least H2 of all points of whole steps about the lowest mechanism."""
    sides = [_whole(size, step) for size in (found.least.start, found.least.roller, found.least.height)]
    start, roller, height = (each.ravel() for each in np.meshgrid(*sides, indexing="ij"))
    good = np.all(margins(scene, start, roller, height) >= -SLACK, axis=0)
    if not good.any():
        raise NoSolutionError(f"no point of a grid of {1e3 * step:g} mm keeps all constraints", where="cam_optimum")
    return float(np.min(height[good]))


def _whole(size: float, step: float) -> np.ndarray:
    """Whole steps about a size."""
    return step * np.arange(max(int((1 - AROUND) * size / step), 1), int((1 + AROUND) * size / step) + 2)
