"""``tmmcalc structure``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.job import of_stage
from tmmcalc.cli.options import Format
from tmmcalc.cli.output import Solved, title
from tmmcalc.report.document import Document


@of_stage("structure")
def command(
    solved: Solved,
    assemblies: Annotated[
        bool,
        typer.Option(
            "--assemblies", help="List all assemblies of every group where the spec chooses one (assembly.at), instead."
        ),
    ] = False,
) -> Document:
    """Structural analysis: mobility, Assur groups in order of assembly, structural formula.

    Example: tmmcalc structure my.toml --assemblies
    """
    if not assemblies:
        return solved.document()
    from tmmcalc.linkage.facts.structure import assemblies_document
    from tmmcalc.linkage.listing import list_assemblies
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    listing = list_assemblies(to_linkage(solved.spec.linkage), solved.result)
    heading = title(solved.spec, solved.file, "assemblies")
    return assemblies_document(listing, solved.result, heading, everything=solved.form is not Format.table)
