"""``tmmcalc page``."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import replace
from itertools import repeat
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.job import Job
from tmmcalc.cli.messages import note_written
from tmmcalc.cli.options import STANDARD_OUTPUT, Fresh, Language, Quiet, Set, Store, language_of
from tmmcalc.cli.output import check_folders, raise_failures
from tmmcalc.cli.progress import described, seen
from tmmcalc.core.errors import TmmError, UsageError

if TYPE_CHECKING:
    from tmmcalc.page.content import Variant
    from tmmcalc.page.said import Said
    from tmmcalc.project import Spec


def command(
    specs: Annotated[list[Path], typer.Argument(help="Project spec (TOML), or several to compare.", metavar="SPEC...")],
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
    sweep: Annotated[
        Path | None,
        typer.Option(
            "--sweep",
            metavar="FILE",
            help="CSV of tmmcalc sweep: its variants overlaid, with the swept key as a slider.",
            show_default=False,
        ),
    ] = None,
    language: Language = None,
    store: Store = True,
    fresh: Fresh = False,
    quiet: Quiet = False,
    overrides: Set = None,
) -> None:
    """Write a page in which the machine moves: one HTML file that needs no network.

    The mechanism turns, or is turned by hand; diagrams, facts and warnings of all stages stand beside it, in both
    languages. Facts are those of the spec's own positions; what moves is solved anew at many. Several specs, or the
    variants of a sweep, are overlaid in the diagrams.

    Example: tmmcalc page my.toml -o my.html
    """
    from tmmcalc.page.content import Variant, content
    from tmmcalc.page.document import document
    from tmmcalc.page.swept import swept
    from tmmcalc.project.found import text_of

    if sweep is not None and len(specs) > 1:
        raise UsageError("a sweep is of one spec", where="--sweep", remedy="name one spec, or leave --sweep out")
    if store:
        check_folders(specs)
    own = tuple(overrides or ())
    wanted: list[tuple[Said, Path, tuple[str, ...]]] = [*zip(_names(specs), specs, repeat(own))]
    key = ""
    if sweep is not None:
        found = swept(sweep)
        key = found.key
        wanted = [(name, specs[0], (*own, *more)) for name, more in found.variants]
    job = Job(specs[0], store=store and sweep is None, fresh=fresh, quiet=quiet, keep_going=True, csv=False)
    jobs = [replace(job, file=spec, overrides=changed) for _, spec, changed in wanted]
    names = [name if isinstance(name, str) else name[0] for name, *_ in wanted]
    scenes = _read(names, jobs)
    variants: list[Variant] = []
    failures: list[tuple[str, TmmError]] = []
    with seen(described(), quiet) as show:
        for called, (name, *_), each, scene in zip(names, wanted, jobs, scenes, strict=True):
            show(f"solving {called}")
            run = each.run(scene, None)
            variants.append(Variant(name, run, text_of(scene)))
            failures += [(called, error) for error in run.failures.values()]
        show("drawing")
        spoken = language_of(variants[0].run.spec, language)
        title = " – ".join(dict.fromkeys(each.run.spec.project.title for each in variants))
        with job.believed():
            written = document(content(variants, title, key, spoken, positions)).encode()
    if out == STANDARD_OUTPUT:
        sys.stdout.buffer.write(written)
    else:
        from tmmcalc.core.atomic import replace_file

        file = out or Path(f"{specs[0].stem}.html")
        replace_file(file, written)
        if not quiet:
            note_written(file)
    _raise(failures, several=len(jobs) > 1)


def _names(specs: Sequence[Path]) -> list[str]:
    """Of each spec the name of its file, with as many folders as tell it from others of this name.

    >>> _names([Path("a/b/my.toml"), Path("a/c/my.toml"), Path("a/c/other.toml")])
    ['b/my', 'c/my', 'other']
    """
    places = [spec.resolve().with_suffix("").parts for spec in specs]
    found = []
    for place in places:
        same = {each for each in places if each[-1] == place[-1]}
        depth = next(k for k in range(1, 1 + len(place)) if len({each[-k:] for each in same}) == len(same))
        found.append("/".join(place[-depth:]))
    return found


def _read(names: Sequence[str], jobs: Sequence[Job]) -> list[Spec]:
    """The specs, before any is solved; the faults of all are said."""
    scenes: list[Spec] = []
    failures: list[tuple[str, TmmError]] = []
    for name, job in zip(names, jobs, strict=True):
        try:
            scenes.append(job.spec())
        except TmmError as error:
            failures.append((name, error))
    _raise(failures, several=len(jobs) > 1)
    return scenes


def _raise(failures: Sequence[tuple[str, TmmError]], *, several: bool) -> None:
    """End with the errors, each with its variant, if there are any; of several variants it is said whose each is."""
    for name, error in failures:
        if several:
            error.where = f"variant {name}: {error.where}" if error.where else f"variant {name}"
    raise_failures({str(k): error for k, (_, error) in enumerate(failures)})
