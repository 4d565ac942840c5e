"""The commands of stages that print facts, with a table of positions or without: all have the same flags."""

from __future__ import annotations

from collections.abc import Callable

from tmmcalc.cli.flags import with_flags
from tmmcalc.cli.options import Columns, Form, Format, Positions, patterns_of
from tmmcalc.cli.work import Job, table_file, title
from tmmcalc.report.rows import rows_of


def stage_command(stage: str, text: str, heading: str = "") -> Callable[..., None]:
    """The command that runs a stage and prints its document; ``text`` is its help.

    The document is chosen by ``patterns``, ``rows``, ``everything``, ``where``; its title says ``heading``, by default
    the stage.
    """

    @with_flags
    def command(
        job: Job,
        form: Form = Format.table,
        columns: Columns = None,
        positions: Positions = None,
    ) -> None:
        patterns = patterns_of(columns)
        scene = job.spec()
        run = job.run(scene, stage)
        result = run.results[stage]
        printed = run.outcomes[stage].stage.document(
            result,
            title(scene, job.file, heading or stage),
            patterns=patterns,
            rows=rows_of(positions, result.labels),
            everything=form is not Format.table,
            where=table_file(run, stage),
        )
        job.finish(printed, run, form)

    command.__doc__ = text
    return command


def summary_command(stage: str, text: str, heading: str = "", *, forms: bool = False) -> Callable[..., None]:
    """The command of a stage without positions.

    With ``forms`` its document is told as ``everything`` whether a format for programs is asked for.
    """

    @with_flags
    def command(
        job: Job,
        form: Form = Format.table,
    ) -> None:
        scene = job.spec()
        run = job.run(scene, stage)
        more = {"everything": form is not Format.table} if forms else {}
        printed = run.outcomes[stage].stage.document(
            run.results[stage], title(scene, job.file, heading or stage), **more
        )
        job.finish(printed, run, form)

    command.__doc__ = text
    return command
