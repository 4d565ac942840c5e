"""The part of ``make bench`` that is about pairs of gears: contours with the choice of shifts, pairs, outlines."""

from __future__ import annotations

from math import radians

from timing import bar_text, median_time

from tmmcalc.gears.involute.contour.task import Task
from tmmcalc.gears.involute.profile.flank import flank_of
from tmmcalc.gears.involute.profile.outline import outline, tooth
from tmmcalc.gears.involute.shifts import choose
from tmmcalc.gears.involute.strategies import STRATEGIES
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.meshing.blocking import solve_blocking
from tmmcalc.gears.meshing.results import Pairs
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask

CHOICE, STAGE, OUTLINE, PAIR = 50.0, 100.0, 20.0, 5.0  # ms
FREE = [name for name in STRATEGIES if name not in ("given", "given_aw", "zero", "equal_shift")]


def pairs() -> list[str]:
    """Every strategy for a spur and a helical pair, both contours with all lines, one pair, a gear of 100 teeth."""
    missed: list[str] = []
    print("\npairs of gears                                                    time     bar")
    for first, second, helix in ((14, 17, 0.0), (19, 60, 15.0)):
        task = Task(Wheel(first, 0.0, radians(helix)), Wheel(second, 0.0, radians(helix)))
        for name in FREE:
            told = f"contour and choice by {name}, {first}/{second}, {helix:g} deg"
            missed += _timed(told, lambda task=task, name=name: choose(task, name), CHOICE)
    given = PairTask((14, 17), 0.005, strategy="given", shifts=(0.6, 0.5))
    missed += _timed("pair with given shifts: geometry, checks, measures", lambda: solve_pair(given), PAIR)
    found = Pairs((solve_pair(given),), "", ())
    missed += _timed("blocking stage: both contours, lines, points", lambda: solve_blocking(found), STAGE)
    wheel = Wheel(100, 0.1)
    missed += _timed("gear of 100 teeth, 200 points a flank", lambda: outline(tooth(flank_of(wheel)), 200), OUTLINE)
    return missed


def _timed(told: str, work: object, bar: float) -> list[str]:
    assert callable(work)
    ms = median_time(work, 0.2) * 1e3
    print(f"  {told:<62} {ms:6.1f} ms  {bar_text(ms, bar)}")
    return [told] if ms > bar else []
