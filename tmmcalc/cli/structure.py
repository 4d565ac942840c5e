"""``tmmcalc structure``."""

from __future__ import annotations

from tmmcalc.cli.flags import with_flags
from tmmcalc.cli.options import Form, Format
from tmmcalc.cli.work import Job, title


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
) -> None:
    """Structural analysis: mobility, Assur groups in order of assembly, structural formula.

    Groups of class III and higher are named with their links; exit code 3 says that they cannot be solved yet.

    Example: tmmcalc structure my.toml
    """
    scene = job.spec()
    run = job.run(scene, "structure")
    result = run.results["structure"]
    from tmmcalc.linkage.structure import check_solvable
    from tmmcalc.report.structure import structure_document

    job.finish(structure_document(result, title(scene, job.file, "structure")), run, form)
    check_solvable(result)
