"""``tmmcalc gears profile``."""

from __future__ import annotations

from dataclasses import replace
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmmcalc.cli.exporting import Dxf, Svg, files_of, write_files
from tmmcalc.cli.gears.drawn import Drawn, angle_of, check_flags, drawn_bytes, length_of, tracks_of
from tmmcalc.cli.gears.known import check_wheel, of_wheel
from tmmcalc.cli.job import Job, with_flags
from tmmcalc.cli.options import Form, Format
from tmmcalc.cli.output import title
from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record

if TYPE_CHECKING:
    from collections.abc import Sequence

    from tmmcalc.gears.meshing.members import Member, Toothed
    from tmmcalc.gears.meshing.profiles import Profiles
    from tmmcalc.gears.meshing.results import Pairs
    from tmmcalc.gears.model import Values
    from tmmcalc.gears.single.results import SingleWheel
    from tmmcalc.pipeline.outcome import RunResult

INTERVALS = 10  # of a table
ROWS = 10_000  # of --fillet and --rolls


@record
class Rolls:
    """Roll angles [rad] of the tables; None: equal steps."""

    main: Values | None
    fillet: Values | None


class AxisChoice(StrEnum):
    """Where the axis Y of the tables runs."""

    tooth = "tooth"
    space = "space"
    pitch = "pitch"
    reference = "reference"


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    wheel: Annotated[
        str | None,
        typer.Option("--wheel", metavar="NAME", help="One wheel: 2', or PAIR/2' (default: all).", show_default=False),
    ] = None,
    points: Annotated[
        int | None,
        typer.Option("--points", metavar="N", min=3, help="Points of each curve of the profile.", show_default=False),
    ] = None,
    axis: Annotated[
        AxisChoice | None,
        typer.Option("--axis", help="Axis Y of the tables (default: tooth).", show_default=False),
    ] = None,
    intervals: Annotated[
        int | None,
        typer.Option(
            "--intervals", metavar="N", min=2, max=ROWS, help="Steps of the tables (default: 10).", show_default=False
        ),
    ] = None,
    fillet: Annotated[
        str | None,
        typer.Option(
            "--fillet",
            metavar="FB:FE:STEP",
            help="Roll angles in rad of the fillet's table.",
            show_default=False,
        ),
    ] = None,
    rolls: Annotated[
        str | None,
        typer.Option(
            "--rolls",
            metavar="FIRST:LAST:STEP",
            help="Roll angles in rad of the main profile's table.",
            show_default=False,
        ),
    ] = None,
    svg: Svg = None,
    dxf: Dxf = None,
    outline: Annotated[
        Path | None,
        typer.Option("--outline", metavar="FILE", help="Write points of the outline as CSV.", show_default=False),
    ] = None,
    tolerance: Annotated[
        str | None,
        typer.Option(
            "--tolerance",
            metavar="LENGTH",
            help="Of chords and cubics in the files (default: 1e-4 of the module).",
            show_default=False,
        ),
    ] = None,
    whole: Annotated[bool, typer.Option("--whole/--tooth", help="Whole wheels in the files, or one tooth.")] = True,
    phase: Annotated[
        str | None,
        typer.Option(
            "--phase", metavar="ANGLE", help="Turn of the first wheel, of pairs in mesh: '5 deg'.", show_default=False
        ),
    ] = None,
) -> None:
    """Tooth profiles: involute and fillet of every wheel, radii of curvature, the textbook's tables, drawings.

    Files hold pairs in mesh, contact at the pitch point at --phase 0; with --wheel, and of a [wheel] without
    a mate, one wheel, a tooth on +Y. The table
    is in mm; --format csv, json or toml prints metres: all points, or with a flag of the tables these.

    Example: tmmcalc gears profile my.toml --wheel 1 --axis pitch --svg wheel.svg
    """
    drawn = Drawn(
        files_of(svg=svg, dxf=dxf, outline=outline),
        None if tolerance is None else length_of(tolerance, "--tolerance", "1 um"),
        whole,
        angle_of(phase),
    )
    check_flags(drawn, wheel, tolerance, phase)
    at = Rolls(
        *(None if text is None else _rolls(text, flag) for text, flag in ((rolls, "--rolls"), (fillet, "--fillet")))
    )
    scene = job.spec()
    single = of_wheel(scene, None, None, wheel)
    _check_mate(single, axis, phase)
    check_wheel(scene, wheel)
    table = "wheel" if single else "pair"
    if points is not None and (single or scene.pair is not None):
        job = replace(job, overrides=[*job.overrides, f"{table}.points={points}"])
        scene = job.spec()
    run = job.run(scene, "wheel" if single else "profile")
    heading = title(scene, job.file, "tooth profile" if single else "tooth profiles")
    result, chosen = _profile_of_wheel(run.results["wheel"]) if single else _profiles_of_pairs(run, wheel)
    asked = any(flag is not None for flag in (axis, intervals, fillet, rolls))
    everything = form is not Format.table
    document = _document(
        result, heading, chosen, (axis or AxisChoice.tooth).value, intervals or INTERVALS, at, everything, asked
    )
    pairs = None if single or wheel else run.results["pair"]
    contents = drawn_bytes(tracks_of(pairs, chosen, drawn), drawn, heading)
    job.finish(document, run, form)
    write_files(contents, job.quiet)


def _rolls(text: str, flag: str) -> Values:
    """FIRST, FIRST + STEP, ... up to LAST."""
    import numpy as np

    try:
        first, last, step = (float(piece) for piece in text.split(":"))
    except ValueError:
        raise _bad_rolls(flag, f"{text!r} is not first:last:step") from None
    if not (np.isfinite([first, last, step]).all() and step > 0 and last >= first):
        raise _bad_rolls(flag, f"{text!r} has to run upward in steps above zero")
    count = (last - first) / step
    if count > ROWS:
        raise _bad_rolls(flag, f"{text!r} has more than {ROWS} rows")
    return np.round(first + step * np.arange(int(count + 1e-9) + 1), 12)


def _bad_rolls(flag: str, message: str) -> UsageError:
    return UsageError(message, where=flag, remedy=f"write roll angles in rad, e.g. {flag}=-0.5:0.1:0.05")


def _check_mate(single: bool, axis: AxisChoice | None, phase: str | None) -> None:
    """A wheel without a mate has no operating pitch circle, and nothing to be in mesh with."""
    if single and axis is AxisChoice.pitch:
        raise UsageError("a wheel without a mate has no operating pitch circle", where="--axis", remedy="tooth, space")
    if single and phase is not None:
        raise UsageError("a wheel without a mate is not in mesh", where="--phase", remedy="leave it out")


def _profile_of_wheel(found: SingleWheel) -> tuple[Profiles, tuple[Toothed, ...]]:
    from tmmcalc.gears.facts.wheel import profiles_of
    from tmmcalc.gears.single.member import SingleMember

    return profiles_of(found), (SingleMember(found.task),)


def _profiles_of_pairs(run: RunResult, wheel: str | None) -> tuple[Profiles, tuple[Toothed, ...]]:
    return run.results["profile"], _chosen(run.results["pair"], wheel)


def _chosen(pairs: Pairs, wheel: str | None) -> tuple[Member, ...]:
    """The wheels of that name, or all."""
    from tmmcalc.gears.meshing.members import members

    every = members(pairs)
    if wheel is None:
        return every
    found = tuple(member for member in every if wheel in (member.name, member.label))
    if not found:
        labels = ", ".join(member.label for member in every)
        raise UsageError(f"there is no wheel {wheel!r}", where="--wheel", remedy=f"wheels: {labels}")
    return found


def _document(
    result: Profiles,
    heading: str,
    chosen: Sequence[Toothed],
    axis: Any,
    intervals: int,
    at: Rolls,
    everything: bool,
    asked: bool,
) -> Any:
    """Facts and tables of the chosen wheels that have a profile."""
    from tmmcalc.gears.facts.profile import document as profile_document
    from tmmcalc.gears.facts.profile import label_of
    from tmmcalc.gears.meshing.booktables import book_tables

    sound = {label_of(wheel) for wheel in result.wheels}
    tables = [
        table
        for member in chosen
        if member.label in sound and (table := book_tables(member, axis, intervals, at.fillet, at.main)) is not None
    ]
    wanted = [member.label for member in chosen]
    return profile_document(result, heading, tables, wanted=wanted, everything=everything, asked=asked)
