"""``tmmcalc structure``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.flags import with_flags
from tmmcalc.cli.options import Form, Format
from tmmcalc.cli.work import Job, title


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    assemblies: Annotated[
        bool,
        typer.Option(
            "--assemblies", help="List all assemblies of every group where the spec chooses one (assembly.at), instead."
        ),
    ] = False,
) -> None:
    """Structural analysis: mobility, Assur groups in order of assembly, structural formula.

    Example: tmmcalc structure my.toml --assemblies
    """
    scene = job.spec()
    run = job.run(scene, "structure")
    result = run.results["structure"]
    from tmmcalc.linkage.facts.structure import assemblies_document
    from tmmcalc.linkage.facts.structure import summary as structure_document

    if assemblies:
        from tmmcalc.linkage.listing import list_assemblies
        from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

        listing = list_assemblies(to_linkage(scene.linkage), result)
        document = assemblies_document(listing, result, title(scene, job.file, "assemblies"))
    else:
        document = structure_document(result, title(scene, job.file, "structure"))
    job.finish(document, run, form)
