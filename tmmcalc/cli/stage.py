"""The commands of stages that print facts, with a table of positions or without: all have the same flags."""

from __future__ import annotations

from collections.abc import Callable

from tmmcalc.cli.options import (
    Columns,
    Csv,
    Depfile,
    Form,
    Format,
    Fresh,
    FromStage,
    Out,
    Positions,
    Quiet,
    Set,
    SpecFile,
    Store,
    Strict,
    patterns_of,
)
from tmmcalc.cli.positions import rows_of
from tmmcalc.cli.work import Job, title


def stage_command(stage: str, document: str, text: str) -> Callable[..., None]:
    """The command that runs a stage and prints ``document``, a ``"module:function"``; ``text`` is its help.

    The function is called as ``document(result, title, patterns=, rows=, everything=, where=)``.
    """

    def command(
        spec: SpecFile,
        form: Form = Format.table,
        columns: Columns = None,
        positions: Positions = None,
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
        patterns = patterns_of(columns)
        job = Job(spec, out, store, fresh, from_stage, csv, depfile, strict, quiet, overrides or ())
        scene = job.spec()
        run = job.run(scene, stage)
        result = run.results[stage]
        from tmmcalc.pipeline.stage import resolve

        printed = resolve(document)(
            result,
            title(scene, spec, stage),
            patterns=patterns,
            rows=rows_of(positions, result.labels),
            everything=form is not Format.table,
            where=next((str(file) for file in run.files if file.name == f"{stage}.csv"), ""),
        )
        job.finish(printed, run, form)

    command.__doc__ = text
    return command


def summary_command(stage: str, document: str, text: str) -> Callable[..., None]:
    """The command of a stage without positions; the function is called as ``document(result, title)``."""

    def command(
        spec: SpecFile,
        form: Form = Format.table,
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
        job = Job(spec, out, store, fresh, from_stage, csv, depfile, strict, quiet, overrides or ())
        scene = job.spec()
        run = job.run(scene, stage)
        from tmmcalc.pipeline.stage import resolve

        job.finish(resolve(document)(run.results[stage], title(scene, spec, stage)), run, form)

    command.__doc__ = text
    return command
