"""``tmmcalc cam profile``."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.flags import with_flags
from tmmcalc.cli.messages import note_written
from tmmcalc.cli.options import Columns, Form, Format, Positions, patterns_of
from tmmcalc.cli.work import Job, check_place, title
from tmmcalc.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.cams.profile.results import Profile
    from tmmcalc.cams.task import CamTask


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    columns: Columns = None,
    positions: Positions = None,
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
    files = {flag: file for flag, file in (("--svg", svg), ("--dxf", dxf), ("--nc", nc)) if file is not None}
    check_files(files, tolerance)
    given = {"tool_radius": tool, "tolerance": tolerance}
    more = [f'cam.{key}="{value}"' for key, value in given.items() if value is not None]
    job = replace(job, overrides=[*job.overrides, *more])
    scene = job.spec()
    run = job.run(scene, "cam_profile")
    from tmmcalc.cli.positions import rows_of
    from tmmcalc.report.cams.profile import profile_document
    from tmmcalc.spec.cams import to_cam

    result, heading = run.results["cam_profile"], title(scene, job.file, "profile of the cam")
    document = profile_document(
        result,
        heading,
        patterns=patterns,
        rows=rows_of(positions, result.positions.labels),
        everything=form is not Format.table,
    )
    contents = _contents(result, to_cam(scene), files, heading) if files else {}
    job.finish(document, run, form)
    write_files(contents, job.quiet)


def check_files(files: dict[str, Path], tolerance: str | None) -> None:
    """Refuse flags without effect, and places where no file can be, before anything is computed."""
    for flag, file in files.items():
        check_place(file, flag)
    if len({file.resolve() for file in files.values()}) < len(files):
        raise UsageError("one file cannot have two formats", where=", ".join(files), remedy="name two files")
    if not files and tolerance is not None:
        raise UsageError("there is no file to draw into", where="--tolerance", remedy="add --svg, --dxf or --nc")
    if "--dxf" in files:
        from tmmcalc.report.outlinefiles import require_dxf

        require_dxf()


def _contents(result: Profile, task: CamTask, files: dict[str, Path], heading: str) -> dict[Path, bytes]:
    """The bytes of all files, made before the first of them is written."""
    from tmmcalc.report.camfiles import dxf, nc_table, outlines, svg

    made: dict[Path, bytes] = {}
    tolerance = task.asked.tolerance
    drawn = outlines(result, task.program, tolerance) if {"--svg", "--dxf"} & set(files) else ()
    for flag, file in files.items():
        if flag == "--svg":
            made[file] = svg(drawn, tolerance, heading)
        elif flag == "--dxf":
            made[file] = dxf(drawn)
        else:
            made[file] = nc_table(result, task.program, tolerance)
    return made


def write_files(contents: dict[Path, bytes], quiet: bool) -> None:
    """Write the files, each in one step; one that has these bytes already is left alone."""
    from tmmcalc.pipeline.atomic import replace_file

    for file, data in contents.items():
        replace_file(file, data)
    if contents and not quiet:
        note_written(*contents)
