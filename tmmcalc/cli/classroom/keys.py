"""``tmmcalc class keys``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.messages import note_written, warn
from tmmcalc.cli.options import Form, Format, Language, Quiet, spoken_in
from tmmcalc.cli.output import check_apart, check_place, show, title
from tmmcalc.cli.progress import counted, seen
from tmmcalc.core.errors import UsageError
from tmmcalc.core.files import other_kind
from tmmcalc.report.language import speaking

if TYPE_CHECKING:
    from tmmcalc.classroom.model import Keybook
    from tmmcalc.classroom.state import Class
    from tmmcalc.project import Spec

SHOWN = 1  # variants that are printed for people, if none is asked for

Folder = Annotated[Path, typer.Argument(metavar="DIR", help="Folder of a class that was made.")]


def command(
    folder: Folder,
    out: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--out",
            metavar="DIR",
            help="Folder of the keys (default: keys in that of the class).",
            show_default=False,
        ),
    ] = None,
    numbers: Annotated[
        list[int] | None,
        typer.Option(
            "--variant", metavar="N", help="Print the key of this variant; may be repeated.", show_default=False
        ),
    ] = None,
    jobs: Annotated[
        int | None,
        typer.Option(
            "--jobs", "-j", metavar="N", min=1, help="Local processes (default: all cores).", show_default=False
        ),
    ] = None,
    page: Annotated[
        str | None,
        typer.Option(
            "--page",
            metavar="FORM",
            help="All right values on a page beside the keys: pdf, docx, html, typ or txt.",
            show_default=False,
        ),
    ] = None,
    notes: Annotated[
        str | None,
        typer.Option(
            "--notes",
            metavar="FORM",
            help="The worked solution of each variant beside the keys: pdf, docx, html, typ or txt.",
            show_default=False,
        ),
    ] = None,
    moodle: Annotated[
        Path | None,
        typer.Option(
            "--moodle",
            metavar="FILE",
            help="Questions for Moodle (xml): a category a variant, with what is said of known mistakes.",
            show_default=False,
        ),
    ] = None,
    moodle_dataset: Annotated[
        Path | None,
        typer.Option(
            "--moodle-dataset",
            metavar="FILE",
            help="The same as one question for each asked result, a set of data a variant.",
            show_default=False,
        ),
    ] = None,
    language: Language = None,
    fresh: Annotated[bool, typer.Option("--fresh", help="Make all keys anew, whatever is stored.")] = False,
    form: Form = Format.table,
    quiet: Quiet = False,
) -> None:
    """The keys of a class: what is right of each variant, and what comes out with each known mistake.

    The folder gets keys.toml, all digits for `class mark`, and keys.csv for the teacher: value, unit, tolerance, what
    else counts as right. It is not for students. Printed is the key of the first variant, or of those asked for; for
    programs of all. Keys that are there already are not made again; what was stopped goes on where it was.

    Example: tmmcalc class keys class --variant 7
    """
    place = out or folder / "keys"
    if kind := other_kind(place):
        if kind != "a folder":
            raise UsageError(f"{place} is {kind}", where="-o", remedy="name a folder")
    elif place.exists():
        raise UsageError(f"{place} is a file", where="-o", remedy="name a folder")
    _check_files(page, notes, moodle, moodle_dataset)
    from tmmcalc.classroom.keybook import write_keybook
    from tmmcalc.classroom.keys_document import keys_document, of_variants
    from tmmcalc.classroom.state import read_class
    from tmmcalc.project import load_spec

    own = read_class(folder)
    missing = [number for number in numbers or () if not 1 <= number <= len(own.variants)]
    if missing:
        raise UsageError(
            f"there is no variant {missing[0]}", where="--variant", remedy=f"the class has {len(own.variants)}"
        )
    book = _made(own, folder, place, jobs, fresh, quiet)
    files = write_keybook(book, place)
    scene = load_spec(own.file(folder))
    with speaking(spoken_in(scene, language)):
        if page is not None:
            files += _page(place / f"keys.{page}", book, scene)
        if notes is not None:
            files += _notes(own, folder, place, notes, jobs, quiet)
        if moodle is not None or moodle_dataset is not None:
            files += _questions(own, folder, book, scene, {moodle: False, moodle_dataset: True}, jobs, quiet)
    chosen = numbers or ([key.number for key in book.keys[:SHOWN]] if form is Format.table else None)
    shown = book if chosen is None else of_variants(book, chosen)
    file = own.file(folder)
    show(keys_document(shown, title(scene, file, "keys"), len(book.keys)), form)
    if not quiet:
        for written in files:
            note_written(written)


def _check_files(page: str | None, notes: str | None, *questions: Path | None) -> None:
    """Refuse files that cannot be written, before the keys are made."""
    from tmmcalc.note.forms import check_form

    for file, flag in zip(questions, ("--moodle", "--moodle-dataset"), strict=True):
        if file is not None:
            check_place(file, flag)
    check_apart(*questions)
    if page is not None:
        check_form(page, "a page of keys", "--page")
    if notes is not None:
        check_form(notes, "a note", "--notes")


def _page(file: Path, book: Keybook, scene: Spec) -> tuple[Path, ...]:
    from tmmcalc.classroom.papers.overview import overview
    from tmmcalc.core.atomic import replace_file
    from tmmcalc.note.forms import formed

    name = scene.project.title
    replace_file(file, formed(overview(book, name), file.suffix[1:], name))
    return (file,)


def _notes(own: Class, folder: Path, place: Path, form: str, jobs: int | None, quiet: bool) -> tuple[Path, ...]:
    from tmmcalc.classroom.papers.sheets import write_notes

    with seen(counted("notes", len(own.variants)), quiet) as told:
        write_notes(folder, own, place, form, jobs=jobs, tell=warn, told=lambda done: told(done, 0))
    return (place,)


def _questions(
    own: Class,
    folder: Path,
    book: Keybook,
    scene: Spec,
    files: dict[Path | None, bool],
    jobs: int | None,
    quiet: bool,
) -> tuple[Path, ...]:
    """Questions for Moodle: a category a variant, or a set of data a variant."""
    from tmmcalc.classroom.grading import rules_of
    from tmmcalc.classroom.moodle.dataset import dataset_questions_of
    from tmmcalc.classroom.moodle.elements import quiz
    from tmmcalc.classroom.moodle.numerical import questions_of
    from tmmcalc.classroom.moodle.scenes import scenes_of
    from tmmcalc.core.atomic import replace_file

    table = scene.class_
    assert table is not None
    with seen(counted("questions", len(own.variants)), quiet) as told:
        scenes = scenes_of(folder, own, book.items, jobs=jobs, tell=warn, told=lambda done: told(done, 0))
    stem = own.file(folder).stem
    written = []
    for file, dataset in files.items():
        if file is not None:
            asked = dataset_questions_of if dataset else questions_of
            replace_file(file, quiz(asked(book, scenes, scene.project.title or stem, stem, rules_of(table))))
            written.append(file)
    return tuple(written)


def _made(own: Class, folder: Path, place: Path, jobs: int | None, fresh: bool, quiet: bool) -> Keybook:
    """The keys of all variants; what an earlier run has made is taken if it is of the same."""
    from tmmcalc.batch.choice import local
    from tmmcalc.batch.local import available, cores
    from tmmcalc.classroom.items import items_of
    from tmmcalc.classroom.keybook import FILE, read_keybook
    from tmmcalc.classroom.keymaking import make_keys
    from tmmcalc.classroom.state import digest_of
    from tmmcalc.core.atomic import blamed_on
    from tmmcalc.project import load_spec

    file = own.file(folder)
    spec = load_spec(file)
    if digest_of(spec) != own.digest:
        raise UsageError(
            f"the assignment is not that of the {len(own.variants)} variants in {folder}",
            where=str(file),
            remedy="undo the change, or make the class afresh: tmmcalc class make --fresh",
        )
    known = read_keybook(place) if (place / FILE).is_file() and not fresh else None
    items, count = items_of(spec), len(own.variants)
    with blamed_on(place, "made"):
        place.mkdir(parents=True, exist_ok=True)
    processes = jobs or (min(cores(), count) if available() and count > 1 else 1)
    with seen(counted("keys", count), quiet) as told:
        return make_keys(
            file,
            own.variants,
            items,
            local(max(processes, 1), warn),
            place / f"{FILE}.part",
            known=known,
            fresh=fresh,
            told=lambda done: told(done, 0),
        )
