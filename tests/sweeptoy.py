"""Solvers for sweeps whose points take a moment, fail, or kill their process; they are found by workers too."""

from __future__ import annotations

import os
import signal
import time
from array import array
from collections.abc import Sequence
from pathlib import Path

from tmmcalc.batch.task import Row, Task
from tmmcalc.spec.variants import Axis

TORQUE = '[torque]\nspeed = "20 rad/s"\nformula = "100*sin(theta)"\n\n[flywheel]\ndelta = 0.02\n'
NAMES = ("flywheel.square", "flywheel.cube[m]")


def task(folder: Path, count: int = 24, solver: str = "square", block: int = 2, **more: object) -> Task:
    """Squares and cubes of 1, 2, ..., as a sweep of two keys."""
    axes = (
        Axis("flywheel.delta", tuple(float(k) for k in range(1, count // 2 + 1))),
        Axis("flywheel.inertia", (0.0, 0.5), "kg*m^2"),
    )
    return Task(TORQUE, "toy.toml", str(folder), (), axes, solver=f"sweeptoy:{solver}", block=block, **more)


def row(given: Task, point: int) -> Row:
    value = sum(given.values(point))
    if value == 3.5:
        return Row(point, "failed 3", "toy: 3.5, as asked")
    return Row(point, "ok", "", NAMES, array("d", (value**2, value**3)))


def square(given: Task, points: Sequence[int]) -> list[Row]:
    return [row(given, point) for point in points]


def slow(given: Task, points: Sequence[int]) -> list[Row]:
    time.sleep(0.1 * len(points))
    return square(given, points)


def killed_once(given: Task, points: Sequence[int]) -> list[Row]:
    """The process of point 7 is killed when it is met first."""
    met = Path(given.folder) / "met"
    if 7 in points and not met.exists():
        met.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return slow(given, points)


def killed(given: Task, points: Sequence[int]) -> list[Row]:
    """The process of point 7 is killed whenever it is met."""
    if 7 in points:
        os.kill(os.getpid(), signal.SIGKILL)
    return square(given, points)


def invalid(given: Task, points: Sequence[int]) -> list[Row]:
    return [Row(point, "failed 2", "no such key") for point in points]
