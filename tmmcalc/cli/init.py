"""``tmmcalc init``."""

from __future__ import annotations

from pathlib import Path
from shlex import quote
from typing import Annotated

import typer

from tmmcalc.cli.messages import put, say
from tmmcalc.cli.options import Quiet, printed
from tmmcalc.core.errors import UsageError

WIDTH = 80
FIRST = "crank-slider"  # what is written where nothing is named


def _ready(incomplete: str) -> list[str]:
    """Ready specs that begin so, for the completion of the shell."""
    from tmmcalc.project import templates

    return [name for name in templates.names() if name.startswith(incomplete)]


def command(
    template: Annotated[
        str | None,
        typer.Argument(
            help=f"Name of a ready spec, see --list (default: {FIRST}).",
            metavar="TEMPLATE",
            show_default=False,
            autocompletion=_ready,
        ),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--out",
            metavar="FILE",
            help="File to write (default, or -: standard output).",
            show_default=False,
            callback=printed,
        ),
    ] = None,
    listing: Annotated[
        bool,
        typer.Option("--list", "-l", help="List the ready specs, or those whose names begin with TEMPLATE, and leave."),
    ] = False,
    force: Annotated[bool, typer.Option("--force", help="Replace a file that exists.")] = False,
    quiet: Quiet = False,
) -> None:
    """Write a commented starter spec; tables that it names go beside it.

    Its first line names the schema by which TOML editors complete and check a spec while it is written.

    Example: tmmcalc init four-bar -o my.toml
    """
    from tmmcalc.project import templates

    if listing:
        put(_listing(template or ""))
        return
    template = template or FIRST
    if template.endswith(".toml"):
        raise UsageError(
            f"{template!r} is a file; what stands here is the name of a ready spec",
            where="init",
            remedy=f"write: tmmcalc init {FIRST} -o {quote(template)}",
        )
    text = templates.text(template)
    if out is None:
        put(text)
    else:
        _write(out, text, templates.beside(template), force, quiet)


def _listing(beginning: str) -> str:
    """The ready specs whose names begin so, a line or two on each; those of a folder only where they are asked for."""
    from textwrap import wrap

    from tmmcalc.project import templates

    names = [name for name in templates.names() if name.startswith(beginning)]
    if not names:
        raise UsageError(f"no ready spec begins with {beginning!r}", where="--list", remedy="see: tmmcalc init --list")
    described = {name: templates.description(name) for name in names if beginning or "/" not in name}
    if rest := len(names) - len(described):
        described["extreme/..."] = f"{rest} hard scenes with known answers: tmmcalc init --list extreme"
    width = max(map(len, described)) + 2
    lines = []
    for name, text in described.items():
        lines += wrap(f"{name:<{width}}{text}", WIDTH, subsequent_indent=" " * width, break_on_hyphens=False)
    return "\n".join([*lines, ""])


def _write(out: Path, text: str, tables: list[Path], force: bool, quiet: bool) -> None:
    """Write the spec and the tables that it names."""
    from tmmcalc.cli.output import check_place
    from tmmcalc.core.atomic import replace_file
    from tmmcalc.core.files import other_kind

    check_place(out, "init")
    copies = {out.parent / table.name: table.read_bytes() for table in tables}
    changed = [
        copy for copy, content in copies.items() if copy.exists() and (other_kind(copy) or copy.read_bytes() != content)
    ]
    there = [*([out] if out.exists() else []), *changed]
    if there and not force:
        raise UsageError(f"{there[0]} exists", where="init", remedy="choose another name, or use --force")
    for file, content in {out: text.encode(), **copies}.items():
        replace_file(file, content)
    if not quiet:
        tables_too = "".join(f", with {copy}" for copy in copies)
        say(f"wrote {out}{tables_too}; next: tmmcalc run {quote(str(out))}", "dim")
