"""The Python API of batches: many variants of one spec."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tmmcalc.batch.sheet import Sheet


def sweep(
    file: str | Path,
    ranges: Sequence[str] = (),
    *,
    points: str | Path | None = None,
    targets: Sequence[str] = (),
    columns: Sequence[str] = (),
    out: str | Path | None = None,
    jobs: int | None = None,
    scheduler: str | None = None,
    tolerance: float | None = None,
    fresh: bool = False,
    tell: Callable[[str], None] = lambda text: None,
) -> Sheet:
    """Solve every variant of the spec in ``file`` over the grid of ``ranges`` (``KEY=FROM:TO:COUNT``), or of a table.

    ``points`` is a CSV with a variant a row in place of the ranges; ``targets`` are the stages to reach, ``columns``
    names and wildcards of the quantities (none: all facts). With ``out`` the table is written there, a sweep that was
    stopped goes on, and one that is up to date is read. ``jobs`` are local processes, ``scheduler`` is the address of
    a Dask cluster; ``tell`` is called when a process dies.

    Raises `UsageError` and `SpecError` for what is no sweep; a variant that fails is a row with its reason.
    """
    from tmmcalc.batch.choice import solver_of
    from tmmcalc.batch.reading import task_of
    from tmmcalc.batch.sweep import sweep as _sweep

    table = Path(points) if points is not None else None
    task = task_of(Path(file), ranges, table, targets, columns, tolerance)
    task, solver = solver_of(task, jobs, scheduler, tell)
    return _sweep(task, solver, Path(out) if out is not None else None, fresh=fresh).sheet
