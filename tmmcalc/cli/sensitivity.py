"""``tmmcalc sensitivity``."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Protocol

import typer

from tmmcalc.cli.messages import note_written, warn
from tmmcalc.cli.options import Form, Format, Jobs, Language, Quiet, Scheduler, Set, SpecFile, names_of
from tmmcalc.cli.output import check_picture, draw_in, show
from tmmcalc.cli.progress import growing, seen
from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.design.sensitivity import Ways
    from tmmcalc.report.document import Document
    from tmmcalc.report.drawing.shapes import Drawing

Names = Sequence[str]
Figure = Callable[[], "Drawing"]


class Told(Protocol):
    """What makes the document of what was found, for people or for programs."""

    def __call__(self, title: str, people: bool) -> Document:
        """The document."""


def command(
    spec: SpecFile,
    of: Annotated[
        list[str] | None,
        typer.Option(
            "--of",
            metavar="NAMES",
            help="Results by name, with wildcards: 'kinematics.stroke_D,forces.max(R_A)'. May be repeated.",
            show_default=False,
        ),
    ] = None,
    to: Annotated[
        list[str] | None,
        typer.Option(
            "--to",
            metavar="KEYS",
            help="Keys of the spec, with wildcards: 'mechanism.links*mass' (default: all its numbers). May be "
            "repeated.",
            show_default=False,
        ),
    ] = None,
    curve: Annotated[
        list[str] | None,
        typer.Option(
            "--curve",
            metavar="COLUMNS",
            help="In place of --of: columns of tables, in every row, with wildcards: 'kinematics.vS_D'. May be "
            "repeated.",
            show_default=False,
        ),
    ] = None,
    picture: Annotated[
        Path | None,
        typer.Option(
            "--picture",
            metavar="FILE",
            help="Draw bars, or the curves, by suffix svg, png, pdf or dxf.",
            show_default=False,
        ),
    ] = None,
    jobs: Jobs = None,
    scheduler: Scheduler = None,
    form: Form = Format.table,
    quiet: Quiet = False,
    language: Language = None,
    overrides: Set = None,
) -> None:
    """Derivatives of results with respect to the numbers of a spec: which of them matters, by how much.

    Of every result the keys are ranked by what one per cent of them does. A kink is told with both sides, a jump as
    such; where steps end without a solution this is told, and where no straight line stands for the result. With
    --curve columns are asked in every row of their tables.

    Example: tmmcalc sensitivity my.toml --of 'kinematics.stroke_D,forces.max(R_A)' --to 'mechanism.links*'
    """
    names, columns, keys = names_of(of, "--of"), names_of(curve, "--curve"), names_of(to, "--to")
    if bool(names) == bool(columns):
        what = "nothing is asked for" if not names else "results and columns are two tables"
        raise UsageError(what, where="--of, --curve", remedy="give one of them, e.g. --of kinematics.stroke_D")
    if picture is not None:
        check_picture(picture, "--picture")
    title = f"{spec.stem}: sensitivity"
    with seen(growing("variants"), quiet) as shown:
        ways: Ways = {"jobs": jobs, "scheduler": scheduler, "tell": warn, "progress": shown}
        told, figure = (_of_columns if columns else _of_results)(spec, names or columns, keys, overrides or (), ways)
    if picture is not None:
        from tmmcalc.project import load_spec

        draw_in(language, load_spec(spec, overrides or ()), picture, figure)
        if not quiet:
            note_written(picture)
    show(told(title, people=form is Format.table), form)


def _of_results(spec: Path, names: Names, keys: Names, fixed: Names, ways: Ways) -> tuple[Told, Figure]:
    from tmmcalc.design.sensitivity import sensitivity
    from tmmcalc.design.sensitivity_document import sensitivity_document, tidy_sensitivity

    found = sensitivity(spec, names, keys, fixed, **ways)

    def drawn() -> Drawing:
        from tmmcalc.design.pictures import bars

        return bars(found)

    return lambda title, people: (sensitivity_document if people else tidy_sensitivity)(found, title), drawn


def _of_columns(spec: Path, columns: Names, keys: Names, fixed: Names, ways: Ways) -> tuple[Told, Figure]:
    from tmmcalc.design.courses import courses
    from tmmcalc.design.sensitivity_document import courses_document, tidy_courses

    every, found = courses(spec, columns, keys, fixed, **ways)

    def drawn() -> Drawing:
        from tmmcalc.design.pictures import curves

        return curves(every)

    return lambda title, people: (courses_document if people else tidy_courses)(every, found, title), drawn
