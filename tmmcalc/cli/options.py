"""Flags that several commands share, each said once."""

from __future__ import annotations

import re
from collections.abc import Sequence
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.project import Spec

_COMMA = re.compile(r",(?![^\[(]*[\])])")  # outside of brackets
LONGEST = 200  # characters of a name of --columns; those of columns have some thirty


class Format(StrEnum):
    """Format of what is printed."""

    table = "table"
    csv = "csv"
    json = "json"
    toml = "toml"
    xlsx = "xlsx"  # into a file


def available(form: Format) -> Format:
    """The format itself; raises `UsageError` before anything is computed if what writes it is not installed."""
    if form is Format.xlsx:
        from tmmcalc.report.workbook import check_xlsxwriter

        check_xlsxwriter()
    return form


def stages(incomplete: str) -> list[str]:
    """Stages that begin so, for the completion of the shell."""
    from tmmcalc.rooms import STAGES

    return [name for name in STAGES if name.startswith(incomplete)]


STANDARD_OUTPUT = Path("-")


def printed(out: Path | None) -> Path | None:
    """The file of ``-o`` of what is printed without it: ``-`` is standard output, as elsewhere."""
    return None if out == STANDARD_OUTPUT else out


def check_named(file: Path | None, where: str) -> None:
    """Raise UsageError for ``-``, which elsewhere is standard output, and here would name a file or a folder."""
    if file == STANDARD_OUTPUT:
        rule = "- is standard output, and what is written here is files"
        raise UsageError(rule, where=where, remedy="name a file or a folder, or leave the flag out")


def written(out: Path | None) -> Path | None:
    """The file or the folder of ``-o`` of what is not printed."""
    check_named(out, "-o")
    return out


SpecFile = Annotated[Path, typer.Argument(help="Project spec (TOML).", metavar="SPEC", show_default=False)]
Form = Annotated[
    Format,
    typer.Option("--format", "-f", help="Format of what is printed; xlsx goes to a file.", callback=available),
]
Out = Annotated[
    Path | None,
    typer.Option(
        "-o",
        "--out",
        metavar="FOLDER",
        help="Folder of the stage files (default: <spec>.out here); with -f xlsx also FILE.xlsx.",
        show_default=False,
        callback=written,
    ),
]
Store = Annotated[
    bool, typer.Option("--store/--no-store", help="Write the stage files, and load those that are valid.")
]
Fresh = Annotated[bool, typer.Option("--fresh", help="Compute all stages, whatever is stored.")]
FromStage = Annotated[
    str | None,
    typer.Option(
        "--from",
        metavar="STAGE",
        help="Compute this stage and all after it.",
        show_default=False,
        autocompletion=stages,
    ),
]
Csv = Annotated[
    bool | None,
    typer.Option(
        "--csv/--no-csv",
        help="Write CSV files (default: up to 2000 rows), or remove old ones.",
        show_default=False,
    ),
]
Depfile = Annotated[
    Path | None,
    typer.Option(
        "--depfile",
        metavar="FILE",
        help="Write a Makefile rule: the stage files need the spec and its files.",
        show_default=False,
    ),
]
Columns = Annotated[
    str | None,
    typer.Option(
        "--columns", metavar="NAMES", help="Columns by name, with wildcards: 'phi,x_*,omega_3'.", show_default=False
    ),
]
Skip = Annotated[
    list[str] | None,
    typer.Option(
        "--skip",
        metavar="STAGE",
        help="Leave this stage out, and all that read it; may be repeated.",
        show_default=False,
        autocompletion=stages,
    ),
]
Jobs = Annotated[
    int | None,
    typer.Option(
        "--jobs", "-j", metavar="N", min=1, help="Local processes (default: as many as pay).", show_default=False
    ),
]
Scheduler = Annotated[
    str | None,
    typer.Option("--scheduler", metavar="ADDRESS", help="Solve on this Dask cluster.", show_default=False),
]
Positions = Annotated[
    str | None,
    typer.Option("--positions", metavar="LIST", help="Positions to show: '0,6,18' or '0:24:2'.", show_default=False),
]
Strict = Annotated[bool, typer.Option("--strict", help="Fail with exit code 5 if there is a warning.")]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="Only warnings and errors on standard error.")]


def _known_language(language: str | None) -> str | None:
    if language is not None:
        from tmmcalc.report.language import speaking

        with speaking(language):
            pass
    return language


def language_of(scene: Spec, language: str | None) -> str:
    """The language of what is drawn: that of the flag, or of the spec."""
    return language or (scene.sheets.language if scene.sheets is not None else "en")


def spoken_in(scene: Spec, language: str | None) -> str:
    """The language of what is written for people: that of the flag, of [note], or of what is drawn."""
    return language or (scene.note.language if scene.note is not None else None) or language_of(scene, None)


Language = Annotated[
    str | None,
    typer.Option(
        "--language",
        metavar="LANGUAGE",
        help="Language of what is drawn: en or uk (default: that of [sheets], or en).",
        show_default=False,
        callback=_known_language,
    ),
]
Wait = Annotated[
    float | None,
    typer.Option(
        "--wait",
        metavar="SECONDS",
        min=0,
        help="Wait so long for another process that works in the folder (default: 60).",
        show_default=False,
    ),
]
Verbose = Annotated[
    bool,
    typer.Option("--verbose", "-v", help="Tell every stage with its time, those that are left out, and all files."),
]
Tolerance = Annotated[
    float | None,
    typer.Option(
        "--tolerance",
        metavar="ERROR",
        help=(
            "Relative error asked of every stage: the cheapest methods for it; exit code 4 if one is not that exact "
            "(the data taken as exact: what their last digit does is told apart)."
        ),
        show_default=False,
    ),
]


def overrides(given: list[str] | None) -> list[str] | None:
    """The overrides, with those of a row in place of ``@FILE:ROW``."""
    if not given or not any(each.startswith("@") for each in given):
        return given
    from tmmcalc.batch.table import row_of

    found: list[str] = []
    for each in given:
        file, _, name = each.removeprefix("@").rpartition(":")
        found += row_of(Path(file), name) if each.startswith("@") else [each]
    return found


Set = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="KEY=VALUE",
        help="Override a value of the spec, or by @FILE:ROW all of a CSV's row; may be repeated.",
        show_default=False,
        callback=overrides,
    ),
]


def patterns_of(columns: str | None) -> list[str]:
    """Names and wildcards of --columns; empty if all columns are meant."""
    if columns is None:
        return []
    names = [name.strip() for name in columns.split(",")]
    if not any(names):
        raise UsageError("no column is named", where="--columns", remedy="write e.g. --columns 'phi,x_*'")
    long = next((name for name in names if len(name) > LONGEST), None)
    if long is not None:  # a search for its wildcards would take the square of its length
        raise UsageError(
            f"'{long[:40]} ...' is longer than {LONGEST} characters",
            where="--columns",
            value=len(long),
            limit=LONGEST,
            remedy="separate names by commas: --columns 'phi,x_*'",
        )
    return [name for name in names if name]


def names_of(given: Sequence[str] | None, flag: str) -> list[str]:
    """What a flag that may be repeated names, with commas between; those in brackets are part of a name.

    >>> names_of(["forces.max(R_A),motion.delta", "kinematics.stroke_D"], "--of")
    ['forces.max(R_A)', 'motion.delta', 'kinematics.stroke_D']
    """
    found = [part.strip() for each in given or () for part in _COMMA.split(each)]
    if not all(found):
        raise UsageError("a name is missing", where=flag, remedy="write names with commas between them")
    return found
