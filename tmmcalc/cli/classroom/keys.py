"""``tmmcalc class keys``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.messages import note_written, warn
from tmmcalc.cli.options import Form, Format, Quiet
from tmmcalc.cli.output import show, title
from tmmcalc.cli.progress import counted, seen
from tmmcalc.core.errors import UsageError
from tmmcalc.core.files import other_kind

if TYPE_CHECKING:
    from tmmcalc.classroom.model import Keybook
    from tmmcalc.classroom.state import Class

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
    chosen = numbers or ([key.number for key in book.keys[:SHOWN]] if form is Format.table else None)
    shown = book if chosen is None else of_variants(book, chosen)
    file = own.file(folder)
    show(keys_document(shown, title(load_spec(file), file, "keys")), form)
    if not quiet:
        for written in files:
            note_written(written)


def _made(own: Class, folder: Path, place: Path, jobs: int | None, fresh: bool, quiet: bool) -> Keybook:
    """The keys of all variants; what an earlier run has made is taken if it is of the same."""
    from tmmcalc.batch.choice import local
    from tmmcalc.batch.local import available, cores
    from tmmcalc.classroom.items import items_of
    from tmmcalc.classroom.keybook import FILE, read_keybook
    from tmmcalc.classroom.keymaking import make_keys
    from tmmcalc.core.atomic import blamed_on
    from tmmcalc.project import load_spec

    file = own.file(folder)
    known = read_keybook(place) if (place / FILE).is_file() and not fresh else None
    items, count = items_of(load_spec(file)), len(own.variants)
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
