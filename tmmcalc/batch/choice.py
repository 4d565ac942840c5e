"""How the points of a task are solved: by which solver, in what blocks, in how many processes."""

from __future__ import annotations

from dataclasses import replace

from tmmcalc.batch.task import Task
from tmmcalc.errors import TmmError
from tmmcalc.pipeline.plan import plan

# Stages that may take longer than a process costs to start: motions in time, searches, contours.
HEAVY = frozenset(
    {"synthesis", "train", "criteria", "blocking", "transient", "cam_optimum", "vibrator", "pendulum", "contact"}
)
FEW = 4  # points that are not worth a process


def running(task: Task) -> frozenset[str]:
    """The stages that the first valid one of a few variants runs; none if they are no valid specs."""
    variants = task.variants()
    for point in task.spread():
        try:
            spec = variants.spec(task.assignments(point))
            return frozenset(name for target in task.targets or (None,) for name in plan(spec, target).running)
        except TmmError:
            continue
    return frozenset()


def chosen(task: Task, jobs: int | None, cores: int) -> tuple[Task, int]:
    """The task with its solver and the size of its blocks, and the number of processes; ``jobs`` None: as it pays."""
    heavy = bool(running(task) & HEAVY)
    if jobs is None:
        jobs = min(cores, task.count) if heavy and task.count > FEW else 1
    shared = -(-task.count // (4 * jobs))  # so that all have work to the end
    return replace(task, block=max(1, min(1 if heavy else task.block, shared))), jobs
