"""Who solves the blocks of points: this process, local processes by joblib, or the workers of a Dask cluster.

A block whose process has died is solved again point by point, one at a time, so that a point that kills its process
is known; when it has done so twice it fails, and the others lose nothing.
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from contextlib import AbstractContextManager
from functools import partial
from time import monotonic, sleep
from typing import Any

from tmmcalc._version import __version__
from tmmcalc.batch.task import BROKEN, Row, Task
from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.core.stage import resolve

Block = Sequence[Any]  # points by their numbers, or places with a number (`batch.places`)
Solve = Callable[[Task, Iterable[Block]], Iterator[list[Row]]]
Tell = Callable[[str], None]
DEATHS = 2  # of a process over one and the same point
PATIENCE = 5.0  # seconds between two looks at whether anybody is still there


@record
class Workers:
    """Executors as they are opened one after the other, and how the loss of a process shows."""

    open: Callable[[], AbstractContextManager[Executor]]
    size: Callable[[], int]  # of processes or threads at this moment
    lost: tuple[type[BaseException], ...]  # what a future raises whose process has died
    watch: Callable[[], None] = lambda: None  # raises UsageError if there is nobody left to wait for


def solve(task: Task, points: Block) -> list[Row]:
    """Rows of a block, by the solver of the task."""
    rows: list[Row] = resolve(task.solver)(task, points)
    return rows


def solve_there(version: str, task: Task, points: Block) -> list[Row]:
    """The same in another process; raises UsageError if another version of the program runs there."""
    if version != __version__:
        raise UsageError(
            f"a worker has version {__version__} of tmmcalc, this is {version}",
            where="--scheduler",
            remedy="install the same version on all workers",
        )
    return solve(task, points)


def solve_here(task: Task, blocks: Iterable[Block]) -> Iterator[list[Row]]:
    """Solve block by block in this process."""
    return (solve(task, block) for block in blocks)


def solve_by(workers: Workers, task: Task, blocks: Iterable[Block], tell: Tell) -> Iterator[list[Row]]:
    """Solve blocks by workers, each as soon as one is free; rows come in any order."""
    work = partial(solve_there, __version__, task)
    waiting, suspects, deaths = deque(blocks), deque[Block](), Counter[Any]()
    while waiting or suspects:
        alone = bool(suspects)
        with workers.open() as pool:
            lost: list[Block] = []
            yield from _drain(pool, work, workers, suspects if alone else waiting, alone, lost)
        if not lost:
            continue
        points = [point for block in lost for point in block]
        tell(f"a process died; {len(points)} point{'s' if len(points) > 1 else ''} of it solved again")
        deaths.update(points if alone else ())
        given_up = [point for point in points if deaths[point] >= DEATHS]
        suspects.extend([point] for point in points if deaths[point] < DEATHS)
        yield [
            Row(getattr(point, "point", point), BROKEN, f"its process died {DEATHS} times: not enough memory?")
            for point in given_up
        ]


def _drain(
    pool: Executor,
    work: Callable[[Block], list[Row]],
    workers: Workers,
    waiting: deque[Block],
    alone: bool,
    lost: list[Block],
) -> Iterator[list[Row]]:
    """Solve what waits until it is done or a process dies; then what was on its way is finished or ``lost``."""
    flying: dict[Future[list[Row]], Block] = {}
    try:
        while flying or (waiting and not lost):
            width = 1 if alone else 2 * workers.size()
            while waiting and not lost and len(flying) < width:
                block = waiting.popleft()
                try:
                    flying[pool.submit(work, block)] = block
                except workers.lost:
                    lost.append(block)
            done, _ = wait(flying, PATIENCE, FIRST_COMPLETED)
            if not done:
                workers.watch()
            for future in done:
                block = flying.pop(future)
                try:
                    yield future.result()
                except workers.lost:
                    lost.append(block)
    finally:
        _settle(flying)


def _settle(flying: Iterable[Future[list[Row]]]) -> None:
    """Wait a moment until what was sent is on its way: joblib's executor stumbles when it is ended before."""
    until = monotonic() + 1.0
    while monotonic() < until and any(not (future.running() or future.done()) for future in flying):
        sleep(0.001)
