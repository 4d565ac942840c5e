"""Files that commands draw: their flags, what is checked before anything is computed, how they are made and written."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.messages import note_written
from tmmcalc.cli.output import check_place
from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.report.outlines import Outline

Files = Mapping[str, Path]  # by their flags

Svg = Annotated[Path | None, typer.Option("--svg", metavar="FILE", help="Write a drawing 1:1.", show_default=False)]
Dxf = Annotated[
    Path | None,
    typer.Option("--dxf", metavar="FILE", help="Write arcs and splines in mm (extra cad).", show_default=False),
]
Nc = Annotated[
    Path | None,
    typer.Option("--nc", metavar="FILE", help="Write points for a machine tool as CSV.", show_default=False),
]
Chord = Annotated[
    str | None,
    typer.Option("--tolerance", metavar="LENGTH", help="Of chords and cubics in the files.", show_default=False),
]


def files_of(**named: Path | None) -> dict[str, Path]:
    """The files that are asked for, by their flags.

    >>> list(files_of(svg=Path("cam.svg"), dxf=None))
    ['--svg']
    """
    return {f"--{name}": file for name, file in named.items() if file is not None}


def check_files(files: Files, idle: Mapping[str, bool], flags: str = "--svg, --dxf or --nc") -> None:
    """Refuse what would only come out after the computation: places where no file can be, flags without effect.

    ``idle`` says of the flags that need a file whether they are given, ``flags`` names those of files.
    """
    for flag, file in files.items():
        check_place(file, flag)
    if len({file.resolve() for file in files.values()}) < len(files):
        raise UsageError("one file cannot have two formats", where=", ".join(files), remedy="name two files")
    useless = ", ".join(flag for flag, given in idle.items() if given)
    if useless and not files:
        raise UsageError("there is no file to draw into", where=useless, remedy=f"add {flags}")
    if "--dxf" in files:
        from tmmcalc.report.outlinefiles import require_dxf

        require_dxf()


def contents_of(
    files: Files,
    heading: str,
    tolerance: float,
    outlines: Callable[[], Sequence[Outline]],
    points: Callable[[], bytes],
) -> dict[Path, bytes]:
    """The bytes of all files, made before the first of them is written.

    ``tolerance`` [m] sets the digits of an SVG; ``outlines`` are those of the drawings, ``points`` any other file.
    """
    from tmmcalc.report.outlinefiles import dxf, svg

    drawn = outlines() if {"--svg", "--dxf"} & files.keys() else ()
    made = {"--svg": lambda: svg(drawn, tolerance, heading), "--dxf": lambda: dxf(drawn)}
    return {file: made.get(flag, points)() for flag, file in files.items()}


def write_files(contents: Mapping[Path, bytes], quiet: bool) -> None:
    """Write the files, each in one step; one that has these bytes already is left alone."""
    from tmmcalc.core.atomic import replace_file

    for file, data in contents.items():
        replace_file(file, data)
    if contents and not quiet:
        note_written(*contents)
