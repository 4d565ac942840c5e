"""``tmmcalc schema``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer


def command(
    out: Annotated[
        Path | None, typer.Option("-o", "--out", help="File to write (default: standard output).", show_default=False)
    ] = None,
) -> None:
    """The JSON Schema of a project spec. TOML editors use it to complete and check a spec while it is written.

    A spec names it in its first line: #:schema ./tmmcalc.schema.json

    Example: tmmcalc schema -o tmmcalc.schema.json
    """
    from tmmcalc.spec.schema import schema_text

    if out is None:
        typer.echo(schema_text(), nl=False)
        return
    from tmmcalc.pipeline.atomic import replace_file

    replace_file(out, schema_text().encode())
