"""How the points of a task are solved: by which solver, in what blocks, in how many processes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from tmmcalc.batch.executors import Solve, solve_by, solve_here
from tmmcalc.batch.local import available, cores, processes
from tmmcalc.batch.stacked import SOLVER, together
from tmmcalc.batch.task import Task
from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.pipeline.settling import planned
from tmmcalc.rooms import STAGES

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
            plans = (planned(spec, target, STAGES) for target in task.targets or (None,))
            return frozenset(name for each in plans for name in each.running)
        except TmmError:
            continue
    return frozenset()


def heavy(task: Task) -> bool:
    """Whether points of a task run stages that may be long."""
    return not HEAVY.isdisjoint(running(task))


def chosen(task: Task, jobs: int | None, cores: int) -> tuple[Task, int]:
    """The task with its solver and the size of its blocks, and the number of processes; ``jobs`` None: as it pays."""
    long = heavy(task)
    if jobs is None:
        jobs = min(cores, task.count) if long and task.count > FEW else 1
    block = 0 if long else together(task)
    if block:
        return replace(task, solver=SOLVER, block=block), jobs
    shared = -(-task.count // (4 * jobs))  # so that all have work to the end
    return replace(task, block=max(1, min(1 if long else task.block, shared))), jobs


def solver_of(task: Task, jobs: int | None, scheduler: str | None, tell: Callable[[str], None]) -> tuple[Task, Solve]:
    """The task in its blocks and who solves them; ``tell`` is called with what becomes of processes that die.

    Raises UsageError for ``jobs`` beside a ``scheduler``, and where joblib or distributed is not installed.
    """
    if scheduler is not None:
        return chosen(task, cores(), cores())[0], cluster(scheduler, jobs, tell)
    task, number = chosen(task, jobs, cores() if available() else 1)
    return task, local(number, tell)


def cluster(scheduler: str, jobs: int | None, tell: Callable[[str], None], kept: bool = False) -> Solve:
    """The workers of a cluster; raises UsageError for ``jobs`` beside it, and where distributed is not installed.

    ``kept``: the connection stays for the next question.
    """
    if jobs is not None:
        remedy = "leave --jobs or --scheduler out"
        raise UsageError("the cluster has its own processes", where="--jobs", remedy=remedy)
    from tmmcalc.batch.cluster import solve_on

    return partial(solve_on, scheduler, tell=tell, kept=kept)


def local(jobs: int, tell: Callable[[str], None], kept: bool = False) -> Solve:
    """So many processes, this one alone if it is one; raises UsageError where joblib is not installed.

    ``kept``: they stay for the next question.
    """
    return solve_here if jobs == 1 else partial(solve_by, processes(jobs, kept), tell=tell)
