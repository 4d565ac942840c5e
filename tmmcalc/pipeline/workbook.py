"""The sheets of a workbook of a run: what is given, what is told, and the table of every stage."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from tmmcalc.core.stage import CSV_ROWS
from tmmcalc.naming.scene import Scene
from tmmcalc.pipeline.csvcolumns import by_choice, with_columns
from tmmcalc.project.given import Given, given
from tmmcalc.report.document import Document, View
from tmmcalc.report.errors import with_errors
from tmmcalc.report.worksheets import TOLD, Worksheet, beside_of, first_columns, sheets_of, table_sheet, told_of

if TYPE_CHECKING:
    from tmmcalc.core.columns import Column
    from tmmcalc.pipeline.outcome import RunResult


def run_sheets(run: RunResult, csv: bool | None = None, columns: Sequence[str] = ()) -> list[Worksheet]:
    """All sheets of a run.

    ``csv`` True takes tables of any length, None up to as many rows as a CSV has; ``columns`` are names and wildcards
    of those that the tables have (empty: all).
    """
    rows: list[tuple[Any, ...]] = []
    tables: list[Worksheet] = []
    further = by_choice(columns, run.outcomes, Scene(run.spec, run.results)) if columns else {}
    for stage, outcome in run.outcomes.items():
        document = with_errors(outcome.stage.summary(run.results[stage], stage), run.record(stage).error)
        rows += ((stage, *row) for row in told_of(document, stage))
        tables += _table(run, stage, document, csv, columns, further)
    rows += (("run", "note", "", text, "", "") for text in run.told)
    rows += ((stage, "failed", "", str(error), "", "") for stage, error in run.failures.items())
    return [_given(run), Worksheet("summary", ("stage", *TOLD), _columns(rows, 1 + len(TOLD))), *tables]


def command_sheets(run: RunResult, document: Document) -> list[Worksheet]:
    """The sheets of the document that the command of a stage prints."""
    stage = run.plan.target or ""
    if stage not in run.outcomes:
        return sheets_of(document)
    return sheets_of(document, stage, _first(run, stage))


def _given(run: RunResult) -> Worksheet:
    return Worksheet("given", Given._fields, _columns([*given(run.spec)], len(Given._fields)))


def _columns(rows: Sequence[Sequence[Any]], count: int) -> list[tuple[Any, ...]]:
    return [*zip(*rows, strict=True)] or [()] * count


def _first(run: RunResult, stage: str) -> list[str]:
    """Names of the columns that a reader of the stage's table looks at first."""
    return first_columns(run.outcomes[stage].stage.document(run.results[stage], stage))


def _table(
    run: RunResult,
    stage: str,
    document: Document,
    csv: bool | None,
    columns: Sequence[str],
    further: Mapping[str, Sequence[Column]],
) -> Iterator[Worksheet]:
    """The sheet of a stage that has a table, or a short one in its summary."""
    table = run.table(stage)
    if table is None:
        if document.table is not None:
            yield table_sheet(stage, document.table, beside_of(document))
    elif csv is not False and (csv or table.rows <= CSV_ROWS):
        chosen = with_columns(table, further.get(stage, ())).selected(columns)
        if chosen is not None:
            view = View(chosen.header, [column.tolist() for column in chosen.columns])
            yield table_sheet(stage, view, beside_of(document), _first(run, stage))
    else:
        said = "not wanted" if csv is False else "are many: --csv writes them"
        beside = [("note", f"{table.rows} rows of {len(table.header)} columns {said}"), *beside_of(document)]
        yield Worksheet(stage, (), (), beside)
