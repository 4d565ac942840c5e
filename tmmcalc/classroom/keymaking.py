"""The keys of a whole class: made in processes side by side, kept as they come, and not made twice."""

from __future__ import annotations

import math
from array import array
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from tmmcalc._version import __version__
from tmmcalc.batch.content import files_of
from tmmcalc.batch.executors import Solve
from tmmcalc.batch.journal import Journal
from tmmcalc.batch.task import Row, Task, verdict
from tmmcalc.classroom.keying import key_of, mistakes_of, told_of
from tmmcalc.classroom.model import Item, Key, Keybook
from tmmcalc.classroom.state import Variant
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.files import read_file
from tmmcalc.pipeline.hashing import content_hash
from tmmcalc.project.loader import Variants, read_text
from tmmcalc.spec.rewrite import without

SOLVER = "tmmcalc.classroom.keymaking:solve_keys"
LOST = (
    "class make draws none like it: undo what was changed in class.toml, "
    "or make the class afresh: tmmcalc class make --fresh"
)


class Order(NamedTuple):
    """A key that is to be made, as it is sent to another process."""

    point: int  # number of the variant
    assignments: tuple[str, ...]
    items: tuple[Item, ...]
    mistakes: tuple[str, ...]


def solve_keys(task: Task, orders: Sequence[Order]) -> list[Row]:
    """The keys as rows of numbers, right values, then those of each mistake, by their places; those that there are.

    The row of a variant without a solution says why.
    """
    variants = task.variants()
    return [_row(variants, order) for order in orders]


def make_keys(
    assignment: Path,
    variants: Sequence[Variant],
    items: tuple[Item, ...],
    solver: Solve,
    journal: Path | None = None,
    *,
    known: Keybook | None = None,
    fresh: bool = False,
    told: Callable[[int], None] = lambda done: None,
) -> Keybook:
    """The keys of the variants; those of a book that is ``known`` are taken if nothing that they are of has changed.

    Mistakes that change nothing in any of them are left out. What is finished is kept in ``journal`` until all is;
    ``fresh``: nothing is taken of what it holds.
    Raises NoSolutionError for a variant that has no right solution, and what the assignment raises.
    """
    bare = without(read_text(assignment), "class")  # what of it counts are the items
    task = Task(bare, str(assignment), str(assignment.parent), (), (), solver=SOLVER, block=1)
    parts = task.variants()
    mistakes = mistakes_of(parts.spec())
    names = tuple(each.name for each in mistakes)
    files = [(name, read_file(parts.folder / name)) for name in files_of(parts.data, parts.folder)]
    made_of = content_hash(("keys", __version__, repr(parts.data), files, items, names))
    hashes = {each.number: content_hash((made_of, each.assignments)) for each in variants}
    done = _taken(known, hashes, names)
    with ExitStack() as stack:
        kept = stack.enter_context(Journal(journal, made_of)) if journal is not None else None
        orders = [Order(each.number, each.assignments, items, names) for each in variants]
        for row in kept.rows() if kept is not None and not fresh else ():
            if row.ok and row.point in hashes and row.alone == hashes[row.point]:
                done.setdefault(row.point, _key(row, len(items), len(names)))
        told(len(done))
        for rows in solver(task, [[order] for order in orders if order.point not in done]):
            for row in rows:
                if not row.ok:
                    raise NoSolutionError(row.reason, where=f"variant {row.point}", remedy=LOST)
                done[row.point] = _key(row, len(items), len(names))
            if kept is not None:
                kept.append(replace(row, alone=hashes[row.point]) for row in rows)
            told(len(done))
        if kept is not None:
            kept.done = True
    keys = tuple(replace(done[each.number], student=each.student) for each in variants)
    return _trimmed(Keybook(items, mistakes, keys, tuple(hashes.values())))


def _row(variants: Variants, order: Order) -> Row:
    try:
        mistakes = [told_of(name) for name in order.mistakes]
        key = key_of(order.point, "", variants.spec(order.assignments), order.items, mistakes)
    except Exception as error:  # one variant that breaks the program must not end the others
        return Row(order.point, *verdict(error))
    flat = [value for values in (key.values, *key.mistaken) for value in values]
    there = {str(at): value for at, value in enumerate(flat) if math.isfinite(value)}
    return Row(order.point, *verdict(None), tuple(there), array("d", there.values()))


def _key(row: Row, items: int, mistakes: int) -> Key:
    there = dict(zip(map(int, row.names), row.values, strict=True))
    flat = [there.get(at, math.nan) for at in range(items * (1 + mistakes))]
    values, *mistaken = (tuple(flat[at : at + items]) for at in range(0, len(flat), items))
    return Key(row.point, "", values, tuple(mistaken))


def _taken(known: Keybook | None, hashes: dict[int, str], names: Sequence[str]) -> dict[int, Key]:
    """The keys of a book that are of the same, with all mistakes again."""
    if known is None:
        return {}
    at = {each.name: k for k, each in enumerate(known.mistakes)}
    none = (math.nan,) * len(known.items)
    return {
        key.number: replace(key, mistaken=tuple(key.mistaken[at[name]] if name in at else none for name in names))
        for key, own in zip(known.keys, known.made_of, strict=True)
        if hashes.get(key.number) == own
    }


def _trimmed(book: Keybook) -> Keybook:
    """The book without the mistakes that change nothing in any variant."""
    telling = [
        at
        for at in range(len(book.mistakes))
        if any(math.isfinite(value) for key in book.keys for value in key.mistaken[at])
    ]
    keys = tuple(replace(key, mistaken=tuple(key.mistaken[at] for at in telling)) for key in book.keys)
    return replace(book, mistakes=tuple(book.mistakes[at] for at in telling), keys=keys)
