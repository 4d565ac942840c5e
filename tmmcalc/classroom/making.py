"""A class made in its folder: the variants that are missing are drawn, those that are given out stay as they are."""

from __future__ import annotations

import csv
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmmcalc.batch.journal import Journal
from tmmcalc.classroom.choosing import Chooser, Chosen, Clashes
from tmmcalc.classroom.draws import candidate
from tmmcalc.classroom.judging import Judge
from tmmcalc.classroom.roster import MOST, newcomers, roster_of
from tmmcalc.classroom.state import (
    DECIDES,
    FILE,
    VARIANTS,
    Class,
    Variant,
    digest_of,
    place_in,
    read_class,
    write_class,
)
from tmmcalc.core.atomic import blamed_on, replace_file
from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.core.records import record
from tmmcalc.pipeline.hashing import content_hash
from tmmcalc.project.found import settled_text
from tmmcalc.project.loader import load_spec, parse_spec
from tmmcalc.spec.override import apply, split
from tmmcalc.spec.rewrite import Change, Found, value_at, without
from tmmcalc.spec.variants import Axis

if TYPE_CHECKING:
    from tmmcalc.classroom.choosing import Told
    from tmmcalc.classroom.model import Item
    from tmmcalc.project import Spec

TABLE = "class.csv"


@record
class Made:
    """A class, and what was drawn for it now."""

    own: Class
    fresh: tuple[Chosen, ...]  # the variants that were drawn now, the last of all
    items: tuple[Item, ...]
    factors: tuple[float, ...]  # of values of the items as they were found, for their units
    refused: dict[str, int]  # candidates that were tried now, by the demand that they do not keep
    least: float  # distance of two variants; NaN of a single one, and where none was drawn
    files: tuple[Path, ...]  # that were written


def make_class(
    file: Path,
    folder: Path,
    count: int | None = None,
    seed: int | None = None,
    *,
    fresh: bool = False,
    jobs: int | None = None,
    clashes: Callable[[Judge], Clashes] | None = None,
    tell: Callable[[str], None] = lambda said: None,
    told: Told = lambda done, words: None,
) -> Made:
    """Draw what a class lacks of ``count`` variants, or of one for each of the roster, and write its folder.

    ``seed`` is that of the class where it is made already, else 1. Raises UsageError for what does not fit, the error
    of the assignment as it is, and NoSolutionError where there are not so many variants; then nothing is written.
    """
    spec = load_spec(file)
    if spec.class_ is None or not spec.class_.drawn:
        raise UsageError("nothing is drawn", where=str(file), remedy="add [class] with what is drawn and asked")
    roster = roster_of(file.parent / spec.class_.roster) if spec.class_.roster is not None else ()
    if count is None and not roster:
        raise UsageError("how many variants?", where="-n", remedy="add -n 40, or roster to [class]")
    digest = digest_of(spec)
    before = None if fresh or not (folder / FILE).is_file() else read_class(folder)
    if before is not None:
        _check_same(before, digest, seed, folder)
    own = before or Class(place_in(file, folder), digest, 1 if seed is None else seed, 0, ())
    students = newcomers(roster, [each.student for each in own.variants if each.student])
    wanted = max(len(students), (count or 0) - len(own.variants))
    if len(own.variants) + wanted > MOST:
        raise UsageError(f"more than {MOST} variants", where="-n", limit=MOST, remedy="make several classes")
    return _made(file, folder, spec, own, wanted, students, jobs, clashes, tell, told)


def _check_same(before: Class, digest: str, seed: int | None, folder: Path) -> None:
    """Refuse another assignment or seed: those that have variants would have others."""
    if before.digest != digest:
        raise UsageError(
            f"the assignment is not that of the {len(before.variants)} variants in {folder}",
            where=str(folder / FILE),
            remedy="undo the change, choose another folder, or make the class afresh: --fresh",
        )
    if seed not in (None, before.seed):
        remedy = "leave --seed out, choose another folder, or make the class afresh: --fresh"
        raise UsageError(f"the class was drawn with seed {before.seed}", where="--seed", remedy=remedy)


def _made(
    file: Path,
    folder: Path,
    spec: Spec,
    own: Class,
    wanted: int,
    students: Sequence[str],
    jobs: int | None,
    clashes: Callable[[Judge], Clashes] | None,
    tell: Callable[[str], None],
    told: Told,
) -> Made:
    judge = Judge(file, jobs, tell)
    there = folder.is_dir()
    with blamed_on(folder, "made"):
        folder.mkdir(parents=True, exist_ok=True)
    try:
        key = content_hash(("class", own.digest, own.seed))
        with Journal(folder / f".{FILE}.part", key) as journal:
            chooser = Chooser(
                judge,
                own.seed,
                taken=[candidate(judge.drawn, own.seed, each.candidate) for each in own.variants],
                tried=own.tried,
                clashes=None if clashes is None else clashes(judge),
                unavoided=own.unavoided,
                journal=journal,
                told=told,
            )
            try:
                choice = chooser.choose(wanted)
            except TmmError:
                journal.done = True  # the same question has the same answer
                raise
            first = len(own.variants)
            names = [*students, *[""] * (wanted - len(students))]
            variants = own.variants + tuple(
                Variant(first + at, name, each.assignments, each.candidate.number)
                for at, (name, each) in enumerate(zip(names, choice.chosen, strict=True), 1)
            )
            done = replace(own, variants=variants, tried=choice.tried, unavoided=choice.unavoided)
            files = _written(file, folder, spec, done, judge, first)
            journal.done = True
    except BaseException:
        if not there and not any(folder.iterdir()):
            folder.rmdir()
        raise
    return Made(done, choice.chosen, judge.items, judge.factors, choice.refused, choice.least, files)


def _written(file: Path, folder: Path, spec: Spec, own: Class, judge: Judge, first: int) -> tuple[Path, ...]:
    """Write the folder: specs of new variants and of those whose file is not there, the table, at last the state."""
    written = spec._written
    assert written is not None
    text = without(written.text, "class") + _asked(written.document["class"])
    bare = parse_spec(text, str(file), (), file.parent)
    texts = {}
    with blamed_on(folder / VARIANTS, "made"):
        (folder / VARIANTS).mkdir(exist_ok=True)
    for each in own.variants:
        target = folder / VARIANTS / f"{each.stem}.toml"
        if each.number > first or not target.is_file():
            texts[target] = variant_text(bare, each.assignments, target)
    texts[folder / TABLE] = _table(own, [axis for drawn in judge.drawn for axis in drawn.axes])
    _remove_others(folder, own)
    files = [path for path, text in texts.items() if replace_file(path, text.encode())]
    return (*files, *([folder / FILE] if write_class(own, folder) else []))


def _asked(table: Mapping[str, Any]) -> str:
    """What of ``[class]`` the spec of a variant keeps: what is asked, by which a student looks at his own answers."""
    import tomli_w

    kept = {key: value for key, value in table.items() if key not in ("roster", *DECIDES)}
    return f"\n\n{tomli_w.dumps({'class': kept})}"


def _remove_others(folder: Path, own: Class) -> None:
    """Remove the specs of a class that was here before and is drawn anew; other files stay."""
    try:
        before = read_class(folder)
    except UsageError:
        return
    stems = {each.stem for each in own.variants}
    for each in before.variants:
        if each.stem not in stems:
            (folder / VARIANTS / f"{each.stem}.toml").unlink(missing_ok=True)


def variant_text(bare: Spec, assignments: Sequence[str], target: Path) -> str:
    """The text of a spec with the numbers of a variant, to be written to ``target``; all else stays, comments too."""
    written = bare._written
    assert written is not None
    document, paths = apply(written.document, assignments)
    return settled_text(bare, target, Found(tuple(Change(path, value_at(document, path)) for path in paths))).text


def _table(own: Class, axes: Sequence[Axis]) -> str:
    """The table of a class, as `--points` and `--set @class.csv:07` read it."""
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["number", "student", *(axis.name for axis in axes)])
    for each in own.variants:
        values = [split(assignment)[1].strip('"').split(" ")[0] for assignment in each.assignments]
        writer.writerow([f"{each.number:02d}", each.student, *values])
    return text.getvalue()
