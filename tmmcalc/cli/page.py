"""``tmmcalc page``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from tmmcalc.cli.job import Job
from tmmcalc.cli.messages import note_written
from tmmcalc.cli.options import STANDARD_OUTPUT, Fresh, Language, Quiet, Set, SpecFile, Store, language_of
from tmmcalc.cli.output import raise_failures


def command(
    spec: SpecFile,
    out: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--out",
            metavar="FILE",
            help="The page; '-' prints it (default: <spec>.html).",
            show_default=False,
        ),
    ] = None,
    positions: Annotated[
        int,
        typer.Option("--positions", min=24, max=3600, help="Positions that the page solves over the cycle."),
    ] = 360,
    language: Language = None,
    store: Store = True,
    fresh: Fresh = False,
    quiet: Quiet = False,
    overrides: Set = None,
) -> None:
    """Write a page in which the machine moves: one HTML file that needs no network.

    The mechanism turns, or is turned by hand; diagrams, facts and warnings of all stages stand beside it, in both
    languages. Facts are those of the spec's own positions; what moves is solved anew at many.

    Example: tmmcalc page my.toml -o my.html
    """
    from tmmcalc.page.content import content
    from tmmcalc.page.document import document
    from tmmcalc.project.found import text_of

    job = Job(spec, store=store, fresh=fresh, quiet=quiet, overrides=overrides or (), keep_going=True, csv=False)
    scene = job.spec()
    run = job.run(scene, None)
    with run.believed():
        written = document(content(run, text_of(scene), language_of(scene, language), positions)).encode()
    if out == STANDARD_OUTPUT:
        sys.stdout.buffer.write(written)
    else:
        from tmmcalc.core.atomic import replace_file

        file = out or Path(f"{spec.stem}.html")
        replace_file(file, written)
        if not quiet:
            note_written(file)
    raise_failures(run.failures)
