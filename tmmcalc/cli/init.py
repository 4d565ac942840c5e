"""``tmmcalc init``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmmcalc.cli.messages import put, say
from tmmcalc.cli.options import Quiet
from tmmcalc.core.errors import UsageError

SCHEMA = "tmmcalc.schema.json"
WIDTH = 80


def _ready(incomplete: str) -> list[str]:
    """Ready specs that begin so, for the completion of the shell."""
    from tmmcalc.project import templates

    return [name for name in templates.names() if name.startswith(incomplete)]


def command(
    template: Annotated[
        str, typer.Argument(help="Name of a ready spec; see --list.", metavar="TEMPLATE", autocompletion=_ready)
    ] = "crank-slider",
    out: Annotated[
        Path | None,
        typer.Option(
            "-o", "--out", metavar="FILE", help="File to write (default: standard output).", show_default=False
        ),
    ] = None,
    listing: Annotated[bool, typer.Option("--list", "-l", help="List the ready specs and leave.")] = False,
    force: Annotated[bool, typer.Option("--force", help="Replace a file that exists.")] = False,
    quiet: Quiet = False,
) -> None:
    """Write a commented starter spec. With -o the schema for TOML editors, and tables that it names, go beside it.

    Example: tmmcalc init four-bar -o my.toml
    """
    from tmmcalc.project import templates

    if listing:
        put(_listing({name: templates.description(name) for name in templates.names()}))
        return
    if template.endswith(".toml"):
        raise UsageError(
            f"{template!r} is a file; what stands here is the name of a ready spec",
            where="init",
            remedy=f"write: tmmcalc init crank-slider -o {template}",
        )
    text = templates.text(template)
    if out is None:
        put(text)
    else:
        _write(out, text, templates.beside(template), force, quiet)


def _listing(described: dict[str, str]) -> str:
    from textwrap import wrap

    width = max(map(len, described)) + 2
    lines = []
    for name, text in described.items():
        lines += wrap(f"{name:<{width}}{text}", WIDTH, subsequent_indent=" " * width, break_on_hyphens=False)
    return "\n".join([*lines, ""])


def _write(out: Path, text: str, tables: list[Path], force: bool, quiet: bool) -> None:
    """Write the spec, the schema that its first line names, and the tables that it names."""
    from tmmcalc.cli.output import check_place
    from tmmcalc.core.atomic import replace_file
    from tmmcalc.project.schema import schema_text

    check_place(out, "init")
    schema = out.parent / SCHEMA
    copies = {out.parent / table.name: table.read_bytes() for table in tables}
    changed = [copy for copy, content in copies.items() if copy.exists() and copy.read_bytes() != content]
    there = [*([out] if out.exists() else []), *changed]
    if there and not force:
        raise UsageError(f"{there[0]} exists", where="init", remedy="choose another name, or use --force")
    for file, content in {out: text.encode(), schema: schema_text().encode(), **copies}.items():
        replace_file(file, content)
    if not quiet:
        tables_too = "".join(f", with {copy}" for copy in copies)
        say(f"wrote {out} and {schema}{tables_too}; next: tmmcalc run {out}", "dim")
