"""``tmmcalc sensitivity``."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from typing import Annotated

import typer

from tmmcalc.cli.messages import say
from tmmcalc.cli.options import Form, Format, Quiet, Set, SpecFile
from tmmcalc.cli.output import show
from tmmcalc.core.errors import UsageError

_COMMA = re.compile(r",(?![^\[]*\])")  # outside of brackets


def command(
    spec: SpecFile,
    of: Annotated[
        list[str],
        typer.Option(
            "--of",
            metavar="NAMES",
            help="Results by name, with wildcards: 'kinematics.stroke_D,forces.max(R_A)'. May be repeated.",
            show_default=False,
        ),
    ],
    to: Annotated[
        list[str] | None,
        typer.Option(
            "--to",
            metavar="KEYS",
            help="Keys of the spec, with wildcards: 'mechanism.links*mass' (default: all its numbers). May be "
            "repeated.",
            show_default=False,
        ),
    ] = None,
    jobs: Annotated[
        int | None,
        typer.Option(
            "--jobs",
            "-j",
            metavar="N",
            min=1,
            help="Local processes (default: one, or all cores where that pays).",
            show_default=False,
        ),
    ] = None,
    scheduler: Annotated[
        str | None,
        typer.Option("--scheduler", metavar="ADDRESS", help="Solve on this Dask cluster.", show_default=False),
    ] = None,
    form: Form = Format.table,
    quiet: Quiet = False,
    overrides: Set = None,
) -> None:
    """Derivatives of results with respect to the numbers of a spec: which of them matters, by how much.

    Of every result the keys are ranked by what one per cent of them does. A kink is told with both sides, a jump as
    such; where steps end without a solution this is told, and where no straight line stands for the result.

    Example: tmmcalc sensitivity my.toml --of 'kinematics.stroke_D,forces.max(R_A)' --to 'mechanism.links*'
    """
    from tmmcalc.design.sensitivity import sensitivity
    from tmmcalc.design.sensitivity_document import sensitivity_document, tidy_sensitivity

    names, keys = _listed(of, "--of"), _listed(to or (), "--to")
    with _progress(quiet) as shown:
        found = sensitivity(
            spec, names, keys, overrides or (), jobs=jobs, scheduler=scheduler, tell=_warn, progress=shown
        )
    title = f"{spec.stem}: sensitivity"
    make = sensitivity_document if form is Format.table else tidy_sensitivity
    show(make(found, title), form)


def _listed(given: list[str] | tuple[str, ...], flag: str) -> list[str]:
    """What a flag names, with commas between or repeated."""
    found = [part.strip() for each in given for part in _COMMA.split(each)]
    if given and not all(found):
        raise UsageError("a name is missing", where=flag, remedy="write names with commas between them")
    return found


def _warn(text: str) -> None:
    say(f"warning: {text}", "yellow")


def _progress(quiet: bool) -> AbstractContextManager[Callable[[int, int], None]]:
    if quiet or not sys.stderr.isatty():
        return nullcontext(lambda done, count: None)
    from tmmcalc.cli.progress import growing

    return growing("variants")
