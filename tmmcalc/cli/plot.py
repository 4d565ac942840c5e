"""``tmmcalc plot``."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmmcalc.cli.job import Job
from tmmcalc.cli.messages import note_written, say
from tmmcalc.cli.options import Language, Quiet, Set, SpecFile, language_of, written
from tmmcalc.cli.output import check_picture, raise_failures
from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.core.plan import plan
from tmmcalc.core.stage import Picture
from tmmcalc.report.drawing import draw
from tmmcalc.report.drawing.order import PHASE, POLYGONS, POSITIONS
from tmmcalc.report.rows import CHOOSE
from tmmcalc.rooms import STAGES

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec

SMALLEST, LARGEST = (180.0, 120.0), 3000.0  # paper of a picture [mm]
SIZE = re.compile(r"(\d+(?:\.\d+)?)\s*[x×*]\s*(\d+(?:\.\d+)?)")
WIDTH = 78  # of the list of pictures, which the help indents by two


PICTURES = {name: stage.picture for name, stage in STAGES.items() if stage.picture is not None}


def _drawn(incomplete: str) -> list[str]:
    """Stages with a picture that begin so, for the completion of the shell."""
    return [name for name in PICTURES if name.startswith(incomplete)]


def picture_of(stage: str, flags: Mapping[str, str | None]) -> Picture:
    """The picture of a stage; raises `UsageError` for a stage without one, and for flags that are not its own."""
    if stage not in PICTURES:
        raise UsageError(f"there is no picture of {stage!r}", where="plot", remedy=f"pictures: {', '.join(PICTURES)}")
    picture = PICTURES[stage]
    strange = [flag for flag, value in flags.items() if value is not None and flag not in picture.flags]
    if strange:
        own = f"its own flags: {', '.join(picture.flags)}" if picture.flags else "it has no flags of its own"
        raise UsageError(
            f"{' and '.join(strange)} cannot be used with the picture of {stage}", where="plot", remedy=own
        )
    return picture


def paper_of(size: str | None) -> dict[str, float]:
    """Width and height [mm] of the paper that ``--size`` gives, nothing without it; raises `UsageError`."""
    if size is None:
        return {}
    found = SIZE.fullmatch(size.strip())
    if found is None:
        raise UsageError(f"{size!r} is no size of paper", where="--size", remedy="write width x height in mm: 180x120")
    width, height = float(found[1]), float(found[2])
    if width < SMALLEST[0] or height < SMALLEST[1] or max(width, height) > LARGEST:
        least = f"{SMALLEST[0]:g} x {SMALLEST[1]:g}"
        raise UsageError(
            f"pictures stand on {least} to {LARGEST:g} x {LARGEST:g} mm",
            where="--size",
            remedy="write a size between them, such as 180x120",
        )
    return {"width": width, "height": height}


@contextmanager
def looking(scene: Spec, language: str | None, size: str | None = None) -> Iterator[None]:
    """Pictures that are drawn within are in this language and on this paper."""
    from tmmcalc.report.drawing.page import on_paper
    from tmmcalc.report.language import speaking

    with speaking(language_of(scene, language)), on_paper(**paper_of(size)):
        yield


def ordered(stage: str, spec: Spec, results: Mapping[str, Any], flags: Mapping[str, str | None], file: Path) -> None:
    """Draw the picture of a stage to a file."""
    from tmmcalc.pipeline.picturing import figure_of

    picture_of(stage, flags)
    draw(file, figure_of(stage, spec, results, flags))


def with_pictures(
    spec: Spec, run: RunResult, folder: Path, flags: Mapping[str, str | None] | None = None, *, quiet: bool = False
) -> RunResult:
    """The run with the picture of every stage that has one, ``folder/STAGE.svg``, among its files.

    Each takes of the ``flags`` those that are its own. One that cannot be drawn is told and stands among the failures.
    """
    from tmmcalc.cli.progress import described, seen

    given = dict.fromkeys((POSITIONS, POLYGONS, CHOOSE, PHASE), None) | dict(flags or {})
    files: list[Path] = []
    failures: dict[str, TmmError] = {}
    with seen(described(), quiet) as tell:
        for stage in [name for name in run.outcomes if name in PICTURES]:
            tell(f"drawing {stage}")
            own = {flag: value if flag in PICTURES[stage].flags else None for flag, value in given.items()}
            file = folder / f"{stage}.svg"
            try:
                ordered(stage, spec, run.results, own, file)
            except TmmError as error:
                failures[f"picture of {stage}"] = error
            else:
                files.append(file)
    for picture in failures:
        say(f"{picture}: not drawn: the error stands at the end", "red")
    return replace(run, files=(*run.files, *files), failures={**run.failures, **failures})


def command(
    spec: SpecFile,
    stage: Annotated[
        str | None,
        typer.Argument(
            help="Stage to draw, one of those above (default: kinematics).",
            metavar="STAGE",
            show_default=False,
            autocompletion=_drawn,
        ),
    ] = None,
    everything: Annotated[
        bool, typer.Option("--all", help="Draw every stage of the spec that has a picture, to an svg file each.")
    ] = False,
    out: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--out",
            metavar="FILE",
            help="Picture, by suffix svg, png, pdf or dxf (default: <spec>.svg); of --all their folder (default: "
            "<spec>.out).",
            show_default=False,
            callback=written,
        ),
    ] = None,
    positions: Annotated[
        str | None,
        typer.Option(POSITIONS, metavar="LIST", help="Positions of the scheme, the first bold: '7,0:24:2'."),
    ] = None,
    polygons: Annotated[
        str | None,
        typer.Option(POLYGONS, metavar="LIST", help="Add plans of velocities, or of forces, in positions: '4,9'."),
    ] = None,
    choose: Annotated[
        int | None,
        typer.Option(
            CHOOSE,
            metavar="N",
            min=1,
            help="What to draw, from 1: of train and criteria row N of gears compare (default: the chosen train), "
            "without [strength] tooth set N of gears synth; of synthesis solution N; of pair, blocking and profile "
            "pair N (default: all).",
            show_default=False,
        ),
    ] = None,
    phase: Annotated[
        str | None,
        typer.Option(
            PHASE,
            metavar="ANGLE",
            help="Turn of the pinion from the contact at P, of indexing cams from the step: '10 deg'.",
        ),
    ] = None,
    size: Annotated[
        str | None,
        typer.Option(
            "--size",
            metavar="WxH",
            help="Paper of the picture in mm, at which its scales hold: 180x120 (default: 297x210).",
            show_default=False,
        ),
    ] = None,
    language: Language = None,
    quiet: Quiet = False,
    overrides: Set = None,
) -> None:
    """Draw the result of a stage, or of --all; it is computed afresh, no stage files are read or written."""
    flags = {POSITIONS: positions, POLYGONS: polygons, CHOOSE: None if choose is None else str(choose), PHASE: phase}
    job = Job(spec, store=False, quiet=True, overrides=overrides or (), keep_going=everything)
    if everything:
        if stage is not None:
            raise UsageError(f"draws {stage} too", where="--all", remedy="leave one of the two out")
        scene = job.spec()
        with looking(scene, language, size):
            _draw_all(job, scene, out or Path(f"{spec.stem}.out"), flags, quiet)
        return
    stage = stage or "kinematics"
    picture = picture_of(stage, flags)
    file = out or Path(f"{spec.stem}.svg")
    check_picture(file, "plot")
    scene = job.spec()
    target = picture.beside if picture.beside and picture.beside in plan(scene).running else stage
    with looking(scene, language, size):
        run = job.run(scene, target)
        ordered(stage, run.spec, run.results, flags, file)
    if not quiet:
        note_written(file)


def _draw_all(job: Job, scene: Spec, folder: Path, flags: Mapping[str, str | None], quiet: bool) -> None:
    """Draw all pictures of a spec into a folder, which is made if it is not there."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise UsageError(f"{folder}: {error.strerror}", where="-o", remedy="name a folder") from None
    done = job.run(scene, None)
    run = with_pictures(done.spec, done, folder, flags, quiet=quiet)
    if run.files and not quiet:
        say(f"pictures in {folder}: {', '.join(file.name for file in run.files)}", "dim")
    raise_failures(run.failures)


def _list() -> str:
    """What the picture of every stage shows, a paragraph that the help leaves as it is."""
    from textwrap import wrap

    longest = max(map(len, PICTURES)) + 2
    lines = []
    for name, picture in PICTURES.items():
        lines += wrap(f"{name:<{longest}}{picture.shows}", WIDTH, subsequent_indent=" " * longest)
    return "\n".join(["\b", *lines])


command.__doc__ = f"""{command.__doc__}

{_list()}

Example: tmmcalc plot my.toml kinematics -o my.svg --polygons 4,9
"""
