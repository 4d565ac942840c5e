"""``tmmcalc transient``."""

from tmmcalc.cli.flags import with_flags
from tmmcalc.cli.options import Columns, Form, Format, patterns_of
from tmmcalc.cli.work import Job, title


@with_flags
def command(
    job: Job,
    form: Form = Format.table,
    columns: Columns = None,
) -> None:
    """Transient: start-up, braking, run-down and load changes in time, of one mass or of an elastic drive.

    The table shows some rows of every motion; --format csv prints all of them.

    Example: tmmcalc transient my.toml --columns 't,omega*,M_*'
    """
    patterns = patterns_of(columns)
    scene = job.spec()
    run = job.run(scene, "transient")
    from tmmcalc.machine.facts.transient import document as transient_document

    printed = transient_document(
        run.results["transient"],
        title(scene, job.file, "transient"),
        patterns=patterns,
        everything=form is not Format.table,
        where=next((str(file) for file in run.files if file.name == "transient.csv"), ""),
    )
    job.finish(printed, run, form)
