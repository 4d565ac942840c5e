"""``tmmcalc cam profile``."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.exporting import Chord, Dxf, Files, Nc, Svg, check_files, contents_of, files_of, write_files
from tmmcalc.cli.job import Job, with_flags
from tmmcalc.cli.options import Columns, Form, Format, Positions, patterns_of
from tmmcalc.cli.output import table_file, title

if TYPE_CHECKING:
    from pathlib import Path

    from tmmcalc.cams.profile.results import Profile
    from tmmcalc.cams.task import CamTask


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    columns: Columns = None,
    positions: Positions = None,
    svg: Svg = None,
    dxf: Dxf = None,
    nc: Nc = None,
    tolerance: Chord = None,
    tool: Annotated[
        str | None,
        typer.Option("--tool", metavar="RADIUS", help="Radius of the cutter or grinding wheel.", show_default=False),
    ] = None,
) -> None:
    """Pitch curve, walls and tool paths with their curvature; undercut, self-crossing, the largest roller and tool.

    The table is in mm; --format csv, json or toml prints metres. --nc follows the tool where one is given.

    Example: tmmcalc cam profile my.toml --tool "20 mm" --svg cam.svg --nc cam.csv
    """
    patterns = patterns_of(columns)
    files = files_of(svg=svg, dxf=dxf, nc=nc)
    check_files(files, {"--tolerance": tolerance is not None})
    given = {"tool_radius": tool, "tolerance": tolerance}
    more = [f'cam.{key}="{value}"' for key, value in given.items() if value is not None]
    job = replace(job, overrides=[*job.overrides, *more])
    scene = job.spec()
    run = job.run(scene, "cam_profile")
    from tmmcalc.cams.facts.cam_profile import document as profile_document
    from tmmcalc.cams.further import of_profile
    from tmmcalc.cams.tables.tasks.cam import to_cam
    from tmmcalc.report.rows import rows_of

    result, heading = run.results["cam_profile"], title(scene, job.file, "profile of the cam")
    document = profile_document(
        result,
        heading,
        patterns=patterns,
        rows=rows_of(positions, result.positions.labels),
        everything=form is not Format.table,
        where=table_file(run, "cam_profile"),
        further=of_profile(scene, run.results) if patterns else (),
    )
    contents = _contents(result, to_cam(scene), files, heading) if files else {}
    job.finish(document, run, form)
    write_files(contents, job.quiet)


def _contents(result: Profile, task: CamTask, files: Files, heading: str) -> dict[Path, bytes]:
    from tmmcalc.cams.files.profile import nc_table, outlines

    given = result, task.program, task.asked.tolerance
    return contents_of(files, heading, task.asked.tolerance, lambda: outlines(*given), lambda: nc_table(*given))
