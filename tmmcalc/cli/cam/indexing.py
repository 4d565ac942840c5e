"""``tmmcalc cam indexing``."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.cam.profile import check_files, write_files
from tmmcalc.cli.flags import with_flags
from tmmcalc.cli.options import Columns, Form, Format, Positions, patterns_of
from tmmcalc.cli.work import Job, title
from tmmcalc.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.cams.indexing import Indexing
    from tmmcalc.cams.indexing.task import IndexingTask


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    columns: Columns = None,
    positions: Positions = None,
    compare: Annotated[
        bool, typer.Option("--compare", help="Print numbers of rollers and laws side by side instead.")
    ] = False,
    svg: Annotated[
        Path | None, typer.Option("--svg", metavar="FILE", help="Write a drawing 1:1.", show_default=False)
    ] = None,
    dxf: Annotated[
        Path | None,
        typer.Option("--dxf", metavar="FILE", help="Write arcs and splines in mm (extra cad).", show_default=False),
    ] = None,
    nc: Annotated[
        Path | None,
        typer.Option("--nc", metavar="FILE", help="Write points for a machine tool as CSV.", show_default=False),
    ] = None,
    tolerance: Annotated[
        str | None,
        typer.Option("--tolerance", metavar="LENGTH", help="Of chords and cubics in the files.", show_default=False),
    ] = None,
) -> None:
    """Cam-lantern indexing drive: limits of lambda and step, profiles, pressure angles, rollers, efficiency.

    The table is in mm, a row a part k of the step; --format csv, json or toml prints metres.

    Example: tmmcalc cam indexing my.toml --compare
    """
    patterns = patterns_of(columns)
    files = {flag: file for flag, file in (("--svg", svg), ("--dxf", dxf), ("--nc", nc)) if file is not None}
    if compare and files:
        raise UsageError("--compare draws no cam", where=", ".join(files), remedy="leave one of them out")
    check_files(files, tolerance)
    if tolerance is not None:
        job = replace(job, overrides=[*job.overrides, f'indexing.tolerance="{tolerance}"'])
    scene = job.spec()
    from tmmcalc.report.cams.indexing import comparison_document, indexing_document
    from tmmcalc.spec.indexings import to_indexing

    heading = title(scene, job.file, "indexing drive")
    if compare:
        from tmmcalc.cams.indexing.compare import compare as compared
        from tmmcalc.cli.work import show

        show(comparison_document(compared(to_indexing(scene)), heading, patterns), form)
        return
    from tmmcalc.cli.positions import rows_of

    run = job.run(scene, "indexing")
    result = run.results["indexing"]
    document = indexing_document(
        result,
        heading,
        patterns=patterns,
        rows=rows_of(positions, result.labels),
        everything=form is not Format.table,
    )
    contents = _contents(to_indexing(scene), result, files, heading) if files else {}
    job.finish(document, run, form)
    write_files(contents, job.quiet)


def _contents(task: IndexingTask, result: Indexing, files: dict[str, Path], heading: str) -> dict[Path, bytes]:
    """The bytes of all files, made before the first of them is written."""
    from tmmcalc.report.indexingfiles import nc_table, outlines
    from tmmcalc.report.outlinefiles import dxf, svg

    made: dict[Path, bytes] = {}
    drawn = outlines(task, result) if {"--svg", "--dxf"} & set(files) else ()
    for flag, file in files.items():
        if flag == "--svg":
            made[file] = svg(drawn, task.tolerance, heading)
        elif flag == "--dxf":
            made[file] = dxf(drawn)
        else:
            made[file] = nc_table(task, result)
    return made
