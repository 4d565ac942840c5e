"""``class.toml``: who has which variant of which assignment, so that more can be drawn later and none is lost."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmmcalc._version import __version__
from tmmcalc.batch.content import files_of
from tmmcalc.classroom.roster import stem
from tmmcalc.core.atomic import replace_file
from tmmcalc.core.errors import SpecError, UsageError
from tmmcalc.core.files import read_file
from tmmcalc.core.printable import escaped
from tmmcalc.core.records import record
from tmmcalc.pipeline.hashing import content_hash
from tmmcalc.project.loader import read_text
from tmmcalc.spec.rewrite import toml
from tmmcalc.spec.syntax import read_toml

if TYPE_CHECKING:
    from tmmcalc.project import Spec

FILE = "class.toml"
VARIANTS = "variants"  # folder of their specs
MOST_BYTES = 10_000_000
TITLES = ("project", "note", "sheets")  # tables that change no number of a variant
DECIDES = ("drawn", "margin", "apart", "spread")  # keys of [class] that decide which variants there are


@record
class Variant:
    """What one student has."""

    number: int  # from 1
    student: str  # empty: not given out yet
    assignments: tuple[str, ...]  # the overrides that make it: mechanism.links[id=1].points.A[0]="75 mm"
    candidate: int  # under which it was drawn, from 0

    @property
    def stem(self) -> str:
        """How its files are called."""
        return stem(self.number, self.student)


@record
class Class:
    """All variants of an assignment that are given out."""

    assignment: str  # its file, from the folder of the class
    digest: str  # of what decides variants
    seed: int
    tried: int  # candidates up to the last variant
    variants: tuple[Variant, ...]
    unavoided: tuple[tuple[str, str], ...] | None = None
    """Items and mistakes that give the right answer of many variants; None: they were not looked for."""

    def file(self, folder: Path) -> Path:
        """The assignment of a class in this folder."""
        return folder / self.assignment


def digest_of(spec: Spec) -> str:
    """Hash of all that decides the variants of an assignment: not of titles, tolerances and weights."""
    written = spec._written
    assert written is not None
    asked = [each.result for each in spec.class_.asked] if spec.class_ is not None else []
    data = {key: value for key, value in written.document.items() if key not in (*TITLES, "class")}
    own = {key: written.document["class"].get(key) for key in DECIDES}
    files = [(name, read_file(written.folder / name)) for name in files_of(data, written.folder)]
    return content_hash(("class", repr(data), repr(own), asked, files))


def read_class(folder: Path) -> Class:
    """The class of a folder; raises UsageError where there is none, or what stands there is none."""
    path = folder / FILE
    if not path.is_file():
        raise UsageError(f"there is no class in {folder}", remedy="make it: tmmcalc class make assignment.toml -n 40")
    try:
        data = read_toml(read_text(path, MOST_BYTES), str(path))
        own = data["class"]
        variants = tuple(_variant(each) for each in data.get("variants", []))
        pairs = own.get("unavoided")
        pairs = None if pairs is None else tuple((_text(item), _text(mistake)) for item, mistake in pairs)
        made = Class(
            _text(own["assignment"]), _text(own["digest"]), _whole(own["seed"]), _whole(own["tried"]), variants, pairs
        )
    except (SpecError, KeyError, TypeError, ValueError, AttributeError) as error:
        rule = f"it is no class as the program writes it ({type(error).__name__}: {error})"
        remedy = "take it from a copy, or make the class afresh: --fresh"
        raise UsageError(rule, where=str(path), remedy=remedy) from None
    if [each.number for each in made.variants] != [*range(1, len(made.variants) + 1)]:
        rule = "its variants are not numbered from 1 on"
        raise UsageError(rule, where=str(path), remedy="take it from a copy, or make the class afresh: --fresh")
    return made


def write_class(made: Class, folder: Path) -> bool:
    """Write it in one step, whole or not at all; False: it was so already."""
    lines = [
        "# Who has which variant, written by tmmcalc class make. What is drawn later goes on from here: keep it.",
        "[class]",
        f"version = {toml(__version__)}",
        *(f"{key} = {toml(getattr(made, key))}" for key in ("assignment", "digest", "seed", "tried")),
    ]
    if made.unavoided is not None:
        lines += ["unavoided = [", *(f"    {toml(pair)}," for pair in made.unavoided), "]"]
    for each in made.variants:
        own = ("number", "student", "candidate")
        lines += ["", "[[variants]]", *(f"{key} = {toml(getattr(each, key))}" for key in own), "set = ["]
        lines += [*(f"    {toml(one)}," for one in each.assignments), "]"]
    return replace_file(folder / FILE, escaped("\n".join(lines) + "\n").encode())


def place_in(file: Path, folder: Path) -> str:
    """Where a file stands, from a folder; from the root where no way leads there."""
    try:
        return Path(os.path.relpath(file.resolve(), folder.resolve())).as_posix()
    except ValueError:
        return file.resolve().as_posix()


def _variant(data: dict[str, Any]) -> Variant:
    sets: Sequence[Any] = data["set"]
    return Variant(_whole(data["number"]), _text(data["student"]), tuple(map(_text, sets)), _whole(data["candidate"]))


def _text(value: object) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{value!r} is no text")
    return value


def _whole(value: object) -> int:
    if isinstance(value, bool) or not isinstance(value, int) or value < 0:
        raise TypeError(f"{value!r} is no whole number")
    return value
