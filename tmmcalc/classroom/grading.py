"""A class marked from its files: keys, the present tolerances of its assignment, what was handed in."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from tmmcalc.classroom.answers.limits import UnreadableError
from tmmcalc.classroom.answers.positions import UNKNOWN, Steps
from tmmcalc.classroom.answers.reading import AngleOf, nowhere, read_answers, read_own
from tmmcalc.classroom.items import asked_now, class_of, items_of
from tmmcalc.classroom.keybook import FILE as KEYS
from tmmcalc.classroom.keybook import read_keybook
from tmmcalc.classroom.keying import key_of, mistakes_of
from tmmcalc.classroom.marking import Marked, Marks, Rules, mark, mark_one
from tmmcalc.classroom.model import Item, Keybook
from tmmcalc.classroom.neighbours import MACHINES
from tmmcalc.classroom.state import Class, digest_of, read_class
from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.core.stage import STAGES
from tmmcalc.naming.language import parse
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import one
from tmmcalc.pipeline.runner import run
from tmmcalc.project.loader import Variants, load_spec, read_text
from tmmcalc.spec.units import conversion

if TYPE_CHECKING:
    from tmmcalc.classroom.tables.class_ import ClassTable
    from tmmcalc.project import Spec

_START = "mechanism.input.start"
FOLDER = "keys"  # where keys stand if nothing else is said: beside the class, or in this folder


def graded(place: Path, answers: Path, keys: Path | None = None) -> tuple[Marks, Keybook, Spec]:
    """The marks of a class, by its folder or its assignment; keys with the tolerances that count now; the assignment.

    Raises UsageError where there are no keys, or those of something else, and where there is nothing to mark.
    """
    own = read_class(place) if place.is_dir() else None
    file = place if own is None else own.file(place)
    spec = load_spec(file)
    table = class_of(spec)
    if own is not None and digest_of(spec) != own.digest:
        rule = "the assignment is not that of the class: only names, tolerances and weights may change"
        raise UsageError(rule, where=str(file), remedy="undo the change, or make the class afresh")
    book = read_keybook(_keys(place, keys))
    book = replace(book, items=asked_now(spec, book.items))
    if not answers.exists():
        raise UsageError(f"there is no {answers}", where="ANSWERS", remedy="name a folder of answers, or a file")
    angle_of = nowhere if own is None else angles_in(_specs(own, file), book.items)
    pile = read_answers(answers, book.items, book.keys, steps_of(spec), angle_of)
    return mark(book, pile, rules_of(table)), book, spec


def _keys(place: Path, keys: Path | None) -> Path:
    if keys is not None:
        return keys
    home = place if place.is_dir() else place.parent
    there = [home / FOLDER, home.parent / FOLDER, Path(FOLDER)]
    return next((folder for folder in there if (folder / KEYS).is_file()), there[-1])


def own_marks(file: Path, answers: Path) -> tuple[Marked, Keybook]:
    """How the answers of a student stand by the spec of his variant, and its keys.

    Raises UsageError for answers that cannot be read; what a stage says of its numbers is not told.
    """
    spec = load_spec(file)
    if spec.class_ is None:
        raise UsageError("nothing is asked", where=str(file), remedy="take the spec of the variant as it was given out")
    try:
        items = items_of(spec)
        mistakes = mistakes_of(spec)
        key = key_of(1, "", spec, items, mistakes)
    except TmmError:
        rule = "its results cannot be computed"
        raise UsageError(rule, where=str(file), remedy=f"take it as it was given out; tmmcalc check {file}") from None
    book = Keybook(items, mistakes, (key,))
    try:
        handed = read_own(answers, items, steps_of(spec), angles_in(lambda number: spec, items))
    except UnreadableError as fault:
        raise UsageError(fault.message, where=str(answers), remedy=fault.remedy) from None
    return mark_one(book, key, handed, rules_of(spec.class_)), book


def _specs(own: Class, file: Path) -> Callable[[int], Spec]:
    """The specs of variants by their numbers."""
    variants = Variants(read_text(file), str(file), file.parent)
    assignments = {each.number: each.assignments for each in own.variants}
    return lambda number: variants.spec(assignments[number])


def angles_in(spec_of: Callable[[int], Spec], items: Sequence[Item]) -> AngleOf:
    """Where positions are whose angle each variant has its own of, as those of a cam; a variant is run when asked."""

    @cache
    def scene(number: int, stage: str) -> Scene:
        found = run(spec_of(number), target=stage, by_name=True)
        return Scene(found.spec, found.results)

    def angle(number: int, item: int) -> float:
        name = parse(items[item].result)
        if name.place is None or name.place.column or STAGES[name.stage].room in MACHINES:
            return math.nan
        try:
            there = scene(number, name.stage)
            found = one(name._replace(what="phi"), there.results, there)
            return found.value * conversion(found.unit, "deg")
        except (TmmError, KeyError):  # it has no such column, or its rows are no positions
            return math.nan

    return angle


def rules_of(table: ClassTable) -> Rules:
    """What is worth how much."""
    return Rules(float(table.for_plans), float(table.for_carried))


def steps_of(spec: Spec) -> Steps:
    """Where the positions of a mechanism are, by which a table over angles is read.

    Its steps have to be equal parts of a turn; position 0 is at a known angle where that is written and not drawn.
    """
    mechanism = spec.mechanism
    if mechanism is None:
        return UNKNOWN
    grid, motion = mechanism.grid, mechanism.input
    if grid.working or grid.span or grid.extra or grid.extremes:
        return UNKNOWN
    step = math.copysign(360.0 / grid.positions, motion.speed)
    drawn = spec.class_ is not None and any(_START in each.of for each in spec.class_.drawn)
    start = math.nan if isinstance(motion.start, str) or drawn else math.degrees(motion.start)
    return Steps(step, start)
