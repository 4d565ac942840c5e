"""Groups of commands whose modules are imported when a command runs, not for ``--help``."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any, ClassVar

import typer
from typer.core import TyperCommand, TyperGroup

Table = Mapping[str, tuple[str, str]]  # module and one line of help, by the command's name


def deferred_group(
    sections: Mapping[str, Table],
    example: str,
    text: str | None = None,
    *,
    brief: str = "",
    callback: Callable[..., None] = lambda: None,
    **settings: Any,
) -> typer.Typer:
    """The application of the commands in ``sections``, which are loaded late, under their headings in the help.

    ``text`` is its help, by default that of ``callback``, which has its own flags; ``brief`` is what is told where no
    command is given, by default the help; ``settings`` are those of `Typer`.
    """
    listed, told = sections, brief

    class Group(DeferredGroup):
        """The commands of these sections."""

        sections, brief = listed, told
        table: ClassVar[Table] = {name: line for part in listed.values() for name, line in part.items()}

    app = typer.Typer(
        cls=Group,
        rich_markup_mode=None,
        no_args_is_help=True,
        context_settings={"help_option_names": ["-h", "--help"]},
        **settings,
    )
    app.callback(help=text or callback.__doc__, epilog=f"Example: {example}")(callback)
    return app


def deferred_group_of(name: str) -> typer.Typer:
    """The application of the commands that stand under a word of their own."""
    from tmmcalc.cli.commands import group_of, grouped

    group = group_of(name)
    return deferred_group({"Commands": grouped(name)}, group.example, group.text, add_completion=False)


class DeferredGroup(TyperGroup):
    """A group whose commands are loaded late.

    The module of one has a function ``command``, or an application ``group`` that is a group in its turn.
    """

    sections: ClassVar[Mapping[str, Table]] = {}
    table: ClassVar[Table] = {}
    brief: ClassVar[str] = ""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Where nothing is given tell in brief what there is; the exit code is that of a wrong usage."""
        if self.brief and not args and not ctx.resilient_parsing:
            from tmmcalc.cli.messages import say

            say(self.brief)
            ctx.exit(2)
        return super().parse_args(ctx, args)

    def list_commands(self, ctx: Any) -> list[str]:
        """Names in the order of work."""
        return list(self.table)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        """Import the module of one command and build it."""
        if cmd_name not in self.table:
            return None
        body = import_module(self.table[cmd_name][0])
        if hasattr(body, "group"):
            built = typer.main.get_command(body.group)
            built.name = cmd_name
            return built
        command = typer.Typer(add_completion=False, rich_markup_mode=None)
        command.command(name=cmd_name, cls=OfSpec)(body.command)
        return typer.main.get_command(command)

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """Refuse an unknown command with the nearest known one, without importing any."""
        known = not args or args[0] in self.table or args[0].startswith("-")
        if not known and not ctx.resilient_parsing:  # resilient: the shell asks for completions
            from tmmcalc.core.errors import UsageError

            raise UsageError(f"no command is called {args[0]!r}", remedy=_what_was_meant(args[0], self.table, ctx))
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """List the commands under their headings, all texts at one place."""
        longest = max(map(len, self.table))
        for heading, part in self.sections.items():
            with formatter.section(heading):
                formatter.write_dl([(f"{name:<{longest}}", text) for name, (_, text) in part.items()])


class OfSpec(TyperCommand):
    """A command that says which specs there are where it is given none."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Take the arguments apart; raises `UsageError` if the spec is missing."""
        try:
            return super().parse_args(ctx, args)
        except Exception as error:  # the class of a missing parameter depends on the version of typer
            if hasattr(error, "param_type") and getattr(getattr(error, "param", None), "metavar", None) == "SPEC":
                from tmmcalc.cli.nospec import no_spec

                raise no_spec(ctx.command_path) from None
            raise


def _what_was_meant(name: str, table: Table, ctx: Any) -> str:
    from difflib import get_close_matches

    if name.endswith(".toml"):
        first = "run" if "run" in table else next(iter(table))
        return f"the command comes first: {ctx.command_path} {first} {name}"
    close = get_close_matches(name, table, 1)
    hint = f"did you mean {close[0]}? " if close else ""
    return f"{hint}commands: {', '.join(table)}"
