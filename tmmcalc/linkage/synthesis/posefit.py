"""Linkages that pass nearest to points or poses, in the least squares of all distances and angles.

Starts come from an atlas of random linkages; hundreds of them are fitted at once, by some of many points.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.core.progress import tell
from tmmcalc.linkage.synthesis.atlas import atlas
from tmmcalc.linkage.synthesis.batch import Course
from tmmcalc.linkage.synthesis.curvefit import Fits, Wanted, fitted
from tmmcalc.linkage.synthesis.planar import bars_of
from tmmcalc.linkage.synthesis.posed import Rated, ranked, spread
from tmmcalc.linkage.synthesis.results import SearchStep
from tmmcalc.linkage.synthesis.task import PoseTask, SynthesisTask

RANDOM = 20_000  # linkages of the atlas
STARTS = 500  # that are fitted
CUTS = {8: 200, 25: 100, 60: 50}  # iterations after which so many are kept
ITERATIONS = 150
ROUNDS = 3  # at most
EXACT = 1e-24  # sum of squares, in units of the spread, of a linkage that meets all points
COARSE = 20  # points by which starts are fitted
FINE = 60  # iterations with all points


def nearest(task: SynthesisTask) -> tuple[list[Rated], tuple[SearchStep, ...]]:
    """Fits of a task, ranked, and the steps of the search."""
    asked: PoseTask = task.asked
    middle, unit = complex(asked.points.mean()), spread(asked.points)
    wanted = _wanted(asked, middle, unit)
    some = np.unique(np.rint(np.linspace(0, len(asked.points) - 1, COARSE)).astype(int))
    coarse = _part(wanted, some)
    course: list[SearchStep] = []
    fits = _rounds(coarse, np.random.default_rng(task.seed), asked.full_turn, course)
    if len(some) < len(asked.points):
        steps: list[Course] = []
        fits = fitted(wanted, fits.bars, _between(wanted, some, fits.phi), {}, FINE, steps)
        course += _steps(ROUNDS + 1, steps)
    placed = fits.bars.at(fits.phi)
    pins = placed.b * unit + middle, placed.c * unit + middle
    return ranked(task, fits.bars.moved(unit, middle), *pins), tuple(course)


def _steps(run: int, steps: Sequence[Course]) -> Iterator[SearchStep]:
    return (SearchStep(run, k, *step) for k, step in enumerate(steps))


def _rounds(wanted: Wanted, rng: np.random.Generator, turning: bool, course: list[SearchStep]) -> Fits:
    """The fits of all rounds; an exact one ends them. ``course`` takes their steps."""
    found: list[Fits] = []
    for done in range(ROUNDS):
        tell(done / ROUNDS, f"round {done + 1} of {ROUNDS}")
        bars, phi, _ = atlas(wanted, rng, RANDOM, STARTS, turning)
        steps: list[Course] = []
        found.append(fitted(wanted, bars, phi, CUTS, ITERATIONS, steps))
        course += _steps(done + 1, steps)
        if found[-1].cost.min(initial=np.inf) < EXACT:
            break
    phi, cost = (np.concatenate(parts) for parts in ([each.phi for each in found], [each.cost for each in found]))
    parts = [np.concatenate(part) for part in zip(*(each.bars[:-1] for each in found), strict=True)]
    return Fits(bars_of(parts, wanted.slides), phi, cost)


def _wanted(asked: PoseTask, middle: complex, unit: float) -> Wanted:
    region = None
    if asked.region is not None:
        low, high = ((corner - middle) / unit for corner in asked.region)
        region = low, high
    turns = None if asked.angles is None else np.exp(1j * (asked.angles - asked.angles[0]))
    return Wanted((asked.points - middle) / unit, turns, asked.timing, asked.mechanism == "slider_crank", region)


def _part(wanted: Wanted, rows: np.ndarray) -> Wanted:
    """What is wanted at some of the points."""
    turns, timing = (None if part is None else part[rows] for part in (wanted.turns, wanted.timing))
    return replace(wanted, points=wanted.points[rows], turns=turns, timing=timing)


def _between(wanted: Wanted, some: np.ndarray, phi: Real) -> Real:
    """Angles of the crank at all points from those at some of them, by the way along the points."""
    way = np.concatenate(([0.0], np.cumsum(np.abs(np.diff(wanted.points)))))
    return np.stack([np.interp(way, way[some], row) for row in np.unwrap(phi, axis=1)])
