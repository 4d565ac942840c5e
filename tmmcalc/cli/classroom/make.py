"""``tmmcalc class make``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmmcalc.cli.messages import note_written, warn
from tmmcalc.cli.options import Form, Format, Quiet, SpecFile
from tmmcalc.cli.output import show, title
from tmmcalc.cli.progress import seen, told_with
from tmmcalc.core.errors import UsageError
from tmmcalc.core.files import other_kind

Folder = Annotated[Path, typer.Option("-o", "--out", metavar="DIR", help="Folder of the class.")]


def command(
    spec: SpecFile,
    count: Annotated[
        int | None,
        typer.Option(
            "-n",
            "--count",
            metavar="N",
            min=1,
            max=1000,
            help="Variants in all (default: one for each of the roster).",
            show_default=False,
        ),
    ] = None,
    seed: Annotated[
        int | None,
        typer.Option(
            "--seed",
            metavar="N",
            min=0,
            max=2**31 - 1,
            help="Of the draws: the same seed, the same variants (default: that of the class, else 1).",
            show_default=False,
        ),
    ] = None,
    out: Folder = Path("class"),
    jobs: Annotated[
        int | None,
        typer.Option(
            "--jobs", "-j", metavar="N", min=1, help="Local processes (default: as many as pay).", show_default=False
        ),
    ] = None,
    skip: Annotated[
        bool,
        typer.Option(
            "--skip-mistakes",
            help="Do not look for known mistakes that give a right answer, which takes most of the time.",
        ),
    ] = False,
    fresh: Annotated[bool, typer.Option("--fresh", help="Draw all variants anew, whatever is given out.")] = False,
    form: Form = Format.table,
    quiet: Quiet = False,
) -> None:
    """Draw variants of an assignment by [class] of the spec: each solved, round, and unlike the others.

    Every variant assembles, turns fully, has a result in all stages and no warning that the assignment itself has not,
    keeps [[constraints]] by a margin, and is apart from all others; no known mistake gives its right answers, but those
    that are told. The folder gets class.toml (who has what),
    class.csv (the numbers of all), and a spec each in variants/. Asked again with more students or a larger N it draws
    what is missing; what is given out stays as it is.

    Example: tmmcalc class make assignment.toml -n 40 --seed 7 -o class
    """
    if kind := other_kind(out):
        if kind != "a folder":
            raise UsageError(f"{out} is {kind}", where="-o", remedy="name a folder")
    elif out.exists():
        raise UsageError(f"{out} is a file", where="-o", remedy="name a folder")
    from tmmcalc.classroom.clashing import clashes_of
    from tmmcalc.classroom.document import class_document
    from tmmcalc.classroom.making import make_class
    from tmmcalc.project import load_spec

    with seen(told_with("variants"), quiet) as told:
        clashes = None if skip else clashes_of
        made = make_class(spec, out, count, seed, fresh=fresh, jobs=jobs, clashes=clashes, tell=warn, told=told)
    show(class_document(made, title(load_spec(spec), spec, "class")), form)
    if not quiet:
        for file in made.files[-2:]:
            note_written(file)
