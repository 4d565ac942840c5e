"""Makers of commands whose document is that of a stage: with positions, or in a few facts."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from tmmcalc.cli.job import Job, of_stage
from tmmcalc.cli.options import Columns, Positions, patterns_of
from tmmcalc.cli.output import Solved
from tmmcalc.report.document import Document

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def stage_command(stage: str, text: str, heading: str = "") -> Callable[..., None]:
    """The command of a stage with positions, whose help is ``text``.

    The document is chosen by ``patterns``, ``rows``, ``everything``, ``where``; of a stage with columns by choice by
    these too, as ``further``.
    """

    def body(solved: Solved, columns: Columns = None, positions: Positions = None) -> Document:
        return positions_document(solved, columns, positions)

    body.__doc__ = text
    return of_stage(stage, heading, named_columns(stage))(body)


def named_columns(stage: str, unless: str = "") -> Callable[..., tuple[Job, Spec]]:
    """The job and its spec, for `of_stage`, if every name of --columns may be one of the stage's table.

    It is passed over under the flag ``unless``, which prints another table.
    """

    def asked(job: Job, columns: str | None = None, **flags: Any) -> tuple[Job, Spec]:
        patterns_of(columns)
        scene = job.spec()
        if not flags.get(unless):
            check_names(columns, stage, scene)
        return job, scene

    return asked


def check_names(columns: str | None, stage: str, spec: Spec) -> None:
    """Refuse names of --columns that no column of the stage can have, before anything is computed."""
    if patterns := patterns_of(columns):
        from tmmcalc.naming.declared import check_columns
        from tmmcalc.rooms import STAGES

        check_columns(patterns, [STAGES[stage]], spec)


def positions_document(solved: Solved, columns: str | None, positions: str | None) -> Document:
    """The document of a stage with positions, with the columns, those by choice among them, and rows that are named."""
    from tmmcalc.report.rows import rows_of

    patterns = patterns_of(columns)
    return solved.document(
        patterns=patterns,
        rows=rows_of(positions, solved.result.labels),
        everything=solved.everything,
        where=solved.where,
        **solved.further(patterns),
    )


def summary_command(
    stage: str, text: str, heading: str = "", *, forms: bool = False, found: bool = False
) -> Callable[..., None]:
    """The command of a stage without positions, whose help is ``text``.

    With ``forms`` its document is told as ``everything`` whether a format for programs is asked for; with ``found``
    what it finds can be written into the spec.
    """

    def body(solved: Solved) -> Document:
        return solved.document(**({"everything": solved.everything} if forms else {}))

    body.__doc__ = text
    return of_stage(stage, heading, found=stage if found else "")(body)
