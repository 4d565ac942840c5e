"""``tmmcalc cam``: the group of commands for cams."""

from __future__ import annotations

import typer

from tmmcalc.cli.commands import CAM
from tmmcalc.cli.late import LateGroup


class Cam(LateGroup):
    """The commands for cams."""

    table = CAM


group = typer.Typer(
    cls=Cam,
    rich_markup_mode=None,
    no_args_is_help=True,
    add_completion=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


@group.callback(epilog="Example: tmmcalc cam synth my.toml")
def cam() -> None:
    """Cams: laws of motion, sizes, profiles, forces, strength, the lowest mechanism."""
