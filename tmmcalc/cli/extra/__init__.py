"""``tmmcalc extra``: the group of small calculators of neighbouring fields."""

from __future__ import annotations

import typer

from tmmcalc.cli.commands import EXTRA
from tmmcalc.cli.late import LateGroup


class Extra(LateGroup):
    """The small calculators."""

    table = EXTRA


group = typer.Typer(
    cls=Extra,
    rich_markup_mode=None,
    no_args_is_help=True,
    add_completion=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


@group.callback(epilog="Example: tmmcalc extra contact my.toml")
def extra() -> None:
    """Small calculators: elastic contact, reliability, tie-down of loads, a falling ball, rolling bearings."""
