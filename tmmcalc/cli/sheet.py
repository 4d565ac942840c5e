"""``tmmcalc sheet``."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmmcalc.cli.job import Job
from tmmcalc.cli.messages import counted, say
from tmmcalc.cli.options import Fresh, Language, Quiet, Set, SpecFile, Store, Strict, language_of, written
from tmmcalc.cli.output import check_strict, raise_failures
from tmmcalc.core.errors import NoSolutionError, TmmError, UsageError
from tmmcalc.report.sheets.formats import FORMATS, FRAMES

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec
    from tmmcalc.report.drawing.shapes import Drawing
    from tmmcalc.report.sheets.piece import Piece
    from tmmcalc.report.sheets.sheet import Sheet, Style

PDF = "pdf"
TILES = ("a4",)
NAMED = 12  # names without a free place that are told by name


def command(
    spec: SpecFile,
    out: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--out",
            metavar="FOLDER",
            help="Folder of the sheets (default: <spec>.sheets here).",
            show_default=False,
            callback=written,
        ),
    ] = None,
    only: Annotated[
        str | None,
        typer.Option(
            "--only",
            metavar="LIST",
            help="These sheets alone, by number or name: '2', 'gears,cam'.",
            show_default=False,
        ),
    ] = None,
    forms: Annotated[
        str,
        typer.Option("--as", "-f", metavar="LIST", help="Forms of the files: pdf, dxf, svg, png; several: 'pdf,dxf'."),
    ] = PDF,
    size: Annotated[
        str | None,
        typer.Option(
            "--format",
            metavar="FORMAT",
            help="Paper: a1, a2 or a3 (default: that of [sheets], or a1).",
            show_default=False,
        ),
    ] = None,
    frame: Annotated[
        str | None,
        typer.Option(
            "--frame",
            metavar="FRAME",
            help="Frame and title block: gost, iso or none (default: that of [sheets]; gost in Ukrainian, else iso).",
            show_default=False,
        ),
    ] = None,
    language: Language = None,
    tile: Annotated[
        str | None,
        typer.Option(
            "--tile",
            metavar="PAPER",
            help="Cut each sheet into pages for a printer at home, in true size: a4.",
            show_default=False,
        ),
    ] = None,
    store: Store = True,
    fresh: Fresh = False,
    strict: Strict = False,
    quiet: Quiet = False,
    overrides: Set = None,
) -> None:
    """Draw the sheets that are handed in: linkage, forces, gears, cam, as far as the spec has them.

    Each picture has a standard scale. What does not fit on a sheet goes to a further one, linkage-2, and is named in a
    warning. Results are taken from the stage files where these are valid. What [sheets] in the spec says holds unless a
    flag says otherwise.

    Example: tmmcalc sheet my.toml -o sheets --format a1 --as pdf,dxf
    """
    from tmmcalc.report.drawing import check_writer
    from tmmcalc.report.language import speaking

    wanted = _forms(forms, tile)
    for form in wanted:
        check_writer(form, "sheet")
    job = Job(spec, store=store, fresh=fresh, quiet=quiet, overrides=overrides or (), keep_going=True, csv=False)
    scene = job.spec()
    style = _style(scene, size, frame, language)
    with speaking(style.language):
        folder = out or Path(f"{spec.stem}.sheets")
        run = job.run(scene, _stages())
        with run.believed():
            made = _Making(run, style)
            chosen = made.chosen(only)
            files = made.files(chosen, folder, wanted, tile, quiet)
    for warning in made.warnings:
        say(warning, "yellow")
    if not quiet:
        say(f"{counted(len(chosen), 'sheet')} in {folder}: {', '.join(file.name for file in files)}", "dim")
    raise_failures({**run.failures, **made.failures})
    check_strict(made.warnings, strict)


def _forms(forms: str, tile: str | None) -> list[str]:
    """The forms of files that are asked for; raises `UsageError` for others."""
    from tmmcalc.report.drawing import WRITERS

    found = list(dict.fromkeys(each.strip().lower() for each in forms.split(",")))
    for form in found:
        if form not in WRITERS:
            raise UsageError(f"there is no form {form!r}", where="--as", remedy=f"forms: {', '.join(WRITERS)}")
    if tile is not None and tile not in TILES:
        raise UsageError(f"there is no paper {tile!r}", where="--tile", remedy=f"paper: {', '.join(TILES)}")
    if tile is not None and PDF not in found:
        raise UsageError("pages are cut of a pdf", where="--tile", remedy="add pdf to --as, or leave --tile out")
    return found


def _style(scene: Spec, size: str | None, frame: str | None, language: str | None) -> Style:
    """How the sheets look: by the flags, else by the spec."""
    from tmmcalc.report.sheets.sheet import Style
    from tmmcalc.report.tables.sheets import SheetsTable

    for flag, value, known in (("--format", size, [*FORMATS]), ("--frame", frame, [*FRAMES])):
        if value is not None and value not in known:
            raise UsageError(f"there is no {flag[2:]} {value!r}", where=flag, remedy=f"there are: {', '.join(known)}")
    said = scene.sheets or SheetsTable()
    spoken = language_of(scene, language)
    usual = "gost" if spoken == "uk" else "iso"
    return Style(size or said.format, frame or said.frame or usual, spoken, scene.project.title, said.who)


def _stages() -> list[str]:
    """The stages that offer pieces, with those that they show as well."""
    from tmmcalc.rooms import STAGES

    offering = [stage for stage in STAGES.values() if stage.picture is not None and stage.picture.pieces]
    beside = [stage.picture.beside for stage in offering if stage.picture is not None and stage.picture.beside]
    return list(dict.fromkeys([*(stage.name for stage in offering), *beside]))


class _Making:
    """The sheets of a run, in the language in force, and what went wrong with them."""

    def __init__(self, run: RunResult, style: Style) -> None:
        from tmmcalc.pipeline.picturing import pieces_of
        from tmmcalc.report.sheets.sheet import planned

        self.style = style
        self.failures: dict[str, TmmError] = {}
        pieces: list[Piece] = []
        for stage in run.outcomes:
            try:
                pieces += pieces_of(stage, run.spec, run.results)
            except TmmError as error:
                self._failed(f"pictures of {stage}", error)
        if not pieces:
            raise_failures({**run.failures, **self.failures})
            raise UsageError(
                "the scene has no picture that stands on a sheet",
                where="sheet",
                remedy="sheets are drawn of a linkage, its forces and motion, gears, a cam; see tmmcalc plan",
            )
        self.sheets, self.warnings = planned(pieces, style)

    def chosen(self, only: str | None) -> list[Sheet]:
        """The sheets that ``--only`` names, all without it; raises `UsageError` for one that is not there."""
        if only is None:
            return self.sheets
        found: list[Sheet] = []
        for name in (each.strip() for each in only.split(",")):
            meant = [each for each in self.sheets if name in (str(each.number), each.file, each.subject)]
            if not meant:
                known = ", ".join(f"{each.number} {each.file}" for each in self.sheets)
                raise UsageError(f"there is no sheet {name!r}", where="--only", remedy=f"sheets: {known}")
            found += meant
        return [each for each in self.sheets if each in found]

    def files(
        self, chosen: Sequence[Sheet], folder: Path, forms: Sequence[str], tile: str | None, quiet: bool
    ) -> list[Path]:
        """Draw sheets and write them in all forms; the files."""
        from tmmcalc.cli.progress import described, seen
        from tmmcalc.core.atomic import replace_file
        from tmmcalc.core.progress import tell

        _make(folder)
        files: list[Path] = []
        with seen(described(), quiet) as show:
            for sheet in chosen:
                words = f"drawing {sheet.file}"
                show(words)
                tell(0.0, words)
                for name, data in self._written(sheet, forms, tile):
                    replace_file(folder / name, data)
                    files.append(folder / name)
        return files

    def _written(self, sheet: Sheet, forms: Sequence[str], tile: str | None) -> Iterator[tuple[str, bytes]]:
        from tmmcalc.report.drawing import written
        from tmmcalc.report.sheets.sheet import drawn
        from tmmcalc.report.sheets.tiles import tiled

        def failed(piece: Piece, error: TmmError) -> None:
            self._failed(f"{sheet.file}: {piece.heading}", error)

        drawing = drawn(sheet, self.style, failed)
        self.warnings += [*sheet.warnings(self.style), *_unplaced(drawing, sheet)]
        for form in forms:
            if form == PDF and tile is not None:
                yield f"{sheet.file}-{tile}.pdf", tiled(drawing, sheet.file)
            else:
                yield f"{sheet.file}.{form}", written(form, drawing)

    def _failed(self, what: str, error: TmmError) -> None:
        """Keep the error of what has no picture for the end; a fault of flags or of the spec ends all."""
        if error.exit_code < NoSolutionError.exit_code:
            raise error
        self.failures[what] = error


def _unplaced(drawing: Drawing, sheet: Sheet) -> list[str]:
    """A warning of the names that found no free place on a drawing."""
    from tmmcalc.report.drawing.lettering import message

    fields: list[Any] = drawing.fields
    faults = [fault for field in fields for fault in field.labels.faults]
    if not faults:
        return []
    named = ", ".join(message(fault.text) for fault in faults[:NAMED]) + (", ..." if len(faults) > NAMED else "")
    return [f"warning: {sheet.file}: {counted(len(faults), 'name')} without a free place: {named}"]


def _make(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise UsageError(f"{folder}: {error.strerror}", where="-o", remedy="name a folder") from None
