"""The typer application. A command's module is imported when that command runs, not for ``--help``."""

from __future__ import annotations

from importlib import import_module
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from tmmcalc.cli.commands import COMMANDS


class LateGroup(TyperGroup):
    """A group whose commands are loaded late from the static table."""

    def list_commands(self, ctx: Any) -> list[str]:
        """Names in the order of work."""
        return list(COMMANDS)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        """Import the module of one command and build it."""
        if cmd_name not in COMMANDS:
            return None
        command = typer.Typer(add_completion=False, rich_markup_mode=None)
        body = import_module(COMMANDS[cmd_name][0])
        command.command(name=cmd_name)(body.command)
        return typer.main.get_command(command)

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """Refuse an unknown command with the nearest known one, without importing any."""
        known = not args or args[0] in COMMANDS or args[0].startswith("-")
        if not known and not ctx.resilient_parsing:  # resilient: the shell asks for completions
            from tmmcalc.errors import UsageError

            raise UsageError(f"no command is called {args[0]!r}", remedy=_what_was_meant(args[0]))
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """List the commands from the table."""
        with formatter.section("Commands"):
            formatter.write_dl([(name, text) for name, (_, text) in COMMANDS.items()])


def _what_was_meant(name: str) -> str:
    from difflib import get_close_matches

    if name.endswith(".toml"):
        return f"the command comes first: tmmcalc run {name}"
    close = get_close_matches(name, COMMANDS, 1)
    hint = f"did you mean {close[0]}? " if close else ""
    return f"{hint}commands: {', '.join(COMMANDS)}"


def _version(asked: bool) -> None:
    if asked:
        from tmmcalc._version import __version__

        typer.echo(f"tmmcalc {__version__}")
        raise typer.Exit


app = typer.Typer(
    cls=LateGroup,
    rich_markup_mode=None,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


@app.callback(epilog="Example: tmmcalc init shaper -o my.toml && tmmcalc run my.toml")
def tmmcalc(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version and leave.")
    ] = False,
) -> None:
    """Course-project calculator for the Theory of Mechanisms and Machines: one TOML spec, checked layers.

    Exit codes: 0 done, 2 bad input or usage, 3 the mechanism has no solution there, 4 accuracy not reached,
    5 a limit exceeded under --strict, 1 a fault of the program itself.
    """
