"""``tmmcalc cam indexing``."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.exporting import Chord, Dxf, Files, Nc, Svg, check_files, contents_of, files_of, write_files
from tmmcalc.cli.job import Job, with_flags
from tmmcalc.cli.options import Columns, Form, Format, Positions, patterns_of
from tmmcalc.cli.output import table_file, title
from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from pathlib import Path

    from tmmcalc.cams.indexing import Indexing
    from tmmcalc.cams.indexing.task import IndexingTask


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    columns: Columns = None,
    positions: Positions = None,
    compare: Annotated[
        bool, typer.Option("--compare", help="Print the reference tables instead: numbers of rollers, then laws.")
    ] = False,
    svg: Svg = None,
    dxf: Dxf = None,
    nc: Nc = None,
    tolerance: Chord = None,
) -> None:
    """Cam-lantern indexing drive: limits of lambda and step, profiles, pressure angles, rollers, efficiency.

    The table is in mm, a row a part k of the step; --format csv, json or toml prints metres.

    Example: tmmcalc cam indexing my.toml --compare
    """
    patterns = patterns_of(columns)
    files = files_of(svg=svg, dxf=dxf, nc=nc)
    if compare and (files or positions is not None):
        where = ", ".join([*files, *(["--positions"] if positions is not None else [])])
        raise UsageError("--compare draws no cam and has no positions", where=where, remedy="leave one of them out")
    check_files(files, {"--tolerance": tolerance is not None})
    if tolerance is not None:
        job = replace(job, overrides=[*job.overrides, f'indexing.tolerance="{tolerance}"'])
    scene = job.spec()
    from tmmcalc.cams.facts.indexing import document as indexing_document
    from tmmcalc.cams.tables.tasks.indexing import to_indexing

    heading = title(scene, job.file, "indexing drive")
    if compare:
        _compare(to_indexing(scene), heading, patterns, form)
        return
    from tmmcalc.report.rows import rows_of

    run = job.run(scene, "indexing")
    result = run.results["indexing"]
    document = indexing_document(
        result,
        heading,
        patterns=patterns,
        rows=rows_of(positions, result.labels),
        everything=form is not Format.table,
        where=table_file(run, "indexing"),
    )
    contents = _contents(result, to_indexing(scene), files, heading) if files else {}
    job.finish(document, run, form)
    write_files(contents, job.quiet)


def _compare(task: IndexingTask, heading: str, patterns: list[str], form: Format) -> None:
    from tmmcalc.cams.facts.indexing_compared import comparison_document
    from tmmcalc.cams.indexing.compare import compare
    from tmmcalc.cli.output import show

    show(comparison_document(compare(task), heading, patterns, everything=form is not Format.table), form)


def _contents(result: Indexing, task: IndexingTask, files: Files, heading: str) -> dict[Path, bytes]:
    from tmmcalc.cams.files.indexing import nc_table, outlines

    return contents_of(files, heading, task.tolerance, lambda: outlines(task, result), lambda: nc_table(task, result))
