"""``tmmcalc sweep``."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.messages import put, say, warn
from tmmcalc.cli.options import (
    STANDARD_OUTPUT,
    Form,
    Format,
    Jobs,
    Quiet,
    Scheduler,
    SpecFile,
    Tolerance,
    patterns_of,
    stages,
)
from tmmcalc.cli.output import check_place, check_tolerance, show
from tmmcalc.cli.progress import counted, seen
from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.batch.sheet import Sheet
    from tmmcalc.batch.sweep import Swept
    from tmmcalc.batch.task import Task


def command(
    spec: SpecFile,
    sets: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="KEY=RANGE",
            help="Range of a key, FROM:TO:COUNT, *FROM:TO:COUNT (times its value) or A,B,C; or one value for all "
            "variants. May be repeated.",
            show_default=False,
        ),
    ] = None,
    points: Annotated[
        Path | None,
        typer.Option(
            "--points", metavar="FILE", help="CSV with a variant a row, keys as headers: no grid.", show_default=False
        ),
    ] = None,
    targets: Annotated[
        list[str] | None,
        typer.Option(
            "--to",
            metavar="STAGE",
            help="Solve up to this stage; may be repeated.",
            show_default=False,
            autocompletion=stages,
        ),
    ] = None,
    columns: Annotated[
        str | None,
        typer.Option(
            "--columns",
            metavar="NAMES",
            help="Quantities by name, with wildcards: 'kinematics.stroke_*,forces.max(R_A)' (default: all facts of "
            "the stages).",
            show_default=False,
        ),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--out",
            metavar="FILE",
            help="The table, a CSV or FILE.parquet (default: <spec>.sweep.csv here; - for standard output).",
            show_default=False,
        ),
    ] = None,
    jobs: Jobs = None,
    scheduler: Scheduler = None,
    limit: Annotated[
        int | None,
        typer.Option(
            "--limit-errors", metavar="N", min=0, help="Stop when more points have failed.", show_default=False
        ),
    ] = None,
    fresh: Annotated[bool, typer.Option("--fresh", help="Solve all points, whatever is stored.")] = False,
    depfile: Annotated[
        Path | None,
        typer.Option(
            "--depfile",
            metavar="FILE",
            help="Write a Makefile rule: the table needs the spec and its files.",
            show_default=False,
        ),
    ] = None,
    tolerance: Tolerance = None,
    form: Form = Format.table,
    quiet: Quiet = False,
) -> None:
    """Solve every variant of a grid over keys of the spec; write a tidy CSV, one row a variant; or Parquet.

    A variant without a solution keeps its row with the reason. A sweep that was stopped goes on where it was; one that
    is up to date is not repeated.

    Example: tmmcalc sweep my.toml --set 'mechanism.links[id=1].points.A[0]=*0.9:1.1:21'
    """
    to_stdout = out == STANDARD_OUTPUT
    file = None if to_stdout else out or Path(f"{spec.stem}.sweep.csv")
    _check(file, depfile, [spec] if points is None else [spec, points])
    if tolerance is not None:
        check_tolerance(tolerance)
    from tmmcalc.batch.reading import task_of

    task = task_of(spec, sets or (), points, targets or (), patterns_of(columns), tolerance)
    swept = _run(task, file, jobs, scheduler, limit, fresh, quiet)
    if depfile is not None and file is not None:
        _depend(depfile, file, task, spec, points)
    _tell(swept, file, quiet, task)
    if to_stdout:
        from tmmcalc.batch.sheet import csv_bytes

        put(csv_bytes(swept.sheet).decode())
    else:
        from tmmcalc.batch.document import sweep_document

        show(sweep_document(swept.sheet, _title(task, spec)), form)
    _end(swept.sheet)


def _check(out: Path | None, depfile: Path | None, sources: Sequence[Path]) -> None:
    """Refuse what would only come out after the computation."""
    if out is not None:
        from tmmcalc.batch.sheet import check_form

        check_place(out, "-o")
        if any(out.absolute() == source.absolute() for source in sources):
            raise UsageError(f"{out} is what the sweep is made from", where="-o", remedy="name another file")
        check_form(out)
    if depfile is not None:
        check_place(depfile, "--depfile")
        if out is None:
            raise UsageError("standard output is no file", where="--depfile", remedy="write the table to a file by -o")


def _run(
    task: Task,
    out: Path | None,
    jobs: int | None,
    scheduler: str | None,
    limit: int | None,
    fresh: bool,
    quiet: bool,
) -> Swept:
    from tmmcalc.batch.choice import solver_of
    from tmmcalc.batch.sweep import sweep

    task, solver = solver_of(task, jobs, scheduler, warn)
    done = 0
    try:
        with seen(counted("points", task.count), quiet) as shown:

            def told(finished: int, failed: int) -> None:
                nonlocal done
                done = finished
                shown(finished, failed)

            return sweep(task, solver, out, fresh=fresh, most_failed=limit, told=told)
    except KeyboardInterrupt:
        say(f"stopped: {_kept(out, done, task.count)}", "yellow")
        raise


def _kept(out: Path | None, done: int, count: int) -> str:
    """What a sweep that was interrupted leaves, and how to go on."""
    from tmmcalc.batch.sweep import part

    if out is None:
        return "nothing is kept of a table for standard output; with -o FILE a sweep goes on where it was"
    if not part(out).is_file():
        return "no point was finished, nothing is kept; the same command begins again"
    return (
        f"{done} of {count} points are kept in {part(out)}; the same command goes on from there, --fresh begins again"
    )


def _depend(depfile: Path, out: Path, task: Task, spec: Path, points: Path | None) -> None:
    from tmmcalc.batch.content import files_of
    from tmmcalc.pipeline.depfile import write

    named = [spec.parent / name for name in files_of(task.variants().data, spec.parent)]
    write(depfile, [out], [spec, *named, *([points] if points is not None else [])])


def _tell(swept: Swept, out: Path | None, quiet: bool, task: Task) -> None:
    """Say what was done, where that is not all there is."""
    if quiet or out is None:
        return
    if swept.loaded:
        say(f"{out} is up to date", "dim")
    else:
        from tmmcalc.batch.stacked import way

        again = f", {swept.resumed} of its points from the run before" if swept.resumed else ""
        how = way(task, swept.alone)
        say(f"wrote {out}{again}{'; ' if how else ''}{how}", "dim")


def _title(task: Task, spec: Path) -> str:
    project = task.variants().data.get("project", {})
    return f"{project.get('title') or spec.stem}: sweep"


def _end(sheet: Sheet) -> None:
    """End with an error where the program has a fault, or where no variant has a solution."""
    from tmmcalc.batch.task import BROKEN

    broken = sheet.status.count(BROKEN)
    if broken:
        row = sheet.status.index(BROKEN)
        say(f"error: {broken} points ended by a fault of the program; row {row + 1}: {sheet.reasons[row]}", "red")
        raise typer.Exit(1)
    if sheet.failed == len(sheet.status):
        say(f"error: no variant has all that was asked for; row 1: {sheet.reasons[0]}", "red")
        raise typer.Exit(int(sheet.status[0].split()[1]))
