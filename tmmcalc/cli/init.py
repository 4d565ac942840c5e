"""``tmmcalc init``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmmcalc.cli.messages import say
from tmmcalc.cli.options import Quiet
from tmmcalc.errors import UsageError

SCHEMA = "tmmcalc.schema.json"


def command(
    template: Annotated[str, typer.Argument(help="Name of a ready spec; see --list.")] = "crank-slider",
    out: Annotated[
        Path | None, typer.Option("-o", "--out", help="File to write (default: standard output).", show_default=False)
    ] = None,
    listing: Annotated[bool, typer.Option("--list", "-l", help="List the ready specs and leave.")] = False,
    force: Annotated[bool, typer.Option("--force", help="Replace a file that exists.")] = False,
    quiet: Quiet = False,
) -> None:
    """Write a commented starter spec. With -o the schema for TOML editors is written beside it.

    Example: tmmcalc init four-bar -o my.toml
    """
    from tmmcalc.spec import templates

    if listing:
        width = max(map(len, templates.names()))
        for name in templates.names():
            typer.echo(f"{name:<{width}}  {templates.description(name)}")
        return
    text = templates.text(template)
    if out is None:
        typer.echo(text, nl=False)
        return
    if out.exists() and not force:
        raise UsageError(f"{out} exists", where="init", remedy="choose another name, or use --force")
    from tmmcalc.pipeline.atomic import replace_file
    from tmmcalc.spec.schema import schema_text

    replace_file(out, text.encode())
    replace_file(out.parent / SCHEMA, schema_text().encode())
    if not quiet:
        say(f"wrote {out} and {out.parent / SCHEMA}; next: tmmcalc kinematics {out}")
