"""The commands of stages that print facts, with a table of positions or without: all have the same flags."""

from __future__ import annotations

from collections.abc import Callable

from tmmcalc.cli.flags import with_flags
from tmmcalc.cli.options import Columns, Form, Format, Positions, patterns_of
from tmmcalc.cli.positions import rows_of
from tmmcalc.cli.work import Job, table_file, title


def stage_command(stage: str, document: str, text: str, heading: str = "") -> Callable[..., None]:
    """The command that runs a stage and prints ``document``, a ``"module:function"``; ``text`` is its help.

    The function is called as ``document(result, title, patterns=, rows=, everything=, where=)``; the title says
    ``heading``, by default the stage.
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
        from tmmcalc.core.stage import resolve

        printed = resolve(document)(
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


def summary_command(
    stage: str, document: str, text: str, heading: str = "", *, forms: bool = False
) -> Callable[..., None]:
    """The command of a stage without positions; the function is called as ``document(result, title)``.

    With ``forms`` it is told as ``everything=`` whether a format for programs is asked for.
    """

    @with_flags
    def command(
        job: Job,
        form: Form = Format.table,
    ) -> None:
        scene = job.spec()
        run = job.run(scene, stage)
        from tmmcalc.core.stage import resolve

        more = {"everything": form is not Format.table} if forms else {}
        printed = resolve(document)(run.results[stage], title(scene, job.file, heading or stage), **more)
        job.finish(printed, run, form)

    command.__doc__ = text
    return command
