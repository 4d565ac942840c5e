"""``tmmcalc check``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmmcalc.cli.messages import put, show_error
from tmmcalc.cli.options import Set
from tmmcalc.errors import TmmError


def command(
    specs: Annotated[list[Path], typer.Argument(help="Project specs (TOML).", metavar="SPEC", show_default=False)],
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Say nothing of specs without faults.")] = False,
    overrides: Set = None,
) -> None:
    """Check specs: every fault of every file, with its line, at once. Exit code 2 if there is any.

    Example: tmmcalc check variants/*.toml
    """
    from tmmcalc.spec import load_spec

    code = 0
    for file in specs:
        try:
            spec = load_spec(file, overrides or ())
        except TmmError as error:
            show_error(error)
            code = error.exit_code
            continue
        if not quiet:
            mechanism = spec.mechanism
            put(f"{file}: ok ({len(mechanism.links)} moving links, {len(mechanism.joints)} joints)\n")
    raise typer.Exit(code)
