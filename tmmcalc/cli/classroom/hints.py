"""``tmmcalc class hints``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmmcalc.cli.options import Form, Format, Language, SpecFile, spoken_in
from tmmcalc.cli.output import show
from tmmcalc.report.language import speaking


def command(
    spec: SpecFile,
    answers: Annotated[
        Path, typer.Argument(metavar="ANSWERS", help="Own answers: CSV, xlsx or TOML.", show_default=False)
    ],
    language: Language = None,
    form: Form = Format.table,
) -> None:
    """Say to a student which of his answers are right, and what to look at where they are not; no number is told.

    The spec is that of the own variant, as it was given out.

    Example: tmmcalc class hints my.toml answers.csv
    """
    from tmmcalc.classroom.grading import own_marks
    from tmmcalc.classroom.marksdocument import hints_document
    from tmmcalc.project import load_spec

    marked, book = own_marks(spec, answers)
    with speaking(language or spoken_in(load_spec(spec), None)):
        document = hints_document(marked, book)
    show(document, form)
