"""The typer application. A command's module is imported when that command runs, not for ``--help``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.commands import SECTIONS
from tmmcalc.cli.deferred import deferred_group


def _version(asked: bool) -> None:
    if asked:
        from tmmcalc._version import __version__

        typer.echo(f"tmmcalc {__version__}")
        raise typer.Exit


def tmmcalc(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version and leave.")
    ] = False,
) -> None:
    """Course-project calculator for the Theory of Mechanisms and Machines: one TOML spec, checked layers.

    Exit codes: 0 done, 2 bad input or usage, 3 the mechanism has no solution there, 4 accuracy not reached,
    5 a limit exceeded under --strict, 1 a fault of the program itself.
    """


BRIEF = """\
tmmcalc: the calculator for a course project in the Theory of Mechanisms and
Machines. One TOML file, the spec, holds the task; each command solves a part.

  tmmcalc init --list             lists ready specs, one to begin with
  tmmcalc init shaper -o my.toml  writes one of them into a file
  tmmcalc run my.toml             solves all of it: tables in the folder my.out
  tmmcalc plan my.toml            tells what is solved, what is not, and why

All commands: tmmcalc -h. Flags of one: tmmcalc run -h."""

app = deferred_group(
    SECTIONS,
    "tmmcalc init shaper -o my.toml && tmmcalc run my.toml",
    brief=BRIEF,
    callback=tmmcalc,
    pretty_exceptions_enable=False,
)
