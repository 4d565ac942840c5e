"""``tmmcalc schema``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmmcalc.cli.messages import note_written, put
from tmmcalc.cli.options import Quiet, printed


def command(
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
    quiet: Quiet = False,
) -> None:
    """The JSON Schema of a project spec. TOML editors use it to complete and check a spec while it is written.

    A spec names it in its first line: those that init writes name that of the program, #:schema ./my.schema.json a copy
    beside the spec, which goes with it to other machines.

    Example: tmmcalc schema -o my.schema.json
    """
    from tmmcalc.project.schema import schema_text

    if out is None:
        put(schema_text())
        return
    from tmmcalc.cli.output import check_place
    from tmmcalc.core.atomic import replace_file

    check_place(out, "schema")
    replace_file(out, schema_text().encode())
    if not quiet:
        note_written(out)
