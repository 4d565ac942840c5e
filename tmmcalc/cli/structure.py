"""``tmmcalc structure``."""

from __future__ import annotations

from tmmcalc.cli.options import Csv, Depfile, Form, Format, Fresh, FromStage, Out, Quiet, Set, SpecFile, Store
from tmmcalc.cli.work import Job, title


def command(
    spec: SpecFile,
    form: Form = Format.table,
    out: Out = None,
    store: Store = True,
    fresh: Fresh = False,
    from_stage: FromStage = None,
    csv: Csv = None,
    depfile: Depfile = None,
    quiet: Quiet = False,
    overrides: Set = None,
) -> None:
    """Structural analysis: mobility, Assur groups in order of assembly, structural formula.

    Groups of class III and higher are named with their links; exit code 3 says that they cannot be solved yet.

    Example: tmmcalc structure my.toml
    """
    job = Job(spec, out, store, fresh, from_stage, csv, depfile, quiet=quiet, overrides=overrides or ())
    scene = job.spec()
    run = job.run(scene, "structure")
    result = run.results["structure"]
    from tmmcalc.linkage.structure import check_solvable
    from tmmcalc.report.structure import structure_document

    job.finish(structure_document(result, title(scene, spec, "structure")), run, form)
    check_solvable(result)
