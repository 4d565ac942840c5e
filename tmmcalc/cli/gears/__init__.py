"""``tmmcalc gears``: the group of commands for gears."""

from __future__ import annotations

import typer

from tmmcalc.cli.commands import GEARS
from tmmcalc.cli.late import LateGroup


class Gears(LateGroup):
    """The commands for gears."""

    table = GEARS


group = typer.Typer(
    cls=Gears,
    rich_markup_mode=None,
    no_args_is_help=True,
    add_completion=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


@group.callback(epilog="Example: tmmcalc gears synth my.toml")
def gears() -> None:
    """Gears: tooth numbers of trains within all constraints, strength, pairs, contours, tooth profiles, measures."""
