"""The part of ``make bench`` that is about cams: all stages at 36 000 positions, least base circle, optimum."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from math import pi
from pathlib import Path

from timing import bar_text, median_time

import tmmcalc
from tmmcalc.cams.forces.solve import solve_forces
from tmmcalc.cams.indexing import solve_indexing
from tmmcalc.cams.indexing.compare import compare
from tmmcalc.cams.lawresult import solve_law
from tmmcalc.cams.optimum.solve import solve_optimum
from tmmcalc.cams.pressure.solve import solve_pressure
from tmmcalc.cams.profile.solve import solve_profile
from tmmcalc.cams.strength.solve import solve_strength
from tmmcalc.cams.synthesis.solve import solve_synthesis
from tmmcalc.cams.synthesis.translatingsizes import lines_of, nearest
from tmmcalc.cams.tables.tasks.cam import to_cam
from tmmcalc.cams.tables.tasks.indexing import to_indexing
from tmmcalc.cams.task import CamTask

CONFIGS = Path(tmmcalc.__file__).parents[1] / "configs"
FULL, LEAST, OPTIMUM, INDEXING = 100.0, 2.0, 300.0, 100.0  # ms
ROWS = 36_000


@cache
def asked_of(name: str) -> CamTask:
    """A ready cam."""
    return to_cam(tmmcalc.load_spec(CONFIGS / f"{name}.toml"))


def task_of(name: str, rows: int = ROWS) -> CamTask:
    """A ready cam, every time with nothing known of its motion."""
    task = asked_of(name)
    program = type(task.program)(task.program.phases)
    return replace(task, program=program, steps=None, step=2 * pi / rows)


def cams() -> list[str]:
    """Each stage and all together; the synthesis alone; the optimum."""
    print("\ncams                                                              time     bar")
    missed: list[str] = []
    follower = solve_synthesis(task_of("cam-translating")).follower
    stages: dict[str, Callable[[CamTask], object]] = {
        "law": solve_law,
        "synthesis": solve_synthesis,
        "profile": lambda task: solve_profile(task, follower),
        "pressure angle": lambda task: solve_pressure(task, follower),
        "forces": lambda task: solve_forces(task, follower),
        "strength": lambda task: solve_strength(task, follower),
    }
    for name, work in stages.items():
        _timed(f"{name}, {ROWS} positions", lambda work=work: work(task_of("cam-translating")))
    missed += _timed(f"all of them in one run, {ROWS} positions", lambda: _whole("cam-translating"), FULL)
    drive = to_indexing(tmmcalc.load_spec(CONFIGS / "cam-lantern.toml"))
    missed += _timed("indexing drive with its limits and efficiency", lambda: solve_indexing(drive), INDEXING)
    missed += _timed("indexing: all numbers of rollers and laws", lambda: compare(drive), INDEXING)
    free = task_of("cam-synthesis")
    missed += _timed("least base circle with its offset", lambda: nearest(lines_of(free)), LEAST)
    asked = task_of("cam-translating", 360)
    missed += _timed("optimal design", lambda: solve_optimum(asked, follower), OPTIMUM)
    return missed


def _whole(name: str) -> None:
    task = task_of(name)
    follower = solve_synthesis(task).follower
    solve_law(task)
    solve_profile(task, follower)
    solve_pressure(task, follower)
    solve_strength(task, follower, solve_forces(task, follower))


def _timed(told: str, work: Callable[[], object], bar: float | None = None) -> list[str]:
    ms = median_time(work, 0.3) * 1e3
    print(f"  {told:<62} {ms:6.1f} ms  {bar_text(ms, bar) if bar else ''}")
    return [told] if bar and ms > bar else []
