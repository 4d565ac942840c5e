"""``tmmcalc transient``."""

from tmmcalc.cli.options import (
    Columns,
    Csv,
    Depfile,
    Form,
    Format,
    Fresh,
    FromStage,
    Out,
    Quiet,
    Set,
    SpecFile,
    Store,
    Strict,
    patterns_of,
)
from tmmcalc.cli.work import Job, title


def command(
    spec: SpecFile,
    form: Form = Format.table,
    columns: Columns = None,
    out: Out = None,
    store: Store = True,
    fresh: Fresh = False,
    from_stage: FromStage = None,
    csv: Csv = None,
    depfile: Depfile = None,
    strict: Strict = False,
    quiet: Quiet = False,
    overrides: Set = None,
) -> None:
    """Transient: start-up, braking, run-down and load changes in time, of one mass or of an elastic drive.

    The table shows some rows of every motion; --format csv prints all of them.

    Example: tmmcalc transient my.toml --columns 't,omega*,M_*'
    """
    patterns = patterns_of(columns)
    job = Job(spec, out, store, fresh, from_stage, csv, depfile, strict, quiet, overrides or ())
    scene = job.spec()
    run = job.run(scene, "transient")
    from tmmcalc.report.transient import transient_document

    printed = transient_document(
        run.results["transient"],
        title(scene, spec, "transient"),
        patterns=patterns,
        everything=form is not Format.table,
        where=next((str(file) for file in run.files if file.name == "transient.csv"), ""),
    )
    job.finish(printed, run, form)
