"""One sweep from its task to its table: what is done already, what is left, and when the table is written."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack
from itertools import groupby
from pathlib import Path

from tmmcalc.batch import sheet as sheets
from tmmcalc.batch.content import key_of
from tmmcalc.batch.executors import Solve, solve
from tmmcalc.batch.journal import Journal
from tmmcalc.batch.points import run_of, solve_variant
from tmmcalc.batch.quantities import offered_like, others, told, unknown, unmatched
from tmmcalc.batch.sheet import Sheet, rows_of, sheet_of
from tmmcalc.batch.task import BROKEN, INVALID, Row, Task
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.records import record

Told = Callable[[int, int], None]  # points done, of these failed


@record
class Swept:
    """A sweep that is done."""

    sheet: Sheet
    loaded: bool  # the table was there already
    resumed: int  # points that an earlier run had finished
    alone: tuple[str, ...] = ()  # reasons of those points that were solved alone although others were solved together


def sweep(
    task: Task,
    solver: Solve,
    out: Path | None = None,
    *,
    fresh: bool = False,
    most_failed: int | None = None,
    told: Told = lambda done, failed: None,
) -> Swept:
    """Solve all points of a task and write them to ``out``; what an earlier run has done is not done again.

    Raises the error of the first point if no variant is a valid spec, UsageError for a pattern that names nothing,
    NoSolutionError when more than ``most_failed`` points fail; what is finished then stays in ``out``.part.
    """
    if out is not None:
        sheets.check_form(out)
    key = key_of(task)
    stored = sheets.current(task, key, out) if out is not None and not fresh else None
    if stored is not None and BROKEN not in stored.status:
        return Swept(stored, True, 0)
    with ExitStack() as stack:
        journal = stack.enter_context(Journal(part(out), key)) if out is not None else None
        done = _Done(task, journal, most_failed, told)
        if journal is not None and not fresh:
            done.take(journal.rows())
            done.take(_finished(stored, done) if stored is not None else ())
        resumed = len(done.rows)
        for rows in _solved(task, solver, done):
            done.add(rows)
        done.settle()
        sheet = sheet_of(task, done.rows.values())
        if journal is not None and out is not None:
            sheets.save(sheet, key, out)
            journal.done = True
    return Swept(sheet, False, resumed, tuple(row.alone for row in done.rows.values() if row.alone))


def part(out: Path) -> Path:
    """The journal beside a table."""
    return out.with_name(f"{out.name}.part")


def _finished(stored: Sheet, done: _Done) -> list[Row]:
    """The points of a finished table that are to be kept: a fault of the program is tried again."""
    return [row for row in rows_of(stored) if row.status != BROKEN and row.point not in done.rows]


class _Done:
    """The finished points; the journal gets them once one is a valid spec, so that a slip in a key leaves no file."""

    def __init__(self, task: Task, journal: Journal | None, most_failed: int | None, told: Told) -> None:
        self.task, self.journal, self.told = task, journal, told
        self.most_failed = task.count if most_failed is None else most_failed
        self.rows: dict[int, Row] = {}
        self.failed = 0
        self.valid = False
        self._held: list[Row] = []

    def take(self, rows: Iterable[Row]) -> None:
        """Points that an earlier run has finished."""
        for row in rows:
            self.rows[row.point] = row
            self.failed += not row.ok
            self.valid |= row.status != INVALID

    def add(self, rows: list[Row]) -> None:
        """Points that this run has finished."""
        self.take(rows)
        self._held += rows
        if self.valid and self.journal is not None:
            self.journal.append(self._held)
        if self.valid:
            self._held = []
        self.told(len(self.rows), self.failed)
        if self.valid and self.failed > self.most_failed:
            raise NoSolutionError(
                f"{self.failed} points have failed",
                where="--limit-errors",
                value=self.failed,
                limit=self.most_failed,
                remedy="look at their reasons; without the limit the sweep goes on from here",
            )

    def settle(self) -> None:
        """Raise the error of the first variant if none is a valid spec."""
        if not self.valid:
            solve_variant(self.task, self.task.variants().spec(self.task.assignments(0)))


def _solved(task: Task, solver: Solve, done: _Done) -> Iterator[list[Row]]:
    """Rows of the points that are left, the first of them tried for what the patterns name."""
    if task.patterns and not done.rows:
        yield _tried(task)
    left = (point for point in range(task.count) if point not in done.rows)
    # blocks are those of all points, so that what is solved together does not depend on what is done already
    yield from solver(task, [list(block) for _, block in groupby(left, lambda point: point // task.block)])


def _tried(task: Task) -> list[Row]:
    """A few points over the sweep, until all patterns name what one of them tells; raises UsageError if they do not."""
    rows: list[Row] = []
    for point in task.spread():
        rows += solve(task, [point])
        pattern = unmatched((name for row in rows for name in row.names), task.patterns)
        if pattern is None:
            return rows
    solved = [row.point for row in rows if row.ok]
    if pattern is not None and solved:
        spec = task.variants().spec(task.assignments(solved[0]))
        run = run_of(task, spec)
        known = [name for name, _ in told(run.results, others(pattern))]
        raise unknown(pattern, [*known, *offered_like(pattern, run.results, run.spec)])
    return rows
