"""``tmmcalc feasibility``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.job import Job, with_flags
from tmmcalc.cli.messages import note_written
from tmmcalc.cli.options import Form, Format
from tmmcalc.cli.output import check_picture, show, title
from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.feasibility.maps import RegionMap
    from tmmcalc.report.drawing.shapes import Drawing


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    over: Annotated[
        list[str] | None,
        typer.Option(
            "--over",
            metavar="KEY=FROM:TO:N",
            help="Map the region over one or two values of the spec: 'loads[0].factor=0.5:2:16'.",
            show_default=False,
        ),
    ] = None,
    picture: Annotated[
        Path | None,
        typer.Option("--picture", metavar="FILE", help="Draw this map, by suffix svg, png or pdf.", show_default=False),
    ] = None,
    truth: Annotated[
        bool, typer.Option("--truth", help="The rule by plain logic: a short form, and all combinations of truths.")
    ] = False,
) -> None:
    """Constraints on results or given values: which hold, by how much, and whether the rule of [feasibility] does.

    With --over the scene is solved at every point of a grid of one or two of its values, and the region where the rule
    holds is told and drawn with the border of every constraint; no stage files are written. With --truth the rule is
    told by itself. With --strict a constraint that fails, or a map without a feasible point, ends with exit code 5.

    Example: tmmcalc feasibility my.toml --over 'synthesis.crank_rocker.time_ratio=1.05:1.5:19' --picture region.svg
    """
    if truth and over:
        remedy = "leave one of them out"
        raise UsageError("together with --over: a map has many combinations", where="--truth", remedy=remedy)
    if over:
        _map(job, form, over, picture)
        return
    if picture is not None:
        raise UsageError(
            "there is no map to draw", where="--picture", remedy="add --over, or: tmmcalc plot SPEC feasibility"
        )
    scene = job.spec()
    run = job.run(scene, "feasibility")
    result = run.results["feasibility"]
    if truth:
        from tmmcalc.feasibility.facts.truth import truth_document
        from tmmcalc.feasibility.truth import truth_table

        table = truth_table(result.rule, {verdict.name: verdict.holds for verdict in result.verdicts})
        told = truth_document(table, title(scene, job.file, "truth table"))
        show(told, form)
        job.close(told, run)
        return
    from tmmcalc.feasibility.facts.feasibility import document as feasibility_document

    job.finish(feasibility_document(result, title(scene, job.file, "feasibility")), run, form)


def _map(job: Job, form: Format, over: list[str], picture: Path | None) -> None:
    """Solve, draw and print the map."""
    _check_flags(job)
    if picture is not None:
        check_picture(picture, "--picture")
    result = _solved(job, over)
    if picture is not None:
        from tmmcalc.report.drawing import draw

        draw(picture, lambda: _drawing(result))
        if not job.quiet:
            note_written(picture)
    from tmmcalc.feasibility.facts.regions import region_document

    printed = region_document(result, f"{job.file.stem}: region", everything=form is not Format.table)
    show(printed, form)
    job.check_warnings(printed)


def _drawing(result: RegionMap) -> Drawing:
    from tmmcalc.feasibility.pictures.regions import region_drawing

    return region_drawing(result)


def _check_flags(job: Job) -> None:
    """Flags of stage files have no place where none is written."""
    given = {
        "--out": job.out,
        "--fresh": job.fresh,
        "--from": job.from_stage,
        "--csv": job.csv,
        "--depfile": job.depfile,
    }
    strange = [flag for flag, value in given.items() if value]
    if strange:
        raise UsageError(
            f"{' and '.join(strange)}: a map leaves no stage files", where="--over", remedy="leave one of them out"
        )


def _solved(job: Job, over: list[str]) -> RegionMap:
    from tmmcalc.batch.regions import map_feasibility

    if job.quiet or not sys.stderr.isatty():
        return map_feasibility(job.file, over, job.overrides)
    from tmmcalc.cli.progress import Progress

    with Progress() as progress:
        progress.start("feasibility")
        return map_feasibility(job.file, over, job.overrides)
